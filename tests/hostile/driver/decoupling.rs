//! Decoupling control of the two-link arm.

use brunovsky::{
    Error,
    controller::Decoupling,
    plant::{IntegratorChain, Link, TwoLinkArm},
};

use super::{
    Bytes, Float, attack,
    controller::Attack,
    parts::{clelc, flc},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = attacked::<T>(bytes);
}

fn attacked<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let chain = IntegratorChain::<T, 2>::new();
    let (arm, mut answers) = arm(bytes)?;
    let limit = bytes.odd().then(|| bytes.parameter());
    answers &= limit.is_none();
    if bytes.odd() {
        let chains = (clelc::<_, T, 2, 2>(chain, bytes)?, flc(chain, bytes)?);
        let mut controller = Decoupling::new(arm, chains);
        if let Some(limit) = limit {
            controller = controller.with_max_condition(limit)?;
        }
        Attack::plain(answers && !bytes.wild).on(&controller, bytes);
    } else {
        let chains = [clelc::<_, T, 2, 2>(chain, bytes)?, clelc(chain, bytes)?];
        let mut controller = Decoupling::new(arm, chains);
        if let Some(limit) = limit {
            controller = controller.with_max_condition(limit)?;
        }
        Attack::plain(answers && !bytes.wild).on(&controller, bytes);
    }
    Ok(())
}

/// An arm, and whether its M(q) is well conditioned everywhere.
fn arm<T: Float>(bytes: &mut Bytes) -> Result<(TwoLinkArm<T>, bool), Error> {
    if bytes.odd() {
        let half = T::one() / (T::one() + T::one());
        let link = Link { mass: T::one(), length: T::one(), centre: half, inertia: half };
        return Ok((TwoLinkArm::new([link; 2], [half; 2], T::one())?, true));
    }
    let [first, second] = [0; 2].map(|_| {
        let [mass, length, centre, inertia] = bytes.parameters();
        Link { mass, length, centre, inertia }
    });
    let arm = TwoLinkArm::new([first, second], bytes.parameters(), bytes.parameter())?;
    Ok((if bytes.odd() { arm.with_payload(bytes.parameter())? } else { arm }, false))
}
