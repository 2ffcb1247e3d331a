//! Lie derivatives by differentiation against formulas that were derived by hand, each with the bound on its rounding error.

use core::array;

use brunovsky::{
    Scalar,
    differentiation::{Dual, RunningError},
    plant::{Along, BoxSamples, Flow, SmoothPlant},
};

/// zᵢ = (hᵢ, L_f hᵢ, …), aᵢ and Bᵢⱼ.
pub struct ByHand<T, const N: usize, const M: usize> {
    pub chains: [[RunningError<T>; N]; M],
    pub drift: [RunningError<T>; M],
    pub matrix: [[RunningError<T>; M]; M],
}

/// Of one output of order N.
pub fn single<T, const N: usize>(
    chain: [RunningError<T>; N],
    drift: RunningError<T>,
    gain: RunningError<T>,
) -> ByHand<T, N, 1> {
    ByHand { chains: [chain], drift: [drift], matrix: [[gain]] }
}

/// Compares chains of `degrees` at 500 states of the box `[low, high]`.
///
/// Both sides compute with a bound on their rounding errors, so that each entry may be off by the sum of both bounds and by nothing more, whatever
/// cancels in it. The bounds themselves are held below 500 units of rounding of the largest entry, 1e-13 in f64.
pub fn assert_as_by_hand<P, T, const NX: usize, const N: usize, const M: usize>(
    plant: &P,
    degrees: [usize; M],
    [low, high]: [[f64; NX]; 2],
    by_hand: impl Fn([RunningError<T>; NX]) -> ByHand<T, N, M>,
) where
    T: Scalar,
    P: SmoothPlant<NX, M, Scalar = T>,
    Along: Flow<N>,
{
    let corner = |corner: [f64; NX]| corner.map(nalgebra::convert::<f64, T>);
    for state in BoxSamples::new(corner(low), corner(high)).unwrap().take(500) {
        let x: [RunningError<T>; NX] = array::from_fn(|i| state[i].into());
        let g = plant.input_fields(x);
        let start: [Dual<_, M>; NX] =
            array::from_fn(|i| Dual { value: x[i], slopes: array::from_fn(|j| g[j][i]) });
        let found = <Along as Flow<N>>::lie(plant, &start);
        let expected = by_hand(x);
        let mut pairs = Vec::new();
        for (i, degree) in degrees.into_iter().enumerate() {
            let drift = found.chains[i].get(degree).copied().unwrap_or(found.drift[i]);
            pairs.push((drift, expected.drift[i]));
            pairs.extend(found.chains[i].into_iter().zip(expected.chains[i]).take(degree));
            pairs.extend((0..M).map(|j| (found.slopes[i][j][degree - 1], expected.matrix[i][j])));
        }
        assert_within_rounding(&pairs, &state);
    }
}

fn assert_within_rounding<T: Scalar>(
    pairs: &[(RunningError<T>, RunningError<T>)],
    state: &impl core::fmt::Debug,
) {
    let largest =
        pairs.iter().fold(T::one(), |largest, (_, by_hand)| largest.max(by_hand.value().abs()));
    let fine = T::default_epsilon() * nalgebra::convert(500.0) * largest;
    for (k, (found, by_hand)) in pairs.iter().enumerate() {
        let bound = found.rounding() + by_hand.rounding();
        let off = (found.value() - by_hand.value()).abs();
        assert!(off <= bound, "pair {k} at {state:?}: {found:?}, not {by_hand:?}");
        assert!(bound <= fine, "pair {k} at {state:?}: a rounding error of {bound} is no test");
    }
}
