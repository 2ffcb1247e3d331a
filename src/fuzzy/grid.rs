use core::fmt::Debug;

use crate::{Scalar, scalar::epsilon};

/// What a rule can have one of: a number, or one for every rule again.
pub trait PerRule: Copy + Debug + PartialEq {}

impl<V: Copy + Debug + PartialEq> PerRule for V {}

/// The number of inputs of a network, as a type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Inputs<const I: usize>;

/// Storage for one value a rule: the nested array `[[V; K]; …; K]` of depth I, without allocation.
///
/// Stable Rust has no `[T; K.pow(I)]`; the nesting is its replacement, and the reason why networks have 1 to 6 inputs.
#[diagnostic::on_unimplemented(
    message = "a fuzzy network has 1 to 6 inputs",
    label = "no grid of rules over these inputs",
    note = "a full grid over more would have K^7 rules and more"
)]
pub trait Grid {
    /// `[[V; K]; …; K]`, Kᴵ values.
    type Cube<V: PerRule, const K: usize>: PerRule;

    /// `value` for every rule.
    fn filled<V: PerRule, const K: usize>(value: V) -> Self::Cube<V, K>;

    /// The sum of the values, each times Πᵢ rowsᵢ\[kᵢ\] for its rule (k₁, …, k_I): one input after another. One row an input; a missing row
    /// counts as ones.
    fn contracted<T: Scalar, const K: usize>(cube: &Self::Cube<T, K>, rows: &[[T; K]]) -> T;

    /// Adds `rate` times the weight `weight`·Πᵢ rowsᵢ\[kᵢ\] to the value of each rule. Weights below ε² are left out: beside those that sum
    /// up to 1 they are lost in rounding, and their products would soon be subnormal numbers, of which a step takes many times as long.
    fn add_outer<T: Scalar, const K: usize>(
        cube: &mut Self::Cube<T, K>,
        rows: &[[T; K]],
        weight: T,
        rate: T,
    );

    /// The values in the order of the rules, last input fastest.
    fn values<V: PerRule, const K: usize>(cube: &Self::Cube<V, K>) -> &[V];

    /// The values in the order of the rules, last input fastest.
    fn values_mut<V: PerRule, const K: usize>(cube: &mut Self::Cube<V, K>) -> &mut [V];
}

impl Grid for Inputs<1> {
    type Cube<V: PerRule, const K: usize> = [V; K];

    fn filled<V: PerRule, const K: usize>(value: V) -> [V; K] {
        [value; K]
    }

    fn contracted<T: Scalar, const K: usize>(cube: &[T; K], rows: &[[T; K]]) -> T {
        first(rows).iter().zip(cube).fold(T::zero(), |sum, (grade, value)| sum + *grade * *value)
    }

    fn add_outer<T: Scalar, const K: usize>(
        cube: &mut [T; K],
        rows: &[[T; K]],
        weight: T,
        rate: T,
    ) {
        for (value, grade) in cube.iter_mut().zip(first(rows)) {
            let weight = weight * grade;
            if weight >= negligible() {
                *value += rate * weight;
            }
        }
    }

    fn values<V: PerRule, const K: usize>(cube: &[V; K]) -> &[V] {
        cube
    }

    fn values_mut<V: PerRule, const K: usize>(cube: &mut [V; K]) -> &mut [V] {
        cube
    }
}

/// The row of the first input; ones if there is none.
fn first<T: Scalar, const K: usize>(rows: &[[T; K]]) -> [T; K] {
    rows.first().copied().unwrap_or([T::one(); K])
}

/// The rows of the inputs after the first.
fn others<T, const K: usize>(rows: &[[T; K]]) -> &[[T; K]] {
    rows.get(1..).unwrap_or_default()
}

/// ε².
fn negligible<T: Scalar>() -> T {
    epsilon::<T>() * epsilon()
}

/// The grid over `$inputs` inputs is K copies of the grid over one fewer; `$flatten` undoes the nesting once a level.
macro_rules! grid {
    ($inputs:literal = 1 + $fewer:literal, $($flatten:ident $flatten_mut:ident),+) => {
        impl Grid for Inputs<$inputs> {
            type Cube<V: PerRule, const K: usize> = [<Inputs<$fewer> as Grid>::Cube<V, K>; K];

            fn filled<V: PerRule, const K: usize>(value: V) -> Self::Cube<V, K> {
                [Inputs::<$fewer>::filled(value); K]
            }

            fn contracted<T: Scalar, const K: usize>(
                cube: &Self::Cube<T, K>,
                rows: &[[T; K]],
            ) -> T {
                first(rows).iter().zip(cube).fold(T::zero(), |sum, (grade, part)| {
                    sum + *grade * Inputs::<$fewer>::contracted(part, others(rows))
                })
            }

            fn add_outer<T: Scalar, const K: usize>(
                cube: &mut Self::Cube<T, K>,
                rows: &[[T; K]],
                weight: T,
                rate: T,
            ) {
                for (part, grade) in cube.iter_mut().zip(first(rows)) {
                    let weight = weight * grade;
                    if weight >= negligible() {
                        Inputs::<$fewer>::add_outer(part, others(rows), weight, rate);
                    }
                }
            }

            fn values<V: PerRule, const K: usize>(cube: &Self::Cube<V, K>) -> &[V] {
                cube$(.$flatten())+
            }

            fn values_mut<V: PerRule, const K: usize>(cube: &mut Self::Cube<V, K>) -> &mut [V] {
                cube$(.$flatten_mut())+
            }
        }
    };
}

grid!(2 = 1 + 1, as_flattened as_flattened_mut);
grid!(3 = 1 + 2, as_flattened as_flattened_mut, as_flattened as_flattened_mut);
grid!(4 = 1 + 3, as_flattened as_flattened_mut, as_flattened as_flattened_mut, as_flattened as_flattened_mut);
grid!(5 = 1 + 4, as_flattened as_flattened_mut, as_flattened as_flattened_mut, as_flattened as_flattened_mut, as_flattened as_flattened_mut);
grid!(6 = 1 + 5, as_flattened as_flattened_mut, as_flattened as_flattened_mut, as_flattened as_flattened_mut, as_flattened as_flattened_mut, as_flattened as_flattened_mut);
