//! The neuro-fuzzy network against its textbook definition, symmetries and closed forms.

#[macro_use]
#[path = "../common/laws.rs"]
mod laws;
#[path = "../common/numbers.rs"]
mod numbers;

/// Calls `law::<T, I, K>()` for networks with one to six inputs.
macro_rules! for_every_shape {
    ($law:ident::<$T:ident>) => {
        $law::<$T, 1, 1>();
        $law::<$T, 1, 5>();
        $law::<$T, 2, 3>();
        $law::<$T, 3, 4>();
        $law::<$T, 4, 3>();
        $law::<$T, 5, 2>();
        $law::<$T, 6, 1>();
        $law::<$T, 6, 3>();
    };
}

mod gaussian;
mod grid;
mod interval;
mod network;
mod support;
mod triangular;
mod triangular_network;
