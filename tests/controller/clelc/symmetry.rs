//! Symmetries of the whole loop: mirrored signs and changed units.

use brunovsky::{
    Scalar,
    controller::Clelc,
    controller::{ClelcCommand, Reference},
    fuzzy::{FuzzyNetwork, Grid, Inputs},
    learning::{
        Antecedents, BackwardDifference, ErrorRate, FilteredDifference, Fixed, Measured,
        ModelAided, NeuroFuzzy, SlidingMode, Switching,
    },
    plant::{FeedbackLinearizable, IntegratorChain, Pendulum, Uncertain, VanDerPol},
    simulation::Sample,
};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::{
    at_f32_and_f64,
    support::{learning, num, real, run},
};

/// x, u, u_f, u_b, u_n and s of one sample.
fn signals<T: Scalar, const N: usize>(
    sample: &Sample<T, Reference<T, N>, ClelcCommand<T>, N, 1>,
) -> (SVector<T, N>, SVector<T, 5>) {
    let command = sample.command;
    (sample.x, SVector::from([command.u, command.u_f, command.u_b, command.u_n, command.s]))
}

/// An odd plant and a network symmetric about 0 do not know left from right.
fn is_mirrored<P, E, T: Scalar, A>(model: P, error_rate: E, rule: SlidingMode<T, A>)
where
    P: FeedbackLinearizable<2, Scalar = T> + Copy,
    E: ErrorRate<T, 2> + Clone,
    A: Antecedents<FuzzyNetwork<T, 2, 3>> + Copy,
{
    let run_with_sign = |sign: T| {
        let plant = Uncertain::matched(model, move |t: T, x: &SVector<T, 2>, _: &_| {
            sign * (t + t).sin() + num::<T>(0.4) * x[0]
        });
        let reference =
            move |t: T| Reference::new([sign * t.sin(), sign * t.cos()], -sign * t.sin());
        let start = [sign * num(0.5), sign * num(-0.7)];
        run(&plant, learning(model, 2.0, error_rate.clone(), rule), reference, start, 0.01, 5.0)
    };
    let (right, left) = (run_with_sign(T::one()), run_with_sign(-T::one()));
    // Signs are exact, but mirrored rules are added up in the opposite order: a few roundings of u_n ≈ 10 a sample, which a difference
    // quotient multiplies by 1/dt = 100 and the loop, being stable, does not.
    let tolerance = 1e4 * real(T::default_epsilon());
    for (a, b) in right.iter().zip(&left) {
        let ((x_a, c_a), (x_b, c_b)) = (signals(a), signals(b));
        assert!(real((x_a + x_b).amax()) <= tolerance, "{a:?} {b:?}");
        assert!(real((c_a + c_b).amax()) <= tolerance, "{a:?} {b:?}");
    }
}

fn odd_plants_are_mirrored<T: Scalar>() {
    let flowing = SlidingMode::new(num::<T>(15.0)).unwrap();
    are_mirrored(flowing);
    are_mirrored(flowing.with_antecedents(Fixed));
    are_mirrored(flowing.with_switching(Switching::Implicit { delta: num(0.1) }).unwrap());
}

fn are_mirrored<T: Scalar, A: Antecedents<FuzzyNetwork<T, 2, 3>> + Copy>(rule: SlidingMode<T, A>) {
    let van_der_pol = VanDerPol::new(T::one()).unwrap();
    let pendulum = Pendulum::new(num(0.8), num(0.5), num(0.1), num(9.81)).unwrap();
    is_mirrored(van_der_pol, Measured, rule);
    is_mirrored(van_der_pol, BackwardDifference::new(), rule);
    is_mirrored(pendulum, FilteredDifference::new(num(0.02)).unwrap(), rule);
    is_mirrored(pendulum, ModelAided::new(), rule);
}

at_f32_and_f64! {
    mirroring_state_reference_and_uncertainty_mirrors_the_response => odd_plants_are_mirrored,
}

/// A loop on N integrators in units where lengths are `c` and times `tau` times as large as in the first.
fn in_units<E: ErrorRate<f64, N> + Clone, const N: usize>(
    c: f64,
    tau: f64,
    switching: Switching<f64>,
    error_rate: impl Fn(f64) -> E,
) -> Vec<(SVector<f64, N>, SVector<f64, 5>)>
where
    Inputs<N>: Grid,
{
    // x_i and e_i have the unit c/τ^(i−1); u, s, u_n, Δ and δ that of ẋ_n, c/τᴺ; α that of u_n a second.
    let unit = |order: usize| c / tau.powi(order as i32);
    let switching = match switching {
        Switching::Explicit { delta } => Switching::Explicit { delta: delta * unit(N) },
        other => other,
    };
    let rule = SlidingMode::new(5.0 * unit(N + 1)).unwrap();
    let rule = rule.with_antecedents(Fixed).with_switching(switching).unwrap();
    let network = FuzzyNetwork::<f64, N, 3>::evenly_spaced(core::array::from_fn(unit)).unwrap();
    let model = IntegratorChain::<f64, N>::new();
    let base = crate::support::flc(model, 2.0 / tau);
    let controller = Clelc::new(base, NeuroFuzzy::new(network, error_rate(tau), rule));
    let plant = Uncertain::matched(model, move |t: f64, x: &SVector<f64, N>, _: &_| {
        (3.0 * t / tau).sin() * unit(N) + 0.5 * x[0] / tau.powi(N as i32)
    });
    let reference = move |_| Reference::setpoint(0.7 * unit(0));
    let start = SVector::from_fn(|i, _| 0.3 * unit(i));
    let samples = run(&plant, controller, reference, start, 0.01 * tau, 2.0 * tau);
    samples
        .iter()
        .map(|sample| {
            let (x, command) = signals(sample);
            (SVector::from_fn(|i, _| x[i] / unit(i)), command / unit(N))
        })
        .collect()
}

fn does_not_depend_on_units<const N: usize>(c: f64, tau: f64)
where
    Inputs<N>: Grid,
{
    // Scaling by powers of two commutes with every rounding, so the runs agree to the last bit.
    for switching in [Switching::SetValued, Switching::Explicit { delta: 0.1 }] {
        macro_rules! compare {
            ($($error_rate:expr),+) => {$(
                assert_eq!(in_units::<_, N>(c, tau, switching, $error_rate), in_units::<_, N>(1.0, 1.0, switching, $error_rate));
            )+};
        }
        compare!(
            |_| Measured,
            |_| BackwardDifference::new(),
            |tau| FilteredDifference::new(0.02 * tau).unwrap(),
            |_| ModelAided::new()
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn other_units_of_length_and_time_change_nothing_but_the_units(c in -20..20_i32, tau in -10..10_i32) {
        let (c, tau) = (2.0_f64.powi(c), 2.0_f64.powi(tau));
        does_not_depend_on_units::<1>(c, tau);
        does_not_depend_on_units::<2>(c, tau);
        does_not_depend_on_units::<3>(c, tau);
    }
}
