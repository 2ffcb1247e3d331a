use crate::{Scalar, scalar::constant};

/// The quantile that is estimated.
const P: f64 = 0.95;

/// A running estimate of the 95 % quantile of values that are not kept, by the P² algorithm.
///
/// Five markers stand at the least value, the quantiles P/2, P and (1 + P)/2, and the largest value. Each new value shifts the ranks; a marker
/// more than a rank from where it belongs moves by one, along the parabola through it and its neighbours.
///
/// # References
/// R. Jain, I. Chlamtac, "The P² algorithm for dynamic calculation of quantiles and histograms without storing observations", Communications of the
/// ACM 28(10), 1985.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Quantile<T> {
    count: u32,
    heights: [T; 5],
    ranks: [u32; 5],
}

impl<T: Scalar> Quantile<T> {
    pub fn new() -> Self {
        Self { count: 0, heights: [T::zero(); 5], ranks: [0, 1, 2, 3, 4] }
    }

    /// How many values there were.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// The estimate; of fewer than five values, the largest.
    pub fn value(&self) -> T {
        if self.count < 5 {
            self.heights.into_iter().take(self.count as usize).fold(T::zero(), T::max)
        } else {
            self.heights[2]
        }
    }

    /// Takes a value ≥ 0. After 2³² of them the estimate stays.
    pub fn push(&mut self, x: T) {
        let Some(count) = self.count.checked_add(1) else { return };
        if let Some(slot) = self.heights.get_mut(self.count as usize) {
            *slot = x;
            if count == 5 {
                sort(&mut self.heights);
            }
        } else {
            self.shift(x);
            self.settle(count);
        }
        self.count = count;
    }

    /// Counts `x` among the ranks, and widens the range to it.
    fn shift(&mut self, x: T) {
        let [least, .., largest] = &mut self.heights;
        *least = least.min(x);
        *largest = largest.max(x);
        let [_, inner @ .., _] = self.heights;
        let [_, ranks @ .., last] = &mut self.ranks;
        for (rank, height) in ranks.iter_mut().zip(inner) {
            *rank += u32::from(x < height);
        }
        *last += 1;
    }

    /// Moves the inner markers to where they belong among `count` values.
    fn settle(&mut self, count: u32) {
        for (i, share) in [(1, P / 2.0), (2, P), (3, (1.0 + P) / 2.0)] {
            let wanted = f64::from(count - 1) * share;
            let off = wanted - f64::from(self.ranks[i]);
            let (below, above) =
                (self.ranks[i] - self.ranks[i - 1], self.ranks[i + 1] - self.ranks[i]);
            if off >= 1.0 && above > 1 {
                self.heights[i] = self.moved(i, i + 1, T::one());
                self.ranks[i] += 1;
            } else if off <= -1.0 && below > 1 {
                self.heights[i] = self.moved(i, i - 1, -T::one());
                self.ranks[i] -= 1;
            }
        }
    }

    /// The height of marker `i` a rank up or down: on the parabola, or on the line to the neighbour `to` where that leaves the order.
    fn moved(&self, i: usize, to: usize, by: T) -> T {
        let [low, here, high] = [self.heights[i - 1], self.heights[i], self.heights[i + 1]];
        let gap =
            |from: usize, to: usize| constant::<T>(f64::from(self.ranks[to] - self.ranks[from]));
        let (below, above) = (gap(i - 1, i), gap(i, i + 1));
        let rise = (below + by) * (high - here) / above + (above - by) * (here - low) / below;
        let parabola = here + by / (below + above) * rise;
        if low < parabola && parabola < high {
            return parabola;
        }
        let distance = if to > i { above } else { below };
        here + (self.heights[to] - here) / distance
    }
}

/// Insertion sort; the values are finite.
fn sort<T: Scalar>(values: &mut [T; 5]) {
    for end in 1..5 {
        for i in (0..end).rev() {
            if values[i] > values[i + 1] {
                values.swap(i, i + 1);
            }
        }
    }
}

checked! {
    [T: Scalar] Quantile<T>, [T] { count: u32, heights: [T; 5], ranks: [u32; 5] } =>
    known("marker", heights).and_then(|()| {
        for (low, high) in heights.into_iter().zip(heights.into_iter().skip(1)) {
            // The first five values are sorted when they are complete.
            not_negative("distance of markers", if count < 5 { low } else { high - low })?;
        }
        not_negative("least marker", heights[0])?;
        for (low, high) in ranks.into_iter().zip(ranks.into_iter().skip(1)) {
            positive("distance of ranks", f64::from(high) - f64::from(low))?;
        }
        let (last, expected) = (ranks[4], count.max(5) - 1);
        if ranks[0] != 0 || last != expected {
            let [expected, found] = [expected, last].map(|rank| rank as usize);
            return Err(crate::Error::Length { name: "ranks", expected, found });
        }
        Ok(Self { count, heights, ranks })
    })
}
