//! CLELC for a chain of integrators as one writes it down from the equations: a grade for every membership, a product for every rule,
//! one sum and one quotient. The same discretization as the crate's (set-valued sign, closed-form antecedents).

// Indices as the equations have them.
#![allow(clippy::needless_range_loop)]

use brunovsky::Scalar;

pub struct Textbook<T> {
    gains: Vec<T>,
    reach: T,
    dt: T,
    centres: Vec<Vec<T>>,
    widths: Vec<Vec<T>>,
    consequents: Vec<T>,
    last: Option<Vec<T>>,
}

fn real<T: Scalar>(value: f64) -> T {
    brunovsky::nalgebra::convert(value)
}

impl<T: Scalar> Textbook<T> {
    /// `n` inputs with `k` memberships over \[−range, range\].
    pub fn new(n: usize, k: usize, lambda: f64, alpha: f64, dt: f64, range: f64) -> Self {
        let spacing = 2.0 * range / (k - 1) as f64;
        let centre = |j: usize| real(-range + spacing * j as f64);
        let binomial = |j: usize| (0..j).fold(1.0, |c, m| c * (n - m) as f64 / (m + 1) as f64);
        Self {
            gains: (0..n).map(|i| real(binomial(n - i) * lambda.powi((n - i) as i32))).collect(),
            reach: real(alpha * dt),
            dt: real(dt),
            centres: vec![(0..k).map(centre).collect(); n],
            widths: vec![vec![real(spacing); k]; n],
            consequents: vec![real(0.0); k.pow(n as u32)],
            last: None,
        }
    }

    /// The input for state `x`, reference 0.
    pub fn update(&mut self, x: &[T]) -> T {
        let (n, k) = (self.centres.len(), self.centres[0].len());
        let e: Vec<T> = x.iter().map(|x| -*x).collect();
        let last = self.last.replace(e.clone()).unwrap_or_else(|| e.clone());
        for i in 0..n {
            for centre in &mut self.centres[i] {
                *centre += e[i] - last[i];
            }
        }

        let mut strengths = vec![real::<T>(1.0); self.consequents.len()];
        for (r, strength) in strengths.iter_mut().enumerate() {
            let mut rest = r;
            for i in (0..n).rev() {
                let m = (e[i] - self.centres[i][rest % k]) / self.widths[i][rest % k];
                *strength *= (m * m * real(-0.5)).exp();
                rest /= k;
            }
        }
        let sum = strengths.iter().fold(real::<T>(0.0), |sum, w| sum + *w);
        for strength in &mut strengths {
            *strength /= sum;
        }

        let mut u_b = real::<T>(0.0);
        for i in 0..n {
            u_b += self.gains[i] * e[i];
        }
        let s = (e[n - 1] - last[n - 1]) / self.dt + u_b;
        let step = s.clamp(-self.reach, self.reach);
        let norm = strengths.iter().fold(real::<T>(0.0), |sum, w| sum + *w * *w);
        for (f, w) in self.consequents.iter_mut().zip(&strengths) {
            *f += *w / norm * step;
        }
        for i in 0..n {
            // M² may stay between 0.01 and 100, for all memberships of an input alike.
            let distance = |j: usize| (e[i] - self.centres[i][j]) / self.widths[i][j];
            let squares: Vec<T> = (0..k).map(|j| distance(j) * distance(j)).collect();
            let lowest = squares.iter().fold(squares[0], |low, m2| low.min(*m2));
            let highest = squares.iter().fold(squares[0], |high, m2| high.max(*m2));
            if lowest < real(0.005) {
                continue;
            }
            let down = ((real::<T>(0.01) - lowest) * real(0.5)).min(real(0.0));
            let up = ((real::<T>(100.0) - highest) * real(0.5)).max(real(0.0));
            let tau = step.max(down).min(up);
            for j in 0..k {
                let d = (e[i] - self.centres[i][j]) * (-tau).exp();
                self.centres[i][j] = e[i] - d;
                self.widths[i][j] = d.abs() / (squares[j] + tau + tau).sqrt();
            }
        }
        let u_n = strengths
            .iter()
            .zip(&self.consequents)
            .fold(real::<T>(0.0), |sum, (w, f)| sum + *w * *f);
        u_b + u_n
    }
}
