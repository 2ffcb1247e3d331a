//! The attack on a controller: calls in any order, with anything in them.

use core::fmt::Debug;

use brunovsky::{
    Error,
    controller::{Controller, Measurement, Reference},
    learning::LearningMode,
};

use super::{Bytes, Float, numbers::Numbers};

/// Decoded from bytes.
pub trait Decode {
    fn decode(bytes: &mut Bytes) -> Self;
}

impl<T: Float, const N: usize> Decode for Reference<T, N> {
    fn decode(bytes: &mut Bytes) -> Self {
        Reference { r: bytes.vector(), r_n_dot: bytes.number() }
    }
}

impl<R: Decode, const M: usize> Decode for [R; M] {
    fn decode(bytes: &mut Bytes) -> Self {
        core::array::from_fn(|_| R::decode(bytes))
    }
}

impl<T: Float, const NX: usize, const NU: usize> Decode for Measurement<T, NX, NU> {
    fn decode(bytes: &mut Bytes) -> Self {
        Measurement {
            x: bytes.vector(),
            x_dot: bytes.odd().then(|| bytes.vector()),
            applied: bytes.odd().then(|| bytes.vector()),
        }
    }
}

impl Decode for LearningMode {
    fn decode(bytes: &mut Bytes) -> Self {
        match bytes.byte() % 3 {
            0 => LearningMode::Off,
            1 => LearningMode::Frozen,
            _ => LearningMode::Active,
        }
    }
}

/// An attack on controllers of type C.
pub struct Attack<C> {
    /// Whether a controller with these parameters answers every moderate call that measures ẋ.
    pub answers: bool,
    /// Whether it answers now, whatever is sent.
    pub always: fn(&C) -> bool,
    /// Brings what `reset` keeps, as far as a caller can change it, back to one and the same.
    pub settle: fn(&mut C),
    /// What else a caller can do.
    pub meddle: fn(&mut C, &mut Bytes),
}

/// The most calls in one attack.
const CALLS: u32 = 12;

impl<C: Clone + PartialEq + Debug> Attack<C> {
    /// The attack on a controller with no more to it than learning, which is on.
    pub fn plain<const NX: usize, const NU: usize>(answers: bool) -> Self
    where
        C: Controller<NX, NU>,
    {
        Self {
            answers,
            always: |_| false,
            settle: |controller| controller.set_learning(LearningMode::Active),
            meddle: |_, _| (),
        }
    }

    /// Attacks `fresh`, a new controller, with the calls that `bytes` say.
    pub fn on<const NX: usize, const NU: usize>(&self, fresh: &C, bytes: &mut Bytes)
    where
        C: Controller<NX, NU, Scalar: Float, Reference: Decode, Command: Numbers>,
    {
        let mut tried = fresh.clone();
        // Sees only the calls that succeed.
        let mut spared = fresh.clone();
        // Whether it has taken in anything that is not moderate.
        let mut wild = false;
        let mut snapshot = (fresh.clone(), wild);
        for _ in 0..CALLS {
            if bytes.is_empty() {
                break;
            }
            bytes.wild = false;
            match bytes.byte() % 16 {
                0 => {
                    for controller in [&mut tried, &mut spared] {
                        controller.reset();
                        (self.settle)(controller);
                    }
                    wild = false;
                }
                1 => {
                    let mode = LearningMode::decode(bytes);
                    tried.set_learning(mode);
                    spared.set_learning(mode);
                }
                2 => snapshot = (tried.clone(), wild),
                3 => {
                    wild = snapshot.1;
                    tried = snapshot.0.clone();
                    spared = snapshot.0.clone();
                }
                4..6 => {
                    let mut again = *bytes;
                    (self.meddle)(&mut spared, &mut again);
                    (self.meddle)(&mut tried, bytes);
                    wild |= bytes.wild;
                }
                _ => {
                    let call = Call::decode(bytes);
                    let always = (self.always)(&tried);
                    let answered = called(&mut tried, &mut spared, &call, bytes.deep);
                    if self.answers && !wild && !bytes.wild && call.is_complete() {
                        assert_eq!(answered, Ok(()), "a good call is refused");
                    }
                    assert!(!always || answered.is_ok(), "{answered:?}");
                    wild |= answered.is_ok() && bytes.wild;
                }
            }
        }
        tried.reset();
        self.as_new(tried, fresh.clone());
    }

    /// Whether a controller that has been reset answers as a new one, and answers at all.
    fn as_new<const NX: usize, const NU: usize>(&self, mut reset: C, mut fresh: C)
    where
        C: Controller<NX, NU, Scalar: Float, Reference: Decode, Command: Numbers>,
    {
        (self.settle)(&mut reset);
        (self.settle)(&mut fresh);
        assert!(reset == fresh, "reset is not as new");
        let mut bytes = Bytes::good();
        for _ in 0..3 {
            let call = Call::<C, NX, NU>::decode(&mut bytes);
            let update = |controller: &mut C| {
                let command = controller.update(&call.measurement, &call.reference, call.dt);
                // As text, because a NaN in an error is not equal to itself.
                command.map(|command| command.bits()).map_err(|error| error.to_string())
            };
            let (from_reset, from_fresh) = (update(&mut reset), update(&mut fresh));
            assert_eq!(from_reset, from_fresh, "reset is not as new");
            assert!(!self.answers || from_reset.is_ok(), "a good call is refused: {from_reset:?}");
        }
    }
}

/// One call: whether it is refused without a trace, or answered in finite numbers.
fn called<C, const NX: usize, const NU: usize>(
    tried: &mut C,
    spared: &mut C,
    call: &Call<C, NX, NU>,
    deep: bool,
) -> Result<(), Error>
where
    C: Controller<NX, NU, Scalar: Float, Reference: Decode, Command: Numbers>,
    C: PartialEq + Debug,
{
    let before = if deep { format!("{tried:?}") } else { String::new() };
    match tried.update(&call.measurement, &call.reference, call.dt) {
        Ok(command) => {
            assert!(command.are_finite(), "not finite");
            let again = spared.update(&call.measurement, &call.reference, call.dt);
            let again = again.map(|command| command.bits());
            assert_eq!(again, Ok(command.bits()), "the refused calls left a trace");
            assert!(*tried == *spared, "the refused calls left a trace");
            if deep {
                let after = format!("{tried:?}");
                assert!(!after.contains("NaN") && !after.contains("inf"), "{after}");
            }
            Ok(())
        }
        Err(error) => {
            assert!(*tried == *spared, "{error} left a trace");
            if deep {
                assert_eq!(format!("{tried:?}"), before, "{error} left a trace");
            }
            Err(error)
        }
    }
}

struct Call<C: Controller<NX, NU>, const NX: usize, const NU: usize> {
    measurement: Measurement<C::Scalar, NX, NU>,
    reference: C::Reference,
    dt: C::Scalar,
}

impl<C, const NX: usize, const NU: usize> Decode for Call<C, NX, NU>
where
    C: Controller<NX, NU, Scalar: Float, Reference: Decode>,
{
    fn decode(bytes: &mut Bytes) -> Self {
        Self {
            dt: bytes.parameter(),
            measurement: Measurement::decode(bytes),
            reference: C::Reference::decode(bytes),
        }
    }
}

impl<C: Controller<NX, NU>, const NX: usize, const NU: usize> Call<C, NX, NU> {
    /// Whether it has all that a source of ė_n may ask for.
    fn is_complete(&self) -> bool {
        self.measurement.x_dot.is_some()
    }
}
