use super::{ClosedLoop, Compensation, Compensator, LearningMode, Watchdog};
use crate::{
    Error, Scalar,
    error::{finite, positive},
    scalar::faded,
};

/// Any compensator with a [`Watchdog`] on its s: a flag where learning does not do its work and, if wanted, the fall-back to feedback
/// linearization.
///
/// u_n = that of the compensator inside + w, w = 0 as long as nothing has happened
///
/// With a fall-back, the compensator inside runs with [`LearningMode::Off`] from the sample after the one that tripped the watchdog. w then
/// starts as the u_n that was there and moves to zero at the rate R, |w(k)| = max(|w(k−1)| − R·h, 0): nothing jumps, and after |u_n|/R the
/// loop is feedback linearization, to the last bit. The s of these samples is that of the compensator inside, which knows nothing of w.
///
/// Learning is watched while it is [`Active`](LearningMode::Active); after a pause the bound on |s| starts anew. Where the loop's mode is
/// `Off`, u_n is 0 and w forgotten. Several chains fall back one by one.
///
/// It helps where feedback linearization would do: against a learner that winds up, a wrong ė_n, an input gain that the feedback bears and
/// learning does not. A bias of ė_n is learned like Δ and goes unnoticed. ė_n still has to be had; see [`Redundant`](super::Redundant) for
/// a sensor that may drop out.
///
/// ```
/// use brunovsky::{learning::Guarded, plant::IntegratorChain, prelude::*};
///
/// let rule = SlidingMode::new(5.0)?;
/// // |Δ̇| ≤ 2, s is known to 0.1, and Δ may jump by 3, which takes 3/(5 − 2) s and two samples to learn.
/// let certificate = rule.certificate(0.01, 2.0)?;
/// let patience = certificate.recovery_time(3.0, 0.01)?.unwrap_or(0.0);
/// let watchdog = Watchdog::new(certificate, 0.11, patience)?;
/// let network = FuzzyNetwork::<f64, 2, 3>::evenly_spaced([1.0, 1.0])?;
/// let learner = NeuroFuzzy::new(network, ModelAided::new(), rule);
/// let guarded = Guarded::new(learner, watchdog).with_fallback(10.0)?;
///
/// let flc = FeedbackLinearization::new(IntegratorChain::<f64, 2>::new(), Gains::from_lambda(2.0)?);
/// let mut clelc = Clelc::new(flc, guarded);
/// // … after a while:
/// if clelc.compensator().tripped() {
///     // The cause is mended; learning begins again.
///     clelc.compensator_mut().rearm(learner);
/// }
/// # Ok::<(), brunovsky::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Guarded<C, T> {
    compensator: C,
    watchdog: Watchdog<T>,
    fade: Option<T>,
    fading: T,
}

impl<C, T: Scalar> Guarded<C, T> {
    /// `compensator` with `watchdog` on it, which only raises the flag.
    pub fn new(compensator: C, watchdog: Watchdog<T>) -> Self {
        Self { compensator, watchdog, fade: None, fading: -T::zero() }
    }

    /// The same with a fall-back to feedback linearization, in which u_n goes away at the rate `fade` R > 0 in the units of ẋ_n per second.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`].
    pub fn with_fallback(self, fade: T) -> Result<Self, Error> {
        Ok(Self { fade: Some(positive("fade", fade)?), ..self })
    }

    /// Whether the watchdog has tripped.
    pub fn tripped(&self) -> bool {
        self.watchdog.tripped()
    }

    /// The compensator inside.
    pub fn compensator(&self) -> &C {
        &self.compensator
    }

    /// Watches anew, with `compensator` in the place of the one that failed: a fresh one, or a copy from better days. What fades goes on
    /// fading, so nothing jumps if `compensator` begins with u_n = 0.
    pub fn rearm(&mut self, compensator: C) {
        self.compensator = compensator;
        self.watchdog.reset();
    }
}

impl<T: Scalar, C: Compensator<T, N>, const N: usize> Compensator<T, N> for Guarded<C, T> {
    fn advance_if(
        &mut self,
        at: &ClosedLoop<T, N>,
        dt: T,
        accept: &mut dyn FnMut(&Compensation<T>) -> Result<(), Error>,
    ) -> Result<Compensation<T>, Error> {
        positive("dt", dt)?;
        let fallen = self.fade.is_some() && self.tripped();
        let learning = if fallen { LearningMode::Off } else { at.learning };
        let inside = ClosedLoop { learning, ..*at };
        let left = match self.fade {
            Some(rate) if at.learning != LearningMode::Off => faded(self.fading, rate * dt),
            _ => -T::zero(),
        };
        let (falls_back, mut watchdog) = (self.fade.is_some(), self.watchdog);
        let (mut u_n, mut fading) = (left, left);
        let Compensation { s, .. } = self.compensator.advance_if(&inside, dt, &mut |learned| {
            if learning == LearningMode::Active {
                watchdog.update(learned.s)?;
            } else if !watchdog.tripped() {
                watchdog.reset();
            }
            u_n = finite("u_n", learned.u_n + left)?;
            // From the next sample on the compensator inside adds nothing, and all of this fades.
            if falls_back && watchdog.tripped() && !fallen {
                fading = u_n;
            }
            accept(&Compensation { u_n, s: learned.s })
        })?;
        (self.watchdog, self.fading) = (watchdog, fading);
        Ok(Compensation { u_n, s })
    }
}

checked! {
    [C, T: Scalar] Guarded<C, T>, [C, T]
    { compensator: C, watchdog: Watchdog<T>, fade: Option<T>, fading: T } =>
    positive("fade", fade.unwrap_or(T::one()))
        .and_then(|_| known("fading u_n", [fading]))
        .map(|()| Self { compensator, watchdog, fade, fading })
}
