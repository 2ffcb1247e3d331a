//! CLELC with the networks and rules beyond those that [`chain`](super::chain) attacks.

use core::fmt::Debug;

use brunovsky::{
    Error,
    controller::Clelc,
    fuzzy::{IntervalNetwork, Over, TriangularNetwork, TypeReduction},
    learning::{
        AdaptationRule, AdaptiveSlidingMode, Fixed, GradientDescent, NeuroFuzzy,
        RecursiveLeastSquares, SlidingMode,
    },
};

use super::{
    Bytes, Float, attack,
    controller::Attack,
    parts::{AnySource, Model, flc, network, switching},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = attacked::<T>(bytes);
}

fn attacked<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    match bytes.byte() % 4 {
        0 if bytes.odd() => on_network(network::<T, 2, 3>(bytes)?, bytes),
        0 => {
            let rule = GradientDescent::new(bytes.parameter())?.with_leakage(bytes.parameter())?;
            on_rule(network::<T, 2, 3>(bytes)?, rule.with_projection(bytes.parameter())?, bytes)
        }
        1 => on_network(TriangularNetwork::<T, 2, 3>::evenly_spaced(bytes.parameters())?, bytes),
        2 => {
            let (ranges, uncertainty) = (bytes.parameters(), bytes.parameter());
            let reduction = reduction(bytes);
            on_network(
                IntervalNetwork::<_, T, 2, 3>::gaussian(ranges, uncertainty, reduction)?,
                bytes,
            )
        }
        _ => {
            let (ranges, exponents) = (bytes.parameters(), bytes.parameters());
            let reduction = reduction(bytes);
            on_network(
                IntervalNetwork::<_, T, 2, 3>::elliptic(ranges, exponents, reduction)?,
                bytes,
            )
        }
    }
}

fn reduction<T: Float>(bytes: &mut Bytes) -> TypeReduction<T> {
    if bytes.odd() { TypeReduction::NieTan } else { TypeReduction::Bmm { m: bytes.parameter() } }
}

fn sliding_mode<T: Float>(bytes: &mut Bytes) -> Result<SlidingMode<T, Fixed>, Error> {
    let rule = SlidingMode::new(bytes.parameter())?.with_switching(switching(bytes))?;
    Ok(rule.with_antecedents(Fixed))
}

fn on_network<W, T: Float>(network: W, bytes: &mut Bytes) -> Result<(), Error>
where
    W: Over<T, 2> + Copy + PartialEq + Debug,
    RecursiveLeastSquares<T, 2, 3>: AdaptationRule<W>,
{
    match bytes.byte() % 4 {
        0 | 1 => {
            let [growth, layer] = bytes.parameters();
            let rule = AdaptiveSlidingMode::new(sliding_mode(bytes)?, growth, layer)?;
            let bounded = if bytes.odd() { rule.with_ceiling(bytes.parameter())? } else { rule };
            on_rule(network, bounded, bytes)
        }
        2 => on_rule(network, RecursiveLeastSquares::new(bytes.parameter())?, bytes),
        _ => {
            let rule = RecursiveLeastSquares::new(bytes.parameter())?;
            on_rule(network, rule.with_memory(bytes.parameter())?, bytes)
        }
    }
}

fn on_rule<W, R, T: Float>(network: W, rule: R, bytes: &mut Bytes) -> Result<(), Error>
where
    W: Over<T, 2> + Copy + PartialEq + Debug,
    R: AdaptationRule<W> + Copy + PartialEq + Debug,
{
    let (model, answers) = Model::<T>::decode(bytes)?;
    let (flc, source) = (flc(model, bytes)?, AnySource::decode(bytes)?);
    let clelc = Clelc::new(flc, NeuroFuzzy::new(network, source, rule));
    Attack::plain(answers && !bytes.wild).on(&clelc, bytes);
    Ok(())
}
