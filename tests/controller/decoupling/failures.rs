//! What is refused, and that it leaves no trace.

use super::*;

/// z̈ = a + B·u with a(x) = (e^x₁, 0) and a B that a test chooses.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Chosen {
    matrix: Matrix2<f64>,
}

impl Decouplable<4, 2, 2> for Chosen {
    type Scalar = f64;

    fn chains(&self, x: &SVector<f64, 4>) -> [SVector<f64, 2>; 2] {
        [SVector::from([x[0], x[2]]), SVector::from([x[1], x[3]])]
    }

    /// Overflows for x₁ = 1000.
    fn chain_drift(&self, x: &SVector<f64, 4>) -> SVector<f64, 2> {
        SVector::from([x[0].exp(), 0.0])
    }

    /// Singular for x₂ = 7.
    fn decoupling_matrix(&self, x: &SVector<f64, 4>) -> SMatrix<f64, 2, 2> {
        if x[1] == 7.0 { Matrix2::repeat(1.0) } else { self.matrix }
    }

    fn chain_rates(&self, _x: &SVector<f64, 4>, x_dot: &SVector<f64, 4>) -> SVector<f64, 2> {
        SVector::from([x_dot[2], x_dot[3]])
    }
}

const ORIGIN: [Reference<f64, 2>; 2] =
    [Reference { r: SVector::<f64, 2>::new(0.0, 0.0), r_n_dot: 0.0 }; 2];

#[test]
fn an_ill_conditioned_matrix_is_refused_with_its_condition_number() {
    let with = |matrix: Matrix2<f64>, limit: f64| {
        let controller = Decoupling::new(Chosen { matrix }, [joint::<f64>(2.0); 2]);
        let mut controller = controller.with_max_condition(limit).unwrap();
        controller.update(&Measurement::new([0.0; 4]), &ORIGIN, 0.1).map(|command| command.u)
    };
    let refused = |condition, limit| Error::IllConditioned { name: "B(x)", condition, limit };
    let near = 2.0_f64.powi(-20);
    let diagonal = Matrix2::new(1.0, 0.0, 0.0, near);
    // ‖diag(1, ε)‖·‖diag(1, 1/ε)‖ = 1/ε, a power of 2 and so without rounding; the limit itself is allowed.
    assert_eq!(with(diagonal, 1e6), Err(refused(1.0 / near, 1e6)));
    assert!(with(diagonal, 1.0 / near).is_ok());
    // (1 1; 0 1) and its inverse (1 −1; 0 1) both have the row sum 2.
    let shear = Matrix2::new(1.0, 1.0, 0.0, 1.0);
    assert_eq!(with(shear, 3.9), Err(refused(4.0, 3.9)));
    assert!(with(shear, 4.0).is_ok());
    assert_eq!(with(Matrix2::repeat(1.0), 1e6), Err(refused(f64::INFINITY, 1e6)));
    // Scaling B does not change how well its equations can be solved.
    assert!(with(Matrix2::identity() * 1e-100, 1.0).is_ok());
    let new = || Decoupling::new(Chosen { matrix: shear }, [joint::<f64>(2.0); 2]);
    for value in [0.0, -1.0] {
        let name = "condition number limit";
        assert_eq!(new().with_max_condition(value), Err(Error::NotPositive { name, value }));
    }
}

/// A maximum prefers numbers to NaN, so a norm alone would let such a matrix pass.
#[test]
fn a_matrix_that_is_not_finite_is_refused_by_its_name() {
    for bad in [f64::NAN, f64::INFINITY] {
        let model = Chosen { matrix: Matrix2::new(bad, 0.0, 0.0, 1.0) };
        let mut controller = Decoupling::new(model, [joint::<f64>(2.0); 2]);
        let error = controller.update(&Measurement::new([0.0; 4]), &ORIGIN, 0.1).unwrap_err();
        assert!(matches!(error, Error::IllConditioned { name: "B(x)", .. }), "{error}");
    }
}

#[test]
fn a_call_that_fails_leaves_no_trace_also_after_the_first_chain_was_updated() {
    let model = Chosen { matrix: Matrix2::new(0.5, 1.0, 0.0, 1.0) };
    let chains = (learner(ModelAided::new()), learner(BackwardDifference::new()));
    let mut tried = Decoupling::new(model, chains);
    let mut spared = tried;
    let good = Measurement::new([0.1, 0.2, 0.3, 0.4]);
    let nan = f64::NAN;
    let mut second = ORIGIN;
    second[1].r_n_dot = nan;
    let mut first = ORIGIN;
    first[0].r[1] = nan;
    // u = B⁻¹·(ν − a) overflows where each chain still has a finite νᵢ.
    let mut far = ORIGIN;
    (far[0].r_n_dot, far[1].r_n_dot) = (1.6e308, -1.6e308);
    let bad = [
        (good, ORIGIN, 0.0, "dt"),
        (good, ORIGIN, nan, "dt"),
        (Measurement::new([0.0, nan, 0.0, 0.0]), ORIGIN, 0.1, "x"),
        (good.with_rate([nan; 4]), ORIGIN, 0.1, "x_dot"),
        (good.with_applied([0.0, nan]), ORIGIN, 0.1, "applied"),
        (good, first, 0.1, "r"),
        (good, second, 0.1, "r_n_dot"),
        (good, far, 0.1, "u"),
        (Measurement::new([1000.0, 0.0, 0.0, 0.0]), ORIGIN, 0.1, "a(x)"),
        (Measurement::new([0.0, 7.0, 0.0, 0.0]), ORIGIN, 0.1, "B(x)"),
    ];
    for (measurement, reference, dt, expected) in bad {
        let name = match tried.update(&measurement, &reference, dt).unwrap_err() {
            Error::NonFinite { name, .. }
            | Error::NonFiniteEntry { name, .. }
            | Error::NotPositive { name, .. }
            | Error::IllConditioned { name, .. } => name,
            other => panic!("unexpected kind: {other}"),
        };
        assert_eq!(name, expected);
        assert_eq!(tried, spared);
        let update = |controller: &mut Decoupling<_, _, 4, 2, 2>| {
            controller.update(&good, &ORIGIN, 0.1).unwrap()
        };
        let before = spared;
        assert_eq!(update(&mut tried), update(&mut spared));
        assert_ne!(spared, before, "a good call is remembered");
    }
    tried.reset();
    assert_eq!(tried, Decoupling::new(model, chains));
}
