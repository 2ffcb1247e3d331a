//! Calls of any kind, with numbers of any bits.

use brunovsky::{controller::ClelcCommand, prelude::*};
use replay::Real;

use crate::{by_hand::ByHand, failed};

/// A sequence of numbers of any bits: xorshift (G. Marsaglia, "Xorshift RNGs", 2003), and now and then a number as sensors send them.
pub struct Noise(u64);

impl Noise {
    /// The sequence that starts with `seed` ≠ 0.
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn number(&mut self) -> Real {
        let bits = self.bits();
        if bits & 7 == 0 {
            Real::from_bits((bits >> 3) as _)
        } else {
            (bits >> 40) as i16 as Real / 4096.0
        }
    }

    fn vector<const N: usize>(&mut self) -> SVector<Real, N> {
        SVector::from_fn(|_, _| self.number())
    }

    fn measurement<const NX: usize, const NU: usize>(&mut self) -> Measurement<Real, NX, NU> {
        let x = Measurement::new(self.vector::<NX>());
        match self.bits() & 3 {
            0 => x,
            1 => x.with_rate(self.vector::<NX>()),
            2 => x.with_applied(self.vector::<NU>()),
            _ => x.with_rate(self.vector::<NX>()).with_applied(self.vector::<NU>()),
        }
    }
}

/// What a controller is to follow, made of noise.
pub trait Noisy {
    /// One of them.
    fn noisy(noise: &mut Noise) -> Self;
}

impl<const N: usize> Noisy for Reference<Real, N> {
    fn noisy(noise: &mut Noise) -> Self {
        Reference::new(noise.vector::<N>(), noise.number())
    }
}

impl<const NX: usize> Noisy for SVector<Real, NX> {
    fn noisy(noise: &mut Noise) -> Self {
        noise.vector()
    }
}

impl<R: Noisy, const M: usize> Noisy for [R; M] {
    fn noisy(noise: &mut Noise) -> Self {
        core::array::from_fn(|_| R::noisy(noise))
    }
}

/// Calls `controller` many times. What it commands has to be finite.
pub fn stand<C, const NX: usize, const NU: usize>(mut controller: C, noise: &mut Noise)
where
    C: Controller<NX, NU, Scalar = Real>,
    C::Reference: Noisy,
{
    for _ in 0..200 {
        match noise.bits() & 31 {
            0 => controller.reset(),
            1 => controller.set_learning(LearningMode::Off),
            2 => controller.set_learning(LearningMode::Frozen),
            3 => controller.set_learning(LearningMode::Active),
            _ => {}
        }
        let measurement = noise.measurement();
        let reference = C::Reference::noisy(noise);
        let dt = noise.number();
        if let Ok(command) = controller.update(&measurement, &reference, dt) {
            let finite = command.input().iter().all(|u| u.is_finite());
            if !finite {
                failed();
            }
        }
    }
}

/// Calls the law written `by_hand` and the `composed` one alike: where one has an answer, the other has the same to the last bit.
pub fn agree<C>(mut by_hand: ByHand, mut composed: C, noise: &mut Noise)
where
    C: Controller<
            2,
            1,
            Scalar = Real,
            Reference = Reference<Real, 2>,
            Command = ClelcCommand<Real>,
        >,
{
    let bits = |shown: ClelcCommand<Real>| {
        let ClelcCommand { u, u_f, u_b, u_n, s } = shown;
        [u, u_f, u_b, u_n, s].map(Real::to_bits)
    };
    let mut answers = 0;
    for _ in 0..1000 {
        let measurement = noise.measurement();
        let reference = Reference::noisy(noise);
        let dt = noise.number().abs();
        let one = by_hand.update(&measurement, &reference, dt).ok().map(bits);
        let other = composed.update(&measurement, &reference, dt).ok().map(bits);
        if one != other {
            failed();
        }
        answers += u32::from(one.is_some());
    }
    if answers < 100 {
        failed();
    }
}
