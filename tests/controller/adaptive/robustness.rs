use brunovsky::{
    controller::{Leakage, Projection, Reference, StateRegressor},
    plant::{IntegratorChain, Uncertain},
};
use nalgebra::SVector;

use super::{Adaptive, adaptive, watched};

const DT: f64 = 0.01;

/// The drift of Ioannou and Kokotović: ẋ = u + d with d(t) → 0, λ = 1, Q = 1 (so p = ½), γ = 2 and a model that rests at 0. Then s = −x/2 and
///
/// ẋ = −x − θ̂·x + d,  θ̂̇ = x²  are solved by  θ̂ = (1 + 5t)^⅕, x = (1 + 5t)^(−⅖),  d = ẋ + (1 + θ̂)·x
///
/// from θ̂(0) = x(0) = 1: the parameter goes to infinity, though the disturbance and x vanish.
fn drifting(
    controller: Adaptive<StateRegressor, 1, 1>,
    t_end: f64,
    mut watch: impl FnMut(f64, f64, f64),
) {
    let plant = Uncertain::matched(IntegratorChain::<f64, 1>::new(), |t: f64, _: &_, _: &_| {
        let s = 1.0 + 5.0 * t;
        -2.0 * s.powf(-1.4) + (1.0 + s.powf(0.2)) * s.powf(-0.4)
    });
    let count = (t_end / DT) as usize;
    watched(
        &plant,
        controller,
        |_| Reference::setpoint(0.0),
        [1.0],
        DT,
        count,
        |sample, controller| {
            watch(sample.t, sample.x[0], controller.parameters()[0]);
        },
    );
}

fn plain() -> Adaptive<StateRegressor, 1, 1> {
    let controller = adaptive::<_, 1, 1>(1.0, StateRegressor, 2.0);
    controller.with_parameters([1.0]).unwrap().with_model_at([0.0]).unwrap()
}

#[test]
fn the_plain_law_drifts_as_its_closed_form_says() {
    let mut last = 0.0;
    drifting(plain(), 600.0, |t, x, theta| {
        let s = 1.0 + 5.0 * t;
        // The hold and the sampled rule are of the first order.
        assert!((theta - s.powf(0.2)).abs() < 3.0 * DT, "{t}: {theta}");
        assert!((x - s.powf(-0.4)).abs() < 3.0 * DT, "{t}: {x}");
        last = theta;
    });
    assert!(last > 4.9);
}

/// θ̂̇ ≤ x² − 2σ·(θ̂ − θ̂(0)) bounds θ̂ − θ̂(0) by the largest x² over 2σ; with the e-modification, σ·|x|/2 in place of σ, by the largest |x|
/// over σ. Both stay far below where the plain law goes, and come back.
#[test]
fn leakage_bounds_the_parameter_that_drifts() {
    for leakage in [Leakage::Sigma { sigma: 0.25 }, Leakage::Error { sigma: 0.5 }] {
        let (mut largest, mut last, mut size) = (0.0_f64, 0.0, 0.0_f64);
        drifting(plain().with_leakage(leakage).unwrap(), 600.0, |_, x, theta| {
            size = size.max(x.abs());
            (largest, last) = (largest.max(theta), theta);
        });
        let bound = match leakage {
            Leakage::Sigma { sigma } => size * size / (2.0 * sigma),
            Leakage::Error { sigma } => size / sigma,
            Leakage::None => f64::MAX,
        };
        assert!(largest - 1.0 <= bound, "{leakage:?}: {largest}");
        assert!(last < 2.5, "{leakage:?}: {last}");
    }
}

/// Pushed against the border for 600 s, to the last bit.
#[test]
fn a_projection_is_never_left() {
    let (radius, upper) = (1.7, 1.9);
    let mut reached = [0.0_f64; 2];
    let ball = plain().with_projection(Projection::Ball { radius }).unwrap();
    drifting(ball, 600.0, |_, _, theta| {
        assert!(theta.abs() <= radius);
        reached[0] = reached[0].max(theta);
    });
    let ends = Projection::Box { lower: [-0.1].into(), upper: [upper].into() };
    drifting(plain().with_projection(ends).unwrap(), 600.0, |_, _, theta| {
        assert!((-0.1..=upper).contains(&theta));
        reached[1] = reached[1].max(theta);
    });
    assert!(reached[0] > radius * (1.0 - 1e-14));
    assert_eq!(reached[1], upper);
}

/// The same in three dimensions, where the norm is rounded: for the start, and under noise that no regressor explains.
#[test]
fn a_ball_is_never_left_in_any_direction() {
    for k in 1..500 {
        let direction = SVector::<f64, 3>::from_fn(|i, _| (f64::from(k) * (1.3 + i as f64)).sin());
        let radius = 0.1 + f64::from(k % 17);
        let controller = adaptive::<_, 3, 3>(1.0, StateRegressor, 2.0);
        let controller = controller.with_projection(Projection::Ball { radius }).unwrap();
        let controller = controller.with_parameters(direction * 1e3).unwrap();
        let theta = controller.parameters();
        assert!(theta.norm() <= radius);
        approx::assert_relative_eq!(*theta, direction.normalize() * radius, max_relative = 1e-14);
    }
    let plant = Uncertain::matched(IntegratorChain::<f64, 3>::new(), |t: f64, _: &_, _: &_| {
        5.0 * (3.1 * t).sin() + 4.0 * (1.3 * t).cos()
    });
    let controller = adaptive::<_, 3, 3>(1.0, StateRegressor, 50.0);
    let controller = controller.with_projection(Projection::Ball { radius: 0.5 }).unwrap();
    let mut at_the_border = 0;
    watched(
        &plant,
        controller,
        |_| Reference::setpoint(0.0),
        [1.0, 0.0, 0.0],
        0.02,
        3000,
        |_, controller| {
            let norm = controller.parameters().norm();
            assert!(norm <= 0.5, "{norm}");
            at_the_border += u32::from(norm > 0.5 - 1e-12);
        },
    );
    assert!(at_the_border > 10);
}
