//! What the loop learns: s is the negative of what is not learned yet, and a constant uncertainty is learned completely.

use brunovsky::{
    Scalar,
    controller::{Controller, Measurement, Reference},
    fuzzy::{FuzzyNetwork, Grid, Inputs},
    learning::{
        Antecedents, BackwardDifference, ErrorRate, FilteredDifference, Fixed, Flow,
        GradientDescent, Measured, ModelAided, NeuroFuzzy, SlidingMode,
    },
    plant::{
        FeedbackLinearizable, IntegratorChain, Pendulum, Plant, ThirdOrder, Uncertain, VanDerPol,
    },
    simulation::Simulation,
};
use nalgebra::SVector;

use crate::{
    at_f32_and_f64,
    support::{flc, learning, num, real, run},
};

const DT: f64 = 0.01;

fn rule<T: Scalar>(alpha: f64) -> SlidingMode<T> {
    SlidingMode::new(num(alpha)).unwrap()
}

/// Δ(t, x, u), a function of all three.
fn delta<T: Scalar>(t: T, x: &SVector<T, 3>, u: &SVector<T, 1>) -> T {
    num::<T>(2.0) * t.sin() + num::<T>(0.3) * x[0] - num::<T>(0.1) * u[0]
}

/// s(k) = −(u_n(k−1) + Δ(k)) with the exact ė_n, where Δ is that of the period before the sample, and
/// b·u = −a + u_f + u_b + u_n at every sample.
fn the_identities_of_the_loop<T: Scalar>() {
    let model = ThirdOrder::<T>::new();
    let plant = Uncertain::matched(model, delta::<T>);
    let reference = |t: T| Reference::new([t.sin(), t.cos(), -t.sin()], -t.cos());
    let controller = learning(model, 2.0, Measured, rule(15.0));
    let samples = run(&plant, controller, reference, [1.0, -1.0, -2.0].map(num), DT, 10.0);
    let (mut u_n, mut u) = (T::zero(), SVector::<T, 1>::zeros());
    for sample in &samples {
        let command = sample.command;
        let (a, b) = (model.drift(&sample.x), model.input_gain(&sample.x));
        let size = real(a.abs() + command.u_b.abs() + command.u_n.abs() + u[0].abs() + T::one());
        // A dozen roundings of terms of that size.
        let tolerance = 12.0 * size * real(T::default_epsilon());
        let expected = -(u_n + delta(sample.t, &sample.x, &u));
        approx::assert_abs_diff_eq!(real(command.s), real(expected), epsilon = tolerance);
        let nu = command.u_f + command.u_b + command.u_n;
        approx::assert_abs_diff_eq!(real(a + b * command.u), real(nu), epsilon = tolerance);
        (u_n, u) = (command.u_n, sample.u);
    }
}

/// With exact ė_n, set-valued sign and constant Δ, u_n = −Δ from the certificate's time on, and the error then decays freely:
/// |e| falls like t^(N−1)·e^(−λt).
fn a_constant_is_learned_in_the_certified_time<T: Scalar, const N: usize>(size: f64)
where
    Inputs<N>: Grid,
{
    let model = IntegratorChain::<T, N>::new();
    let plant = Uncertain::matched(model, |_: T, _: &_, _: &_| num::<T>(size));
    let rule = rule::<T>(5.0);
    let controller = learning(model, 3.0, Measured, rule);
    let samples =
        run(&plant, controller, |_| Reference::setpoint(T::zero()), SVector::zeros(), DT, 15.0);
    let certificate = rule.certificate(num(DT), T::zero()).unwrap();
    let promised = certificate.reaching_time(samples[0].command.s).unwrap().unwrap();
    let rounding = 64.0 * real(T::default_epsilon()) * size.abs();
    for sample in &samples {
        if sample.t >= promised {
            approx::assert_abs_diff_eq!(real(sample.command.u_n), -size, epsilon = rounding);
        }
    }
    // Not earlier either: the rule moves by α·h a sample, and the first one moves it at t = 0.
    let early = samples.iter().rfind(|sample| sample.t < promised - num(1.5 * DT)).unwrap();
    assert!(real((early.command.u_n + num(size)).abs()) > rounding);
    // At the end nothing is left for the feedback, within the rounding of Δ.
    let last = samples.last().unwrap();
    approx::assert_abs_diff_eq!(real(last.command.u_b), 0.0, epsilon = 4.0 * rounding);
    approx::assert_abs_diff_eq!(real(last.x.amax()), 0.0, epsilon = 4.0 * rounding);
}

fn on_chains_of_one_to_four<T: Scalar>() {
    for size in [1.3, -0.8] {
        a_constant_is_learned_in_the_certified_time::<T, 1>(size);
        a_constant_is_learned_in_the_certified_time::<T, 2>(size);
        a_constant_is_learned_in_the_certified_time::<T, 3>(size);
        a_constant_is_learned_in_the_certified_time::<T, 4>(size);
    }
}

at_f32_and_f64! {
    s_is_what_is_not_learned_yet_and_the_shares_add_up => the_identities_of_the_loop,
    a_constant_uncertainty_is_learned_completely_in_the_certified_time => on_chains_of_one_to_four,
}

/// Whatever delays ė_n, the loop comes to rest only where s = ė_n + k·e = 0 with ė_n = 0 and e₂ = 0, that is on the setpoint, and there
/// u_n = −Δ.
fn learns_with<P, E, A>(model: P, error_rate: E, antecedents: A)
where
    P: FeedbackLinearizable<2, Scalar = f64> + Copy,
    E: ErrorRate<f64, 2> + Clone,
    A: Antecedents<FuzzyNetwork<f64, 2, 3>> + Clone,
{
    let plant = Uncertain::matched(model, |_: f64, _: &_, _: &_| 0.9);
    let rule = rule(5.0).with_antecedents(antecedents);
    let controller = learning(model, 2.0, error_rate, rule);
    let samples = run(&plant, controller, |_| Reference::setpoint(0.5), [0.0, 0.0], DT, 40.0);
    let last = samples.last().unwrap();
    approx::assert_abs_diff_eq!(last.command.u_n, -0.9, epsilon = 1e-8);
    approx::assert_abs_diff_eq!(last.command.u_b, 0.0, epsilon = 1e-8);
    approx::assert_abs_diff_eq!(last.x, SVector::from([0.5, 0.0]), epsilon = 1e-8);
}

fn learns_on<P, A>(model: P, antecedents: A)
where
    P: FeedbackLinearizable<2, Scalar = f64> + Copy,
    A: Antecedents<FuzzyNetwork<f64, 2, 3>> + Copy,
{
    learns_with(model, Measured, antecedents);
    learns_with(model, BackwardDifference::new(), antecedents);
    learns_with(model, FilteredDifference::new(0.02).unwrap(), antecedents);
    learns_with(model, ModelAided::new(), antecedents);
}

#[test]
fn every_source_of_the_error_rate_leads_to_the_setpoint() {
    let (chain, oscillator) = (IntegratorChain::new(), VanDerPol::new(1.0).unwrap());
    let pendulum = Pendulum::new(0.8, 0.5, 0.1, 9.81).unwrap();
    learns_on(chain, Fixed);
    learns_on(chain, Flow::default());
    learns_on(oscillator, Fixed);
    learns_on(oscillator, Flow::default());
    learns_on(pendulum, Fixed);
    learns_on(pendulum, Flow::default());
}

/// A run leaves something behind, and `reset` takes all of it away.
fn forgets<
    C: Controller<2, 1, Scalar = f64, Reference = Reference<f64, 2>>
        + Clone
        + PartialEq
        + core::fmt::Debug,
>(
    fresh: C,
) {
    let plant =
        Uncertain::matched(IntegratorChain::<f64, 2>::new(), |t: f64, _: &_, _: &_| t.sin());
    let mut used = fresh.clone();
    run(&plant, &mut used, |_| Reference::setpoint(1.0), [0.3, -0.2], DT, 1.0);
    assert_ne!(used, fresh);
    used.reset();
    assert_eq!(used, fresh);
}

#[test]
fn reset_makes_it_equal_to_a_fresh_one() {
    let model = IntegratorChain::<f64, 2>::new();
    let (flowing, fixed) = (rule(5.0), rule(5.0).with_antecedents(Fixed));
    forgets(learning(model, 2.0, Measured, flowing));
    forgets(learning(model, 2.0, BackwardDifference::new(), flowing));
    forgets(learning(model, 2.0, FilteredDifference::new(0.1).unwrap(), flowing));
    forgets(learning(model, 2.0, ModelAided::new(), flowing));
    forgets(learning(model, 2.0, Measured, fixed));
    forgets(learning(model, 2.0, BackwardDifference::new(), fixed));
    forgets(learning(model, 2.0, FilteredDifference::new(0.1).unwrap(), fixed));
    forgets(learning(model, 2.0, ModelAided::new(), fixed));
    let network = FuzzyNetwork::<f64, 2, 3>::evenly_spaced([1.0, 2.0]).unwrap();
    let gradient =
        NeuroFuzzy::new(network, BackwardDifference::new(), GradientDescent::new(3.0).unwrap());
    forgets(brunovsky::controller::Clelc::new(flc(model, 2.0), gradient));
}

#[test]
fn a_controller_that_goes_on_in_a_second_run_knows_what_it_learned_in_the_first() {
    let model = IntegratorChain::<f64, 2>::new();
    let plant = Uncertain::matched(model, |_: f64, _: &_, _: &_| 0.9);
    let mut controller = learning(model, 2.0, Measured, rule(5.0));
    run(&plant, &mut controller, |_| Reference::setpoint(0.0), [0.0, 0.0], DT, 10.0);
    let again =
        Simulation::new(&plant, &mut controller, |_| Reference::setpoint(0.0), [0.0, 0.0], DT)
            .unwrap();
    // The new run starts from u = 0, which the simulation reports as applied.
    let first = again.until(0.0).unwrap().next().unwrap().unwrap();
    approx::assert_abs_diff_eq!(first.command.u_n, -0.9, epsilon = 1e-12);
}

#[test]
fn its_parts_can_be_looked_at_and_the_network_set() {
    let model = VanDerPol::new(0.7).unwrap();
    let mut controller = learning(model, 2.0, Measured, rule(1.0));
    assert_eq!(*controller.base(), flc(model, 2.0));
    assert_eq!(
        controller.base().model().derivative(0.0, &[1.0, 2.0].into(), &[3.0].into()),
        SVector::from([2.0, 2.0])
    );
    let fresh = controller;
    // All consequents alike are a constant output; −Δ̂ = 0.25 is forgotten by at most α·h in a sample.
    controller.compensator_mut().network_mut().set_consequents(&[0.25; 9]).unwrap();
    assert_ne!(controller, fresh);
    let at_rest = Measurement::new([0.0, 0.0]).with_rate([0.0, 0.0]);
    let command = controller.update(&at_rest, &Reference::setpoint(0.0), DT).unwrap();
    approx::assert_abs_diff_eq!(command.s, -0.25, epsilon = 1e-15);
    approx::assert_abs_diff_eq!(command.u_n, 0.25 - DT, epsilon = 1e-15);
    let known = controller.compensator().network().evaluate(&SVector::zeros()).unwrap();
    assert_eq!(known, command.u_n);
    controller.reset();
    assert_eq!(controller, fresh);
}
