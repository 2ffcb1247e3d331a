use brunovsky::{
    Error, Scalar,
    learning::{BackwardDifference, ClosedLoop, ErrorRate, Measured, Redundant},
};

use crate::support::{at_error, real};

in_both_precisions! {
    the_second_source_speaks_where_the_first_has_no_measurement,
    it_lacks_what_both_lack,
}

/// e_n is a ramp of 2/s; the sensor says 7 and drops out at samples 2, 3 and 5. The difference has seen the sample before each.
fn the_second_source_speaks_where_the_first_has_no_measurement<T: Scalar>() {
    let mut source = Redundant::new(Measured, BackwardDifference::new());
    for k in 0..8_u32 {
        let rate = (![2, 3, 5].contains(&k)).then(|| real::<T>(-7.0));
        let at = ClosedLoop { rate, ..at_error(real(0.25 * f64::from(k))) };
        let wanted = if rate.is_some() { 7.0 } else { 2.0 };
        assert_eq!(source.error_rate(&at, T::zero(), real(0.125)), Ok(real(wanted)));
    }
}

fn it_lacks_what_both_lack<T: Scalar>() {
    let mut source = Redundant::new(Measured, Measured);
    assert_eq!(
        source.error_rate(&at_error::<T>(T::one()), T::zero(), T::one()),
        Err(Error::Missing { name: "measured rate of x_n" })
    );
    let mut other = Redundant::new(BackwardDifference::new(), Measured);
    assert_eq!(other.error_rate(&at_error::<T>(T::one()), T::zero(), T::one()), Ok(T::zero()));
}
