use core::array;

use super::SmoothPlant;
use crate::{
    Scalar,
    differentiation::{Dual, Jet, Smooth},
};

/// The outputs of a plant differentiated along its drift field, up to order N, and the slopes of that in D directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LieDerivatives<S, const N: usize, const M: usize, const D: usize> {
    /// (h, L_f h, …, L_f^{N−1} h), for each output.
    pub chains: [[S; N]; M],
    /// L_f^N h, for each output.
    pub drift: [S; M],
    /// The slopes of (h, L_f h, …, L_f^{N−1} h), for each output and direction.
    pub slopes: [[[S; N]; D]; M],
}

/// The motion along the drift field, ẋ = f(x).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Along;

/// Lie derivatives of order N, without symbols and without allocation.
///
/// L_f^k h is the k-th derivative of h along the motion ẋ = f(x), whose jet is its start followed by the jet of its rate: from a jet of k entries, f
/// makes one of k + 1. L_g L_f^k h is the slope of that where the start moves in the direction g(x).
///
/// Stable Rust has no length `N + 1`; an implementation for each N from 1 to 8 is its replacement. Each runs straight through, so that the compiler
/// finds what the longer jets have in common with the shorter ones.
#[diagnostic::on_unimplemented(
    message = "Lie derivatives have orders 1 to 8",
    label = "no Lie derivatives of order {N}"
)]
pub trait Flow<const N: usize> {
    /// The jets of the states, from `start`.
    fn jets<P, S, const NX: usize, const M: usize, const D: usize>(
        plant: &P,
        start: &[Dual<S, D>; NX],
    ) -> [Dual<Jet<S, N>, D>; NX]
    where
        P: SmoothPlant<NX, M>,
        S: Smooth<P::Scalar>;

    /// The Lie derivatives of the outputs, at `start`.
    fn lie<P, S, const NX: usize, const M: usize, const D: usize>(
        plant: &P,
        start: &[Dual<S, D>; NX],
    ) -> LieDerivatives<S, N, M, D>
    where
        P: SmoothPlant<NX, M>,
        S: Smooth<P::Scalar>;
}

/// Order N from jets of N entries, which `$jets` finds, and one of N + 1 = `$longer`; the last entry needs no slopes.
macro_rules! order {
    ($n:literal + 1 = $longer:literal, |$plant:ident, $start:ident| $jets:expr) => {
        impl Flow<$n> for Along {
            #[inline]
            fn jets<P, S, const NX: usize, const M: usize, const D: usize>(
                $plant: &P,
                $start: &[Dual<S, D>; NX],
            ) -> [Dual<Jet<S, $n>, D>; NX]
            where
                P: SmoothPlant<NX, M>,
                S: Smooth<P::Scalar>,
            {
                $jets
            }

            #[inline]
            fn lie<P, S, const NX: usize, const M: usize, const D: usize>(
                plant: &P,
                start: &[Dual<S, D>; NX],
            ) -> LieDerivatives<S, $n, M, D>
            where
                P: SmoothPlant<NX, M>,
                S: Smooth<P::Scalar>,
            {
                let jets = <Self as Flow<$n>>::jets(plant, start);
                let rates = plant.drift_field(jets.map(|x| x.value));
                let longer: [Jet<S, $longer>; NX] =
                    array::from_fn(|i| Jet::starting(start[i].value, &rates[i]));
                let outputs = plant.outputs(longer).map(|y| *y.derivatives());
                let slopes =
                    plant.outputs(jets).map(|y| y.slopes.map(|slope| *slope.derivatives()));
                LieDerivatives {
                    chains: outputs.map(|y| array::from_fn(|k| y[k])),
                    drift: outputs.map(|y| y[$n]),
                    slopes,
                }
            }
        }
    };
}

order!(1 + 1 = 2, |_plant, start| start.each_ref().map(|start| Dual {
    value: Jet::constant(start.value),
    slopes: start.slopes.map(Jet::constant),
}));

macro_rules! next_order {
    ($fewer:literal + 1 = $n:literal, $_n:literal + 1 = $longer:literal) => {
        order!($n + 1 = $longer, |plant, start| {
            following(start, &plant.drift_field(<Self as Flow<$fewer>>::jets(plant, start)))
        });
    };
}

next_order!(1 + 1 = 2, 2 + 1 = 3);
next_order!(2 + 1 = 3, 3 + 1 = 4);
next_order!(3 + 1 = 4, 4 + 1 = 5);
next_order!(4 + 1 = 5, 5 + 1 = 6);
next_order!(5 + 1 = 6, 6 + 1 = 7);
next_order!(6 + 1 = 7, 7 + 1 = 8);
next_order!(7 + 1 = 8, 8 + 1 = 9);

/// The motion from `start` with `rates`.
#[inline]
fn following<S, const NX: usize, const D: usize, const J: usize, const K: usize>(
    start: &[Dual<S, D>; NX],
    rates: &[Dual<Jet<S, J>, D>; NX],
) -> [Dual<Jet<S, K>, D>; NX]
where
    S: crate::differentiation::Arithmetic,
{
    array::from_fn(|i| Dual {
        value: Jet::starting(start[i].value, &rates[i].value),
        slopes: array::from_fn(|j| Jet::starting(start[i].slopes[j], &rates[i].slopes[j])),
    })
}

/// The state `x` with the slopes of the input fields.
#[inline]
pub(super) fn along_inputs<P, S, const NX: usize, const M: usize>(
    plant: &P,
    x: [S; NX],
) -> [Dual<S, M>; NX]
where
    P: SmoothPlant<NX, M>,
    S: Smooth<P::Scalar>,
{
    let fields = plant.input_fields(x);
    array::from_fn(|i| Dual { value: x[i], slopes: array::from_fn(|j| fields[j][i]) })
}

/// The slopes of (h, L_f h, …, L_f^{K−1} h) for any K, for each output and direction: by K − 1 evaluations of f at the full length.
pub(super) fn slopes<P, S, T, const NX: usize, const M: usize, const D: usize, const K: usize>(
    plant: &P,
    start: &[Dual<S, D>; NX],
) -> [[[S; K]; D]; M]
where
    T: Scalar,
    P: SmoothPlant<NX, M, Scalar = T>,
    S: Smooth<T>,
{
    let mut jets: [Dual<Jet<S, K>, D>; NX] = start.each_ref().map(|start| Dual {
        value: Jet::constant(start.value),
        slopes: start.slopes.map(Jet::constant),
    });
    for _ in 1..K {
        jets = following(start, &plant.drift_field(jets));
    }
    plant.outputs(jets).map(|y| y.slopes.map(|slope| *slope.derivatives()))
}
