//! `Limited` and `Supervised`, around a controller and around each other.

use core::fmt::Debug;

use brunovsky::{
    Error,
    controller::{Controller, Limited, Mode, Supervised},
    learning::LearningMode,
};

use super::{
    Bytes, Float, attack,
    controller::{Attack, Decode},
    parts::{AnyChannel, Model, clelc},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = attacked::<T>(bytes);
}

fn attacked<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let kind = bytes.byte();
    let (model, answers) = Model::<T>::decode(bytes)?;
    let clelc = clelc::<_, T, 2, 2>(model, bytes)?;
    let actuator = AnyChannel::<T, 1>::decode(bytes)?;
    let fade = bytes.parameters::<T, 1>();
    let answers = answers && !bytes.wild;
    match kind % 4 {
        0 => {
            let controller = Limited::new(clelc, actuator);
            Attack::plain(answers).on(&controller, bytes);
        }
        1 => {
            let controller = Supervised::new(clelc, fade)?;
            supervision(answers).on(&controller, bytes);
        }
        2 => {
            let controller = Supervised::new(Limited::new(clelc, actuator), fade)?;
            supervision(answers).on(&controller, bytes);
        }
        _ => {
            let controller = Limited::new(Supervised::new(clelc, fade)?, actuator);
            Attack {
                settle: |limited: &mut Limited<_, _, _, 1>| hand_over(limited.controller_mut()),
                meddle: |limited, bytes| operate(limited.controller_mut(), bytes),
                ..Attack::plain(answers)
            }
            .on(&controller, bytes);
        }
    }
    Ok(())
}

/// The attack on a supervised controller, in which nothing can fail while the operator has the say.
fn supervision<C: Controller<2, 1, Scalar: Float> + PartialEq + Clone + Debug>(
    answers: bool,
) -> Attack<Supervised<C, C::Scalar, 1>> {
    Attack {
        always: |supervised| supervised.mode() == Mode::Manual,
        settle: hand_over,
        meddle: operate,
        ..Attack::plain(answers)
    }
}

/// The controller decides and learns, and the operator's input is 0.
fn hand_over<C: Controller<2, 1, Scalar: Float>>(supervised: &mut Supervised<C, C::Scalar, 1>) {
    supervised.select(Mode::Automatic(LearningMode::Active));
    let zero: C::Scalar = nalgebra::zero();
    assert_eq!(supervised.set_manual([zero]), Ok(()));
}

/// The operator takes over, hands back, or sets an input.
fn operate<C: Controller<2, 1, Scalar: Float> + PartialEq + Clone>(
    supervised: &mut Supervised<C, C::Scalar, 1>,
    bytes: &mut Bytes,
) {
    let before = supervised.clone();
    let mut select = |mode| {
        supervised.select(mode);
        let same = mode == before.mode();
        assert!(!same || *supervised == before, "the mode that is there was selected");
    };
    match bytes.byte() % 3 {
        0 => select(Mode::Manual),
        1 => select(Mode::Automatic(LearningMode::decode(bytes))),
        _ => {
            if supervised.set_manual(bytes.vector::<C::Scalar, 1>()).is_err() {
                assert!(*supervised == before, "a refused input left a trace");
            }
        }
    }
}
