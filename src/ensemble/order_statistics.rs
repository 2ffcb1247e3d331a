use std::vec::Vec;

/// The rank k ∈ 1…n of the p-quantile of n ≥ 1 ordered values: the least k with k/n ≥ p.
pub(super) fn rank(count: usize, p: f64) -> usize {
    let n = count as f64;
    let rank = (n * p).ceil();
    // n·p is rounded and may lie above the whole number that it is.
    let rank = if (rank - 1.0) / n >= p { rank - 1.0 } else { rank };
    (rank as usize).clamp(1, count)
}

/// Ranks (l, u) for which the l-th and the u-th of n ordered values enclose the p-quantile with a confidence of at least `level`, half of what
/// is missing on either side; l = 0 or u = n + 1 where the values say nothing.
///
/// As many values as are at most the quantile are B ~ Bin(n, p) if the distribution is continuous: P(B < l) and P(B ≥ u) are at most
/// (1 − level)/2, and l is the largest, u the smallest such rank. Distributions with atoms are enclosed with more confidence.
pub(super) fn ranks(count: usize, p: f64, level: f64) -> (usize, usize) {
    let (first, masses) = binomial(count, p);
    let tail = 0.5 * (1.0 - level);
    let beyond = |mass: &f64, sum: &mut f64| {
        *sum += mass;
        *sum > tail
    };
    let mut sum = 0.0;
    let below = masses.iter().position(|mass| beyond(mass, &mut sum)).unwrap_or(masses.len());
    sum = 0.0;
    let above = masses.iter().rposition(|mass| beyond(mass, &mut sum)).map_or(0, |k| k + 1);
    (first + below, first + above)
}

/// P(B = first), P(B = first + 1), … of B ~ Bin(n, p), as far as they count.
///
/// From the mode to both sides by P(k + 1)/P(k) = (n − k)/(k + 1)·p/(1 − p), then divided by the sum: some 20·√n terms, each exact to rounding.
fn binomial(count: usize, p: f64) -> (usize, Vec<f64>) {
    const NEGLIGIBLE: f64 = 1e-30;
    let odds = p / (1.0 - p);
    let ratio = |k: usize| (count - k) as f64 / (k + 1) as f64 * odds;
    let mode = (((count + 1) as f64 * p) as usize).min(count);
    let mut masses = Vec::new();
    let (mut first, mut mass) = (mode, 1.0);
    while first > 0 && mass > NEGLIGIBLE {
        mass /= ratio(first - 1);
        first -= 1;
        masses.push(mass);
    }
    masses.reverse();
    masses.push(1.0);
    let (mut last, mut mass) = (mode, 1.0);
    while last < count && mass > NEGLIGIBLE {
        mass *= ratio(last);
        last += 1;
        masses.push(mass);
    }
    let total: f64 = masses.iter().sum();
    for mass in &mut masses {
        *mass /= total;
    }
    (first, masses)
}
