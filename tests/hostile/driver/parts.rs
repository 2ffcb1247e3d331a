//! Parts of a controller, of a kind and with parameters that the bytes choose.

use brunovsky::{
    Error,
    channel::{Channel, Ideal, RateLimit, Saturation},
    controller::{Clelc, FeedbackLinearization, Gains},
    fuzzy::{FuzzyNetwork, Gaussian, Grid, Inputs, Travelling},
    learning::{
        AdaptationRule, Antecedents, BackwardDifference, Bounded, ClosedLoop, Conditional,
        ErrorRate, FeedbackError, FilteredDifference, Fixed, Flow, GradientDescent, Measured,
        ModelAided, NeuroFuzzy, NullRule, SlidingMode, Switching,
    },
    plant::{FeedbackLinearizable, Pendulum, VanDerPol},
};
use nalgebra::SVector;

use super::{Bytes, Float};

/// Any source of ė_n that stands alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Source<T> {
    Measured(Measured),
    Backward(BackwardDifference<T>),
    Filtered(FilteredDifference<T>),
    ModelAided(ModelAided<T>),
    FeedbackError(FeedbackError),
}

/// Any source of ė_n.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AnySource<T> {
    Plain(Source<T>),
    Conditional(Conditional<Source<T>, T>),
}

impl<T: Float> AnySource<T> {
    pub fn decode(bytes: &mut Bytes) -> Result<Self, Error> {
        let kind = bytes.byte();
        let source = match kind % 4 {
            0 => Source::Measured(Measured),
            1 if kind & 8 != 0 => Source::FeedbackError(FeedbackError),
            1 => Source::Backward(BackwardDifference::new()),
            2 => Source::Filtered(FilteredDifference::new(bytes.parameter())?),
            _ => Source::ModelAided(ModelAided::new()),
        };
        Ok(if kind & 4 == 0 {
            AnySource::Plain(source)
        } else {
            AnySource::Conditional(Conditional::new(source, bytes.parameter())?)
        })
    }
}

impl<T: Float, const N: usize> ErrorRate<T, N> for Source<T> {
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, u_n: T, dt: T) -> Result<T, Error> {
        match self {
            Source::Measured(source) => source.error_rate(at, u_n, dt),
            Source::Backward(source) => source.error_rate(at, u_n, dt),
            Source::Filtered(source) => source.error_rate(at, u_n, dt),
            Source::ModelAided(source) => source.error_rate(at, u_n, dt),
            Source::FeedbackError(source) => source.error_rate(at, u_n, dt),
        }
    }
}

impl<T: Float, const N: usize> ErrorRate<T, N> for AnySource<T> {
    fn error_rate(&mut self, at: &ClosedLoop<T, N>, u_n: T, dt: T) -> Result<T, Error> {
        match self {
            AnySource::Plain(source) => source.error_rate(at, u_n, dt),
            AnySource::Conditional(source) => source.error_rate(at, u_n, dt),
        }
    }
}

/// Any treatment of the antecedents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AnyAntecedents<T> {
    Fixed(Fixed),
    Flow(Flow<T>),
}

impl<T: Float> AnyAntecedents<T> {
    pub fn decode(bytes: &mut Bytes) -> Result<Self, Error> {
        Ok(match bytes.byte() % 3 {
            0 => AnyAntecedents::Fixed(Fixed),
            1 => AnyAntecedents::Flow(Flow::default()),
            _ => AnyAntecedents::Flow(Flow::new(bytes.parameter(), bytes.parameter())?),
        })
    }
}

impl<T: Float, W: Travelling<Scalar = T>> Antecedents<W> for AnyAntecedents<T> {
    fn follow(&self, network: &mut W, e: &W::Input) {
        match self {
            AnyAntecedents::Fixed(fixed) => fixed.follow(network, e),
            AnyAntecedents::Flow(flow) => flow.follow(network, e),
        }
    }

    fn flow(&self, network: &mut W, tau: T) {
        match self {
            AnyAntecedents::Fixed(fixed) => fixed.flow(network, tau),
            AnyAntecedents::Flow(flow) => flow.flow(network, tau),
        }
    }
}

type AnySlidingMode<T> = SlidingMode<T, AnyAntecedents<T>>;

/// Any adaptation rule.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AnyRule<T> {
    Null(NullRule),
    SlidingMode(AnySlidingMode<T>),
    GradientDescent(GradientDescent<T>),
    BoundedSlidingMode(Bounded<AnySlidingMode<T>, T>),
    BoundedGradientDescent(Bounded<GradientDescent<T>, T>),
}

impl<T: Float> AnyRule<T> {
    pub fn decode(bytes: &mut Bytes) -> Result<Self, Error> {
        Ok(match bytes.byte() % 7 {
            0 => AnyRule::Null(NullRule),
            1 | 2 => AnyRule::SlidingMode(sliding_mode(bytes)?),
            3 => AnyRule::GradientDescent(GradientDescent::new(bytes.parameter())?),
            4 | 5 => AnyRule::BoundedSlidingMode(bounded(sliding_mode(bytes)?, bytes)?),
            _ => {
                let rule = GradientDescent::new(bytes.parameter())?;
                AnyRule::BoundedGradientDescent(bounded(rule, bytes)?)
            }
        })
    }
}

/// Calls the rule inside with the rest of the arguments.
macro_rules! each_rule {
    ($rule:ident, $name:ident => $call:expr) => {
        match $rule {
            AnyRule::Null($name) => $call,
            AnyRule::SlidingMode($name) => $call,
            AnyRule::GradientDescent($name) => $call,
            AnyRule::BoundedSlidingMode($name) => $call,
            AnyRule::BoundedGradientDescent($name) => $call,
        }
    };
}

impl<T: Float, W: Travelling<Scalar = T>> AdaptationRule<W> for AnyRule<T> {
    fn follow(&mut self, network: &mut W, e: &W::Input) {
        each_rule!(self, rule => rule.follow(network, e));
    }

    fn adapt(&mut self, network: &mut W, firing: &W::Firing, s: T, dt: T) {
        each_rule!(self, rule => rule.adapt(network, firing, s, dt));
    }
}

pub fn switching<T: Float>(bytes: &mut Bytes) -> Switching<T> {
    match bytes.byte() % 3 {
        0 => Switching::Explicit { delta: bytes.parameter() },
        1 => Switching::Implicit { delta: bytes.parameter() },
        _ => Switching::SetValued,
    }
}

fn sliding_mode<T: Float>(bytes: &mut Bytes) -> Result<AnySlidingMode<T>, Error> {
    let rule = SlidingMode::new(bytes.parameter())?.with_switching(switching(bytes))?;
    Ok(rule.with_antecedents(AnyAntecedents::decode(bytes)?))
}

fn bounded<R, T: Float>(rule: R, bytes: &mut Bytes) -> Result<Bounded<R, T>, Error> {
    let bounded = Bounded::new(rule, bytes.parameter())?;
    if bytes.odd() { bounded.with_rate(bytes.parameter()) } else { Ok(bounded) }
}

pub fn memberships<T: Float, const I: usize, const K: usize>(
    bytes: &mut Bytes,
) -> Result<[[Gaussian<T>; K]; I], Error> {
    let mut memberships = [[Gaussian::new(T::zero(), T::one())?; K]; I];
    for membership in memberships.as_flattened_mut() {
        *membership = Gaussian::new(bytes.number(), bytes.parameter())?;
    }
    Ok(memberships)
}

pub fn network<T: Float, const I: usize, const K: usize>(
    bytes: &mut Bytes,
) -> Result<FuzzyNetwork<T, I, K>, Error>
where
    Inputs<I>: Grid,
{
    if bytes.odd() {
        FuzzyNetwork::evenly_spaced(bytes.parameters())
    } else {
        Ok(FuzzyNetwork::new(memberships(bytes)?))
    }
}

/// CLELC with every part chosen by the bytes, but the model.
pub type AnyClelc<P, T, const N: usize, const K: usize> =
    Clelc<P, NeuroFuzzy<FuzzyNetwork<T, N, K>, AnySource<T>, AnyRule<T>>, N>;

pub fn clelc<P, T: Float, const N: usize, const K: usize>(
    model: P,
    bytes: &mut Bytes,
) -> Result<AnyClelc<P, T, N, K>, Error>
where
    P: FeedbackLinearizable<N, Scalar = T>,
    Inputs<N>: Grid,
{
    let base = flc(model, bytes)?;
    let source = AnySource::decode(bytes)?;
    let rule = AnyRule::decode(bytes)?;
    Ok(Clelc::new(base, NeuroFuzzy::new(network(bytes)?, source, rule)))
}

pub fn flc<P, T: Float, const N: usize>(
    model: P,
    bytes: &mut Bytes,
) -> Result<FeedbackLinearization<P, N>, Error>
where
    P: FeedbackLinearizable<N, Scalar = T>,
{
    let gains = if bytes.odd() {
        Gains::from_lambda(bytes.parameter())?
    } else {
        Gains::new(bytes.parameters::<T, N>())?
    };
    Ok(FeedbackLinearization::new(model, gains))
}

/// A plant of order 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Model<T> {
    Pendulum(Pendulum<T>),
    VanDerPol(VanDerPol<T>),
    /// a(x) and b(x) are whatever they want to be: x₁² and x₂.
    Fragile,
}

impl<T: Float> Model<T> {
    /// The model, and whether it has an input for every moderate state.
    pub fn decode(bytes: &mut Bytes) -> Result<(Self, bool), Error> {
        Ok(match bytes.byte() % 3 {
            0 => {
                let [mass, length, damping, gravity] = bytes.parameters();
                (Model::Pendulum(Pendulum::new(mass, length, damping, gravity)?), true)
            }
            1 => (Model::VanDerPol(VanDerPol::new(bytes.number())?), true),
            _ => (Model::Fragile, false),
        })
    }
}

impl<T: Float> FeedbackLinearizable<2> for Model<T> {
    type Scalar = T;

    fn drift(&self, x: &SVector<T, 2>) -> T {
        match self {
            Model::Pendulum(plant) => plant.drift(x),
            Model::VanDerPol(plant) => plant.drift(x),
            Model::Fragile => x[0] * x[0],
        }
    }

    fn input_gain(&self, x: &SVector<T, 2>) -> T {
        match self {
            Model::Pendulum(plant) => plant.input_gain(x),
            Model::VanDerPol(plant) => plant.input_gain(x),
            Model::Fragile => x[1],
        }
    }
}

/// Any channel that a controller is told of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AnyChannel<T, const NU: usize> {
    Ideal(Ideal),
    Saturation(Saturation<T, NU>),
    RateLimit(RateLimit<T, NU>),
    Pair((RateLimit<T, NU>, Saturation<T, NU>)),
}

impl<T: Float, const NU: usize> AnyChannel<T, NU> {
    pub fn decode(bytes: &mut Bytes) -> Result<Self, Error> {
        Ok(match bytes.byte() % 4 {
            0 => AnyChannel::Ideal(Ideal),
            1 => AnyChannel::Saturation(saturation(bytes)?),
            2 => AnyChannel::RateLimit(rate_limit(bytes)?),
            _ => AnyChannel::Pair((rate_limit(bytes)?, saturation(bytes)?)),
        })
    }
}

pub fn saturation<T: Float, const NU: usize>(
    bytes: &mut Bytes,
) -> Result<Saturation<T, NU>, Error> {
    if bytes.odd() {
        Saturation::symmetric(bytes.parameters::<T, NU>())
    } else {
        Saturation::new(bytes.vector::<T, NU>(), bytes.vector::<T, NU>())
    }
}

pub fn rate_limit<T: Float, const NU: usize>(bytes: &mut Bytes) -> Result<RateLimit<T, NU>, Error> {
    let limit = RateLimit::new(bytes.parameters::<T, NU>())?;
    if bytes.odd() { limit.starting_at(bytes.vector::<T, NU>()) } else { Ok(limit) }
}

impl<T: Float, const NU: usize> Channel<T, NU> for AnyChannel<T, NU> {
    fn passed(&self, u: &SVector<T, NU>, dt: T) -> Result<(Self, SVector<T, NU>), Error> {
        Ok(match self {
            AnyChannel::Ideal(channel) => {
                let (channel, u) = channel.passed(u, dt)?;
                (AnyChannel::Ideal(channel), u)
            }
            AnyChannel::Saturation(channel) => {
                let (channel, u) = channel.passed(u, dt)?;
                (AnyChannel::Saturation(channel), u)
            }
            AnyChannel::RateLimit(channel) => {
                let (channel, u) = channel.passed(u, dt)?;
                (AnyChannel::RateLimit(channel), u)
            }
            AnyChannel::Pair(channel) => {
                let (channel, u) = channel.passed(u, dt)?;
                (AnyChannel::Pair(channel), u)
            }
        })
    }
}
