use nalgebra::{SMatrix, SVector};

use super::{size, symmetric};
use crate::{Scalar, scalar::constant};

/// The matrices of a Riccati equation in a state z, x = D·z, D diagonal with powers of 2: so nothing is rounded on the way there and back.
///
/// The solution depends on the units of the state, the error of the computation should not: D makes the entries as small as they get.
#[derive(Debug, Clone, Copy)]
pub(super) struct Balanced<T, const N: usize> {
    /// D⁻¹·A·D.
    pub a: SMatrix<T, N, N>,
    /// D⁻¹·G·D⁻¹.
    pub g: SMatrix<T, N, N>,
    /// D·Q·D.
    pub q: SMatrix<T, N, N>,
    units: SVector<T, N>,
}

/// No unit is changed by more than 2 to this power: where an entry of D has no bound it has no use either.
const REACH: u8 = 40;

impl<T: Scalar, const N: usize> Balanced<T, N> {
    /// By coordinate descent: the sum of all entries is convex in the logarithm of each unit.
    pub fn new(a: SMatrix<T, N, N>, g: SMatrix<T, N, N>, q: SMatrix<T, N, N>) -> Self {
        let mut balanced = Self { a, g, q, units: SVector::repeat(T::one()) };
        let gain: T = constant(0.95);
        let farthest = constant::<T>((1_u64 << REACH) as f64);
        let within = |unit: T| unit <= farthest && unit.recip() <= farthest;
        for _ in 0..REACH {
            let mut moved = false;
            for i in 0..N {
                for factor in [constant(2.0), constant(0.5)] {
                    while within(balanced.units[i] * factor)
                        && balanced.sum(i, factor) < gain * balanced.sum(i, T::one())
                    {
                        balanced.change(i, factor);
                        moved = true;
                    }
                }
            }
            if !moved {
                break;
            }
        }
        balanced
    }

    /// The sum of the entries that change with unit `i`, if that is multiplied by `factor`.
    fn sum(&self, i: usize, factor: T) -> T {
        let (mut grows, mut shrinks) = (T::zero(), T::zero());
        for j in 0..N {
            if j != i {
                grows += self.a[(j, i)].abs() + self.q[(j, i)].abs();
                shrinks += self.a[(i, j)].abs() + self.g[(i, j)].abs();
            }
        }
        grows += self.q[(i, i)].abs() * factor;
        shrinks += self.g[(i, i)].abs() / factor;
        grows * factor + shrinks / factor
    }

    fn change(&mut self, i: usize, factor: T) {
        for j in 0..N {
            self.a[(j, i)] *= factor;
            self.a[(i, j)] /= factor;
            self.q[(j, i)] *= factor;
            self.q[(i, j)] *= factor;
            self.g[(j, i)] /= factor;
            self.g[(i, j)] /= factor;
        }
        self.units[i] *= factor;
    }

    /// The solution for x, D⁻¹·P·D⁻¹, from that for z.
    pub fn restored(&self, p: &SMatrix<T, N, N>) -> SMatrix<T, N, N> {
        // Where the first quotient is subnormal the two orders of division differ.
        symmetric(SMatrix::from_fn(|i, j| p[(i, j)] / self.units[i] / self.units[j]))
    }

    /// D⁻¹·B: what an input does to z.
    pub fn input<const M: usize>(&self, b: &SMatrix<T, N, M>) -> SMatrix<T, N, M> {
        SMatrix::from_fn(|i, j| b[(i, j)] / self.units[i])
    }

    /// The gain for x, K·D⁻¹, from that for z.
    pub fn gain<const M: usize>(&self, k: &SMatrix<T, M, N>) -> SMatrix<T, M, N> {
        SMatrix::from_fn(|i, j| k[(i, j)] / self.units[j])
    }

    /// A bound on the sizes of the eigenvalues of the Hamiltonian matrix, and more than that of those of A.
    pub fn rate(&self) -> T {
        let entries: T = constant(N as f64);
        let rate = (size(&self.a) + (size(&self.g) * size(&self.q)).sqrt()) * entries;
        if rate > T::zero() { rate * constant(1.25) } else { T::one() }
    }
}
