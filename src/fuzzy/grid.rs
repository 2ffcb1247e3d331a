use crate::Scalar;

/// The number of inputs of a network, as a type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Inputs<const I: usize>;

/// Storage for one value a rule: the nested array `[[T; K]; …; K]` of depth I, without allocation.
///
/// Stable Rust has no `[T; K.pow(I)]`; the nesting is its replacement, and the reason why networks have 1 to 6 inputs.
#[diagnostic::on_unimplemented(
    message = "a fuzzy network has 1 to 6 inputs",
    label = "no grid of rules over these inputs",
    note = "a full grid over more would have K^7 rules and more"
)]
pub trait Grid {
    /// `[[T; K]; …; K]`, Kᴵ values.
    type Cube<T: Scalar, const K: usize>: Copy + core::fmt::Debug + PartialEq;

    /// `value` for every rule.
    fn filled<T: Scalar, const K: usize>(value: T) -> Self::Cube<T, K>;

    /// `scale` times the outer product of the rows: entry (k₁, …, k_I) is scale·Πᵢ rowsᵢ\[kᵢ\]. One row an input; a missing
    /// row counts as ones.
    fn outer<T: Scalar, const K: usize>(rows: &[[T; K]], scale: T) -> Self::Cube<T, K>;

    /// The values in the order of the rules, last input fastest.
    fn values<T: Scalar, const K: usize>(cube: &Self::Cube<T, K>) -> &[T];

    /// The values in the order of the rules, last input fastest.
    fn values_mut<T: Scalar, const K: usize>(cube: &mut Self::Cube<T, K>) -> &mut [T];
}

impl Grid for Inputs<1> {
    type Cube<T: Scalar, const K: usize> = [T; K];

    fn filled<T: Scalar, const K: usize>(value: T) -> [T; K] {
        [value; K]
    }

    fn outer<T: Scalar, const K: usize>(rows: &[[T; K]], scale: T) -> [T; K] {
        match rows.first() {
            Some(row) => row.map(|grade| scale * grade),
            None => [scale; K],
        }
    }

    fn values<T: Scalar, const K: usize>(cube: &[T; K]) -> &[T] {
        cube
    }

    fn values_mut<T: Scalar, const K: usize>(cube: &mut [T; K]) -> &mut [T] {
        cube
    }
}

/// The grid over `$inputs` inputs is K copies of the grid over one fewer; `$flatten` undoes the nesting once a level.
macro_rules! grid {
    ($inputs:literal = 1 + $fewer:literal, $($flatten:ident $flatten_mut:ident),+) => {
        impl Grid for Inputs<$inputs> {
            type Cube<T: Scalar, const K: usize> = [<Inputs<$fewer> as Grid>::Cube<T, K>; K];

            fn filled<T: Scalar, const K: usize>(value: T) -> Self::Cube<T, K> {
                [Inputs::<$fewer>::filled(value); K]
            }

            fn outer<T: Scalar, const K: usize>(rows: &[[T; K]], scale: T) -> Self::Cube<T, K> {
                match rows {
                    [row, rest @ ..] => row.map(|grade| Inputs::<$fewer>::outer(rest, scale * grade)),
                    [] => Self::filled(scale),
                }
            }

            fn values<T: Scalar, const K: usize>(cube: &Self::Cube<T, K>) -> &[T] {
                cube$(.$flatten())+
            }

            fn values_mut<T: Scalar, const K: usize>(cube: &mut Self::Cube<T, K>) -> &mut [T] {
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
