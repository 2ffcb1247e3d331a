//! Saturation and rate limit.

use brunovsky::{Error, actuator::Actuator};

use super::{
    Bytes, Float, attack,
    numbers::Numbers,
    parts::{AnyActuator, rate_limit, saturation},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = match bytes.byte() % 4 {
        0 => AnyActuator::<T, 2>::decode(bytes).map(|actuator| driven(actuator, bytes)),
        1 => pair::<T>(bytes).map(|pair| driven(pair, bytes)),
        2 => saturation::<T, 2>(bytes).map(|saturation| driven(saturation, bytes)),
        _ => rate_limit::<T, 2>(bytes).map(|limit| driven(limit, bytes)),
    };
}

fn pair<T: Float>(bytes: &mut Bytes) -> Result<(AnyActuator<T, 2>, AnyActuator<T, 2>), Error> {
    Ok((AnyActuator::decode(bytes)?, AnyActuator::decode(bytes)?))
}

fn driven<A: Actuator<T, 2>, T: Float>(mut actuator: A, bytes: &mut Bytes) {
    while !bytes.is_empty() {
        let (u, dt) = (bytes.vector::<T, 2>(), bytes.parameter::<T>());
        match actuator.driven(&u, dt) {
            Ok((next, arrived)) => {
                assert!(arrived.are_finite(), "{arrived}");
                let again = actuator.driven(&u, dt).map(|(_, arrived)| arrived.bits());
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
