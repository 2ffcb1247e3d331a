//! The robust controllers: sliding modes of every kind, active disturbance rejection, and any of them with a compensator on top.

use core::fmt::Debug;

use brunovsky::{
    Error,
    controller::{
        ActiveDisturbanceRejection, Clelc, Compensated, Gains, Limited,
        sliding_mode::{
            IntegralSlidingMode, SlidingModeControl, SlidingSurface, Stepping, SuperTwisting,
            SuperTwistingGains,
        },
    },
    fuzzy::{Grid, Inputs},
    learning::NeuroFuzzy,
    plant::{FeedbackLinearizable, IntegratorChain},
};

use super::{
    Bytes, Float, attack,
    controller::Attack,
    parts::{AnyChannel, AnyRule, AnySource, Model, flc, network, switching},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = attacked::<T>(bytes);
}

fn attacked<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    match bytes.byte() % 10 {
        0 => on_law::<_, T, 1>(IntegratorChain::new(), true, bytes)?,
        1 => on_law::<_, T, 3>(IntegratorChain::new(), true, bytes)?,
        2 | 3 => {
            let (model, answers) = Model::<T>::decode(bytes)?;
            on_law::<_, T, 2>(model, answers, bytes)?;
        }
        4 => on_active_disturbance_rejection::<T, 1>(bytes)?,
        5 => on_active_disturbance_rejection::<T, 3>(bytes)?,
        6 => {
            let (model, answers) = Model::<T>::decode(bytes)?;
            let clelc = Clelc::new(flc(model, bytes)?, integral(bytes)?);
            Attack::plain(answers && !bytes.wild).on(&clelc, bytes);
        }
        _ => {
            let (model, answers) = Model::<T>::decode(bytes)?;
            on_compensated(model, answers, bytes)?;
        }
    }
    Ok(())
}

fn surface<T: Float, const N: usize>(bytes: &mut Bytes) -> Result<SlidingSurface<T, N>, Error> {
    SlidingSurface::from_lambda(bytes.parameter())
}

fn first_order<P, T: Float, const N: usize>(
    model: P,
    bytes: &mut Bytes,
) -> Result<SlidingModeControl<P, N>, Error>
where
    P: FeedbackLinearizable<N, Scalar = T>,
{
    let law = SlidingModeControl::new(model, surface(bytes)?, bytes.parameter())?;
    if bytes.odd() {
        law.with_switching(switching(bytes))
    } else {
        law.with_saturation(bytes.parameter())
    }
}

fn super_twisting<P, T: Float, const N: usize>(
    model: P,
    bytes: &mut Bytes,
) -> Result<SuperTwisting<P, N>, Error>
where
    P: FeedbackLinearizable<N, Scalar = T>,
{
    let gains = if bytes.odd() {
        SuperTwistingGains::for_rate(bytes.parameter())?
    } else {
        SuperTwistingGains::new(bytes.parameter(), bytes.parameter())?
    };
    let stepping = if bytes.odd() { Stepping::Implicit } else { Stepping::Explicit };
    Ok(SuperTwisting::new(model, surface(bytes)?, gains).with_stepping(stepping))
}

fn integral<T: Float>(bytes: &mut Bytes) -> Result<IntegralSlidingMode<T, AnySource<T>>, Error> {
    let source = AnySource::decode(bytes)?;
    IntegralSlidingMode::with_error_rate(bytes.parameter(), source)?
        .with_switching(switching(bytes))
}

fn on_law<P, T: Float, const N: usize>(
    model: P,
    answers: bool,
    bytes: &mut Bytes,
) -> Result<(), Error>
where
    P: FeedbackLinearizable<N, Scalar = T> + Copy + PartialEq + Debug,
{
    if bytes.odd() {
        let law = first_order(model, bytes)?;
        certified(&law, bytes);
        Attack::plain(answers && !bytes.wild).on(&law, bytes);
    } else {
        let law = super_twisting(model, bytes)?;
        promised(law.gains(), bytes);
        Attack::plain(answers && !bytes.wild).on(&law, bytes);
    }
    Ok(())
}

/// What is promised is a number, and none is negative.
fn is_a_promise<T: Float>(promise: Result<Option<T>, Error>) {
    if let Ok(Some(promise)) = promise {
        assert!(promise.is_finite() && promise >= T::zero(), "{promise:?}");
    }
}

fn certified<P, T: Float, const N: usize>(law: &SlidingModeControl<P, N>, bytes: &mut Bytes)
where
    P: FeedbackLinearizable<N, Scalar = T>,
{
    let (wild, [sigma, bound, dt]) = (bytes.wild, bytes.numbers());
    is_a_promise(law.reaching_time(sigma, bound));
    is_a_promise(law.residual(bound, dt));
    bytes.wild = wild;
}

fn promised<T: Float>(gains: &SuperTwistingGains<T>, bytes: &mut Bytes) {
    let (wild, [sigma, z, bound, dt]) = (bytes.wild, bytes.numbers());
    is_a_promise(gains.reaching_time(sigma, z, bound));
    is_a_promise(gains.residual(bound, dt));
    bytes.wild = wild;
}

fn on_active_disturbance_rejection<T: Float, const N: usize>(
    bytes: &mut Bytes,
) -> Result<(), Error> {
    let gains = Gains::<T, N>::from_lambda(bytes.parameter())?;
    let law = ActiveDisturbanceRejection::new(gains, bytes.parameter(), bytes.parameter())?;
    let (wild, [bound, dt]) = (bytes.wild, bytes.numbers());
    is_a_promise(law.disturbance_error(bound, dt).map(Some));
    is_a_promise(law.output_error(bound, dt).map(Some));
    bytes.wild = wild;
    Attack::plain(!bytes.wild).on(&law, bytes);
    Ok(())
}

fn on_compensated<T: Float>(model: Model<T>, answers: bool, bytes: &mut Bytes) -> Result<(), Error>
where
    Inputs<2>: Grid,
{
    let base = super_twisting(model, bytes)?;
    let kind = bytes.byte();
    let answers = |bytes: &Bytes| answers && !bytes.wild;
    if kind & 1 == 0 {
        let controller = Compensated::new(base, model, integral(bytes)?);
        Attack::plain(answers(bytes)).on(&controller, bytes);
        return Ok(());
    }
    let (source, rule) = (AnySource::decode(bytes)?, AnyRule::decode(bytes)?);
    let learner = NeuroFuzzy::new(network::<T, 2, 2>(bytes)?, source, rule);
    let controller = Compensated::new(base, model, learner);
    if kind & 2 == 0 {
        Attack::plain(answers(bytes)).on(&controller, bytes);
    } else {
        let actuator = AnyChannel::<T, 1>::decode(bytes)?;
        let controller = Limited::new(controller, actuator);
        Attack::plain(answers(bytes)).on(&controller, bytes);
    }
    Ok(())
}
