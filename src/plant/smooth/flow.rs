use core::array;

use super::SmoothPlant;
use crate::differentiation::{Dual, Jet, Smooth};

/// The motion along the drift field ẋ = f(x), as jets of up to nine entries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Along;

/// (h, L_f h, …, L_f^{N−1} h), L_f^N h and the slopes of L_f^{N−1} h, for outputs h of a plant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LieDerivatives<S, const N: usize, const M: usize, const D: usize> {
    pub chains: [[S; N]; M],
    pub drift: [S; M],
    pub slopes: [[S; D]; M],
}

/// Lie derivatives of the outputs up to order N, by a jet of N + 1 entries along the flow of the drift field.
///
/// L_f^k h is the k-th derivative of h along the flow, and the flow's jet is its start followed by the jet of its rate f(x): a jet of k entries gives one
/// of k + 1. Stable Rust has no `N + 1`; the implementations for N = 1 … 8 are its replacement, and run straight through.
pub trait Flow<const N: usize> {
    /// The jets of x, …, from a start with slopes in D directions.
    fn jets<P, S, const NX: usize, const M: usize, const D: usize>(
        plant: &P,
        start: &[Dual<S, D>; NX],
    ) -> [Dual<Jet<S, N>, D>; NX]
    where
        P: SmoothPlant<NX, M>,
        S: Smooth<P::Scalar>;

    /// The Lie derivatives of the outputs.
    fn lie<P, S, const NX: usize, const M: usize, const D: usize>(
        plant: &P,
        start: &[Dual<S, D>; NX],
    ) -> LieDerivatives<S, N, M, D>
    where
        P: SmoothPlant<NX, M>,
        S: Smooth<P::Scalar>;
}

macro_rules! flow {
    ($n:literal, $more:literal, |$plant:ident, $start:ident| $jets:expr) => {
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
                let jets = <Along as Flow<$n>>::jets(plant, start);
                let values = jets.map(|x| x.value);
                let rates = plant.drift_field(values);
                let longer: [Jet<S, $more>; NX] =
                    array::from_fn(|i| Jet::starting(start[i].value, &rates[i]));
                let outputs = plant.outputs(longer).map(|y| *y.derivatives());
                let slopes = plant.outputs(jets).map(|y| y.slopes.map(|s| s.derivatives()[$n - 1]));
                LieDerivatives {
                    chains: outputs.map(|y| array::from_fn(|k| y[k])),
                    drift: outputs.map(|y| y[$n]),
                    slopes,
                }
            }
        }
    };
}

/// A jet of one entry is the start.
fn at<S: Smooth<T>, T: crate::Scalar, const D: usize>(start: &Dual<S, D>) -> Dual<Jet<S, 1>, D> {
    Dual { value: Jet::new([start.value]), slopes: start.slopes.map(|s| Jet::new([s])) }
}

flow!(1, 2, |_plant, start| array::from_fn(|i| at(&start[i])));

macro_rules! longer {
    ($n:literal = 1 + $fewer:literal, $more:literal) => {
        flow!($n, $more, |plant, start| {
            let known = <Along as Flow<$fewer>>::jets(plant, start);
            let rates = plant.drift_field(known);
            array::from_fn(|i| {
                let (start, rate) = (&start[i], &rates[i]);
                Dual {
                    value: Jet::starting(start.value, &rate.value),
                    slopes: array::from_fn(|j| Jet::starting(start.slopes[j], &rate.slopes[j])),
                }
            })
        });
    };
}

longer!(2 = 1 + 1, 3);
longer!(3 = 1 + 2, 4);
longer!(4 = 1 + 3, 5);
longer!(5 = 1 + 4, 6);
longer!(6 = 1 + 5, 7);
longer!(7 = 1 + 6, 8);
longer!(8 = 1 + 7, 9);
