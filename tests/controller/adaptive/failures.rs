use brunovsky::{
    Error,
    controller::{
        Controller, Leakage, Measurement, ModelReferenceAdaptive, Projection, Reference,
        StateRegressor,
    },
    plant::IntegratorChain,
};
use nalgebra::SVector;

use super::{Adaptive, adaptive};
use crate::support::flc;

fn fresh() -> Adaptive<StateRegressor, 2, 2> {
    adaptive(1.0, StateRegressor, 2.0)
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    let new = |rate, q| {
        ModelReferenceAdaptive::new(
            flc(IntegratorChain::new(), 1.0),
            StateRegressor,
            rate,
            [1.0, q],
        )
    };
    type Build<'a> = &'a dyn Fn(f64) -> Result<Adaptive<StateRegressor, 2, 2>, Error>;
    let refusals: [(&str, Build); 8] = [
        ("rate of learning", &|value| new(value, 1.0)),
        ("q", &|value| new(1.0, value)),
        ("sigma", &|sigma| fresh().with_leakage(Leakage::Sigma { sigma })),
        ("sigma", &|sigma| fresh().with_leakage(Leakage::Error { sigma })),
        ("radius", &|radius| fresh().with_projection(Projection::Ball { radius })),
        ("rate of learning", &|value| fresh().with_unknown_effectiveness(value, [0.5, 2.0])),
        ("lower", &|value| fresh().with_unknown_effectiveness(1.0, [value, 2.0])),
        ("upper", &|value| fresh().with_unknown_effectiveness(1.0, [0.5, value])),
    ];
    for (wrong, refused) in refusals {
        for value in [0.0, -1.0] {
            assert_eq!(refused(value), Err(Error::NotPositive { name: wrong, value }));
        }
        for bad in [f64::NAN, f64::INFINITY] {
            assert!(matches!(refused(bad), Err(Error::NonFinite { name, .. }) if name == wrong));
        }
    }
    let refused = Error::NotBelow { name: "lower", value: 1.0, limit: 1.0 };
    assert_eq!(fresh().with_unknown_effectiveness(1.0, [1.0, 1.0]), Err(refused));
    let ends = Projection::Box { lower: [0.0, 1.0].into(), upper: [1.0, 1.0].into() };
    assert_eq!(fresh().with_projection(ends), Err(refused));
    for bad in [f64::NAN, f64::INFINITY] {
        let ends = Projection::Box { lower: [0.0, 1.0].into(), upper: [1.0, bad].into() };
        for (wrong, refused) in [
            ("upper", fresh().with_projection(ends)),
            ("theta", fresh().with_parameters([0.0, bad])),
            ("x_m", fresh().with_model_at([0.0, bad])),
        ] {
            let index = 1;
            assert!(
                matches!(refused, Err(Error::NonFiniteEntry { name, index: i, .. }) if name == wrong && i == index)
            );
        }
    }
}

#[test]
fn a_start_outside_of_what_is_allowed_is_the_nearest_inside() {
    let ends = Projection::Box { lower: [-1.0, 2.0].into(), upper: [1.0, 3.0].into() };
    let expected = SVector::from([1.0, 2.0]);
    let one = fresh().with_projection(ends).unwrap().with_parameters([5.0, 0.0]).unwrap();
    let other = fresh().with_parameters([5.0, 0.0]).unwrap().with_projection(ends).unwrap();
    assert_eq!((one.parameters(), other.parameters()), (&expected, &expected));
    let weak = fresh().with_unknown_effectiveness(1.0, [2.0, 9.0]).unwrap();
    assert_eq!(weak.inverse_effectiveness(), 2.0);
}

#[test]
fn a_bad_call_changes_nothing_and_reset_everything() {
    let fresh = fresh().with_unknown_effectiveness(1.0, [0.5, 2.0]).unwrap();
    let mut used = fresh;
    let (x, r) = (Measurement::new([1.0, 2.0]), Reference::setpoint(0.0));
    for k in 0..3 {
        used.update(&Measurement::new([1.0, f64::from(k)]), &r, 0.1).unwrap();
    }
    let before = used;
    assert!(used != fresh && used.parameters() != fresh.parameters());
    for dt in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(used.update(&x, &r, dt).is_err());
    }
    for bad in [f64::NAN, f64::INFINITY, f64::MAX] {
        assert!(used.update(&Measurement::new([bad, 0.0]), &r, 0.1).is_err());
        assert!(used.update(&x, &Reference::setpoint(bad), 0.1).is_err());
    }
    assert!(used.update(&x.with_applied([f64::NAN]), &r, 0.1).is_err());
    let refused = Error::Missing { name: "consent" };
    assert_eq!(used.update_if(&x, &r, 0.1, &mut |_| Err(refused)), Err(refused));
    assert_eq!(used, before);
    used.reset();
    assert_eq!(used, fresh);
}

#[test]
fn a_regressor_that_is_not_finite_is_refused_by_name() {
    let regressor = |x: &SVector<f64, 1>| SVector::from([1.0, x[0].ln()]);
    let mut controller = adaptive::<_, 1, 2>(1.0, regressor, 1.0);
    let refused = controller.update(&Measurement::new([-1.0]), &Reference::setpoint(0.0), 0.1);
    assert!(matches!(refused, Err(Error::NonFiniteEntry { name: "phi(x)", index: 1, .. })));
}
