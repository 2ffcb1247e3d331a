use brunovsky::{
    Error,
    controller::{
        Gains,
        lqr::{self, Weights},
    },
};
use nalgebra::SMatrix;

use super::chain;

type Square = SMatrix<f64, 2, 2>;

fn unit() -> Weights<f64, 2, 1> {
    Weights::diagonal([1.0, 1.0], [1.0]).unwrap()
}

#[test]
fn weights_that_are_not_allowed_are_refused_by_name() {
    let (q, r) = (Square::identity(), SMatrix::from([[1.0]]));
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = Weights::diagonal([1.0, bad], [1.0]);
        assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "Q", index: 3, .. })));
        let refused = Weights::diagonal([1.0, 1.0], [bad]);
        assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "R", .. })));
        let refused = Weights::with_cross(q, r, SMatrix::from([[0.0, bad]]));
        assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "N", index: 1, .. })));
    }
    let lopsided = SMatrix::from([[1.0, 0.2], [0.3, 1.0]]);
    let refused = Error::Asymmetric { name: "Q", row: 1, column: 0, below: 0.2, above: 0.3 };
    assert_eq!(Weights::new(lopsided, r), Err(refused));
    for value in [0.0, -2.0] {
        let refused = Error::NotPositive { name: "pivot of R", value };
        assert_eq!(Weights::diagonal([1.0, 1.0], [value]), Err(refused));
    }
    let refused = Error::Negative { name: "pivot of Q", value: -3.0 };
    assert_eq!(Weights::diagonal([1.0, -3.0], [1.0]), Err(refused));
    // Indefinite though no diagonal entry is negative.
    for q in [[[0.0, 1.0], [1.0, 0.0]], [[1.0, 2.0], [2.0, 1.0]], [[1.0, 1.0], [1.0, 0.0]]] {
        let refused = Weights::new(Square::from(q), r);
        assert!(matches!(refused, Err(Error::Negative { name: "pivot of Q", .. })), "{q:?}");
    }
    let r = SMatrix::<f64, 2, 2>::from([[1.0, 2.0], [2.0, 1.0]]);
    let refused = Weights::<f64, 2, 2>::new(q, r);
    assert!(matches!(refused, Err(Error::NotPositive { name: "pivot of R", .. })));
    // N²/R is more than Q.
    let refused = Weights::with_cross(q, SMatrix::from([[1.0]]), SMatrix::from([[0.0, 1.1]]));
    assert!(matches!(refused, Err(Error::Negative { name: "pivot of Q", .. })));
}

/// Semidefinite to rounding is semidefinite: v·vᵀ has one pivot that is not 0.
#[test]
fn weights_of_a_single_direction_are_allowed() {
    for k in 1..200 {
        let v = SMatrix::<f64, 3, 1>::from_fn(|i, _| f64::from(k * (i as i32 + 1)).sin());
        let r = SMatrix::from([[1.0]]);
        assert!(Weights::<f64, 3, 1>::new(v * v.transpose(), r).is_ok(), "{v}");
        // N = v and R = 1 take all of it.
        assert!(Weights::with_cross(v * v.transpose(), r, v).is_ok(), "{v}");
    }
}

#[test]
fn a_mode_out_of_reach_is_refused() {
    let b = SMatrix::<f64, 2, 1>::from([[1.0, 0.0]]);
    // Growing, swinging or resting, and not reached by the input.
    for pole in [1.0, 1e-3, 0.0] {
        let a = Square::from([[-1.0, 0.0], [0.5, pole]]);
        let refused = lqr::continuous(&a, &b, &unit());
        let name = "Riccati equation";
        assert!(matches!(refused, Err(Error::NotStabilizable { name: n, .. }) if n == name));
        let a = Square::from([[0.5, 0.0], [0.5, 1.0 + pole]]);
        assert!(matches!(lqr::discrete(&a, &b, &unit()), Err(Error::NotStabilizable { .. })));
    }
    // Fading by itself it is left alone.
    let a = Square::from([[1.0, 0.0], [0.5, -1e-3]]);
    assert!(lqr::continuous(&a, &b, &unit()).is_ok());
    let zero = SMatrix::zeros();
    let refused = lqr::continuous(&chain::<f64, 2>().0, &zero, &unit());
    assert!(matches!(refused, Err(Error::NotStabilizable { .. })));
}

#[test]
fn a_mode_without_a_cost_is_refused() {
    let (a, b) = chain::<f64, 2>();
    // Nobody pays for the position, so nobody brings it back.
    for q in [[0.0, 1.0], [0.0, 0.0]] {
        let weights = Weights::diagonal(q, [1.0]).unwrap();
        let refused = lqr::continuous(&a, &b, &weights);
        assert!(matches!(refused, Err(Error::NotStabilizable { .. })), "{refused:?}");
        assert!(Gains::lqr(q, 1.0).is_err() && Gains::sampled_lqr(q, 1.0, 0.1).is_err());
    }
}

#[test]
fn a_bad_plant_or_period_is_refused_by_name() {
    let (a, b) = chain::<f64, 2>();
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = lqr::continuous(&(a * bad), &b, &unit());
        assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "A", .. })));
        let refused = lqr::discrete(&a, &(b * bad), &unit());
        assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "B", .. })));
        let refused = lqr::held(&a, &b, &unit(), bad);
        assert!(matches!(refused, Err(Error::NonFinite { name: "dt", .. })));
    }
    for value in [0.0, -1.0] {
        let refused = Error::NotPositive { name: "dt", value };
        assert_eq!(lqr::sampled(&a, &b, &unit(), value), Err(refused));
    }
    // exp(A·h) beyond the range of the scalar.
    let refused = lqr::held(&Square::identity(), &b, &unit(), 1e3);
    assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "exp(A*dt)", .. })));
    let huge = lqr::held(&(Square::identity() * f64::MAX), &b, &unit(), f64::MAX);
    assert!(huge.is_err());
}
