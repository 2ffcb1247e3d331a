//! Means with confidence intervals, from the means of batches.

/// The number of batches that a stretch is divided into.
const BATCHES: u64 = 20;

/// The sums of N quantities over batches of equal length. Where a batch is much longer than the memory of the process, their means are as good
/// as independent.
pub struct Batches<const N: usize> {
    length: u64,
    left: u64,
    running: [f64; N],
    sum: [f64; N],
    sum_of_squares: [f64; N],
}

impl<const N: usize> Batches<N> {
    /// For a stretch of `samples`, of which a remainder that fills no batch is left out.
    pub fn new(samples: u64) -> Self {
        let length = samples / BATCHES;
        let zero = [0.0; N];
        Self { length, left: length, running: zero, sum: zero, sum_of_squares: zero }
    }

    pub fn add(&mut self, values: [f64; N]) {
        for (running, value) in self.running.iter_mut().zip(values) {
            *running += value;
        }
        self.left -= 1;
        if self.left == 0 {
            for (i, running) in self.running.iter_mut().enumerate() {
                let mean = core::mem::take(running) / self.length as f64;
                self.sum[i] += mean;
                self.sum_of_squares[i] += mean * mean;
            }
            self.left = self.length;
        }
    }

    pub fn means(&self) -> [Estimate; N] {
        let count = BATCHES as f64;
        core::array::from_fn(|i| {
            let mean = self.sum[i] / count;
            let variance = (self.sum_of_squares[i] / count - mean * mean) / (count - 1.0);
            Estimate { mean, error: variance.max(0.0).sqrt() }
        })
    }
}

/// A mean and its standard error.
#[derive(Clone, Copy)]
pub struct Estimate {
    pub mean: f64,
    error: f64,
}

impl Estimate {
    /// Half the confidence interval of 95 %, by Student's t distribution with 19 degrees of freedom.
    pub fn half_width(&self) -> f64 {
        2.093 * self.error
    }

    /// How many standard errors of their difference two means are apart.
    pub fn apart(&self, other: &Self) -> f64 {
        (self.mean - other.mean).abs() / self.error.hypot(other.error)
    }
}
