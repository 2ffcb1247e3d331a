//! How wrong the model's input gain may be: near s = 0 one sample turns s into (1 − (b/b̂)·slope)·s, where αh·ς ≈ slope·s.

use brunovsky::{
    controller::Reference,
    learning::{Measured, SlidingMode, Switching},
    plant::{FeedbackLinearizable, IntegratorChain, Uncertain},
};
use nalgebra::SVector;

use crate::support::{learning, run};

const DT: f64 = 1e-3;
const ALPHA: f64 = 10.0;
const REACH: f64 = ALPHA * DT;

/// ẋ = b·u, of which the model believes that b = 1.
struct Gain(f64);

impl FeedbackLinearizable<1> for Gain {
    type Scalar = f64;

    fn drift(&self, _x: &SVector<f64, 1>) -> f64 {
        0.0
    }

    fn input_gain(&self, _x: &SVector<f64, 1>) -> f64 {
        self.0
    }
}

/// The largest |s| of the last 10 of 4000 samples under Δ = 1, for b = `ratio`·b̂.
fn remaining(switching: Switching<f64>, ratio: f64) -> f64 {
    let plant = Uncertain::matched(Gain(ratio), |_: f64, _: &_, _: &_| 1.0);
    let rule = SlidingMode::new(ALPHA).unwrap().with_switching(switching).unwrap();
    let clelc = learning(IntegratorChain::<f64, 1>::new(), 1.0, Measured, rule);
    let samples = run(&plant, clelc, |_| Reference::setpoint(0.0), [0.0], DT, 4.0);
    samples.iter().rev().take(10).map(|sample| sample.command.s.abs()).fold(0.0, f64::max)
}

/// Inside its margin s goes to zero as the error does, like e^(−t); outside it ends in a cycle that is as wide as a sample can reach.
#[test]
fn each_sign_bears_the_gain_that_its_slope_allows() {
    let delta = REACH;
    for (switching, slope) in [
        (Switching::SetValued, 1.0),
        (Switching::Implicit { delta }, 0.5),
        (Switching::Explicit { delta: 2.0 * delta }, 0.5),
    ] {
        let margin = 2.0 / slope;
        for share in [0.2, 0.5, 0.9, 0.97] {
            let left = remaining(switching, share * margin);
            assert!(left < 0.05 * REACH, "{switching:?}, {share}: {left}");
        }
        for share in [1.05, 1.2] {
            let left = remaining(switching, share * margin);
            assert!(left > 0.05 * REACH, "{switching:?}, {share}: {left}");
        }
    }
}
