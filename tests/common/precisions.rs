//! Checks in both precisions, each under a name of its own.

/// Tests of the given names, each a module that runs a check generic over the scalar at f32 and at f64.
macro_rules! at_f32_and_f64 {
    ($($name:ident => $check:ident),+ $(,)?) => {
        $(mod $name {
            #[test]
            fn f32() {
                super::$check::<f32>();
            }

            #[test]
            fn f64() {
                super::$check::<f64>();
            }
        })+
    };
}
pub(crate) use at_f32_and_f64;
