use core::ops::{Deref, DerefMut};

use super::{Grid, Inputs, PerRule};
use crate::{Error, Scalar, error::finite};

/// One value for each of the Kᴵ rules, in their order: a slice that is stored in place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rules<V: PerRule, const I: usize, const K: usize>(<Inputs<I> as Grid>::Cube<V, K>)
where
    Inputs<I>: Grid;

impl<V: PerRule, const I: usize, const K: usize> Rules<V, I, K>
where
    Inputs<I>: Grid,
{
    /// `value` for every rule.
    pub fn filled(value: V) -> Self {
        Self(Inputs::<I>::filled(value))
    }
}

impl<T: Scalar, const I: usize, const K: usize> Rules<T, I, K>
where
    Inputs<I>: Grid,
{
    /// `values`, one a rule, which are to be consequents.
    ///
    /// # Errors
    /// [`Error::Length`] unless there are Kᴵ of them, [`Error::NonFinite`] for one that is not finite.
    pub(super) fn consequents(values: &[T]) -> Result<Self, Error> {
        let mut rules = Self::filled(T::zero());
        let (expected, found) = (rules.len(), values.len());
        if expected != found {
            return Err(Error::Length { name: "consequents", expected, found });
        }
        for (own, value) in rules.iter_mut().zip(values) {
            *own = finite("consequent", *value)?;
        }
        Ok(rules)
    }

    /// Their mean, weighted with the outer product of `grades`.
    pub(super) fn mean(&self, grades: &[[T; K]; I]) -> T {
        Inputs::<I>::contracted(&self.0, grades)
    }

    /// Adds `rate` times the outer product of `grades`.
    pub(super) fn add(&mut self, grades: &[[T; K]; I], rate: T) {
        Inputs::<I>::add_outer(&mut self.0, grades, T::one(), rate);
    }
}

impl<V: PerRule, const I: usize, const K: usize> Deref for Rules<V, I, K>
where
    Inputs<I>: Grid,
{
    type Target = [V];

    fn deref(&self) -> &[V] {
        Inputs::<I>::values(&self.0)
    }
}

impl<V: PerRule, const I: usize, const K: usize> DerefMut for Rules<V, I, K>
where
    Inputs<I>: Grid,
{
    fn deref_mut(&mut self) -> &mut [V] {
        Inputs::<I>::values_mut(&mut self.0)
    }
}
