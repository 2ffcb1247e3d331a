//! Networks that learn: CLELC under several rules, its predecessor, and CLELC on top of other controllers.

use brunovsky::{
    fuzzy::{Grid, Inputs, IntervalNetwork, TypeReduction},
    learning::{AdaptiveSlidingMode, FeedbackError, RecursiveLeastSquares},
    prelude::*,
};

use super::{
    Contestant, Facts, around,
    feedback::{lqr, lqr_parameters, pid, pid_parameters},
};

/// The sliding-mode rule with a boundary layer.
fn rule(alpha: f64, delta: f64) -> Result<SlidingMode<f64>, Error> {
    SlidingMode::new(alpha)?.with_switching(Switching::Implicit { delta })
}

/// All of them, with networks of K memberships an input.
pub fn of<P, const N: usize, const K: usize>(model: P, facts: Facts<N>) -> Vec<Contestant<N>>
where
    P: FeedbackLinearizable<N, Scalar = f64> + Copy + Send + Sync + 'static,
    Inputs<N>: Grid,
{
    let Facts { rate, delta, errors, period, .. } = facts;
    let lambda = facts.lambda();
    // From what follows such an uncertainty slowly to what learns all of it in a period.
    let slowest = 0.1 * delta * rate;
    let alpha = ("α", [slowest, delta / period]);
    let layer = ("δ", [0.01 * delta, 100.0 * delta]);
    let clelc = [lambda, alpha, layer];
    let network = move || FuzzyNetwork::<f64, N, K>::evenly_spaced(errors);
    let flc = move |lambda| Ok(FeedbackLinearization::new(model, Gains::from_lambda(lambda)?));
    let learner =
        move |alpha, delta| Ok(NeuroFuzzy::new(network()?, ModelAided::new(), rule(alpha, delta)?));
    let [k, t_i, t_d, t_f] = pid_parameters(facts);
    let [q1, q2] = lqr_parameters(facts);
    vec![
        Contestant::new("feedback-error learning", "x, model", &clelc, move |p| {
            let learner = NeuroFuzzy::new(network()?, FeedbackError, rule(p[1], p[2])?);
            Ok(Clelc::new(flc(p[0])?, learner))
        }),
        Contestant::new("CLELC", "x, model, bound on Δ̇", &clelc, move |p| {
            Ok(Clelc::new(flc(p[0])?, learner(p[1], p[2])?))
        }),
        Contestant::new("CLELC, type 2", "x, model, bound on Δ̇", &clelc, move |p| {
            let network =
                IntervalNetwork::<_, f64, N, K>::gaussian(errors, 0.2, TypeReduction::NieTan)?;
            let rule = rule(p[1], p[2])?.with_antecedents(Fixed);
            Ok(Clelc::new(flc(p[0])?, NeuroFuzzy::new(network, ModelAided::new(), rule)))
        }),
        Contestant::new(
            "CLELC, adaptive α",
            "x, model",
            &[lambda, ("γ", [rate * rate, 0.1 / (period * period)]), ("ε", layer.1)],
            move |p| {
                let rule = AdaptiveSlidingMode::new(SlidingMode::new(slowest)?, p[1], p[2])?
                    .with_ceiling(delta / period)?;
                Ok(Clelc::new(flc(p[0])?, NeuroFuzzy::new(network()?, ModelAided::new(), rule)))
            },
        ),
        Contestant::new(
            "CLELC, gradient descent",
            "x, model",
            &[lambda, ("η", [0.1 * rate, 1.0 / period])],
            move |p| {
                let rule = GradientDescent::new(p[1])?;
                Ok(Clelc::new(flc(p[0])?, NeuroFuzzy::new(network()?, ModelAided::new(), rule)))
            },
        ),
        Contestant::new(
            "CLELC, least squares",
            "x, model",
            &[lambda, ("p", around(1.0, 1000.0)), ("τ", around(10.0 / rate, 30.0))],
            move |p| {
                let rule = RecursiveLeastSquares::new(p[1])?.with_memory(p[2])?;
                Ok(Clelc::new(flc(p[0])?, NeuroFuzzy::new(network()?, ModelAided::new(), rule)))
            },
        ),
        Contestant::new(
            "PID and learning",
            "x, model, bound on Δ̇",
            &[k, t_i, t_d, t_f, alpha, layer],
            move |p| {
                let base = pid::<N>([p[0], p[1], p[2], p[3]])?;
                Ok(Compensated::new(base, model, learner(p[4], p[5])?))
            },
        ),
        Contestant::new(
            "LQR and learning",
            "x, model, bound on Δ̇",
            &[q1, q2, alpha, layer],
            move |p| {
                let base = lqr(model, period, [p[0], p[1]])?;
                Ok(Clelc::new(base, learner(p[2], p[3])?))
            },
        ),
    ]
}
