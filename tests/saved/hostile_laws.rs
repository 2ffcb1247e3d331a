//! What no constructor of the control laws, networks and rules beside CLELC's own accepts is not loaded.

use brunovsky::{
    controller::{
        ActiveDisturbanceRejection, AntiWindup, Backstepping, Clelc, Compensated, Controller,
        FeedbackLinearization, Gains, Leakage, ModelReferenceAdaptive, Pid, PidGains, Projection,
        StateFeedback, StateRegressor,
        sliding_mode::{
            IntegralSlidingMode, SlidingModeControl, SlidingSurface, SuperTwisting,
            SuperTwistingGains,
        },
    },
    fuzzy::{Elliptic, IntervalNetwork, Triangular, TriangularNetwork, TypeReduction},
    learning::{
        AdaptiveSlidingMode, FeedbackError, NeuroFuzzy, RecursiveLeastSquares, SlidingMode,
    },
    nalgebra::SMatrix,
    plant::IntegratorChain,
};
use serde_json::{Value, json};

use crate::support::{comes_back, measured, reference, refusal};

type Chain = IntegratorChain<f64, 2>;

/// `controller` after some samples.
fn worked<C>(mut controller: C) -> C
where
    C: Controller<2, 1, Scalar = f64, Reference = brunovsky::controller::Reference<f64, 2>>,
{
    for k in 0..20 {
        controller.update(&measured(k), &reference(k, 0.0), 0.02).unwrap();
    }
    controller
}

fn chain() -> FeedbackLinearization<Chain, 2> {
    FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(2.0).unwrap())
}

fn pid(anti_windup: AntiWindup<f64>) -> Pid<f64, 2> {
    worked(Pid::new(PidGains::parallel(3.0, 2.0, 1.0, 0.1).unwrap(), anti_windup).unwrap())
}

fn surface() -> SlidingSurface<f64, 2> {
    SlidingSurface::from_lambda(2.0).unwrap()
}

fn adaptive() -> ModelReferenceAdaptive<Chain, StateRegressor, 2, 2> {
    let new = ModelReferenceAdaptive::new(chain(), StateRegressor, 5.0, [1.0, 1.0]).unwrap();
    let new = new.with_leakage(Leakage::Sigma { sigma: 0.1 }).unwrap();
    let new = new.with_projection(Projection::Ball { radius: 0.5 }).unwrap();
    worked(new.with_unknown_effectiveness(2.0, [0.5, 2.0]).unwrap())
}

fn least_squares() -> RecursiveLeastSquares<f64, 2, 3> {
    RecursiveLeastSquares::new(10.0).unwrap().with_memory(0.5).unwrap()
}

/// `what` is refused, and the message says `why`.
macro_rules! refused {
    ($what:expr, $($place:literal: [$($value:tt)+] => $why:literal),+ $(,)?) => {
        let what = $what;
        $(
            let message = refusal(&what, $place, json!($($value)+));
            assert!(message.starts_with($why), "{}: {message}", $place);
        )+
    };
}

#[test]
fn parameters_out_of_range_are_named() {
    refused! {
        pid(AntiWindup::BackCalculation { tracking_time: 0.5 }),
        "/gains/t_f": [0.0] => "T_f = 0 must be greater than 0",
        "/anti_windup/BackCalculation/tracking_time": [-1.0] => "tracking time = -1 must not be negative",
        "/anti_windup": [{ "Conditional": { "tolerance": -1.0 } }] => "tolerance = -1 must not be negative",
        "/anti_windup": [{ "Conditional": { "tolerance": 1.0, "time": 1.0 } }] => "unknown field `time`",
    }
    refused! {
        adaptive(),
        "/q/1": [0.0] => "q = 0 must be greater than 0",
        "/learning/rate": [-1.0] => "rate of learning = -1 must be greater than 0",
        "/learning/leakage/Sigma/sigma": [0.0] => "sigma = 0 must be greater than 0",
        "/learning/projection/Ball/radius": [0.0] => "radius = 0 must be greater than 0",
        "/learning/projection": [{ "Box": { "lower": [0.0, 1.0], "upper": [1.0, 1.0] } }] => "lower = 1 must be less than 1",
        "/learning/effectiveness/1/0": [2.0] => "lower = 2 must be less than 2",
    }
    refused! {
        Backstepping::<Chain, 2>::new(IntegratorChain::new(), [1.0, 2.0]).unwrap(),
        "/c/0": [-1.0] => "c = -1 must be greater than 0",
    }
    refused! {
        SlidingModeControl::<Chain, 2>::new(IntegratorChain::new(), surface(), 3.0).unwrap(),
        "/k": [0.0] => "k = 0 must be greater than 0",
        "/sign": [{ "Saturated": { "delta": -1.0 } }] => "delta = -1 must not be negative",
        "/sign": [{ "Switched": { "Explicit": { "delta": 0.0 } } }] => "delta = 0 must be greater than 0",
        "/surface/c/0": [-1.0] => "gains are not Hurwitz",
        "/surface/c/1": [2.0] => "distance of c_N from 1 = 1 must not be above 0",
    }
    refused! {
        SuperTwistingGains::new(2.0, 1.0).unwrap(),
        "/k1": [0.0] => "k1 = 0 must be greater than 0",
        "/k2": [-1.0] => "k2 = -1 must be greater than 0",
    }
    refused! {
        ActiveDisturbanceRejection::new(Gains::<f64, 2>::from_lambda(2.0).unwrap(), 9.0, 1.0).unwrap(),
        "/bandwidth": [0.0] => "bandwidth = 0 must be greater than 0",
        "/input_gain": [0.0] => "b0 = 0",
    }
    refused! {
        TriangularNetwork::<f64, 2, 3>::new([[Triangular::new(-1.0, 0.0, 2.0).unwrap(); 3]; 2]),
        "/memberships/1/0/peak": [2.0] => "right flank = 0 must be greater than 0",
        "/consequents/8": [null] => "invalid type: null",
        "/consequents": [([0.0; 8])] => "8 entries instead of 9",
    }
    let reduction = TypeReduction::Bmm { m: 0.5 };
    refused! {
        IntervalNetwork::<_, f64, 2, 3>::gaussian([1.0, 2.0], 0.2, reduction).unwrap(),
        "/memberships/0/2/widths/0": [9.0] => "lower width = 9 must not be above",
        "/reduction/Bmm/m": [1.5] => "m = 1.5 must not be above 1",
    }
    refused! {
        Elliptic::new(0.0, 1.0, [0.5, 2.0]).unwrap(),
        "/reach": [0.0] => "reach = 0 must be greater than 0",
        "/exponents/1": [0.25] => "lower exponent = 0.5 must not be above 0.25",
    }
    refused! {
        least_squares(),
        "/variance": [0.0] => "variance = 0 must be greater than 0",
        "/memory": [-1.0] => "memory = -1 must be greater than 0",
    }
    let rule = SlidingMode::new(5.0).unwrap();
    refused! {
        AdaptiveSlidingMode::new(rule, 2.0, 0.1).unwrap().with_ceiling(8.0).unwrap(),
        "/growth": [0.0] => "growth of alpha = 0 must be greater than 0",
        "/layer": [0.0] => "layer = 0 must be greater than 0",
        "/floor": [0.0] => "floor of alpha = 0 must be greater than 0",
        "/ceiling": [5.0] => "alpha = 5 must be less than 5",
    }
}

#[test]
fn what_is_remembered_is_within_what_was_promised() {
    let rule = SlidingMode::new(5.0).unwrap();
    refused! {
        AdaptiveSlidingMode::new(rule, 2.0, 0.1).unwrap().with_ceiling(8.0).unwrap(),
        "/rule/alpha": [4.0] => "floor of alpha = 5 must not be above 4",
        "/rule/alpha": [9.0] => "alpha = 9 must not be above 8",
    }
    refused! {
        adaptive(),
        "/learned/theta": [[0.4, 0.4]] => "distance of theta from the projection",
        "/learned/kappa": [3.0] => "distance of kappa from its range = 1 must not be above 0",
        "/learned/kappa": [0.0] => "kappa = 0 must be greater than 0",
        "/learning/initial/theta": [[0.6, 0.0]] => "distance of theta from the projection",
        // Without an effectiveness to learn it is known.
        "/learning/effectiveness": [null] => "distance of kappa from its range",
        "/last/phi/1": [1e200] => "phi(x) = ",
    }
    let mut integral = IntegralSlidingMode::new(3.0).unwrap();
    integral = *worked(Compensated::new(chain(), Chain::new(), integral)).compensator();
    refused! { integral, "/u_n": [-4.0] => "size of u_n = 4 must not be above 3" }
    let gains = SuperTwistingGains::new(2.0, 1.0).unwrap();
    refused! {
        worked(SuperTwisting::new(Chain::new(), surface(), gains)),
        "/last/reach": [-1.0] => "k2*dt = -1 must not be negative",
    }
}

#[test]
fn factors_of_what_is_no_covariance_are_refused() {
    let network = TriangularNetwork::<f64, 2, 3>::evenly_spaced([1.0, 2.0]).unwrap();
    let learner = NeuroFuzzy::new(network, FeedbackError, least_squares());
    let clelc = worked(Clelc::new(chain(), learner));
    comes_back(&clelc);
    refused! {
        clelc,
        "/compensator/rule/factors/4/4": [0.0] => "diagonal factor of the covariance = 0 must be greater than 0",
        "/compensator/rule/factors/0/0": [-1e-9] => "diagonal factor of the covariance = -0.000000001 must be",
        "/compensator/rule/factors/4/5": [1.0] => "size of what is below the factors = 1 must not be above 0",
        "/compensator/rule/factors/8/0": [1e6] => "trace of the covariance",
        "/compensator/rule/factors/8/8": [1e3] => "trace of the covariance",
        "/compensator/rule/factors/8": [([0.0; 8])] => "8 entries instead of 9",
    }
}

/// What in `saved` is a number, replaced by `1e39`, which is none in single precision.
fn overflown<S>(saved: &S, places: &[&str]) -> Vec<String>
where
    S: serde::Serialize + serde::de::DeserializeOwned,
{
    places.iter().map(|place| refusal(saved, place, Value::from(1e39))).collect()
}

#[test]
fn memory_that_is_not_finite_is_refused() {
    fn worked<C>(mut controller: C) -> C
    where
        C: Controller<2, 1, Scalar = f32, Reference = brunovsky::controller::Reference<f32, 2>>,
    {
        for k in 0..3 {
            controller.update(&measured(k), &reference(k, 0.0), 0.02).unwrap();
        }
        controller
    }
    let pid = Pid::new(PidGains::new(3.0).unwrap(), AntiWindup::None).unwrap();
    let mut refusals = overflown(&worked(pid), &["/last/i", "/last/d", "/last/u", "/last/y"]);
    let gains = Gains::<f32, 2>::from_lambda(2.0).unwrap();
    let rejection = worked(ActiveDisturbanceRejection::new(gains, 9.0, 1.0).unwrap());
    refusals.extend(overflown(&rejection, &["/last/z/1", "/last/f", "/last/u"]));
    let plant = IntegratorChain::<f32, 2>::new;
    let twisting = SuperTwistingGains::new(2.0, 1.0).unwrap();
    let surface = SlidingSurface::from_lambda(2.0).unwrap();
    let twisting = worked(SuperTwisting::new(plant(), surface, twisting));
    refusals.extend(overflown(&twisting, &["/last/start", "/last/end", "/last/sum", "/last/gain"]));
    let base = FeedbackLinearization::new(plant(), gains);
    let integral = IntegralSlidingMode::new(3.0).unwrap();
    let compensated = worked(Compensated::new(base, plant(), integral));
    let places = ["/last/u", "/last/base", "/compensator/sigma", "/compensator/u_n"];
    refusals.extend(overflown(&compensated, &places));
    let adaptive = ModelReferenceAdaptive::new(base, StateRegressor, 5.0, [1.0, 1.0]).unwrap();
    let adaptive = worked(adaptive.with_model_at([0.1, 0.2]).unwrap());
    let places = ["/start/0", "/last/model/0", "/last/rate", "/last/asked", "/learned/theta/1"];
    refusals.extend(overflown(&adaptive, &places));
    let feedback = StateFeedback::new(SMatrix::<f32, 1, 2>::new(1.0, 2.0), [0.5]).unwrap();
    refusals.extend(overflown(&feedback, &["/gain/1", "/u0/0"]));
    for refusal in refusals {
        assert!(refusal.contains("inf is not finite"), "{refusal}");
    }
}
