//! What a hostile sensor or caller can do, decoded from bytes: the same for the fuzz targets and for the property tests.
//!
//! | file | who is attacked |
//! |---|---|
//! | [`chain`] | feedback linearization and CLELC, with every source of ė_n and every rule |
//! | [`classical`] | PID, linear-quadratic regulators, adaptive control, backstepping |
//! | [`learner`] | CLELC with every other network and rule |
//! | [`sliding`] | sliding modes, active disturbance rejection, and compensators on top of a controller |
//! | [`decoupling`] | the two-link arm |
//! | [`unicycle`] | the unicycle's controller, and the feedforward and heading of a planar reference |
//! | [`wrapped`] | `Limited` and `Supervised`, around a controller and around each other |
//! | [`watch`] | certificate, monitor and watchdog |
//! | [`gains`] | gains from values, λ and poles |
//! | [`network`] | membership functions and the fuzzy network, at rest and under a rule |
//! | [`elementary`] | sines, cosines and hypotenuses |
//! | [`channel`] | saturation, rate limit and all else that a signal passes |
//! | [`differentiator`] | every differentiator |
//! | [`solver`] | adaptive integration and events |
//! | [`trajectory`] | constructors, derivatives and limits of every trajectory |
//! | [`simulation`] | integrators, the sampled loop and the figures of merit |
//!
//! # What has to hold
//! Nothing panics. Every number in an `Ok` is finite. After an `Err` the object is as before, and two objects of which only one saw the bad calls
//! go on alike, bit for bit. After `reset` it answers as a new one does. With moderate parameters and a moderate past, a moderate call succeeds.
//!
//! # Why "as before" means bit for bit
//! `==` finds every difference but the sign of a zero, and no NaN equals itself. The sign of a zero shows in what `Debug` prints, which is exact for
//! every other number too; as that is slow, an eighth of the inputs ask for it. Without it, a sign that matters shows in what follows.

pub mod chain;
pub mod channel;
pub mod classical;
pub mod decoupling;
pub mod differentiator;
pub mod elementary;
pub mod gains;
pub mod learner;
pub mod network;
pub mod simulation;
pub mod sliding;
pub mod solver;
pub mod trajectory;
pub mod unicycle;
pub mod watch;
pub mod wrapped;

mod bytes;
mod controller;
mod numbers;
mod parts;

use bytes::Bytes;
pub use bytes::Float;

/// Runs an attack in the precision that the first byte names.
fn in_a_precision(data: &[u8], single: fn(&mut Bytes), double: fn(&mut Bytes)) {
    let mut bytes = Bytes::new(data);
    if bytes.single {
        single(&mut bytes);
    } else {
        double(&mut bytes);
    }
}

/// The entry of a file: its `run` at f32 or at f64.
macro_rules! attack {
    () => {
        /// Attacks with what `data` says.
        pub fn attack(data: &[u8]) {
            super::in_a_precision(data, run::<f32>, run::<f64>);
        }
    };
}
use attack;
