//! What the tests of this room share: samples of a loop, a learner without a loop, and the scalar recursion of s.

use brunovsky::{
    Scalar,
    fuzzy::{FuzzyNetwork, Gaussian, Grid, Inputs},
    learning::{
        AdaptationRule, Antecedents, ClosedLoop, Flow, LearningMode, SlidingMode, Switching,
    },
    nalgebra::SVector,
};
use proptest::{
    prelude::*,
    test_runner::{RngAlgorithm, TestRng},
};

pub use crate::numbers::{cases, real, ulps};

/// The same random numbers at every run.
pub fn rng() -> TestRng {
    TestRng::deterministic_rng(RngAlgorithm::XorShift)
}

/// The least positive number.
pub fn least<T: Scalar>() -> T {
    real(if T::default_epsilon() > real(1e-10) {
        f64::from(f32::from_bits(1))
    } else {
        f64::from_bits(1)
    })
}

/// The decimal exponents between which `T` has normal numbers, with room for sums and factors of a few.
pub fn decades<T: Scalar>() -> core::ops::Range<i32> {
    if T::default_epsilon() > real(1e-10) { -36..37 } else { -300..301 }
}

/// A number of either sign and any magnitude.
pub fn any_magnitude<T: Scalar>() -> impl Strategy<Value = T> {
    (decades::<T>(), 1.0..9.0_f64, prop::bool::ANY).prop_map(|(decade, digits, negative)| {
        let size = real::<T>(10.0_f64.powi(decade)) * real(digits);
        if negative { -size } else { size }
    })
}

pub const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// A sample at which nothing happens.
pub fn quiet<T: Scalar, const N: usize>() -> ClosedLoop<T, N> {
    ClosedLoop {
        x: SVector::zeros(),
        e: SVector::zeros(),
        u_f: T::zero(),
        u_b: T::zero(),
        drift: T::zero(),
        gain: T::one(),
        u: T::zero(),
        asked: T::zero(),
        rate: None,
        learning: LearningMode::Active,
    }
}

/// A sample at which only the last error differs from zero.
pub fn at_error<T: Scalar>(e_n: T) -> ClosedLoop<T, 2> {
    ClosedLoop { e: SVector::from([T::zero(), e_n]), ..quiet() }
}

/// A network and its rule, run by hand through the public traits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Learner<T: Scalar, const I: usize, const K: usize, A = Flow<T>>
where
    Inputs<I>: Grid,
{
    pub network: FuzzyNetwork<T, I, K>,
    pub rule: SlidingMode<T, A>,
}

impl<T: Scalar, const I: usize, const K: usize, A> Learner<T, I, K, A>
where
    Inputs<I>: Grid,
    A: Antecedents<FuzzyNetwork<T, I, K>> + Copy,
{
    /// One sample at the input `e` with sliding variable `s`: the output after learning.
    pub fn step(&mut self, e: SVector<T, I>, s: T, dt: T) -> T {
        self.rule.follow(&mut self.network, &e);
        let firing = self.network.fire(&e);
        self.rule.adapt(&mut self.network, &firing, s, dt);
        self.network.output(&firing)
    }

    /// The memberships as they stand to the input. At an input of zero their centres are −d, without rounding.
    pub fn at_zero(&self) -> [[Gaussian<T>; K]; I] {
        let mut moved = *self;
        moved.rule.follow(&mut moved.network, &SVector::zeros());
        moved.network.memberships()
    }

    /// M² of every membership, exact to rounding wherever the input is.
    pub fn squares(&self) -> [[T; K]; I] {
        self.at_zero().map(|row| row.map(|membership| membership.distance(T::zero()).powi(2)))
    }

    /// The firing strengths at the present input, which the memberships have followed.
    pub fn strengths(&self) -> Vec<T> {
        let mut moved = *self;
        moved.rule.follow(&mut moved.network, &SVector::zeros());
        moved.network.fire(&SVector::zeros()).strengths().to_vec()
    }
}

/// ς as its defining equation says, found by bisection and not in closed form.
pub fn sign_by_definition(switching: Switching<f64>, s: f64, reach: f64) -> f64 {
    let smooth = |s: f64, delta: f64| s / (s.abs() + delta);
    match switching {
        Switching::Explicit { delta } => smooth(s, delta),
        Switching::Implicit { delta } if delta > 0.0 => {
            // s⁺ + αh·s⁺/(|s⁺| + δ) grows with s⁺ and is 0 at 0, so its root for |s| lies between 0 and |s|.
            let (mut low, mut high) = (0.0, s.abs());
            for _ in 0..100 {
                let middle = 0.5 * (low + high);
                if middle + reach * smooth(middle, delta) > s.abs() {
                    high = middle
                } else {
                    low = middle
                }
            }
            smooth(low, delta).copysign(s)
        }
        _ => (s / reach).clamp(-1.0, 1.0),
    }
}

/// α = 25 and h = 0.01 s, so αh = 0.25, with boundary layers on either side of the chattering limit.
pub const ALPHA: f64 = 25.0;
pub const PERIOD: f64 = 0.01;
pub const REACH: f64 = ALPHA * PERIOD;
pub const SWITCHINGS: [Switching<f64>; 6] = [
    Switching::Explicit { delta: 0.0125 },
    Switching::Explicit { delta: 0.05 },
    Switching::Explicit { delta: 0.5 },
    Switching::Implicit { delta: 0.05 },
    Switching::Implicit { delta: 0.0 },
    Switching::SetValued,
];

/// The number of ways in which [`trajectory`] lets Δ move.
pub const DISTURBANCES: usize = 7;

/// s at `samples` samples of a loop whose Δ moves by at most `change` a period: at that rate one way or the other, always away
/// from zero, always the way that the step went, at random, at random at that rate, or to and fro.
///
/// The rule acts on s + `noise`(k).
pub fn trajectory(
    switching: Switching<f64>,
    s0: f64,
    change: f64,
    kind: usize,
    samples: u32,
    noise: impl Fn(u32) -> f64,
) -> impl Iterator<Item = f64> {
    let (mut s, mut rng) = (s0, rng());
    (0..samples).map(move |k| {
        let now = s;
        let after = s - REACH * sign_by_definition(switching, s + noise(k), REACH);
        s = after
            - change
                * match kind {
                    0 => 1.0,
                    1 => -1.0,
                    2 => -after.signum(),
                    3 => -(after - now).signum(),
                    4 => rng.random_range(-1.0..1.0),
                    5 => f64::from(rng.random_range(0..2_i32) * 2 - 1),
                    _ => f64::from(k % 2) * 2.0 - 1.0,
                };
        now
    })
}
