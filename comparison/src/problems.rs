//! Standard problems ẋ = f(x), with the ends of their solutions.
//!
//! # References
//! E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, II.0 (Arenstorf), I.16 (Brusselator).
//! E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, IV.10 (Van der Pol, Robertson), with the reference solutions of
//! their test set.

use anyhow::Result;

use crate::contenders::ode_solvers::reference;

pub trait Problem<const N: usize>: 'static {
    const NAME: &'static str;
    const START: [f64; N];
    const END: f64;
    /// The tolerances to solve it at.
    const DIGITS: core::ops::RangeInclusive<i32>;
    /// atol in units of rtol.
    const ABSOLUTE: [f64; N];

    fn rate(x: &[f64; N]) -> [f64; N];

    /// ∂f/∂x by rows.
    fn jacobian(x: &[f64; N]) -> [[f64; N]; N];

    /// x at the end.
    fn end() -> Result<[f64; N]>;

    /// What an error is measured by: the largest component, if the problem does not say otherwise.
    fn scale(end: &[f64; N]) -> [f64; N] {
        [end.iter().fold(0.0_f64, |scale, x| scale.max(x.abs())); N]
    }
}

/// e^(−t/2) at 3 rad/s in the plane, in closed form.
pub struct DampedOscillator;

impl Problem<2> for DampedOscillator {
    const NAME: &'static str = "damped oscillator, linear";
    const START: [f64; 2] = [1.0, 0.0];
    const END: f64 = 10.0;
    const DIGITS: core::ops::RangeInclusive<i32> = 3..=12;
    const ABSOLUTE: [f64; 2] = [1e-2; 2];

    fn rate(x: &[f64; 2]) -> [f64; 2] {
        [-0.5 * x[0] - 3.0 * x[1], 3.0 * x[0] - 0.5 * x[1]]
    }

    fn jacobian(_: &[f64; 2]) -> [[f64; 2]; 2] {
        [[-0.5, -3.0], [3.0, -0.5]]
    }

    fn end() -> Result<[f64; 2]> {
        let radius = (-0.5 * Self::END).exp();
        Ok([radius * (3.0 * Self::END).cos(), radius * (3.0 * Self::END).sin()])
    }
}

/// ẍ = 5·(1 − x²)·ẋ − x.
pub struct VanDerPol;

impl Problem<2> for VanDerPol {
    const NAME: &'static str = "Van der Pol, μ = 5";
    const START: [f64; 2] = [2.0, 0.0];
    const END: f64 = 20.0;
    const DIGITS: core::ops::RangeInclusive<i32> = 3..=12;
    const ABSOLUTE: [f64; 2] = [1.0; 2];

    fn rate(x: &[f64; 2]) -> [f64; 2] {
        [x[1], 5.0 * (1.0 - x[0] * x[0]) * x[1] - x[0]]
    }

    fn jacobian(x: &[f64; 2]) -> [[f64; 2]; 2] {
        [[0.0, 1.0], [-10.0 * x[0] * x[1] - 1.0, 5.0 * (1.0 - x[0] * x[0])]]
    }

    fn end() -> Result<[f64; 2]> {
        reference::<Self, 2>()
    }
}

/// A chemical oscillator.
pub struct Brusselator;

impl Problem<2> for Brusselator {
    const NAME: &'static str = "Brusselator";
    const START: [f64; 2] = [1.5, 3.0];
    const END: f64 = 20.0;
    const DIGITS: core::ops::RangeInclusive<i32> = 3..=12;
    const ABSOLUTE: [f64; 2] = [1.0; 2];

    fn rate(x: &[f64; 2]) -> [f64; 2] {
        let reaction = x[0] * x[0] * x[1];
        [1.0 + reaction - 4.0 * x[0], 3.0 * x[0] - reaction]
    }

    fn jacobian(x: &[f64; 2]) -> [[f64; 2]; 2] {
        let (first, second) = (2.0 * x[0] * x[1], x[0] * x[0]);
        [[first - 4.0, second], [3.0 - first, -second]]
    }

    fn end() -> Result<[f64; 2]> {
        reference::<Self, 2>()
    }
}

/// A periodic orbit of a satellite between earth and moon.
pub struct Arenstorf;

const MOON: f64 = 0.012277471;

impl Problem<4> for Arenstorf {
    const NAME: &'static str = "Arenstorf orbit";
    const START: [f64; 4] = [0.994, 0.0, 0.0, -2.001_585_106_379_082_5];
    const END: f64 = 17.065_216_560_157_962;
    const DIGITS: core::ops::RangeInclusive<i32> = 6..=13;
    const ABSOLUTE: [f64; 4] = [1.0; 4];

    fn rate(x: &[f64; 4]) -> [f64; 4] {
        let earth = 1.0 - MOON;
        let cube = |dx: f64| {
            let square = dx * dx + x[1] * x[1];
            square * square.sqrt()
        };
        let (a, b) = (earth / cube(x[0] + MOON), MOON / cube(x[0] - earth));
        [
            x[2],
            x[3],
            x[0] + 2.0 * x[3] - a * (x[0] + MOON) - b * (x[0] - earth),
            x[1] - 2.0 * x[2] - (a + b) * x[1],
        ]
    }

    /// Not needed by explicit methods.
    fn jacobian(_: &[f64; 4]) -> [[f64; 4]; 4] {
        [[f64::NAN; 4]; 4]
    }

    fn end() -> Result<[f64; 4]> {
        Ok(Self::START)
    }
}

/// ẍ = 10⁶·((1 − x²)·ẋ − x): relaxation within 10⁻⁶ of a unit of time.
pub struct StiffVanDerPol;

impl Problem<2> for StiffVanDerPol {
    const NAME: &'static str = "Van der Pol, ε = 10⁻⁶";
    const START: [f64; 2] = [2.0, 0.0];
    const END: f64 = 2.0;
    const DIGITS: core::ops::RangeInclusive<i32> = 3..=9;
    const ABSOLUTE: [f64; 2] = [1.0; 2];

    fn rate(x: &[f64; 2]) -> [f64; 2] {
        [x[1], 1e6 * ((1.0 - x[0] * x[0]) * x[1] - x[0])]
    }

    fn jacobian(x: &[f64; 2]) -> [[f64; 2]; 2] {
        [[0.0, 1.0], [1e6 * (-2.0 * x[0] * x[1] - 1.0), 1e6 * (1.0 - x[0] * x[0])]]
    }

    fn end() -> Result<[f64; 2]> {
        Ok([1.706_167_732_170_483, -0.892_809_701_024_797_5])
    }
}

/// An autocatalytic reaction with rates nine powers of ten apart.
pub struct Robertson;

impl Problem<3> for Robertson {
    const NAME: &'static str = "Robertson, to t = 10¹¹";
    const START: [f64; 3] = [1.0, 0.0, 0.0];
    const END: f64 = 1e11;
    const DIGITS: core::ops::RangeInclusive<i32> = 3..=9;
    const ABSOLUTE: [f64; 3] = [1e-8, 1e-13, 1e-2];

    fn rate(x: &[f64; 3]) -> [f64; 3] {
        let (forth, back, third) = (0.04 * x[0], 1e4 * x[1] * x[2], 3e7 * x[1] * x[1]);
        [back - forth, forth - back - third, third]
    }

    fn jacobian(x: &[f64; 3]) -> [[f64; 3]; 3] {
        let (back_2, back_3, third_2) = (1e4 * x[2], 1e4 * x[1], 6e7 * x[1]);
        [[-0.04, back_2, back_3], [0.04, -back_2 - third_2, -back_3], [0.0, third_2, 0.0]]
    }

    fn end() -> Result<[f64; 3]> {
        Ok([0.208_334_014_970_125_5e-7, 0.833_336_077_033_471_3e-13, 0.999_999_979_166_505])
    }

    /// Each component counts by itself.
    fn scale(end: &[f64; 3]) -> [f64; 3] {
        *end
    }
}
