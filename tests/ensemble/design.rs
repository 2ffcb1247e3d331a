//! Grids in the order of nested loops, and Latin hypercubes with one point in each stratum.

use std::collections::BTreeSet;

use brunovsky::{
    Error,
    ensemble::{Axis, Design, Levels},
};
use proptest::prelude::*;

#[test]
fn a_grid_is_in_the_order_of_nested_loops() {
    let (a, b, c) = ([1.0, 2.0], [0.5], [-1.0, 0.0, 1.0]);
    let levels = |name, values: &[f64]| Levels::new(name, values.to_vec()).unwrap();
    let grid = Design::grid([levels("a", &a), levels("b", &b), levels("c", &c)]);
    let mut wanted = Vec::new();
    for a in a {
        for b in b {
            for c in c {
                wanted.push([a, b, c]);
            }
        }
    }
    assert_eq!(grid.points(), wanted);
    assert_eq!(grid.names(), &["a", "b", "c"]);
}

#[test]
fn levels_are_evenly_spaced_and_hit_both_ends() {
    let linear = Axis::linear("k", 0.1, 0.7).unwrap().levels(7).unwrap();
    let logarithmic = Axis::logarithmic("k", 0.3, 30.0).unwrap().levels(5).unwrap();
    assert_eq!((linear.values()[0], linear.values()[6]), (0.1, 0.7));
    assert_eq!((logarithmic.values()[0], logarithmic.values()[4]), (0.3, 30.0));
    for pair in linear.values().windows(2) {
        approx::assert_relative_eq!(pair[1] - pair[0], 0.1, max_relative = 1e-14);
    }
    for pair in logarithmic.values().windows(2) {
        approx::assert_relative_eq!(pair[1] / pair[0], 10.0_f64.sqrt(), max_relative = 1e-14);
    }
    assert_eq!(Axis::linear("k", 0.1, 0.7).unwrap().levels(1).unwrap().values(), [0.1]);
}

proptest! {
    /// Undoing the scale of the axis gives the stratum: each one occurs once.
    #[test]
    fn a_latin_hypercube_has_one_point_in_each_stratum(count in 1..200_u32, seed: u64) {
        let axes = [
            Axis::linear("mass", 0.0, 1.0).unwrap(),
            Axis::linear("start", -3.0, 5.0).unwrap(),
            Axis::logarithmic("gain", 0.01, 100.0).unwrap(),
        ];
        let design = Design::latin_hypercube(axes, count, seed).unwrap();
        let shares = [|x: f64| x, |x: f64| (x + 3.0) / 8.0, |x: f64| (x / 0.01).ln() / 1e4_f64.ln()];
        prop_assert_eq!(design.points().len(), count as usize);
        for (k, share) in shares.iter().enumerate() {
            let strata: BTreeSet<u32> =
                design.points().iter().map(|x| (share(x[k]) * f64::from(count)) as u32).collect();
            prop_assert_eq!(strata, (0..count).collect());
        }
    }

    /// The shuffles of two axes differ, and a seed decides them; another axis leaves those before it as they are.
    #[test]
    fn a_latin_hypercube_follows_from_its_seed(seed: u64) {
        let axis = |name| Axis::linear(name, 0.0, 1.0).unwrap();
        let two = Design::latin_hypercube([axis("a"), axis("b")], 40, seed).unwrap();
        let three = Design::latin_hypercube([axis("a"), axis("b"), axis("c")], 40, seed).unwrap();
        for (two, three) in two.points().iter().zip(three.points()) {
            prop_assert_eq!(two, &three[..2]);
        }
        let pairs = two.points().iter().filter(|[a, b]| (a * 40.0) as u32 == (b * 40.0) as u32);
        prop_assert!(pairs.count() < 20);
        let other = Design::latin_hypercube([axis("a"), axis("b")], 40, seed ^ 1).unwrap();
        prop_assert_ne!(two.points(), other.points());
    }
}

/// The mean of f(x) = Σ xᵢ over a Latin hypercube of n points errs by the places inside the strata alone: its variance is D/(12·n³) where
/// that of independent points is D/(12·n).
#[test]
fn a_latin_hypercube_integrates_sums_with_a_smaller_error() {
    let axis = |name| Axis::linear(name, 0.0, 1.0).unwrap();
    let (n, trials) = (20_u32, 4000);
    let square = |seed| {
        let design = Design::latin_hypercube([axis("a"), axis("b")], n, seed).unwrap();
        let mean = design.points().iter().map(|[a, b]| a + b).sum::<f64>() / f64::from(n);
        (mean - 1.0).powi(2)
    };
    let variance = (0..trials).map(square).sum::<f64>() / trials as f64;
    // The variance of 4000 nearly normal squares is 2/4000: a deviation of 2.2 %, five of which are 11 %.
    approx::assert_relative_eq!(variance, 2.0 / 12.0 / f64::from(n).powi(3), max_relative = 0.11);
}

#[test]
fn what_is_no_range_is_refused_by_the_name_of_the_axis() {
    let below = |low, limit| Err(Error::NotBelow { name: "k", value: low, limit });
    assert_eq!(Axis::linear("k", 1.0, 1.0), below(1.0, 1.0));
    assert_eq!(Axis::linear("k", 2.0, 1.0), below(2.0, 1.0));
    assert_eq!(Axis::logarithmic("k", 0.0, 1.0), Err(Error::NotPositive { name: "k", value: 0.0 }));
    assert!(matches!(Axis::linear("k", f64::NAN, 1.0), Err(Error::NonFinite { name: "k", .. })));
    assert!(matches!(
        Axis::linear("k", 0.0, f64::INFINITY),
        Err(Error::NonFinite { name: "k", .. })
    ));
    let axis = Axis::linear("k", 0.0, 1.0).unwrap();
    assert_eq!(axis.levels(0), Err(Error::Missing { name: "level" }));
    assert_eq!(Design::latin_hypercube([axis], 0, 0), Err(Error::Missing { name: "point" }));
    assert_eq!(Design::<1>::listed(["k"], Vec::new()), Err(Error::Missing { name: "point" }));
    let bad = Design::listed(["k", "m"], vec![[0.0, f64::NAN]]);
    assert!(matches!(bad, Err(Error::NonFinite { name: "m", .. })));
    assert!(matches!(Levels::new("k", vec![f64::NAN]), Err(Error::NonFinite { name: "k", .. })));
}
