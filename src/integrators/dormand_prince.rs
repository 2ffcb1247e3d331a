use nalgebra::SVector;

use super::{
    Integrator,
    adaptive::{Attempt, Embedded, Point, combination},
};
use crate::{Scalar, scalar::constant};

/// The explicit pair of Dormand and Prince, order 5 with an estimate of order 4, and dense output of order 4.
///
/// kᵢ = f(t + cᵢ·h, x + h·Σⱼ aᵢⱼ·kⱼ), x⁺ = x + h·Σᵢ bᵢ·kᵢ, error = h·Σᵢ eᵢ·kᵢ, k₇ = f(t + h, x⁺)
///
/// k₇ is k₁ of the next step, so that a step costs six evaluations. Under [`Adaptive`](super::Adaptive) it chooses its steps; as an
/// [`Integrator`] it takes equal ones. Its coefficients are fractions, so that its order conditions can be checked without rounding;
/// that, and the many codes built on it that a user can compare with, is why it is here and not a pair with decimal coefficients.
///
/// # References
/// J. R. Dormand, P. J. Prince, "A family of embedded Runge–Kutta formulae", J. Comput. Appl. Math. 6(1), 1980: RK5(4)7M.
/// E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, table II.5.2 and (II.6.12), the dense output.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DormandPrince;

/// k₁ … k₆, with the state x⁺ that they lead to.
fn stages<T: Scalar, const N: usize>(
    mut f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
    at: &Point<T, N>,
    h: T,
) -> ([SVector<T, N>; 6], SVector<T, N>) {
    let Point { t, x, rate: k1 } = at;
    let at = |c: f64| *t + h * constant(c);
    let k2 = f(at(1.0 / 5.0), &(x + combination([1.0 / 5.0], [k1]) * h));
    let k3 = f(at(3.0 / 10.0), &(x + combination([3.0 / 40.0, 9.0 / 40.0], [k1, &k2]) * h));
    let a4 = [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0];
    let k4 = f(at(4.0 / 5.0), &(x + combination(a4, [k1, &k2, &k3]) * h));
    let a5 = [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0];
    let k5 = f(at(8.0 / 9.0), &(x + combination(a5, [k1, &k2, &k3, &k4]) * h));
    let a6 = [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0];
    let k6 = f(*t + h, &(x + combination(a6, [k1, &k2, &k3, &k4, &k5]) * h));
    let b = [35.0 / 384.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0];
    let end = x + combination(b, [k1, &k3, &k4, &k5, &k6]) * h;
    ([*k1, k2, k3, k4, k5, k6], end)
}

impl Integrator for DormandPrince {
    const ORDER: i32 = 5;

    fn step<T: Scalar, const N: usize>(
        &self,
        mut f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        t: T,
        x: &SVector<T, N>,
        h: T,
    ) -> SVector<T, N> {
        let at = Point { t, x: *x, rate: f(t, x) };
        stages(f, &at, h).1
    }
}

impl<T: Scalar, const N: usize> Embedded<T, N> for DormandPrince {
    const ORDER: i32 = 5;
    const ESTIMATE: i32 = 4;
    const LINEARIZES: bool = false;

    type Linearization = ();
    /// k₁ … k₇.
    type Stages = [SVector<T, N>; 7];

    fn linearize(
        &self,
        _f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        _at: &Point<T, N>,
        _h: T,
        _weights: &SVector<T, N>,
    ) {
    }

    // What it returns is large: inlined, it is written where it is kept.
    #[inline(always)]
    fn attempt(
        &self,
        mut f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        at: &Point<T, N>,
        (): &(),
        h: T,
    ) -> Option<Attempt<T, N, Self::Stages>> {
        let ([k1, k2, k3, k4, k5, k6], x) = stages(&mut f, at, h);
        let k7 = f(at.t + h, &x);
        let e = [
            71.0 / 57600.0,
            -71.0 / 16695.0,
            71.0 / 1920.0,
            -17253.0 / 339200.0,
            22.0 / 525.0,
            -1.0 / 40.0,
        ];
        let error = combination(e, [&k1, &k3, &k4, &k5, &k6, &k7]) * h;
        Some(Attempt { x, error, rate: Some(k7), stages: [k1, k2, k3, k4, k5, k6, k7] })
    }

    fn dense(
        &self,
        at: &Point<T, N>,
        attempt: &Attempt<T, N, Self::Stages>,
        h: T,
    ) -> [SVector<T, N>; 4] {
        let [k1, _, k3, k4, k5, k6, k7] = &attempt.stages;
        let d = [
            -12715105075.0 / 11282082432.0,
            87487479700.0 / 32700410799.0,
            -10690763975.0 / 1880347072.0,
            701980252875.0 / 199316789632.0,
            -1453857185.0 / 822651844.0,
            69997945.0 / 29380423.0,
        ];
        let change = attempt.x - at.x;
        let start = k1 * h - change;
        let end = change - k7 * h - start;
        [change, start, end, combination(d, [k1, k3, k4, k5, k6, k7]) * h]
    }
}
