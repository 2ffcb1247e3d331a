use approx::assert_abs_diff_eq;
use brunovsky::{
    Scalar,
    differentiator::{BackwardDifference, HighGain},
    learning::{ClosedLoop, ErrorRate, OfState},
};

use crate::support::{quiet, real, ulps};

in_both_precisions! {
    a_jump_of_the_reference_is_not_differentiated,
    for_a_reference_at_rest_it_is_the_differentiator_of_the_error,
    at_the_first_sample_the_state_is_taken_to_rest,
}

fn sample<T: Scalar>(x_n: f64, r_n: f64, u_f: f64) -> ClosedLoop<T, 2> {
    let mut at = ClosedLoop { u_f: real(u_f), ..quiet() };
    (at.x[1], at.e[1]) = (real(x_n), real(r_n - x_n));
    at
}

/// x_n falls by 3 a second; the reference jumps to and fro and claims any rate.
fn a_jump_of_the_reference_is_not_differentiated<T: Scalar>() {
    let mut source = OfState::new(BackwardDifference::new());
    for (k, (r_n, u_f)) in
        [(0.0, 0.0), (50.0, 2.0), (-70.0, 0.0), (0.5, -9.0)].into_iter().enumerate()
    {
        let at = sample::<T>(-3.0 * 0.125 * k as f64, r_n, u_f);
        let rate = source.error_rate(&at, T::one(), real(0.125)).unwrap();
        let fall = if k == 0 { 0.0 } else { 3.0 };
        assert_eq!(rate, real(u_f + fall));
    }
}

fn for_a_reference_at_rest_it_is_the_differentiator_of_the_error<T: Scalar>() {
    let observer = HighGain::first_order(real(6.0)).unwrap();
    let (mut of_state, mut of_error) = (OfState::new(observer), observer);
    for k in 0..60 {
        let at = sample::<T>((0.2 * f64::from(k)).sin(), 0.7, 0.0);
        let found = of_state.error_rate(&at, T::zero(), real(0.1)).unwrap();
        let wanted = of_error.error_rate(&at, T::zero(), real(0.1)).unwrap();
        // x and e ≤ 2 are rounded apart and divided by h; some ten of them are remembered.
        assert_abs_diff_eq!(found, wanted, epsilon = ulps(2.0 / 0.1 * 10.0));
    }
}

fn at_the_first_sample_the_state_is_taken_to_rest<T: Scalar>() {
    let mut source = OfState::new(BackwardDifference::new());
    assert_eq!(source.error_rate(&sample::<T>(4.0, 1.0, 0.25), T::one(), T::one()), Ok(real(0.25)));
}
