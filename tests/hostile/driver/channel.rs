//! Everything that a signal passes.

use brunovsky::{
    Error,
    channel::{Bias, Channel, DeadZone, Delay, Dropout, Lag, Noise, Quantization, Wander},
};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use super::{
    Bytes, Float, attack,
    numbers::Numbers,
    parts::{AnyChannel, rate_limit, saturation},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = match bytes.byte() % 12 {
        0 => AnyChannel::<T, 2>::decode(bytes).map(|channel| passed(channel, bytes)),
        1 => pair::<T>(bytes).map(|pair| passed(pair, bytes)),
        2 => saturation::<T, 2>(bytes).map(|saturation| passed(saturation, bytes)),
        3 => rate_limit::<T, 2>(bytes).map(|limit| passed(limit, bytes)),
        4 => DeadZone::new(bytes.parameters::<T, 2>()).map(|zone| passed(zone, bytes)),
        5 => lag::<T>(bytes).map(|lag| passed(lag, bytes)),
        6 => delay::<T>(bytes).map(|delay| passed(delay, bytes)),
        7 => Quantization::new(bytes.parameters::<T, 2>()).map(|steps| passed(steps, bytes)),
        8 => Bias::new(bytes.vector::<T, 2>()).map(|bias| passed(bias, bytes)),
        9 => Noise::new(bytes.parameters::<T, 2>(), random()).map(|noise| passed(noise, bytes)),
        10 => wander::<T>(bytes).map(|wander| passed(wander, bytes)),
        _ => dropout::<T>(bytes).map(|dropout| passed(dropout, bytes)),
    };
}

fn random() -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(0)
}

fn pair<T: Float>(bytes: &mut Bytes) -> Result<(AnyChannel<T, 2>, AnyChannel<T, 2>), Error> {
    Ok((AnyChannel::decode(bytes)?, AnyChannel::decode(bytes)?))
}

fn lag<T: Float>(bytes: &mut Bytes) -> Result<Lag<T, 2>, Error> {
    Lag::new(bytes.parameters::<T, 2>())?.starting_at(bytes.vector::<T, 2>())
}

fn delay<T: Float>(bytes: &mut Bytes) -> Result<Delay<T, 2, 3>, Error> {
    Delay::new().starting_at(bytes.vector::<T, 2>())
}

fn wander<T: Float>(bytes: &mut Bytes) -> Result<Wander<T, ChaCha8Rng, 2>, Error> {
    Wander::new(bytes.parameters::<T, 2>(), bytes.parameter(), random())
}

fn dropout<T: Float>(bytes: &mut Bytes) -> Result<Dropout<T, ChaCha8Rng, 2>, Error> {
    Dropout::new(f64::from(bytes.byte()) / 256.0, random())
}

fn passed<C: Channel<T, 2>, T: Float>(mut channel: C, bytes: &mut Bytes) {
    while !bytes.is_empty() {
        let (signal, dt) = (bytes.vector::<T, 2>(), bytes.parameter::<T>());
        match channel.passed(&signal, dt) {
            Ok((next, arrived)) => {
                assert!(arrived.are_finite(), "{arrived}");
                let again = channel.passed(&signal, dt).map(|(_, arrived)| arrived.bits());
                assert_eq!(again, Ok(arrived.bits()));
                channel = next;
            }
            // A sum may leave the range; nothing else can be wrong with a signal.
            Err(Error::NonFiniteEntry { name, .. }) if name.starts_with("signal +") => {}
            Err(error) => {
                assert!(!signal.are_finite() || !dt.are_finite() || dt <= T::zero(), "{error}");
            }
        }
    }
}
