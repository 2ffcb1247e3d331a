use nalgebra::{SMatrix, SVector};

use super::{FiniteDifferences, Jacobian, Linearization, lu::Lu};
use crate::{
    Scalar,
    integrators::adaptive::{Attempt, Embedded, Point, combination},
    scalar::constant,
};

/// RODAS, a Rosenbrock method for stiff problems: order 4 with an estimate of order 3, L-stable and stiffly accurate, dense output of order 3.
///
/// (I/(γ·h) − ∂f/∂x)·uᵢ = f(t + αᵢ·h, x + Σⱼ aᵢⱼ·uⱼ) + Σⱼ cᵢⱼ/h·uⱼ + γᵢ·h·∂f/∂t, x⁺ = x + Σⱼ a₆ⱼ·uⱼ + u₆, error = u₆
///
/// A step solves six linear equations with one LU factorization, without iteration, and evaluates f six times; the linearization is that of
/// the start of the step, by [`FiniteDifferences`] or from [the user](Self::with_jacobian). The method relies on it: with a wrong one it is
/// still consistent, but no longer of order 4.
///
/// # References
/// E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, IV.7 and IV.10, and their code RODAS (method 1), whose coefficients
/// these are.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Rodas<J = FiniteDifferences> {
    jacobian: J,
}

const GAMMA: f64 = 0.25;
const ALPHA: [f64; 6] = [0.0, 0.386, 0.21, 0.63, 1.0, 1.0];
const GAMMAS: [f64; 6] = [0.25, -0.1043, 0.1035, -0.03620000000000023, 0.0, 0.0];
const A2: [f64; 1] = [1.544];
const A3: [f64; 2] = [0.9466785280815826, 0.2557011698983284];
const A4: [f64; 3] = [3.314825187068521, 2.896124015972201, 0.9986419139977817];
const A5: [f64; 4] = [1.221224509226641, 6.019134481288629, 12.53708332932087, -0.687886036105895];
const C2: [f64; 1] = [-5.6688];
const C3: [f64; 2] = [-2.430093356833875, -0.2063599157091915];
const C4: [f64; 3] = [-0.1073529058151375, -9.594562251023355, -20.47028614809616];
const C5: [f64; 4] = [7.496443313967647, -10.24680431464352, -33.99990352819905, 11.7089089320616];
const C6: [f64; 5] = [
    8.083246795921522,
    -7.981132988064893,
    -31.52159432874371,
    16.31930543123136,
    -6.058818238834054,
];
const D2: [f64; 5] = [
    10.12623508344586,
    -7.487995877610167,
    -34.80091861555747,
    -7.992771707568823,
    1.025137723295662,
];
const D3: [f64; 5] = [
    -0.6762803392801253,
    6.087714651680015,
    16.43084320892478,
    24.76722511418386,
    -6.594389125716872,
];

impl Rodas {
    /// The method with [`FiniteDifferences`] of f in x and t.
    pub fn new() -> Self {
        Self::default()
    }

    /// The same for an f without time.
    pub fn autonomous() -> Self {
        Self { jacobian: FiniteDifferences::autonomous() }
    }
}

impl<J> Rodas<J> {
    /// The method with another source of the linearization: a closure `|t, x| Linearization { x: …, t: … }` or a [`Jacobian`].
    pub fn with_jacobian(jacobian: J) -> Self {
        Self { jacobian }
    }
}

impl<J: Jacobian<T, N>, T: Scalar, const N: usize> Embedded<T, N> for Rodas<J> {
    const ORDER: i32 = 4;
    const ESTIMATE: i32 = 3;
    const LINEARIZES: bool = true;

    type Linearization = Linearization<T, N>;
    /// u₁ … u₆.
    type Stages = [SVector<T, N>; 6];

    fn linearize(
        &self,
        f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        at: &Point<T, N>,
        h: T,
        weights: &SVector<T, N>,
    ) -> Linearization<T, N> {
        self.jacobian.linearize(f, at, h, weights)
    }

    fn attempt(
        &self,
        mut f: impl FnMut(T, &SVector<T, N>) -> SVector<T, N>,
        at: &Point<T, N>,
        linearization: &Linearization<T, N>,
        h: T,
    ) -> Option<Attempt<T, N, Self::Stages>> {
        let Point { t, x, rate } = at;
        let inverse = (h * constant(GAMMA)).recip();
        let lu = Lu::new(SMatrix::identity() * inverse - linearization.x)?;
        // What f gives at stage i, completed and solved for uᵢ.
        let solve = |i: usize, f: SVector<T, N>, history: SVector<T, N>| {
            lu.solve(f + history / h + linearization.t * (h * constant(GAMMAS[i])))
        };
        let mut f = |i: usize, x: &SVector<T, N>| f(*t + h * constant(ALPHA[i]), x);
        let u1 = solve(0, *rate, SVector::zeros());
        let x2 = x + combination(A2, [&u1]);
        let u2 = solve(1, f(1, &x2), combination(C2, [&u1]));
        let x3 = x + combination(A3, [&u1, &u2]);
        let u3 = solve(2, f(2, &x3), combination(C3, [&u1, &u2]));
        let x4 = x + combination(A4, [&u1, &u2, &u3]);
        let u4 = solve(3, f(3, &x4), combination(C4, [&u1, &u2, &u3]));
        let x5 = x + combination(A5, [&u1, &u2, &u3, &u4]);
        let u5 = solve(4, f(4, &x5), combination(C5, [&u1, &u2, &u3, &u4]));
        let x6 = x5 + u5;
        let u6 = solve(5, f(5, &x6), combination(C6, [&u1, &u2, &u3, &u4, &u5]));
        Some(Attempt { x: x6 + u6, error: u6, rate: None, stages: [u1, u2, u3, u4, u5, u6] })
    }

    fn dense(
        &self,
        at: &Point<T, N>,
        attempt: &Attempt<T, N, Self::Stages>,
        _h: T,
    ) -> [SVector<T, N>; 4] {
        let [u1, u2, u3, u4, u5, _] = &attempt.stages;
        let u = [u1, u2, u3, u4, u5];
        [attempt.x - at.x, combination(D2, u), combination(D3, u), SVector::zeros()]
    }
}
