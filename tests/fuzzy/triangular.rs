use brunovsky::{Error, Scalar, fuzzy::Triangular};
use proptest::prelude::*;

use crate::support::{cases, real, ulps};

in_both_precisions! {
    it_gives_back_its_places,
    it_is_the_straight_lines_between_its_places,
    outside_of_its_feet_it_is_zero,
    places_out_of_order_or_range_are_refused,
}

fn it_gives_back_its_places<T: Scalar>() {
    let own = Triangular::new(real::<T>(-1.0), real(0.5), real(4.0)).unwrap();
    assert_eq!((own.left(), own.peak(), own.right()), (real(-1.0), real(0.5), real(4.0)));
}

/// Share t of the way up a flank is grade t. Places that are integers and shares that are multiples of 1/64 have no rounding errors but that of the quotient.
fn it_is_the_straight_lines_between_its_places<T: Scalar>() {
    proptest!(cases(256), |(peak in -40..40_i32, left in 1..40_i32, right in 1..40_i32, share in 0..=64_i32)| {
        let own = Triangular::new(
            real::<T>((peak - left).into()), real(peak.into()), real((peak + right).into()),
        ).unwrap();
        let share = f64::from(share) / 64.0;
        let up = own.grade(real(f64::from(peak) - f64::from(left) * (1.0 - share)));
        let down = own.grade(real(f64::from(peak) + f64::from(right) * (1.0 - share)));
        for grade in [up, down] {
            prop_assert!((grade - real(share)).abs() <= ulps(1.0));
        }
    });
}

fn outside_of_its_feet_it_is_zero<T: Scalar>() {
    let own = Triangular::new(real::<T>(-1.0), real(0.5), real(4.0)).unwrap();
    for e in [-1.0, 4.0, -1.5, 4.5, -1e30, 1e30] {
        assert_eq!(own.grade(real(e)), T::zero());
    }
}

fn places_out_of_order_or_range_are_refused<T: Scalar>() {
    let attempt = |places: [f64; 3]| {
        let [left, peak, right] = places.map(real::<T>);
        Triangular::new(left, peak, right).unwrap_err()
    };
    assert_eq!(attempt([0.0, 0.0, 1.0]), Error::NotPositive { name: "left flank", value: 0.0 });
    assert_eq!(attempt([0.0, 1.0, 0.5]), Error::NotPositive { name: "right flank", value: -0.5 });
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (place, name) in ["left foot", "peak", "right foot"].into_iter().enumerate() {
            let mut places = [-1.0, 0.0, 1.0];
            places[place] = bad;
            assert!(
                matches!(attempt(places), Error::NonFinite { name: found, .. } if found == name)
            );
        }
    }
    let most = T::max_value().unwrap();
    assert!(matches!(
        Triangular::new(-most, most, most),
        Err(Error::NonFinite { name: "left flank", .. })
    ));
}
