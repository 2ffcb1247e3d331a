//! The interval of the mean against Student's distribution in closed form, and its coverage.

use brunovsky::ensemble::{Run, rand::RngExt};
use core::f64::consts::{FRAC_PI_2, PI};
use rand_distr::{Distribution, StandardNormal};

use crate::support::{assert_plausible, given};

const LEVELS: [f64; 4] = [0.001, 0.5, 0.95, 0.999];

/// With n = 2, s/√2 = |x₁ − x₂|/2, and T is Cauchy: t = tan(π·level/2). With n = 3, t = level·√(2/(1 − level²)).
#[test]
fn small_samples_have_closed_forms() {
    for level in LEVELS {
        let [two] = given(&[1.0, 4.0]).summaries(level).unwrap();
        let mean = two.mean().unwrap();
        assert_eq!(mean.value, 2.5);
        approx::assert_relative_eq!(
            mean.high - 2.5,
            (FRAC_PI_2 * level).tan() * 1.5,
            max_relative = 1e-9
        );
        approx::assert_relative_eq!(mean.high - 2.5, 2.5 - mean.low, max_relative = 1e-12);

        let [three] = given(&[1.0, 4.0, 7.0]).summaries(level).unwrap();
        let t = level * (2.0 / (1.0 - level * level)).sqrt();
        assert_eq!((three.mean().unwrap().value, three.deviation().unwrap()), (4.0, 3.0));
        approx::assert_relative_eq!(
            three.mean().unwrap().high - 4.0,
            t * 3.0 / 3.0_f64.sqrt(),
            max_relative = 1e-9
        );
    }
}

/// One value says where the mean may be, and nothing of how far off that is.
#[test]
fn one_run_has_a_mean_and_no_interval() {
    let [one] = given(&[3.0]).summaries(0.95).unwrap();
    let mean = one.mean().unwrap();
    assert_eq!((mean.value, mean.low, mean.high), (3.0, f64::NEG_INFINITY, f64::INFINITY));
    assert!(one.deviation().is_err());
}

/// ∫ of Student's density, Γ((ν+1)/2)/(Γ(ν/2)·√(νπ))·(1 + x²/ν)^(−(ν+1)/2), over [−t, t] by Simpson's rule is the level. The density is
/// written relative to its integral over the line, x = √ν·tan φ: ∫ cos^(ν−1) φ dφ.
#[test]
fn the_interval_is_that_of_students_density() {
    for n in [4_usize, 10, 100, 1000, 1001, 1002, 5000, 100_000] {
        // n values of mean 0 and s² = n/(n−1), or nearly so if n is odd.
        let values: Vec<f64> = (0..n).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 }).collect();
        for level in LEVELS {
            let [summary] = given(&values).summaries(level).unwrap();
            let mean = summary.mean().unwrap();
            let half = 0.5 * (mean.high - mean.low);
            let t = half / (summary.deviation().unwrap() / (n as f64).sqrt());
            let nu = (n - 1) as f64;
            let angle = (t / nu.sqrt()).atan();
            // Beyond ten standard deviations of φ, about 1/√ν, nothing is left; for small ν all of it is taken.
            let end = (12.0 / nu.sqrt()).min(PI / 2.0);
            let inside = simpson(angle, |phi| phi.cos().powf(nu - 1.0));
            let all = simpson(end, |phi| phi.cos().max(0.0).powf(nu - 1.0));
            approx::assert_relative_eq!(inside / all, level, max_relative = 1e-8);
        }
    }
}

fn simpson(end: f64, f: impl Fn(f64) -> f64) -> f64 {
    let steps = 20_000;
    let weight = |k| {
        if k == 0 || k == steps {
            1.0
        } else if k % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    let h = end / f64::from(steps);
    (0..=steps).map(|k| weight(k) * f(f64::from(k) * h)).sum::<f64>() * h / 3.0
}

/// Student's interval covers the mean of normal values with exactly its level, whatever n.
#[test]
fn the_interval_covers_the_mean_of_normal_values_at_its_level() {
    let trials = 5000;
    for (n, level) in [(3, 0.95), (10, 0.5), (30, 0.9)] {
        let covered = |trial| {
            let mut run = Run::new(21, trial);
            let values: Vec<f64> = (0..n).map(|_| 2.0 + 3.0 * normal(&mut run)).collect();
            let [summary] = given(&values).summaries(level).unwrap();
            summary.mean().unwrap().covers(2.0)
        };
        let hits = (0..trials).filter(|&trial| covered(trial)).count();
        assert_plausible(hits as u32, trials as u32, level);
    }
}

fn normal(run: &mut Run) -> f64 {
    StandardNormal.sample(run)
}

/// For a skewed figure the documentation promises the level in the limit only: of the exponential's means with n = 5 fewer than 0.95 are covered,
/// with n = 2000 as many as are due.
#[test]
fn for_skewed_values_the_level_holds_in_the_limit() {
    let hits = |n, trials| {
        let covered = |trial| {
            let mut run = Run::new(22, trial);
            let values: Vec<f64> = (0..n).map(|_| -(1.0 - run.random::<f64>()).ln()).collect();
            given(&values).summaries(0.95).unwrap()[0].mean().unwrap().covers(1.0)
        };
        (0..trials).filter(|&trial| covered(trial)).count() as u32
    };
    assert!(hits(5, 2000) < 1850);
    assert_plausible(hits(2000, 2000), 2000, 0.95);
}

/// Sums that leave the range of numbers are an error, not an interval.
#[test]
fn overflow_is_an_error() {
    let [summary] = given(&[f64::MAX, -f64::MAX]).summaries(0.95).unwrap();
    assert!(summary.mean().is_err());
    assert!(summary.deviation().is_err());
    assert_eq!(summary.worst().unwrap().value, f64::MAX);
}
