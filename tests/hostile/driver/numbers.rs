//! All numbers of an output.

use brunovsky::{
    controller::{
        ActiveDisturbanceRejectionCommand, ClelcCommand, CompensatedCommand, DecouplingCommand,
        FeedbackLinearizationCommand, LimitedCommand, SupervisedCommand,
        sliding_mode::{SlidingModeCommand, SuperTwistingCommand},
        unicycle::UnicycleCommand,
    },
    learning::{Verdict, Watch},
};
use nalgebra::SVector;

use super::Float;

/// An output that shows its numbers.
pub trait Numbers {
    fn each(&self, see: &mut impl FnMut(f64));

    /// Whether every number is finite.
    fn are_finite(&self) -> bool {
        let mut finite = true;
        self.each(&mut |x| finite &= x.is_finite());
        finite
    }

    /// The bits of all numbers, one after the other.
    fn bits(&self) -> Bits {
        let mut bits = Bits { bits: [0; 40], count: 0 };
        self.each(&mut |x| {
            bits.bits[bits.count] = x.to_bits();
            bits.count += 1;
        });
        bits
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bits {
    bits: [u64; 40],
    count: usize,
}

impl<T: Float> Numbers for T {
    fn each(&self, see: &mut impl FnMut(f64)) {
        see(self.wide());
    }
}

impl<N: Numbers, const M: usize> Numbers for [N; M] {
    fn each(&self, see: &mut impl FnMut(f64)) {
        self.iter().for_each(|numbers| numbers.each(see));
    }
}

impl<N: Numbers> Numbers for Option<N> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        self.iter().for_each(|numbers| numbers.each(see));
    }
}

impl<A: Numbers, B: Numbers> Numbers for (A, B) {
    fn each(&self, see: &mut impl FnMut(f64)) {
        self.0.each(see);
        self.1.each(see);
    }
}

impl<T: Float, const N: usize> Numbers for SVector<T, N> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        self.iter().for_each(|x| see(x.wide()));
    }
}

impl<T: Float> Numbers for FeedbackLinearizationCommand<T> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.u, self.u_f, self.u_b].each(see);
    }
}

impl<T: Float> Numbers for ClelcCommand<T> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.u, self.u_f, self.u_b, self.u_n, self.s].each(see);
    }
}

impl<T: Float> Numbers for SlidingModeCommand<T> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.u, self.u_f, self.u_b, self.u_s, self.sigma].each(see);
    }
}

impl<T: Float> Numbers for SuperTwistingCommand<T> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.u, self.u_f, self.u_b, self.u_s, self.w, self.sigma].each(see);
    }
}

impl<T: Float, const N: usize> Numbers for ActiveDisturbanceRejectionCommand<T, N> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.u, self.u_f, self.u_b, self.f].each(see);
        self.z.each(see);
    }
}

impl<D: Numbers, T: Float> Numbers for CompensatedCommand<D, T> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.u, self.u_f, self.u_b, self.u_n, self.s].each(see);
        self.base.each(see);
    }
}

impl<T: Float, D: Numbers, const M: usize> Numbers for DecouplingCommand<T, D, M> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        self.u.each(see);
        self.nu.each(see);
        self.chains.each(see);
    }
}

impl<T: Float, D: Numbers> Numbers for UnicycleCommand<T, D> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.v, self.omega].each(see);
        self.decoupled.each(see);
    }
}

impl<D: Numbers, T: Float, const NU: usize> Numbers for LimitedCommand<D, T, NU> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        self.u.each(see);
        self.asked.each(see);
    }
}

impl<D: Numbers, T: Float, const NU: usize> Numbers for SupervisedCommand<D, T, NU> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        self.u.each(see);
        self.offset.each(see);
        if let Ok(asked) = &self.asked {
            asked.each(see);
        }
    }
}

impl<T: Float> Numbers for Verdict<T> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        self.allowed.each(see);
    }
}

impl<T: Float> Numbers for Watch<T> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.allowed, self.late].each(see);
    }
}
