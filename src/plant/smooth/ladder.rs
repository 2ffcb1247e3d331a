//! From equations to the ladder of plants.

/// `$plant`, a [`SmoothPlant`](super::SmoothPlant) generic over its scalar, is [`ControlAffine`](crate::plant::ControlAffine) by the same equations: to
/// simulate as it stands, whatever its relative degree. (One implementation for all would collide with the plants in chain form.)
macro_rules! control_affine {
    ($plant:ident, $nx:literal, $m:literal) => {
        impl<T: $crate::Scalar> $crate::plant::ControlAffine<$nx, $m> for $plant<T> {
            type Scalar = T;

            fn drift_field(&self, x: &nalgebra::SVector<T, $nx>) -> nalgebra::SVector<T, $nx> {
                $crate::plant::SmoothPlant::drift_field::<T>(self, (*x).into()).into()
            }

            fn input_fields(&self, x: &nalgebra::SVector<T, $nx>) -> nalgebra::SMatrix<T, $nx, $m> {
                $crate::plant::SmoothPlant::input_fields::<T>(self, (*x).into()).into()
            }
        }
    };
}
pub(in crate::plant) use control_affine;
