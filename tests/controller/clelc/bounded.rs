//! Limits on what is learned, in closed loop.

use brunovsky::{
    channel::Saturation,
    controller::{Clelc, ClelcCommand, Limited, Reference},
    fuzzy::FuzzyNetwork,
    learning::{
        AdaptationRule, BackwardDifference, Bounded, ErrorRate, GradientDescent, Measured,
        NeuroFuzzy, SlidingMode,
    },
    plant::{IntegratorChain, Uncertain},
};

use super::faults::Faulty;
use crate::support::{flc, run};

const DT: f64 = 0.01;
const RATE: f64 = 4.0;
/// The sample at which the sensor of ẋ says 10⁶, once.
const OUTLIER: u32 = 1000;

type Chain = IntegratorChain<f64, 2>;

fn clelc<E, R>(error_rate: E, rule: R) -> Clelc<Chain, NeuroFuzzy<FuzzyNetwork<f64, 2, 3>, E, R>, 2>
where
    E: ErrorRate<f64, 2> + Clone,
    R: AdaptationRule<FuzzyNetwork<f64, 2, 3>> + Clone,
{
    let network = FuzzyNetwork::evenly_spaced([1.0, 1.0]).unwrap();
    Clelc::new(flc(Chain::new(), 2.0), NeuroFuzzy::new(network, error_rate, rule))
}

/// A double integrator under Δ = 1, with an outlier of the sensor of ẋ_n.
fn with_an_outlier<R: AdaptationRule<FuzzyNetwork<f64, 2, 3>> + Clone>(
    rule: R,
) -> Vec<ClelcCommand<f64>> {
    let plant = Uncertain::matched(Chain::new(), |_: f64, _: &_, _: &_| 1.0);
    let outlier = [OUTLIER, OUTLIER + 1];
    let controller = Faulty::new(clelc(Measured, rule), |_| 1e6, outlier);
    let samples = run(&plant, controller, |_| Reference::setpoint(0.0), [0.5, 0.0], DT, 40.0);
    samples.into_iter().map(|sample| sample.command).collect()
}

/// The outlier alone moves u_n by η·h·w̃ᵀw̃·10⁶; limited, by R·h at the most, as any other sample. What feedback and learning make of that is over
/// in the end.
#[test]
fn an_outlier_does_no_more_than_the_rate_allows() {
    let rule = GradientDescent::new(5.0).unwrap();
    let steps = |commands: &[ClelcCommand<f64>]| {
        commands.windows(2).map(|pair| (pair[1].u_n - pair[0].u_n).abs()).fold(0.0, f64::max)
    };
    assert!(steps(&with_an_outlier(rule)) > 1e3);
    // Gradient descent has Fixed antecedents: in this loop e moves slowly, and with it what is known, by a twentieth of the rate.
    let bounded = Bounded::new(rule, 2.0).unwrap().with_rate(RATE).unwrap();
    let commands = with_an_outlier(bounded);
    assert!(steps(&commands) <= 1.05 * RATE * DT);
    assert!(commands.iter().all(|command| command.u_n.abs() <= 2.0));
    let jump = commands[OUTLIER as usize].u_n - commands[OUTLIER as usize - 1].u_n;
    approx::assert_abs_diff_eq!(jump, -RATE * DT, epsilon = 0.05 * RATE * DT);
    approx::assert_abs_diff_eq!(commands.last().unwrap().u_n, -1.0, epsilon = 1e-6);
}

/// A plain difference behind an actuator that can never hold Δ: unlimited, u_n goes on at the rate −α (see `limited`), bounded it stays at −U.
#[test]
fn a_learner_that_winds_up_stops_at_the_bound() {
    let plant = Uncertain::matched(Chain::new(), |_: f64, _: &_, _: &_| 1.0);
    let bounded = Bounded::new(SlidingMode::new(5.0).unwrap(), 1.5).unwrap();
    let limits = Saturation::symmetric([0.5]).unwrap();
    let controller = Limited::new(clelc(BackwardDifference::new(), bounded), limits);
    let samples = run(&plant, controller, |_| Reference::setpoint(0.0), [0.0, 0.0], DT, 10.0);
    assert!(samples.iter().all(|sample| sample.command.asked.u_n.abs() <= 1.5));
    approx::assert_abs_diff_eq!(samples.last().unwrap().command.asked.u_n, -1.5, epsilon = 1e-12);
}
