use brunovsky::{Error, controller::lqr};
use nalgebra::SMatrix;
use proptest::prelude::*;

use super::{by_linear_equations, eigenvalues};

proptest! {
    #[test]
    fn lyapunov_solves_its_linear_equations(entries in prop::collection::vec(-1.0..1.0_f64, 18)) {
        let mut entries = entries.into_iter();
        let mut a = SMatrix::<f64, 3, 3>::from_fn(|_, _| entries.next().unwrap());
        // Shifted to the left until it is stable.
        let rightmost = eigenvalues(&a).iter().map(|pole| pole.re).fold(f64::MIN, f64::max);
        a -= SMatrix::identity() * (rightmost + 0.05);
        let m = SMatrix::<f64, 3, 3>::from_fn(|_, _| entries.next().unwrap());
        let q = m + m.transpose();
        let p = lqr::lyapunov(&a, &q).unwrap();
        let expected = by_linear_equations(&a, &q);
        prop_assert!((p - expected).norm() <= 1e-8 * expected.norm(), "{} {}", p, expected);
    }
}

/// For a decoupled state P = Q/(2·|pole|).
#[test]
fn a_diagonal_is_divided_by_twice_its_rates() {
    let a = SMatrix::<f32, 2, 2>::from([[-0.5, 0.0], [0.0, -4.0]]);
    let p = lqr::lyapunov(&a, &SMatrix::identity()).unwrap();
    approx::assert_relative_eq!(p, SMatrix::from([[1.0, 0.0], [0.0, 0.125]]), epsilon = 1e-6);
}

#[test]
fn an_unstable_matrix_has_no_lyapunov_function() {
    let identity = SMatrix::<f64, 2, 2>::identity();
    let refused = |a: [[f64; 2]; 2]| lqr::lyapunov(&SMatrix::from(a), &identity);
    for a in [[[1.0, 0.0], [0.0, -1.0]], [[0.0, 1.0], [-1.0, 0.0]], [[0.0; 2]; 2]] {
        assert!(
            matches!(refused(a), Err(Error::NotStabilizable { name: "Lyapunov equation", .. })),
            "{a:?}"
        );
    }
    let lopsided = SMatrix::from([[1.0, 0.5], [0.0, 1.0]]);
    let refused_weight = lqr::lyapunov(&-identity, &lopsided);
    assert!(matches!(refused_weight, Err(Error::Asymmetric { name: "Q", row: 1, column: 0, .. })));
    assert!(matches!(refused([[f64::NAN; 2]; 2]), Err(Error::NonFiniteEntry { name: "A", .. })));
}
