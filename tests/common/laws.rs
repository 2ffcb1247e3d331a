//! Laws in both precisions, under the names of the functions.

/// Runs each law, a function generic over the scalar, as one test in `f32` and one in `f64`.
macro_rules! in_both_precisions {
    ($($law:ident),+ $(,)?) => {
        mod in_f32 {
            $(#[test] fn $law() { super::$law::<f32>(); })+
        }
        mod in_f64 {
            $(#[test] fn $law() { super::$law::<f64>(); })+
        }
    };
}
