use approx::{assert_abs_diff_eq, assert_relative_eq};
use brunovsky::{
    Error, Scalar,
    fuzzy::{Firing, FuzzyNetwork},
    learning::{AdaptationRule, RecursiveLeastSquares},
    nalgebra::{DMatrix, DVector, SVector},
};
use proptest::prelude::*;

use crate::support::{NOT_FINITE, real, rng, ulps};

in_both_precisions! {
    without_a_memory_it_is_the_batch_solution,
    with_a_memory_it_forgets_in_the_direction_of_the_sample,
    while_the_error_rests_it_is_the_weighted_mean_over_the_memory,
    a_step_leaves_the_stated_part_of_s,
    what_was_learned_elsewhere_is_kept_while_the_error_rests,
    forgetting_does_not_pass_the_covariance_of_the_beginning,
    nothing_becomes_non_finite_in_a_million_samples,
    a_parameter_out_of_range_is_refused,
}

fn number<T: Scalar>(value: T) -> f64 {
    nalgebra::try_convert(value).unwrap()
}

fn network<T: Scalar>() -> FuzzyNetwork<T, 2, 3> {
    FuzzyNetwork::evenly_spaced([T::one(), real(2.0)]).unwrap()
}

/// A sample at which −Δ = `y`, h = 0.1 s.
fn told<T: Scalar>(
    rule: &mut RecursiveLeastSquares<T, 2, 3>,
    network: &mut FuzzyNetwork<T, 2, 3>,
    firing: &Firing<T, 2, 3>,
    y: T,
) {
    let s = y - network.output(firing);
    rule.adapt(network, firing, s, real(0.1));
}

/// −Δ of the tests: smooth, and no network of nine rules.
fn wanted(e: [f64; 2]) -> f64 {
    2.0 * (1.5 * e[0]).sin() - e[1] * e[1] * 0.5 + 1.0
}

/// The same estimate by inverses: P⁻¹, from which (1 − λ)/(w̃ᵀPw̃)·w̃w̃ᵀ is taken, and to which w̃w̃ᵀ is added.
struct Batch {
    information: DMatrix<f64>,
    right: DVector<f64>,
    most: f64,
}

impl Batch {
    fn new(variance: f64) -> Self {
        let information = DMatrix::identity(9, 9) / variance;
        Self { information, right: DVector::zeros(9), most: 9.0 * variance }
    }

    /// P.
    fn covariance(&self) -> DMatrix<f64> {
        self.information.clone().try_inverse().unwrap()
    }

    fn add(&mut self, w: &[f64], y: f64, lambda: f64) {
        let w = DVector::from_column_slice(w);
        let square = &w * w.transpose();
        let (covariance, estimate) = (self.covariance(), self.solution());
        let r = w.dot(&(&covariance * &w));
        let forgotten = &self.information - &square * ((1.0 - lambda) / r);
        // The tests do not come to where the trace would be passed.
        let next = (&forgotten + &square).try_inverse().unwrap();
        assert!(next.trace() < self.most);
        // Forgetting does not move the estimate; without it the sum is the same to the last bit but not to be trusted with it.
        self.right = if lambda < 1.0 { &forgotten * estimate } else { self.right.clone() } + &w * y;
        self.information = forgotten + square;
    }

    fn solution(&self) -> DVector<f64> {
        self.information.clone().cholesky().unwrap().solve(&self.right)
    }
}

/// 300 samples all over the grid, `memory` in seconds, h = 0.1 s; against the normal equations at several of them.
fn is_the_batch_solution<T: Scalar>(memory: Option<f64>) {
    let variance = 100.0;
    let mut rule = RecursiveLeastSquares::new(real::<T>(variance)).unwrap();
    if let Some(memory) = memory {
        rule = rule.with_memory(real(memory)).unwrap();
    }
    let (mut network, mut batch, mut rng) = (network::<T>(), Batch::new(variance), rng());
    for k in 1..=300 {
        let e = [rng.random_range(-1.5..1.5), rng.random_range(-3.0..3.0)];
        let firing = network.fire(&SVector::from(e.map(real)));
        let y = real::<T>(wanted(e));
        told(&mut rule, &mut network, &firing, y);
        let strengths: Vec<f64> = firing.strengths().iter().map(|w| number(*w)).collect();
        batch.add(&strengths, number(y), memory.map_or(1.0, |memory| (-0.1 / memory).exp()));
        if k % 50 == 7 {
            // The information has eigenvalues from 1/p = 0.01 up to the number of samples: a condition of some 10⁴.
            let epsilon = number(T::default_epsilon()) * 2e4;
            for (own, wanted) in network.consequents().iter().zip(batch.solution().iter()) {
                assert_abs_diff_eq!(number(*own), *wanted, epsilon = epsilon * 10.0);
            }
            let trace = batch.covariance().trace();
            assert_relative_eq!(number(rule.uncertainty()), trace, max_relative = epsilon);
        }
    }
}

fn without_a_memory_it_is_the_batch_solution<T: Scalar>() {
    is_the_batch_solution::<T>(None);
}

fn with_a_memory_it_forgets_in_the_direction_of_the_sample<T: Scalar>() {
    is_the_batch_solution::<T>(Some(5.0));
    is_the_batch_solution::<T>(Some(1.0));
}

/// At one e the strengths are one direction, and u_n = Σ λ^{k−i}·y_i/(λᵏ/(p·w̃ᵀw̃) + Σ λ^{k−i}).
fn while_the_error_rests_it_is_the_weighted_mean_over_the_memory<T: Scalar>() {
    let (variance, lambda) = (100.0, (-0.1_f64 / 2.0).exp());
    let mut rule = RecursiveLeastSquares::new(real::<T>(variance)).unwrap();
    rule = rule.with_memory(real(2.0)).unwrap();
    let (mut network, mut rng) = (network::<T>(), rng());
    let firing = network.fire(&SVector::from([0.3, -0.4].map(real)));
    let (mut sum, mut weight) = (0.0, 1.0 / (variance * number(firing.norm_squared())));
    for _ in 0..2000 {
        let y = real::<T>(rng.random_range(-1.0..3.0));
        told(&mut rule, &mut network, &firing, y);
        sum = sum * lambda + number(y);
        weight = weight * lambda + 1.0;
        // Some twenty samples are remembered, with consequents of a few units; at the first of them P falls by a factor of p.
        let epsilon = number(T::default_epsilon()) * 20.0 * variance;
        assert_abs_diff_eq!(number(network.output(&firing)), sum / weight, epsilon = epsilon);
    }
}

/// P = p·𝟙 at the first sample, so r = p·w̃ᵀw̃, and λ = 1.
fn a_step_leaves_the_stated_part_of_s<T: Scalar>() {
    for variance in [0.01, 1.0, 1e4] {
        let mut rule = RecursiveLeastSquares::new(real::<T>(variance)).unwrap();
        let mut network = network::<T>();
        let firing = network.fire(&SVector::from([0.3, -0.4].map(real)));
        let s = real::<T>(3.0);
        rule.adapt(&mut network, &firing, s, real(0.1));
        let left = s / (T::one() + real::<T>(variance) * firing.norm_squared());
        assert_abs_diff_eq!(s - network.output(&firing), left, epsilon = ulps(64.0));
    }
}

/// e rests, 10 000 memories long: one direction is excited, and eight are not. Plain forgetting would multiply those by e^10000.
fn what_was_learned_elsewhere_is_kept_while_the_error_rests<T: Scalar>() {
    let mut rule = RecursiveLeastSquares::new(real::<T>(100.0)).unwrap();
    rule = rule.with_memory(real(0.5)).unwrap();
    let mut network = network::<T>();
    let [here, there] =
        [[0.3, -0.4], [-1.0, 2.0]].map(|e| network.fire(&SVector::from(e.map(real))));
    for _ in 0..20 {
        told(&mut rule, &mut network, &there, real(2.0));
        told(&mut rule, &mut network, &here, T::zero());
    }
    let known = network.output(&there);
    let mut uncertainty = T::zero();
    for k in 0..50_000 {
        told(&mut rule, &mut network, &here, T::one());
        // In the direction of the sample P comes to rest within the memory of five samples, and stays there.
        if k == 300 {
            uncertainty = rule.uncertainty();
        } else if k > 300 {
            let rounding = uncertainty * ulps(4096.0);
            assert_abs_diff_eq!(rule.uncertainty(), uncertainty, epsilon = rounding);
        }
    }
    assert_abs_diff_eq!(network.output(&here), T::one(), epsilon = ulps(64.0));
    // It has moved by what the grid itself carries over from here to there, w̃ᵀṽ/w̃ᵀw̃ < 0.1.
    assert!((network.output(&there) - known).abs() < real(0.1));
}

/// With λ = ½, w̃ᵀPw̃ would go to 1 − λ = ½ wherever e rests, and 9·p is 0.09.
fn forgetting_does_not_pass_the_covariance_of_the_beginning<T: Scalar>() {
    let mut rule = RecursiveLeastSquares::new(real::<T>(0.01)).unwrap();
    rule = rule.with_memory(real(1e-3)).unwrap();
    let (mut network, mut rng) = (network::<T>(), rng());
    let most = real::<T>(0.09) * (T::one() + ulps(64.0));
    for k in 0..2000 {
        let e = if k < 1000 { [0.3, -0.4] } else { [0, 1].map(|_| rng.random_range(-3.0..3.0)) };
        let firing = network.fire(&SVector::from(e.map(real)));
        told(&mut rule, &mut network, &firing, T::one());
        assert!(rule.uncertainty() <= most, "{k}: {}", rule.uncertainty());
    }
    assert!(rule.uncertainty() > real(0.08));
}

/// Noise of all sizes, rests and walks, in a network whose covariance loses and regains ten decades.
fn nothing_becomes_non_finite_in_a_million_samples<T: Scalar>() {
    let mut rule =
        RecursiveLeastSquares::new(real::<T>(1e6)).unwrap().with_memory(real(2.0)).unwrap();
    let (mut network, mut rng) = (network::<T>(), rng());
    let most = real::<T>(9e6) * (T::one() + ulps(1024.0));
    let mut e = SVector::<T, 2>::zeros();
    for k in 0..1_000_000_u32 {
        if k / 1000 % 2 == 0 {
            e = SVector::from([0, 1].map(|_| real(rng.random_range(-3.0..3.0))));
        }
        let firing = network.fire(&e);
        let s = real::<T>(rng.random_range(-1.0..1.0)) - network.output(&firing);
        rule.adapt(&mut network, &firing, s, real(if k % 7 == 0 { 0.5 } else { 0.001 }));
        let uncertainty = rule.uncertainty();
        assert!(uncertainty >= T::zero() && uncertainty <= most, "{k}: {uncertainty}");
        // Of numbers within ±1 no consequent that counts is a large one.
        assert!(network.output(&firing).abs() <= real(2.0), "{k}");
    }
}

fn a_parameter_out_of_range_is_refused<T: Scalar>() {
    let fresh = |variance: f64| RecursiveLeastSquares::<T, 2, 3>::new(real(variance));
    for bad in [0.0, -1.0] {
        assert_eq!(fresh(bad).unwrap_err(), Error::NotPositive { name: "variance", value: bad });
        assert_eq!(
            fresh(1.0).unwrap().with_memory(real(bad)).unwrap_err(),
            Error::NotPositive { name: "memory", value: bad }
        );
    }
    for bad in NOT_FINITE {
        assert!(matches!(fresh(bad), Err(Error::NonFinite { name: "variance", .. })));
        assert!(matches!(
            fresh(1.0).unwrap().with_memory(real(bad)),
            Err(Error::NonFinite { name: "memory", .. })
        ));
    }
    let greatest = T::max_value().unwrap();
    assert!(matches!(
        RecursiveLeastSquares::<T, 2, 3>::new(greatest),
        Err(Error::NonFinite { name: "trace of the covariance", .. })
    ));
}
