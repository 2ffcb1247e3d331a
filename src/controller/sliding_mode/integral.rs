use crate::{
    Error, Scalar,
    error::{finite, positive, remembered},
    learning::{
        ClosedLoop, Compensation, Compensator, ErrorRate, LearningMode, ModelAided, Switching,
    },
};

/// Integral sliding mode, as a compensator beside any feedback: u_n = k·sgn(σ) with σ = ∫s dt, s = ė_n + u_b.
///
/// σ̇ = s = −(u_n + Δ), and σ = e_n − e_n(0) + ∫u_b dt starts at zero: for k > B ≥ |Δ| the loop is in the sliding mode from the first instant on,
/// without a reaching phase, and u_n = −Δ. e then follows the nominal trajectory, that of the feedback alone on the plant that the model
/// describes, transient included.
///
/// * [`Clelc::new(flc, …)`](crate::controller::Clelc::new): the nominal feedback is feedback linearization, with any gains.
/// * [`Compensated::new(base, model, …)`](crate::controller::Compensated::new): it is any controller.
///
/// # In samples
/// σ(k) = σ(k−1) + h·s(k), s from an [`ErrorRate`]. The default, [`ModelAided`], makes h·s what the model leaves of the change of x_n over the
/// period that ends there: no derivative is taken, σ is the integral of the law, and an input that did not arrive is not in it. Then σ(k+1) =
/// σ(k) − h·(u_n + Δ), and the set-valued sign, clamp(σ/(k·h), −1, 1), leaves σ = −h·Δ and u_n the −Δ of the period before, whatever k is.
///
/// In [`LearningMode::Frozen`] u_n and σ stay as they are. In `Off` σ is 0: the nominal trajectory begins where the mode is thawed.
///
/// # References
/// V. Utkin, J. Shi, "Integral sliding mode in systems operating under uncertainty conditions", Conference on Decision and Control, 1996. The
/// projection is that on ẋ_n, which takes nothing but the matched Δ: F. Castaños, L. Fridman, "Analysis and design of integral sliding manifolds
/// for systems with unmatched perturbations", IEEE Transactions on Automatic Control 51(5), 2006.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntegralSlidingMode<T, E = ModelAided<T>> {
    k: T,
    switching: Switching<T>,
    error_rate: E,
    sigma: T,
    u_n: T,
}

impl<T: Scalar> IntegralSlidingMode<T> {
    /// Gain k > 0 in the units of ẋ_n, the set-valued sign, and s from the model.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn new(k: T) -> Result<Self, Error> {
        Self::with_error_rate(k, ModelAided::new())
    }
}

impl<T: Scalar, E> IntegralSlidingMode<T, E> {
    /// The same with ė_n from another source.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_error_rate(k: T, error_rate: E) -> Result<Self, Error> {
        let (sigma, u_n) = (T::zero(), -T::zero());
        Ok(Self { k: positive("k", k)?, switching: Switching::SetValued, error_rate, sigma, u_n })
    }

    /// The same law with another discretization of the sign.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Negative`] or [`Error::NonFinite`] for a boundary layer out of range.
    pub fn with_switching(self, switching: Switching<T>) -> Result<Self, Error> {
        Ok(Self { switching: switching.validated()?, ..self })
    }

    /// The sliding variable σ at the last sample, in the units of x_n.
    pub fn sigma(&self) -> T {
        self.sigma
    }
}

impl<T: Scalar, E: ErrorRate<T, N> + Clone, const N: usize> Compensator<T, N>
    for IntegralSlidingMode<T, E>
{
    fn advance_if(
        &mut self,
        at: &ClosedLoop<T, N>,
        dt: T,
        accept: &mut dyn FnMut(&Compensation<T>) -> Result<(), Error>,
    ) -> Result<Compensation<T>, Error> {
        positive("dt", dt)?;
        let known = match at.learning {
            // −0 is the number that changes no sum.
            LearningMode::Off => -T::zero(),
            LearningMode::Frozen | LearningMode::Active => self.u_n,
        };
        let mut error_rate = self.error_rate.clone();
        let s = finite("s", error_rate.error_rate(at, known, dt)? + at.u_b)?;
        let (sigma, u_n) = match at.learning {
            LearningMode::Off => (T::zero(), known),
            LearningMode::Frozen => (self.sigma, known),
            LearningMode::Active => {
                let sigma = remembered("sigma", self.sigma + s * dt, dt)?;
                (sigma, self.k * self.switching.sign(sigma, finite("k*dt", self.k * dt)?))
            }
        };
        let compensation = Compensation { u_n, s };
        accept(&compensation)?;
        (self.error_rate, self.sigma, self.u_n) = (error_rate, sigma, u_n);
        Ok(compensation)
    }
}

checked! {
    [T: Scalar, E] IntegralSlidingMode<T, E>, [T, E]
    { k: T, switching: Switching<T>, error_rate: E, sigma: T, u_n: T } =>
    Self::with_error_rate(k, error_rate).and_then(|new| {
        finite("sigma", sigma)?;
        at_most("size of u_n", finite("u_n", u_n)?.abs(), k)?;
        Ok(Self { sigma, u_n, ..new.with_switching(switching)? })
    })
}
