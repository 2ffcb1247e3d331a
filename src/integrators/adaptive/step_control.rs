use crate::{Scalar, scalar::constant};

/// The proportional–integral control of the step size: h⁺ = h·0.9·ε⁻ᵅ·ε₋₁ᵝ, with ε the error of this step in units of the tolerance and
/// ε₋₁ that of the step before.
///
/// For an estimate that falls like hᵏ, β = 0.2/k and α = 1/k − 0.75·β (0.04 and 0.17 for k = 5). A step grows at most tenfold and shrinks
/// at most fivefold.
///
/// # References
/// K. Gustafsson, M. Lundh, G. Söderlind, "A PI stepsize control for the numerical solution of ordinary differential equations", BIT 28, 1988.
/// E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, IV.2, for α and β.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StepControl<T> {
    /// ln ε₋₁: a sum of logarithms costs less than two powers.
    last: T,
}

impl<T: Scalar> StepControl<T> {
    /// No step yet: as after one with an error of 10⁻⁴.
    pub(crate) fn new() -> Self {
        Self { last: constant::<T>(1e-4).ln() }
    }

    /// After a step of `error` ≤ 1 whose length it chose: how much longer the next one may be.
    pub(crate) fn accepted(&mut self, error: T, k: i32) -> T {
        let size = error.ln();
        let growth = self.growth(size, k);
        self.last = size.max(constant::<T>(1e-4).ln());
        growth
    }

    /// After a step of `error` ≤ 1 that was cut short: how much longer the next one may be.
    pub(crate) fn cut_short(&self, error: T, k: i32) -> T {
        self.growth(error.ln(), k)
    }

    fn growth(&self, size: T, k: i32) -> T {
        let (alpha, beta) = exponents::<T>(k);
        let growth = (self.last * beta - size * alpha).exp() * constant(0.9);
        growth.min(constant(10.0)).max(constant(0.2))
    }

    /// How much shorter a step has to be after one of `error` > 1, or of one that met a number that is not finite.
    pub(crate) fn rejected(error: Option<T>, k: i32) -> T {
        error.map_or(constant(0.1), |error| {
            let (alpha, _) = exponents::<T>(k);
            (error.powf(-alpha) * constant(0.9)).max(constant(0.2))
        })
    }
}

fn exponents<T: Scalar>(k: i32) -> (T, T) {
    let k = f64::from(k);
    let beta = 0.2 / k;
    (constant(1.0 / k - 0.75 * beta), constant(beta))
}
