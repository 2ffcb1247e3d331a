//! Every differentiator.

use core::fmt::Debug;

use brunovsky::{
    Error,
    differentiator::{
        BackwardDifference, Differentiator, FilteredDifference, HighGain, RobustExact, Tracking,
    },
};

use super::{Bytes, Float, attack, numbers::Numbers};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = attacked::<T>(bytes);
}

fn attacked<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let [a, b, c] = [bytes.parameter(), bytes.parameter(), bytes.parameter()];
    match bytes.byte() % 12 {
        0 => sampled(BackwardDifference::<T>::new(), bytes),
        1 => sampled(FilteredDifference::<T>::new(a)?, bytes),
        2 => sampled(FilteredDifference::<T>::for_noise(a, b)?, bytes),
        3 => sampled(HighGain::first_order(a)?, bytes),
        4 => sampled(HighGain::<T, 2>::for_noise(a, b, c)?, bytes),
        5 => sampled(HighGain::second_order(a)?, bytes),
        6 => sampled(HighGain::<T, 3>::for_noise(a, b, c)?, bytes),
        7 => sampled(RobustExact::first_order(a)?, bytes),
        8 => sampled(RobustExact::second_order(a)?, bytes),
        9 => sampled(RobustExact::third_order(a)?, bytes),
        10 => sampled(Tracking::new(a, b)?, bytes),
        _ => sampled(Tracking::<T>::for_noise(a, b, c)?, bytes),
    }
    Ok(())
}

fn sampled<D, T: Float>(new: D, bytes: &mut Bytes)
where
    D: Differentiator<Scalar = T> + Clone + PartialEq + Debug,
{
    let mut source = new.clone();
    while !bytes.is_empty() {
        if bytes.byte().is_multiple_of(16) {
            source.reset();
            assert!(source == new, "a reset left a trace");
        }
        let before = source.clone();
        let (y, known) = (bytes.number::<T>(), bytes.number::<T>());
        match source.update_beyond(y, known, bytes.parameter()) {
            Ok(rate) => assert!(rate.are_finite(), "{rate}"),
            Err(error) => {
                assert!(source == before, "{error} left a trace");
                if bytes.deep {
                    assert_eq!(
                        format!("{source:?}"),
                        format!("{before:?}"),
                        "{error} left a trace"
                    );
                }
            }
        }
    }
}
