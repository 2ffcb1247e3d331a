//! The unicycle's controller, and the feedforward and heading of a planar reference.

use brunovsky::{
    Error,
    controller::{
        Reference,
        unicycle::{
            Direction, Heading, Standstill, UnicycleController, feedforward_yaw_rate, heading,
        },
    },
    plant::IntegratorChain,
};

use super::{
    Bytes, Float, attack,
    controller::{Attack, Decode},
    numbers::Numbers,
    parts::{clelc, flc},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ =
        if bytes.byte().is_multiple_of(4) { headings::<T>(bytes) } else { attacked::<T>(bytes) };
}

fn attacked<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let chain = IntegratorChain::<T, 2>::new();
    let direction = direction(bytes);
    let standstill = if bytes.odd() { Standstill::Refuse } else { Standstill::Hold };
    let min_speed = bytes.parameter();
    let pair = bytes.odd();
    let first = clelc::<_, T, 2, 2>(chain, bytes)?;
    let answers = standstill == Standstill::Hold;
    if pair {
        let axes = (first, flc(chain, bytes)?);
        let controller = UnicycleController::new(axes, direction, min_speed, standstill)?;
        Attack::plain(answers && !bytes.wild).on(&controller, bytes);
    } else {
        let axes = [first, clelc(chain, bytes)?];
        let controller = UnicycleController::new(axes, direction, min_speed, standstill)?;
        Attack::plain(answers && !bytes.wild).on(&controller, bytes);
    }
    Ok(())
}

fn direction(bytes: &mut Bytes) -> Direction {
    if bytes.odd() { Direction::Forward } else { Direction::Reverse }
}

fn headings<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let direction = direction(bytes);
    let mut tried = if bytes.odd() {
        Heading::from(direction, bytes.number())?
    } else {
        Heading::<T>::new(direction)
    };
    let mut spared = tried;
    while !bytes.is_empty() {
        let reference = <[Reference<T, 2>; 2]>::decode(bytes);
        if let Ok(yaw_rate) = feedforward_yaw_rate(&reference) {
            assert!(yaw_rate.are_finite());
        }
        if let Ok(angle) = heading(&reference, direction) {
            assert!(angle.are_finite());
        }
        if let Ok(angle) = tried.update(&reference) {
            assert!(angle.are_finite(), "heading {angle}");
            assert_eq!(spared.update(&reference).map(|angle| angle.bits()), Ok(angle.bits()));
        }
        assert!(tried == spared, "a refused reference left a trace");
    }
    Ok(())
}
