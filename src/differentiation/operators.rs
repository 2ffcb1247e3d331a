//! The operators that follow from others.

/// From the four operations among `$number`: the assigning ones, and the neutral elements from their plain values.
macro_rules! operators {
    ([$($parameters:tt)*] $number:ty, zero: $zero:expr, one: $one:expr) => {
        operators!(@assign [$($parameters)*] $number, AddAssign add_assign +);
        operators!(@assign [$($parameters)*] $number, SubAssign sub_assign -);
        operators!(@assign [$($parameters)*] $number, MulAssign mul_assign *);
        operators!(@assign [$($parameters)*] $number, DivAssign div_assign /);

        impl<$($parameters)*> num_traits::Zero for $number {
            #[inline]
            fn zero() -> Self {
                $zero
            }

            #[inline]
            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }

        impl<$($parameters)*> num_traits::One for $number {
            #[inline]
            fn one() -> Self {
                $one
            }
        }
    };
    (@assign [$($parameters:tt)*] $number:ty, $trait:ident $method:ident $operator:tt) => {
        impl<$($parameters)*> core::ops::$trait for $number {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    };
}
pub(super) use operators;
