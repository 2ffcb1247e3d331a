//! Feedback linearization and CLELC, with every source of ė_n and every rule.

use core::fmt::Debug;

use brunovsky::{
    Error,
    controller::Clelc,
    fuzzy::{Grid, Inputs},
    learning::NullCompensator,
    plant::{FeedbackLinearizable, IntegratorChain},
};

use super::{
    Bytes, Float, attack,
    controller::Attack,
    parts::{AnyClelc, AnySource, Model, clelc, flc, memberships},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = attacked::<T>(bytes);
}

fn attacked<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    match bytes.byte() % 6 {
        0 => {
            let (model, answers) = Model::<T>::decode(bytes)?;
            let flc = flc(model, bytes)?;
            Attack::plain(answers && !bytes.wild).on(&flc, bytes);
        }
        1 => {
            let (model, answers) = Model::<T>::decode(bytes)?;
            let (flc, source) = (flc(model, bytes)?, AnySource::decode(bytes)?);
            let clelc = Clelc::new(flc, NullCompensator::new(source));
            Attack::plain(answers && !bytes.wild).on(&clelc, bytes);
        }
        2 => on_clelc::<_, T, 1, 3>(IntegratorChain::new(), true, bytes)?,
        3 => on_clelc::<_, T, 3, 2>(IntegratorChain::new(), true, bytes)?,
        _ => {
            let (model, answers) = Model::<T>::decode(bytes)?;
            on_clelc::<_, T, 2, 3>(model, answers, bytes)?;
        }
    }
    Ok(())
}

fn on_clelc<P, T, const N: usize, const K: usize>(
    model: P,
    answers: bool,
    bytes: &mut Bytes,
) -> Result<(), Error>
where
    P: FeedbackLinearizable<N, Scalar = T> + Copy + PartialEq + Debug,
    T: Float,
    Inputs<N>: Grid,
{
    let clelc = clelc::<_, T, N, K>(model, bytes)?;
    let answers = answers && !bytes.wild;
    Attack { meddle: retrain, ..Attack::plain(answers) }.on(&clelc, bytes);
    Ok(())
}

/// Overwrites what was learned.
fn retrain<P, T, const N: usize, const K: usize>(
    clelc: &mut AnyClelc<P, T, N, K>,
    bytes: &mut Bytes,
) where
    P: FeedbackLinearizable<N, Scalar = T>,
    T: Float,
    Inputs<N>: Grid,
{
    let network = clelc.compensator_mut().network_mut();
    if bytes.odd() {
        let values = bytes.numbers::<T, 9>();
        let count = network.consequents().len().min(values.len());
        let _ = network.set_consequents(&values[..count]);
    } else if let Ok(memberships) = memberships(bytes) {
        network.set_memberships(memberships);
    }
}
