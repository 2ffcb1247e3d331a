//! What is seen of a decade of the run.

use std::time::{Duration, Instant};

use brunovsky::{controller::ClelcCommand, prelude::*};

use crate::statistics::Batches;

/// `value` as f64.
pub fn real<T: Scalar>(value: T) -> f64 {
    value.to_subset_unchecked()
}

/// Whether `value` is subnormal as a number of its own type.
fn subnormal<T: Scalar>(value: T) -> bool {
    let least = if real(T::default_epsilon()) > 1e-10 {
        f32::MIN_POSITIVE.into()
    } else {
        f64::MIN_POSITIVE
    };
    !value.is_zero() && real(value).abs() < least
}

/// A decade of the run.
pub struct Decade {
    first: u64,
    steps: u64,
    /// e₁, e₁² and (u_n + Δ)².
    batches: Batches<3>,
    /// The largest |consequent|, and the largest that is left of one after projection on w̃.
    consequents: [f64; 2],
    /// The subnormal numbers among u, u_n and s, and among parameters and firing strengths whenever looked into.
    pub subnormal: u64,
    begun: Instant,
    took: Duration,
}

impl Decade {
    pub const HEADER: [&str; 7] = [
        "variant",
        "from step",
        "mean e₁ in µm",
        "rms e₁ in µm",
        "rms u_n + Δ in mm/s²",
        "largest f, and off w̃",
        "ns a step",
    ];

    pub fn new(first: u64, end: u64) -> Self {
        Self {
            first,
            steps: end - first,
            batches: Batches::new(end - first),
            consequents: [0.0; 2],
            subnormal: 0,
            begun: Instant::now(),
            took: Duration::ZERO,
        }
    }

    /// A sample, with the true error and Δ.
    pub fn see<T: Scalar>(&mut self, e_1: f64, delta: f64, command: &ClelcCommand<T>) {
        let left = real(command.u_n) + delta;
        self.batches.add([e_1, e_1 * e_1, left * left]);
        let subnormal = [command.u, command.u_n, command.s].map(subnormal);
        self.subnormal += subnormal.map(u64::from).iter().sum::<u64>();
    }

    /// The network at the error `e`.
    pub fn look_into<T: Scalar>(&mut self, network: &FuzzyNetwork<T, 2, 3>, e: &SVector<T, 2>) {
        let firing = network.fire(e);
        let (f, w) = (network.consequents(), firing.strengths());
        let rows = network.memberships();
        let antecedents = rows.iter().flatten().flat_map(|m| [m.centre(), m.width()]);
        let all = antecedents.chain(f.iter().chain(w.iter()).copied());
        self.subnormal += all.filter(|value| subnormal(*value)).count() as u64;

        let pairs = || f.iter().zip(w.iter()).map(|(f, w)| (real(*f), real(*w)));
        let along =
            pairs().map(|(f, w)| f * w).sum::<f64>() / pairs().map(|(_, w)| w * w).sum::<f64>();
        let [largest, astray] = &mut self.consequents;
        for (f, w) in pairs() {
            *largest = largest.max(f.abs());
            *astray = astray.max((f - along * w).abs());
        }
    }

    pub fn over(mut self) -> Self {
        self.took = self.begun.elapsed();
        self
    }

    /// The part of the consequents off w̃, in relation to the largest.
    pub fn astray(&self) -> f64 {
        self.consequents[1] / self.consequents[0]
    }

    /// A row of the table. A figure that is more than four standard errors from that of the `last` decade is marked.
    pub fn row(&self, name: &str, last: Option<&Self>) -> [String; 7] {
        let [mean, square, left] = self.batches.means();
        let marks = last.map_or([""; 3], |last| {
            let [a, b, c] = last.batches.means();
            [mean.apart(&a), square.apart(&b), left.apart(&c)]
                .map(|apart| if apart > 4.0 { " *" } else { "" })
        });
        let root = |square: &crate::statistics::Estimate, unit: f64| {
            let rms = square.mean.sqrt();
            // d√x = dx/(2√x).
            format!("{:.3} ± {:.3}", rms * unit, square.half_width() / (2.0 * rms) * unit)
        };
        [
            name.to_owned(),
            format!("10^{}", self.first.max(1).ilog10()),
            format!("{:.3} ± {:.3}{}", mean.mean * 1e6, mean.half_width() * 1e6, marks[0]),
            root(&square, 1e6) + marks[1],
            root(&left, 1e3) + marks[2],
            format!("{:.3}, {:.0e}", self.consequents[0], self.consequents[1]),
            format!("{:.0}", self.took.as_nanos() as f64 / self.steps as f64),
        ]
    }
}
