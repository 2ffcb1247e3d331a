//! Membership functions and the fuzzy network, at rest and under a rule.

use brunovsky::{
    Error,
    fuzzy::{FuzzyNetwork, Grid, Inputs},
    learning::AdaptationRule,
};
use nalgebra::SVector;

use super::{
    Bytes, Float, attack,
    numbers::Numbers,
    parts::{AnyRule, memberships, network},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = match bytes.byte() % 4 {
        0 => attacked::<T, 1, 1>(bytes),
        1 => attacked::<T, 1, 3>(bytes),
        2 => attacked::<T, 2, 3>(bytes),
        _ => attacked::<T, 3, 2>(bytes),
    };
}

fn attacked<T: Float, const I: usize, const K: usize>(bytes: &mut Bytes) -> Result<(), Error>
where
    Inputs<I>: Grid,
{
    let mut network = network::<T, I, K>(bytes)?;
    let mut rule = AnyRule::decode(bytes)?;
    // The sizes of the consequents so far: what cancels in them leaves the rounding of what they were.
    let mut history = T::zero();
    while !bytes.is_empty() {
        history = history.max(largest_consequent(&network));
        match bytes.byte() % 4 {
            0 => {
                let before = network;
                let values = bytes.numbers::<T, 12>();
                let count = usize::from(bytes.byte()) % 13;
                if network.set_consequents(&values[..count]).is_err() {
                    assert!(network == before, "refused consequents left a trace");
                }
            }
            1 => {
                if let Ok(memberships) = memberships(bytes) {
                    network.set_memberships(memberships);
                }
            }
            2 => {
                let mut next = network;
                let e = bytes.vector::<T, I>();
                let (s, dt) = (bytes.number::<T>(), bytes.parameter::<T>());
                if e.are_finite() && s.are_finite() && dt.are_finite() && dt > T::zero() {
                    rule.follow(&mut next, &e);
                    let firing = next.fire(&e);
                    rule.adapt(&mut next, &firing, s, dt);
                    // As a compensator does: a network out of range is dropped.
                    if next.output(&firing).are_finite() {
                        network = next;
                    }
                }
            }
            _ => evaluated(&network, &bytes.vector(), history),
        }
        for membership in network.memberships().as_flattened() {
            assert!([membership.centre(), membership.width()].are_finite(), "{membership:?}");
            assert!(membership.width() > T::zero(), "{membership:?}");
        }
    }
    Ok(())
}

/// The output is a mean of the consequents, and every grade is one.
fn evaluated<T: Float, const I: usize, const K: usize>(
    network: &FuzzyNetwork<T, I, K>,
    e: &SVector<T, I>,
    history: T,
) where
    Inputs<I>: Grid,
{
    let answer = network.evaluate(e);
    if let Ok(u_n) = answer {
        assert!(u_n.are_finite());
    }
    if !e.are_finite() {
        assert!(answer.is_err());
        return;
    }
    let unit = |grade: T| grade >= T::zero() && grade <= T::one();
    for (row, e) in network.memberships().iter().zip(e.iter()) {
        assert!(row.iter().all(|membership| unit(membership.grade(*e))));
    }
    let firing = network.fire(e);
    assert!(firing.strengths().iter().all(|w| unit(*w)), "{:?}", firing.strengths());
    let sum = firing.strengths().iter().fold(T::zero(), |sum, w| sum + *w);
    let rounding: T = T::default_epsilon() * nalgebra::convert(32.0);
    assert!((sum - T::one()).abs() <= rounding, "{sum}");
    let least = nalgebra::convert::<_, T>((K as f64).powi(-(I as i32)));
    let norm_squared = firing.norm_squared();
    assert!(norm_squared >= least - rounding && norm_squared <= T::one() + rounding);
    if let Ok(u_n) = answer {
        let largest = largest_consequent(network);
        // Products below the least normal number round more coarsely.
        let size = largest + history * rounding + T::LEAST;
        assert!(u_n.abs() <= size, "{u_n} of {largest} after {history}");
    }
}

fn largest_consequent<T: Float, const I: usize, const K: usize>(
    network: &FuzzyNetwork<T, I, K>,
) -> T
where
    Inputs<I>: Grid,
{
    network.consequents().iter().fold(T::zero(), |size, f| size.max(f.abs()))
}
