//! Integrators, the sampled loop and the figures of merit.

use core::fmt::Debug;

use brunovsky::{
    Error,
    controller::Reference,
    integrators::{Euler, Heun, Integrator, Rk4},
    simulation::{ErrorMetrics, Simulation, StepInfo, TotalVariation},
};
use nalgebra::SVector;

use super::{
    Bytes, Float, attack,
    numbers::Numbers,
    parts::{Model, clelc},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = match bytes.byte() % 5 {
        0 => step_info::<T>(bytes),
        1 => metrics::<T>(bytes),
        2 => variation::<T>(bytes),
        3 => integrated::<T>(bytes),
        _ => simulated::<T>(bytes),
    };
}

fn step_info<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let info = StepInfo::<T>::new(bytes.number(), bytes.number())?;
    pushed(info, bytes, StepInfo::push, |info| {
        let times = [info.rise_time(), info.settling_time(), info.steady_state_error()];
        let sizes = [info.overshoot(), info.undershoot(), info.peak(), info.peak_time()];
        assert!(times.are_finite() && sizes.are_finite(), "{info:?}");
    });
    Ok(())
}

fn metrics<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    pushed(ErrorMetrics::<T>::default(), bytes, ErrorMetrics::push, |metrics| {
        let figures = [metrics.iae(), metrics.ise(), metrics.itae(), metrics.maximum()];
        assert!(figures.are_finite() && metrics.rms().are_finite(), "{metrics:?}");
    });
    Ok(())
}

fn variation<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let push = |variation: &mut TotalVariation<T>, _: T, u: T| variation.push(u);
    pushed(TotalVariation::default(), bytes, push, |variation| {
        assert!(variation.value().are_finite(), "{variation:?}");
    });
    Ok(())
}

/// Takes samples (t, y) with any t, or with one that advances.
fn pushed<F: Copy + PartialEq + Debug, T: Float>(
    mut figures: F,
    bytes: &mut Bytes,
    push: impl Fn(&mut F, T, T) -> Result<(), Error>,
    check: impl Fn(&F),
) {
    let mut t = T::zero();
    while !bytes.is_empty() {
        t = if bytes.odd() { bytes.number() } else { t + bytes.parameter() };
        let before = figures;
        match push(&mut figures, t, bytes.number()) {
            Ok(()) => check(&figures),
            Err(error) => {
                assert!(figures == before, "{error} left a trace");
                assert_eq!(format!("{figures:?}"), format!("{before:?}"), "{error} left a trace");
            }
        }
    }
}

fn integrated<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let method = bytes.byte();
    let (t, x, duration) = (bytes.number::<T>(), bytes.vector::<T, 2>(), bytes.parameter::<T>());
    let steps = u32::from(bytes.byte() % 9);
    let field = |t: T, x: &SVector<T, 2>| {
        assert!(t.are_finite(), "asked for {t}");
        match bytes.byte() % 3 {
            0 => -x,
            1 => x.component_mul(x),
            _ => bytes.vector(),
        }
    };
    let end = match method % 3 {
        0 => Euler.integrate(field, t, &x, duration, steps),
        1 => Heun.integrate(field, t, &x, duration, steps),
        _ => Rk4.integrate(field, t, &x, duration, steps),
    };
    assert!(end?.are_finite());
    Ok(())
}

fn simulated<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let (plant, _) = Model::<T>::decode(bytes)?;
    let controller = clelc::<_, T, 2, 2>(Model::<T>::decode(bytes)?.0, bytes)?;
    let (x0, dt) = (bytes.vector::<T, 2>(), bytes.parameter());
    let reference = Reference::new(bytes.vector::<T, 2>(), bytes.number());
    let run = Simulation::new(&plant, controller, |_| reference, x0, dt)?;
    let run = run.substeps(u32::from(bytes.byte() % 4))?;
    for sample in run.until(bytes.number())?.take(4) {
        let sample = sample?;
        assert!(sample.x.are_finite() && sample.u.are_finite() && sample.command.are_finite());
        assert!(sample.t.are_finite());
    }
    Ok(())
}
