use brunovsky::{
    Error,
    channel::{Ideal, RateLimit, Saturation},
    controller::{Controller, Limited, Measurement, Reference},
    learning::{BackwardDifference, ErrorRate, ModelAided, SlidingMode},
    plant::{IntegratorChain, Uncertain},
    simulation::Simulation,
};
use nalgebra::SVector;

use crate::support::{flc, learning};

const DT: f64 = 0.01;

/// A limit that is never reached leaves the run as it is, bit for bit.
#[test]
fn a_limit_that_is_never_reached_changes_nothing() {
    let plant = IntegratorChain::<f64, 2>::new();
    let rest = |_| Reference::setpoint(0.0);
    let bare = Simulation::new(&plant, flc(plant, 2.0), rest, [1.0, 0.0], DT).unwrap();
    let wide = Saturation::symmetric([1e3]).unwrap();
    let limited = Limited::new(flc(plant, 2.0), wide);
    let limited = Simulation::new(&plant, limited, rest, [1.0, 0.0], DT).unwrap();
    for (bare, limited) in bare.zip(limited).take(500) {
        let (bare, limited) = (bare.unwrap(), limited.unwrap());
        assert_eq!((bare.x, bare.u, bare.command), (limited.x, limited.u, limited.command.asked));
        assert!(!limited.command.is_limited());
    }
}

/// Far from the reference the double integrator is driven at the limit: x₁ = x₁(0) − ½·u·t², until the law asks for less.
#[test]
fn at_the_limit_the_plant_moves_as_the_limit_says() {
    let plant = IntegratorChain::<f64, 2>::new();
    let controller = Limited::new(flc(plant, 2.0), Saturation::symmetric([0.5]).unwrap());
    let rest = |_| Reference::setpoint(0.0);
    let run = Simulation::new(&plant, controller, rest, [10.0, 0.0], DT).unwrap();
    let limited = run.map(Result::unwrap).take_while(|sample| sample.command.is_limited());
    let count = limited.inspect(|sample| {
        assert_eq!(sample.u[0], -0.5);
        approx::assert_abs_diff_eq!(
            sample.x[0],
            10.0 - 0.25 * sample.t * sample.t,
            epsilon = 1e-11
        );
    });
    // k₁·x₁ + k₂·x₂ = 4·(10 − t²/4) − 4·t/2 is 0.5 for the first time at t = −1 + √40.5.
    assert_eq!(count.count(), ((40.5_f64.sqrt() - 1.0) / DT).ceil() as usize);
}

/// The last s and u_n under Δ = 1, of which an input within ±0.5 can never get the better.
fn overpowered(error_rate: impl ErrorRate<f64, 2> + Clone) -> (f64, f64) {
    let model = IntegratorChain::<f64, 2>::new();
    let plant = Uncertain::matched(model, |_: f64, _: &_, _: &_| 1.0);
    let clelc = learning(model, 1.0, error_rate, SlidingMode::new(5.0).unwrap());
    let limited = Limited::new(clelc, Saturation::symmetric([0.5]).unwrap());
    let rest = |_| Reference::setpoint(0.0);
    let run = Simulation::new(&plant, limited, rest, [0.0, 0.0], DT).unwrap();
    let last = run.take(1000).last().unwrap().unwrap();
    assert!(last.command.is_limited());
    (last.command.asked.s, last.command.asked.u_n)
}

/// A learner that knows what arrived learns Δ itself and stops. One that does not takes what is missing for more of Δ: with u at the
/// limit ẋ_n = 0.5, s = u_b − 0.5 stays negative, and u_n goes on at the rate −α as long as the plant runs away.
#[test]
fn learning_that_knows_what_arrived_does_not_wind_up() {
    let (s, u_n) = overpowered(ModelAided::new());
    approx::assert_abs_diff_eq!(s, 0.0, epsilon = 1e-9);
    approx::assert_abs_diff_eq!(u_n, -1.0, epsilon = 1e-9);
    let (s, u_n) = overpowered(BackwardDifference::new());
    assert!(s < -5.0 * DT);
    assert!(u_n < -5.0 * 9.0, "{u_n}");
}

/// A report from the actuators themselves goes before the wrapper's own idea.
#[test]
fn a_reported_input_goes_before_the_actuators() {
    let model = IntegratorChain::<f64, 1>::new();
    let clelc = learning(model, 1.0, ModelAided::new(), SlidingMode::new(1.0).unwrap());
    let (mut limited, mut bare) =
        (Limited::new(clelc, Saturation::symmetric([0.1]).unwrap()), clelc);
    let rest = Reference::setpoint(0.0);
    for (x, u) in [(1.0, 0.0), (0.9, -0.3), (0.95, 0.2)] {
        let told = Measurement::new([x]).with_applied([u]);
        let command = limited.update(&told, &rest, DT).unwrap();
        assert_eq!(command.asked, bare.update(&told, &rest, DT).unwrap());
    }
}

#[test]
fn a_failed_update_changes_nothing_and_reset_everything() {
    let plant = IntegratorChain::<f64, 2>::new();
    let clelc = learning(plant, 1.0, BackwardDifference::new(), SlidingMode::new(5.0).unwrap());
    let fresh = Limited::new(clelc, (RateLimit::new([1.0]).unwrap(), Ideal));
    let mut used = fresh;
    let (rest, x) = (Reference::setpoint(0.0), Measurement::new([1.0, 2.0]));
    used.update(&x, &rest, DT).unwrap();
    let before = used;
    assert_ne!(used, fresh);
    let bad = Measurement::new(SVector::from([f64::NAN, 0.0]));
    assert!(matches!(used.update(&bad, &rest, DT), Err(Error::NonFiniteEntry { name: "x", .. })));
    assert!(matches!(used.update(&x, &rest, 0.0), Err(Error::NotPositive { name: "dt", .. })));
    assert_eq!(used, before);
    used.reset();
    assert_eq!(used, fresh);
}
