use brunovsky::{
    controller::Reference,
    plant::{IntegratorChain, Uncertain},
};

use super::{adaptive, constant, watched};

/// The largest error over the last tenth of 400 periods, after the constant 1 has acted on a loop with λ = 1 that learns at the rate γ.
fn left<const N: usize>(h: f64, rate: f64) -> f64 {
    let plant = Uncertain::matched(IntegratorChain::<f64, N>::new(), |_: f64, _: &_, _: &_| 1.0);
    let mut left = 0.0_f64;
    let controller = adaptive::<_, N, 1>(1.0, constant, rate);
    watched(
        &plant,
        controller,
        |_| Reference::setpoint(0.0),
        [0.0; N],
        h,
        400,
        |sample, _| {
            if sample.k >= 360 {
                left = left.max(sample.x.norm());
            }
        },
    );
    left
}

fn is_stable_up_to<const N: usize>(longest: f64) {
    for part in [0.5, 0.75, 1.0] {
        for rate in [0.3, 1.0, 10.0, 1e3, 1e9, 1e15] {
            let left = left::<N>(longest * part, rate);
            assert!(left < 1e-3, "N = {N}, h = {}, rate = {rate}: {left}", longest * part);
        }
    }
}

/// The periods that the documentation names, at rates from slow to far faster than sampling.
#[test]
fn the_sampled_law_is_stable_at_every_rate_where_the_nominal_loop_has_a_margin() {
    is_stable_up_to::<1>(1.3);
    is_stable_up_to::<2>(0.7);
    is_stable_up_to::<3>(0.5);
    is_stable_up_to::<4>(0.4);
}

/// Without a margin it is not: at N = 1 the poles of fast learning are those of z² − (2 − h − g)·z + (1 − h), g → 1, which are stable for
/// 4 − 2h > g, so up to h = 3/2; feedback linearization alone up to h = 2.
#[test]
fn beyond_the_margin_fast_learning_is_unstable() {
    assert!(left::<1>(1.45, 1e9) < 1e-3);
    assert!(left::<1>(1.55, 1e9) > 10.0);
    assert!(left::<1>(1.9, 1e-6) < 1.1);
}
