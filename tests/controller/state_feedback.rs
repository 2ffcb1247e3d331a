//! State feedback against the matrix exponential of its loop, and the inverted pendulum on a cart.

use brunovsky::{
    Error, Scalar,
    controller::{Controller, Measurement, StateFeedback, lqr::Weights},
    plant::{CartPole, CartPoleOutput, ControlAffine, SmoothPlant},
    simulation::Simulation,
};
use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use crate::{
    at_f32_and_f64,
    support::{num, real},
};

fn cart<T: Scalar>() -> CartPole<T> {
    let [cart, pole, length, gravity] = [1.2, 0.3, 0.6, 9.81].map(num);
    CartPole::new(cart, pole, length, [0.4, 0.05].map(num), gravity, CartPoleOutput::Position)
        .unwrap()
}

fn weights<T: Scalar>() -> Weights<T, 4, 1> {
    Weights::diagonal([1.0, 1.0, 0.1, 0.1].map(num::<T>), [num::<T>(0.1)]).unwrap()
}

/// From a tilt of a third of a radian and a metre off, under sampling at 50 Hz.
fn balances<T: Scalar>() {
    let (plant, dt) = (cart::<T>(), num(0.02));
    let upright = plant.jacobians([T::zero(); 4], [T::zero()]).unwrap();
    let goal = SVector::from([T::one(), T::zero(), T::zero(), T::zero()]);
    for controller in [
        StateFeedback::lqr(&upright, &weights(), [T::zero()]),
        StateFeedback::sampled_lqr(&upright, &weights(), dt, [T::zero()]),
    ] {
        let start = [0.0, 0.33, 0.0, 0.0].map(num::<T>);
        let run = Simulation::new(&plant, controller.unwrap(), |_| goal, start, dt).unwrap();
        let last = run.until(num(25.0)).unwrap().last().unwrap().unwrap();
        // The slowest pole is near −0.9, so e^(−22) is left. A step of 2 ms does not see a speed that moves p by less than its rounding.
        let tolerance = 1e-6 + real(T::default_epsilon()) / 0.002;
        assert!(real((last.x - goal).norm()) < tolerance, "{}", last.x);
    }
}

at_f32_and_f64! {
    a_pendulum_on_a_cart_is_balanced => balances,
}

/// A plant that is linear, ẋ = A·x + B·u.
struct Linear(SMatrix<f64, 2, 2>, SMatrix<f64, 2, 1>);

impl ControlAffine<2, 1> for Linear {
    type Scalar = f64;

    fn drift_field(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        self.0 * x
    }

    fn input_fields(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 1> {
        self.1
    }
}

/// About the equilibrium of u₀ the error obeys ė = (A − B·K)·e; the hold is of first order.
#[test]
fn the_error_follows_the_matrix_exponential() {
    let a = SMatrix::from([[0.0, 2.0], [1.0, -0.4]]);
    let b = SMatrix::from([[0.0, 1.0]]);
    let plant = Linear(a, b);
    // A·r + B·u₀ = 0.
    let (r, u0) = (SVector::from([0.7, 0.0]), -1.4);
    let gain = SMatrix::from([[5.0], [3.0]]);
    let closed = a - b * gain;
    let closed = DMatrix::from_column_slice(2, 2, closed.as_slice());
    let error = |dt| {
        let controller = StateFeedback::new(gain, [u0]).unwrap();
        let run = Simulation::new(&plant, controller, |_| r, [0.0, 0.5], dt).unwrap();
        let apart = run.until(3.0).unwrap().step_by(50).map(|sample| {
            let sample = sample.unwrap();
            let start = DVector::from_row_slice(&[0.7, -0.5]);
            let e = (&closed * sample.t).exp() * start;
            (r - sample.x - SVector::from([e[0], e[1]])).norm()
        });
        apart.fold(0.0, f64::max)
    };
    let order = (error(0.002) / error(0.001)).log2();
    assert!((order - 1.0).abs() < 0.1, "{order}");
}

#[test]
fn bad_input_is_refused_by_name_and_leaves_no_trace() {
    let gain = SMatrix::<f64, 1, 2>::from([[5.0], [3.0]]);
    let before = StateFeedback::new(gain, [1.0]).unwrap();
    assert_eq!(*before.gain(), gain);
    let mut used = before;
    let (x, r) = (Measurement::new([1.0, 2.0]), SVector::from([0.0, 0.0]));
    assert_eq!(used.update(&x, &r, 0.1), Ok([1.0 - 5.0 - 6.0].into()));
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = StateFeedback::new(gain * bad, [1.0]);
        assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "K", .. })));
        let refused = StateFeedback::new(gain, [bad]);
        assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "u0", .. })));
        let refused = used.update(&Measurement::new([bad, 0.0]), &r, 0.1);
        assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "x", index: 0, .. })));
        let refused = used.update(&x, &SVector::from([0.0, bad]), 0.1);
        assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "r", index: 1, .. })));
        assert!(used.update(&x, &r, bad).is_err());
    }
    let refused = used.update(&Measurement::new([f64::MAX, 0.0]), &r, 0.1);
    assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "u", index: 0, .. })));
    assert_eq!(used.update(&x, &r, 0.0), Err(Error::NotPositive { name: "dt", value: 0.0 }));
    assert_eq!(used, before);
    used.reset();
    assert_eq!(used, before);
}
