//! Saturation and rate limit.

use brunovsky::{Error, channel::Channel};

use super::{
    Bytes, Float, attack,
    numbers::Numbers,
    parts::{AnyChannel, rate_limit, saturation},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = match bytes.byte() % 4 {
        0 => AnyChannel::<T, 2>::decode(bytes).map(|actuator| driven(actuator, bytes)),
        1 => pair::<T>(bytes).map(|pair| driven(pair, bytes)),
        2 => saturation::<T, 2>(bytes).map(|saturation| driven(saturation, bytes)),
        _ => rate_limit::<T, 2>(bytes).map(|limit| driven(limit, bytes)),
    };
}

fn pair<T: Float>(bytes: &mut Bytes) -> Result<(AnyChannel<T, 2>, AnyChannel<T, 2>), Error> {
    Ok((AnyChannel::decode(bytes)?, AnyChannel::decode(bytes)?))
}

fn driven<A: Channel<T, 2>, T: Float>(mut actuator: A, bytes: &mut Bytes) {
    while !bytes.is_empty() {
        let (u, dt) = (bytes.vector::<T, 2>(), bytes.parameter::<T>());
        match actuator.passed(&u, dt) {
            Ok((next, arrived)) => {
                assert!(arrived.are_finite(), "{arrived}");
                let again = actuator.passed(&u, dt).map(|(_, arrived)| arrived.bits());
                assert_eq!(again, Ok(arrived.bits()));
                actuator = next;
            }
            // Nothing else can be wrong with an input.
            Err(error) => {
                assert!(!u.are_finite() || !dt.are_finite() || dt <= T::zero(), "{error}");
            }
        }
    }
}
