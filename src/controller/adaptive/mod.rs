//! Direct adaptive control with a reference model.
//!
//! | part | what it is |
//! |---|---|
//! | [`ModelReferenceAdaptive`] | the law |
//! | [`Regressor`] | the functions φ(x) whose coefficients it learns; [`StateRegressor`] is φ(x) = x |
//! | [`Leakage`] | σ- and e-modification |
//! | [`Projection`] | a ball or a box that the coefficients stay in |

mod leakage;
mod parameters;
mod past;
mod projection;
mod regressor;

pub use leakage::Leakage;
pub use projection::Projection;
pub use regressor::{Regressor, StateRegressor};

use parameters::{Learning, Parameters, remembered, usable};
use past::{Past, advanced};

use nalgebra::{SMatrix, SVector};

use super::{
    Accept, Command, Controller, FeedbackLinearization, Measurement, Reference,
    feedback_linearization::linearizing, lqr::lyapunov,
};
use crate::{
    Error, Scalar,
    error::{finite_vector, positive},
    learning::{ClosedLoop, LearningMode},
    plant::FeedbackLinearizable,
};

/// Direct model reference adaptive control: u = b(x)⁻¹·(−a(x) + u_f + u_b + u_a), u_a = −θ̂ᵀφ(x) + (κ̂ − 1)·(u_f + u_b − a(x)).
///
/// For plants ẋ_n = a(x) + Λ·(b(x)·u + θᵀφ(x)) of which a and b are the model and θ is not known; Λ > 0 is 1, or not known either. The base is
/// [`FeedbackLinearization`] with gains k. The reference model is the loop that it would have without uncertainty, and what the plant lacks to
/// it trains the parameters:
///
/// ```text
/// ẋ_m,n = r⁽ⁿ⁾ + k·(r − x_m),   ε = x_m − x,   s = p_nᵀ·ε,   AᵀP + PA = −Q,   p_n the last column of P
/// θ̂̇ = −γ·s·φ(x) − leakage,   κ̂̇ = γ_κ·s·(u_f + u_b − a(x)),   κ = 1/Λ
/// ```
///
/// with A the matrix of the error dynamics. Then V = εᵀPε + Λ·(|θ̂ − θ|²/γ + (κ̂ − κ)²/γ_κ) has V̇ = −εᵀQε: ε → 0, and θ̂ → θ if the motion
/// excites φ persistently. [`lyapunov_matrix`](Self::lyapunov_matrix) is P.
///
/// # Sampling
/// The parameters move at a sample by what the regressor of the period before explains of s now, and the step is normalized:
///
/// θ̂ ← Π( (θ̂ − η·γ·s·φ + ℓ·θ̂(0))/(1 + ℓ) ),  η = h/(1 + c·h·(γ·|φ|² + γ_κ·μ²)·Λ_max),  ℓ = γ·h·(σ or σ·|s|)
///
/// where c·w is what a w = θ̃ᵀφ over a period makes of s. No γ, φ or σ is too large for that. What is needed is a period in which the nominal
/// loop is stable with a margin: with all poles at −1/s, Q = I and a constant φ, the adaptive loop is stable at every γ for h ≤ 1.3, 0.7, 0.5
/// and 0.4 s at N = 1, 2, 3 and 4 (feedback linearization alone below 2 and 1 s at N = 1 and 2). x_m is sampled as the plant is, under a held
/// ν, so that a chain with the right parameters follows it exactly. What φ changes within a period acts as a disturbance of the order of h.
///
/// # Limits of the actuator
/// The model is given the input that did not arrive, b·(u_applied − u)/κ̂ (pseudo-control hedging), so a limit is not learned as an uncertainty.
/// A step of the parameters, or of x_m, that leaves the range of the scalar is not taken; x_m then restarts at x.
///
/// Without uncertainty, from θ̂ = 0, it is feedback linearization, bit for bit as long as ε = 0. [`LearningMode::Off`] takes u_a away and lets
/// x_m wait at x.
///
/// ```
/// use brunovsky::{controller::{ModelReferenceAdaptive, StateRegressor}, plant::IntegratorChain, prelude::*};
///
/// // ẍ = u + 2·x − 0.5·ẋ, of which the model knows ẍ = u.
/// let truth = Uncertain::matched(IntegratorChain::new(), |_: f64, x: &SVector<f64, 2>, _: &_| 2.0 * x[0] - 0.5 * x[1]);
/// let flc = FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(2.0)?);
/// let mut mrac = ModelReferenceAdaptive::new(flc, StateRegressor, 20.0, [1.0, 1.0])?;
/// let wave = |t: f64| Reference::new([t.sin(), t.cos()], -t.sin());
/// let run = Simulation::new(&truth, &mut mrac, wave, [0.5, 0.0], 0.001)?;
/// let last = run.until(60.0)?.last().ok_or(Error::Missing { name: "sample" })??;
/// assert!((last.reference.r - last.x).norm() < 0.01);
/// assert!((mrac.parameters() - SVector::from([2.0, -0.5])).norm() < 0.01);
/// # Ok::<(), Error>(())
/// ```
///
/// # References
/// P. A. Ioannou, J. Sun, *Robust Adaptive Control*, 1996, 6.2 (direct MRAC), 8.4 and 8.5 (leakage, projection); E. N. Johnson, A. J. Calise,
/// "Pseudo-control hedging", *AIAA Guidance, Navigation, and Control Conference*, 2000.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelReferenceAdaptive<P, F, const N: usize, const L: usize>
where
    P: FeedbackLinearizable<N>,
{
    base: FeedbackLinearization<P, N>,
    regressor: F,
    q: SVector<P::Scalar, N>,
    lyapunov: SMatrix<P::Scalar, N, N>,
    learning: Learning<P::Scalar, L>,
    start: Option<SVector<P::Scalar, N>>,
    mode: LearningMode,
    learned: Parameters<P::Scalar, L>,
    last: Option<Past<P::Scalar, N, L>>,
}

/// An input of [`ModelReferenceAdaptive`], its shares, and what was learned from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelReferenceAdaptiveCommand<T> {
    /// The input u, in the plant's units.
    pub u: T,
    /// The feedforward u_f = ṙ_n, in the units of ẋ_n.
    pub u_f: T,
    /// The feedback u_b = k·e, in the units of ẋ_n.
    pub u_b: T,
    /// The adaptive term u_a, in the units of ẋ_n.
    pub u_a: T,
    /// s = p_nᵀ·(x_m − x).
    pub s: T,
}

impl<T: Scalar> Command<T, 1> for ModelReferenceAdaptiveCommand<T> {
    fn input(&self) -> SVector<T, 1> {
        SVector::from([self.u])
    }
}

impl<P, F, const N: usize, const L: usize> ModelReferenceAdaptive<P, F, N, L>
where
    P: FeedbackLinearizable<N>,
    F: Regressor<P::Scalar, N, L>,
{
    /// `base` with an adaptive term in φ = `regressor`, learned at the `rate` γ > 0 from s, whose p_n belongs to Q = diag(`q`) > 0. θ̂ starts at
    /// 0, κ̂ stays at 1.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for `rate` and `q`; those of [`lyapunov`].
    pub fn new(
        base: FeedbackLinearization<P, N>,
        regressor: F,
        rate: P::Scalar,
        q: impl Into<SVector<P::Scalar, N>>,
    ) -> Result<Self, Error> {
        let learning = Learning::new(rate)?;
        let q = q.into();
        for q in q.iter() {
            positive("q", *q)?;
        }
        let k = base.gains().as_vector();
        let a = SMatrix::from_fn(|i, j| match () {
            () if i + 1 == N => -k[j],
            () if i + 1 == j => nalgebra::one(),
            () => nalgebra::zero(),
        });
        Ok(Self {
            lyapunov: lyapunov(&a, &SMatrix::from_diagonal(&q))?,
            base,
            regressor,
            q,
            learning,
            start: None,
            mode: LearningMode::Active,
            learned: learning.initial,
            last: None,
        })
    }

    /// The same with `leakage`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for σ.
    pub fn with_leakage(self, leakage: Leakage<P::Scalar>) -> Result<Self, Error> {
        let learning = self.learning.with_leakage(leakage)?;
        Ok(self.learning(learning))
    }

    /// The same with parameters that stay in the set of `projection`.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotBelow`] or [`Error::NonFinite`] for a set that is none.
    pub fn with_projection(self, projection: Projection<P::Scalar, L>) -> Result<Self, Error> {
        let learning = self.learning.with_projection(projection)?;
        Ok(self.learning(learning))
    }

    /// The same, starting from θ̂(0) = `theta`, or the nearest point to it that the projection allows.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`].
    pub fn with_parameters(self, theta: impl Into<SVector<P::Scalar, L>>) -> Result<Self, Error> {
        let theta = theta.into();
        finite_vector("theta", &theta)?;
        let initial = Parameters { theta, ..self.learning.initial };
        let learning = self.learning.starting(initial);
        Ok(self.learning(learning))
    }

    /// The same for a Λ that is not known: κ̂ is learned at the `rate` γ_κ > 0 in a `range` (lower, upper) of positive numbers. It starts
    /// at 1, or at the end of the range that is nearest.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotBelow`] or [`Error::NonFinite`].
    pub fn with_unknown_effectiveness(
        self,
        rate: P::Scalar,
        range: [P::Scalar; 2],
    ) -> Result<Self, Error> {
        let learning = self.learning.with_effectiveness(rate, range)?;
        Ok(self.learning(learning))
    }

    /// The same with a reference model that starts at `x_m`, and not at the first x.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`].
    pub fn with_model_at(self, x_m: impl Into<SVector<P::Scalar, N>>) -> Result<Self, Error> {
        let x_m = x_m.into();
        finite_vector("x_m", &x_m)?;
        Ok(Self { start: Some(x_m), ..self })
    }

    /// θ̂, in the units of ẋ_n over those of φ.
    pub fn parameters(&self) -> &SVector<P::Scalar, L> {
        &self.learned.theta
    }

    /// κ̂, the reciprocal of Λ as learned so far.
    pub fn inverse_effectiveness(&self) -> P::Scalar {
        self.learned.kappa
    }

    /// x_m at the last sample, if there was one.
    pub fn model_state(&self) -> Option<&SVector<P::Scalar, N>> {
        self.last.as_ref().map(|last| &last.model)
    }

    /// P.
    pub fn lyapunov_matrix(&self) -> &SMatrix<P::Scalar, N, N> {
        &self.lyapunov
    }

    /// The feedback linearization inside.
    pub fn base(&self) -> &FeedbackLinearization<P, N> {
        &self.base
    }

    fn learning(self, learning: Learning<P::Scalar, L>) -> Self {
        Self { learning, learned: learning.initial, ..self }
    }

    /// s of a difference ε.
    fn weighed(&self, epsilon: &SVector<P::Scalar, N>) -> P::Scalar {
        self.lyapunov.column(N - 1).dot(epsilon)
    }

    /// x_m at this sample, with its ẋ_n and s. Where it has left the range of the scalar, and while nothing is to be learned, it is at x.
    fn modelled(
        &self,
        at: &ClosedLoop<P::Scalar, N>,
        r: &SVector<P::Scalar, N>,
        applied: Option<P::Scalar>,
        dt: P::Scalar,
    ) -> (SVector<P::Scalar, N>, P::Scalar, P::Scalar) {
        let model = match self.last {
            None => self.start.unwrap_or(at.x),
            Some(last) => last.advanced(applied, self.learned.kappa, dt),
        };
        let rate = at.u_f + self.base.gains().feedback(&(r - model));
        let s = self.weighed(&(model - at.x));
        let kept = model.iter().all(|x| usable(*x)) && usable(rate) && usable(s);
        if kept && self.mode != LearningMode::Off {
            (model, rate, s)
        } else {
            (at.x, at.u_f + at.u_b, nalgebra::zero())
        }
    }

    /// The parameters at this sample.
    fn learned(&self, s: P::Scalar, dt: P::Scalar) -> Parameters<P::Scalar, L> {
        let (LearningMode::Active, Some(last)) = (self.mode, &self.last) else {
            return self.learned;
        };
        let reach = self.weighed(&advanced(&SVector::zeros(), nalgebra::one(), dt));
        self.learning.learned(&self.learned, (&last.phi, last.mu), s, reach, dt)
    }
}

impl<P, F, const N: usize, const L: usize> Controller<N, 1> for ModelReferenceAdaptive<P, F, N, L>
where
    P: FeedbackLinearizable<N>,
    F: Regressor<P::Scalar, N, L>,
{
    type Scalar = P::Scalar;
    type Reference = Reference<P::Scalar, N>;
    type Command = ModelReferenceAdaptiveCommand<P::Scalar>;

    /// # Errors
    /// Those of [`FeedbackLinearization`]; [`Error::NonFiniteEntry`] for φ(x); [`Error::NonFinite`] for a reference, φ(x) or u so large that the
    /// next sample could not be computed.
    fn update_if(
        &mut self,
        measurement: &Measurement<P::Scalar, N, 1>,
        reference: &Self::Reference,
        dt: P::Scalar,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        let asked = self.last.map_or(nalgebra::zero(), |last| last.asked);
        let at = self.base.closed_loop(measurement, reference, dt, asked, self.mode)?;
        let nu = remembered("nu", at.u_f + at.u_b)?;
        let mu = remembered("-a(x) + nu", nu - at.drift)?;
        let phi = self.regressor.regressor(&at.x);
        finite_vector("phi(x)", &phi)?;
        for phi in phi.iter() {
            remembered("phi(x)", *phi)?;
        }
        let applied = measurement.applied.map(|applied| applied[0]);
        let (model, rate, s) = self.modelled(&at, &reference.r, applied, dt);
        let learned = self.learned(s, dt);
        let one: P::Scalar = nalgebra::one();
        let u_a = match self.mode {
            LearningMode::Off => nalgebra::zero(),
            _ => (learned.kappa - one) * mu - learned.theta.dot(&phi),
        };
        let u = linearizing(&at, nu + u_a)?;
        let last = Past { model, rate, phi, mu, gain: at.gain, asked: u };
        let command = ModelReferenceAdaptiveCommand { u, u_f: at.u_f, u_b: at.u_b, u_a, s };
        accept(&command)?;
        (self.learned, self.last) = (learned, Some(last));
        Ok(command)
    }

    fn reset(&mut self) {
        (self.learned, self.last) = (self.learning.initial, None);
    }

    fn set_learning(&mut self, mode: LearningMode) {
        self.mode = mode;
    }
}

checked! {
    [P: FeedbackLinearizable<N>, F: Regressor<P::Scalar, N, L>, const N: usize, const L: usize]
    ModelReferenceAdaptive<P, F, N, L>, [P, F, P::Scalar]
    {
        base: FeedbackLinearization<P, N>,
        regressor: F,
        q: SVector<P::Scalar, N>,
        learning: Learning<P::Scalar, L>,
        start: Option<SVector<P::Scalar, N>>,
        mode: LearningMode,
        learned: Parameters<P::Scalar, L>,
        last: Option<Past<P::Scalar, N, L>>;
        lyapunov
    } =>
    Self::new(base, regressor, nalgebra::one(), q).and_then(|new| {
        known("x_m", start.iter().flatten().copied())?;
        learning.allows(&learned)?;
        Ok(Self { learning, start, mode, learned, last, ..new })
    })
}
