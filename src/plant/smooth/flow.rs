use num_traits::Zero;

use super::SmoothPlant;
use crate::{
    Scalar,
    differentiation::{Arithmetic, Dual, Jet, Smooth},
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
///
/// The linearizing law of the flexible joint (N = 4) takes 1.3 to 1.5 times as long as the expressions derived by hand in `f64`, 1.6 to 2.3 times in
/// `f32`; 5 and 9 times if the plant's functions are not `#[inline]`. For a plant of order 6 with a sine and a product in every equation:
///
/// | N | 1 | 2 | 3 | 4 | 5 | 6 |
/// |---|---|---|---|---|---|---|
/// | time in ns | 17 | 53 | 61 | 95 | 104 | 131 |
///
/// `cargo bench --bench lie` prints both.
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

/// Order N by jets of N entries, which `$jets` finds, and of N + 1 = `$longer`.
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
                along::<_, _, NX, M, D, $n, $longer>(
                    plant,
                    start,
                    <Self as Flow<$n>>::jets(plant, start),
                )
            }
        }
    };
}

/// The same, by f of jets of `$fewer` entries.
macro_rules! next_order {
    ($fewer:literal + 1 = $n:literal, $_n:literal + 1 = $longer:literal) => {
        order!($n + 1 = $longer, |plant, start| {
            following(start, &plant.drift_field(<Self as Flow<$fewer>>::jets(plant, start)))
        });
    };
}

order!(1 + 1 = 2, |_plant, start| resting(start));
next_order!(1 + 1 = 2, 2 + 1 = 3);
next_order!(2 + 1 = 3, 3 + 1 = 4);
next_order!(3 + 1 = 4, 4 + 1 = 5);
next_order!(4 + 1 = 5, 5 + 1 = 6);
next_order!(5 + 1 = 6, 6 + 1 = 7);
next_order!(6 + 1 = 7, 7 + 1 = 8);
next_order!(7 + 1 = 8, 8 + 1 = 9);

/// The outputs along the motion `jets` from `start`: L_f^N h needs one entry more, and no slopes of it.
#[inline]
fn along<
    P,
    S,
    const NX: usize,
    const M: usize,
    const D: usize,
    const N: usize,
    const LONGER: usize,
>(
    plant: &P,
    start: &[Dual<S, D>; NX],
    jets: [Dual<Jet<S, N>, D>; NX],
) -> LieDerivatives<S, N, M, D>
where
    P: SmoothPlant<NX, M>,
    S: Smooth<P::Scalar>,
{
    let rates = plant.drift_field(each([Jet::zero(); NX], |i| jets[i].value));
    let longer: [Jet<S, LONGER>; NX] =
        each([Jet::zero(); NX], |i| Jet::starting(start[i].value, &rates[i]));
    let outputs = plant.outputs(longer);
    LieDerivatives {
        chains: each([[S::zero(); N]; M], |i| {
            each([S::zero(); N], |k| outputs[i].derivatives()[k])
        }),
        drift: each([S::zero(); M], |i| outputs[i].derivatives()[N]),
        slopes: slopes(&plant.outputs(jets)),
    }
}

/// The motion from `start` with `rates`.
#[inline]
fn following<S, const NX: usize, const D: usize, const J: usize, const K: usize>(
    start: &[Dual<S, D>; NX],
    rates: &[Dual<Jet<S, J>, D>; NX],
) -> [Dual<Jet<S, K>, D>; NX]
where
    S: Arithmetic,
{
    each([Dual::zero(); NX], |i| Dual {
        value: Jet::starting(start[i].value, &rates[i].value),
        slopes: each([Jet::zero(); D], |j| Jet::starting(start[i].slopes[j], &rates[i].slopes[j])),
    })
}

/// No motion.
#[inline]
fn resting<S: Arithmetic, const NX: usize, const D: usize, const K: usize>(
    start: &[Dual<S, D>; NX],
) -> [Dual<Jet<S, K>, D>; NX] {
    following(start, &[Dual::<Jet<S, 1>, D>::zero(); NX])
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
    each([Dual::zero(); NX], |i| Dual {
        value: x[i],
        slopes: each([S::zero(); M], |j| fields[j][i]),
    })
}

/// The derivatives of the slopes.
#[inline]
fn slopes<S: Arithmetic, const M: usize, const D: usize, const K: usize>(
    outputs: &[Dual<Jet<S, K>, D>; M],
) -> [[[S; K]; D]; M] {
    each([[[S::zero(); K]; D]; M], |i| {
        each([[S::zero(); K]; D], |j| *outputs[i].slopes[j].derivatives())
    })
}

/// `entries`, each replaced by `f` of its place: `array::from_fn` as a plain loop, which the compiler sees through at any size.
#[inline]
fn each<A, const N: usize>(mut entries: [A; N], f: impl Fn(usize) -> A) -> [A; N] {
    for (i, entry) in entries.iter_mut().enumerate() {
        *entry = f(i);
    }
    entries
}

/// The slopes of (h, L_f h, …, L_f^{K−1} h) for any K, for each output and direction: by K − 1 evaluations of f at the full length.
pub(super) fn all_slopes<P, S, T, const NX: usize, const M: usize, const D: usize, const K: usize>(
    plant: &P,
    start: &[Dual<S, D>; NX],
) -> [[[S; K]; D]; M]
where
    T: Scalar,
    P: SmoothPlant<NX, M, Scalar = T>,
    S: Smooth<T>,
{
    let mut jets: [Dual<Jet<S, K>, D>; NX] = resting(start);
    for _ in 1..K {
        jets = following(start, &plant.drift_field(jets));
    }
    slopes(&plant.outputs(jets))
}
