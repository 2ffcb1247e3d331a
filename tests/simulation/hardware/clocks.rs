//! Periods, lateness and the ends of runs.

use brunovsky::{
    Error,
    channel::Ideal,
    plant::IntegratorChain,
    simulation::{Hardware, Simulation},
};
use nalgebra::SVector;
use proptest::prelude::*;

use super::Recorded;

fn still() -> Recorded<fn(&SVector<f64, 1>) -> f64, 1> {
    Recorded::new(|_| 0.0)
}

const PLANT: IntegratorChain<f64, 1> = IntegratorChain::new();

#[test]
fn a_period_of_no_tick_is_refused_by_name() {
    let named = |name| Error::NotPositive { name, value: 0.0 };
    let every = |s, c, a| Hardware::default().every(s, c, a).unwrap_err();
    assert_eq!(every(0, 1, 1), named("sensor period"));
    assert_eq!(every(1, 0, 1), named("controller period"));
    assert_eq!(every(1, 1, 0), named("actuator period"));
}

#[test]
fn a_call_that_would_be_late_by_its_period_is_refused() {
    let refusal = Error::NotBelow { name: "lateness", value: 3.0, limit: 3.0 };
    let late = |from: u64| {
        let hardware = Hardware::default().every(1, 3, 1).unwrap();
        let hardware = hardware.late(move |k| if k < from { 2 } else { 3 });
        Simulation::with_hardware(&PLANT, hardware, still(), |t| t, [0.0], 0.1)
    };
    assert_eq!(late(0).err(), Some(refusal));
    // Call 1 asks when call 2 is due.
    let mut run = late(2).unwrap();
    assert!(run.next().unwrap().is_ok());
    assert_eq!(run.next().unwrap().err(), Some(refusal));
    assert!(run.next().is_none());
}

/// 0.1·3 is not 0.3 in binary; an end at 0.3 still has the tick 3.
#[test]
fn a_run_ends_with_the_last_tick_at_or_before_its_end() {
    let count = |every, t_end| {
        let hardware = Hardware::default().every(1, every, 1).unwrap();
        let run = Simulation::with_hardware(&PLANT, hardware, still(), |t| t, [0.0], 0.1).unwrap();
        let ticks = run.clone().until(t_end).unwrap().ticks().count();
        (run.until(t_end).unwrap().count(), ticks)
    };
    assert_eq!(count(1, 0.3), (4, 4));
    assert_eq!(count(2, 0.3), (2, 4));
    assert_eq!(count(3, 0.3), (2, 4));
    assert_eq!(count(3, 0.29), (1, 3));
    assert_eq!(count(7, 0.0), (1, 1));
}

proptest! {
    /// Calls come at k·period + lateness, the controller is told the time since the call before, and k counts them.
    #[test]
    fn calls_come_when_they_are_due(period in 1..6_u32, lateness in prop::collection::vec(0..6_u64, 20)) {
        let lateness: Vec<u64> = lateness.iter().map(|late| late % u64::from(period)).collect();
        let due: Vec<f64> =
            (0..).zip(&lateness).map(|(k, late)| (k * u64::from(period) + late) as f64).collect();
        let hardware = Hardware::default().every(1, period, 1).unwrap();
        let hardware = hardware.late(move |k| lateness.get(k as usize).copied().unwrap_or(0));
        let controller = still();
        let heard = controller.heard.clone();
        // Powers of two: no rounding.
        let run = Simulation::with_hardware(&PLANT, hardware, controller, |t| t, [0.0], 0.25).unwrap();
        for (k, sample) in (0..20_usize).zip(run) {
            let sample = sample.unwrap();
            let last = k.checked_sub(1).map_or(due[0] - f64::from(period), |last| due[last]);
            prop_assert_eq!((sample.k, sample.t), (k as u64, due[k] * 0.25));
            prop_assert_eq!(heard.borrow()[k].0, sample.t);
            prop_assert_eq!(heard.borrow()[k].2, (due[k] - last) * 0.25);
        }
    }
}

/// A controller every ten ticks is one at ten times the tick.
#[test]
fn ticks_between_the_calls_change_nothing() {
    let plant = IntegratorChain::<f64, 2>::new();
    let law = |x: &SVector<f64, 2>| -4.0 * x[0] - 3.0 * x[1];
    let coarse = Simulation::new(&plant, Recorded::new(law), |t| t, [1.0, 0.0], 0.1).unwrap();
    let hardware = Hardware::new(Ideal, Ideal).every(10, 10, 10).unwrap();
    let fine =
        Simulation::with_hardware(&plant, hardware, Recorded::new(law), |t| t, [1.0, 0.0], 0.01)
            .unwrap()
            .substeps(1)
            .unwrap();
    for (coarse, fine) in coarse.zip(fine).take(100) {
        let (coarse, fine) = (coarse.unwrap(), fine.unwrap());
        approx::assert_relative_eq!(coarse.t, fine.t, max_relative = 1e-15);
        approx::assert_relative_eq!(coarse.x, fine.x, epsilon = 1e-13);
        approx::assert_relative_eq!(coarse.u, fine.u, epsilon = 1e-12);
    }
}
