//! Random networks, and the textbook to compare them with.

use brunovsky::{
    Scalar,
    fuzzy::{FuzzyNetwork, Gaussian, Grid, Inputs},
    nalgebra::SVector,
};
use proptest::{collection::vec, prelude::*};

pub use crate::numbers::{cases, real, ulps};

/// The membership that rule `rule` asks of input `input`: a digit of the rule's number written to the base K, the last input
/// being the last digit.
pub fn digit<const I: usize, const K: usize>(rule: usize, input: usize) -> usize {
    rule / K.pow((I - 1 - input) as u32) % K
}

/// A network's parameters and an input.
#[derive(Debug, Clone)]
pub struct Case<T, const I: usize, const K: usize> {
    pub memberships: [[Gaussian<T>; K]; I],
    pub consequents: Vec<T>,
    pub e: SVector<T, I>,
}

impl<T: Scalar, const I: usize, const K: usize> Case<T, I, K>
where
    Inputs<I>: Grid,
{
    pub fn network(&self) -> FuzzyNetwork<T, I, K> {
        let mut network = FuzzyNetwork::new(self.memberships);
        network.set_consequents(&self.consequents).unwrap();
        network
    }
}

/// Centres and consequents in \[−1, 1\], widths in \[0.5, 2\] and inputs in \[−1.5, 1.5\], at most 5 widths from any centre.
///
/// All are multiples of 2⁻¹⁰, so their sums and differences have no rounding errors, not even in `f32`.
pub fn case<T: Scalar, const I: usize, const K: usize>() -> impl Strategy<Value = Case<T, I, K>> {
    let dyadic = |low: i32, high: i32| (low..=high).prop_map(|n| real::<T>(f64::from(n) / 1024.0));
    let parameters = vec((dyadic(-1024, 1024), dyadic(512, 2048)), I * K);
    let consequents = vec(dyadic(-1024, 1024), K.pow(I as u32));
    let e = vec(dyadic(-1536, 1536), I);
    (parameters, consequents, e).prop_map(|(parameters, consequents, e)| Case {
        memberships: core::array::from_fn(|i| {
            core::array::from_fn(|k| {
                let (centre, width) = parameters[i * K + k];
                Gaussian::new(centre, width).unwrap()
            })
        }),
        consequents,
        e: SVector::from_vec(e),
    })
}

/// eq_mu to eq_un word for word, rule by rule: the normalized firing strengths and the output.
pub fn textbook<T: Scalar, const I: usize, const K: usize>(case: &Case<T, I, K>) -> (Vec<T>, T) {
    let mut strengths = Vec::new();
    for rule in 0..K.pow(I as u32) {
        let mut w = T::one();
        for i in 0..I {
            let membership = case.memberships[i][digit::<I, K>(rule, i)];
            let m = (case.e[i] - membership.centre()) / membership.width();
            w *= (m * m * real(-0.5)).exp();
        }
        strengths.push(w);
    }
    let sum = strengths.iter().fold(T::zero(), |sum, w| sum + *w);
    let mut u_n = T::zero();
    for (w, f) in strengths.iter_mut().zip(&case.consequents) {
        *w /= sum;
        u_n += *w * *f;
    }
    (strengths, u_n)
}

pub fn evenly_spaced<T: Scalar, const I: usize, const K: usize>(range: T) -> FuzzyNetwork<T, I, K>
where
    Inputs<I>: Grid,
{
    FuzzyNetwork::evenly_spaced([range; I]).unwrap()
}
