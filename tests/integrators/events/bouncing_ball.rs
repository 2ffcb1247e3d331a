//! A ball on the floor, in closed form: dropped from H it lands at t₁ = √(2H/g) with the speed g·t₁; each impact leaves the fraction ε of the
//! speed, so the n-th flight lasts 2·εⁿ·t₁ and tₙ₊₁ = tₙ + 2·εⁿ·t₁, with the limit t∞ = t₁·(1 + ε)/(1 − ε).

use brunovsky::{
    Scalar,
    integrators::{
        Adaptive, Crossing, Direction, DormandPrince, Embedded, Events, Rodas, Tolerance,
    },
};
use nalgebra::SVector;

use super::num;

const GRAVITY: f64 = 9.81;
const HEIGHT: f64 = 2.0;

fn first() -> f64 {
    (2.0 * HEIGHT / GRAVITY).sqrt()
}

fn limit(restitution: f64) -> f64 {
    first() * (1.0 + restitution) / (1.0 - restitution)
}

/// The times of the first `count` impacts.
fn impacts<T: Scalar>(
    method: impl Embedded<T, 2>,
    tolerance: f64,
    restitution: f64,
    count: usize,
) -> Vec<T> {
    let ball = |_: T, x: &SVector<T, 2>| SVector::from([x[1], num(-GRAVITY)]);
    let tolerance = Tolerance::new(num(tolerance), num(tolerance)).unwrap();
    let solver = Adaptive::new(method, tolerance).solve(ball, T::zero(), [num(HEIGHT), T::zero()]);
    let mut solver = solver.unwrap();
    let mut floor = Events::new(|_, x: &SVector<T, 2>| [x[0]], [Crossing::falling().terminal()]);
    let mut times = vec![];
    while times.len() < count {
        let impact = solver.next_event(num(10.0), &mut floor).unwrap().expect("another impact");
        assert_eq!((impact.index, impact.direction), (0, Direction::Falling));
        assert!(impact.terminal && impact.x[0] <= T::zero(), "just below the floor");
        assert_eq!((solver.time(), *solver.state()), (impact.t, impact.x));
        times.push(impact.t);
        solver.restart([T::zero(), -impact.x[1] * num(restitution)]).unwrap();
    }
    times
}

/// The dense output of order 3 and 4 is exact for a parabola, so only rounding is left: of the time, up to 4 s, and of the height, which
/// shows in time divided by the speed; either adds up over the impacts.
fn at_the_right_times<T: Scalar>(method: impl Embedded<T, 2>, tolerance: f64) {
    let (restitution, count) = (0.8_f64, 20);
    let times = impacts(method, tolerance, restitution, count);
    let mut expected = first();
    for (n, time) in times.into_iter().enumerate() {
        let speed = GRAVITY * first() * restitution.powi(n as i32);
        let rounding = T::default_epsilon() * num(20.0 * (n + 1) as f64 * (4.0 + HEIGHT / speed));
        assert!((time - num(expected)).abs() < rounding, "impact {n}: {time}, not {expected}");
        expected += 2.0 * first() * restitution.powi(n as i32 + 1);
    }
}

#[test]
fn a_ball_lands_when_the_closed_form_says() {
    at_the_right_times::<f64>(DormandPrince, 1e-9);
    at_the_right_times::<f64>(Rodas::autonomous(), 1e-9);
    at_the_right_times::<f32>(DormandPrince, 1e-4);
}

/// Infinitely many impacts happen before t∞; each halves the time that is left.
#[test]
fn the_impacts_pile_up_before_the_limit() {
    let times = impacts::<f64>(DormandPrince, 1e-9, 0.5, 30);
    assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
    let end = *times.last().unwrap();
    // After impact n the rest is 2·t₁·εⁿ/(1 − ε).
    let rest = 2.0 * first() * 0.5_f64.powi(30) / 0.5;
    approx::assert_abs_diff_eq!(limit(0.5) - end, rest, epsilon = 1e-9);
}
