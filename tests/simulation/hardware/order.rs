//! Who acts when, and in which order within a tick.

use brunovsky::{
    Error,
    channel::Channel,
    controller::Measurement,
    plant::IntegratorChain,
    simulation::{Hardware, Sensor, Simulation, Truth},
};
use nalgebra::SVector;

use super::{Log, Recorded};

/// Shows the state and writes down that it was asked.
#[derive(Clone)]
struct Eye(Log<(char, f64)>);

impl Sensor<f64, 1, 1> for Eye {
    type Seen = Measurement<f64, 1, 1>;

    fn sensed(&self, truth: &Truth<f64, 1, 1>, dt: f64) -> Result<(Self, Self::Seen), Error> {
        self.0.borrow_mut().push(('s', dt));
        Ok((self.clone(), Measurement::new(truth.x).with_rate(truth.x_dot).with_applied(truth.u)))
    }
}

/// Does as it is told and writes that down.
#[derive(Clone)]
struct Hand(Log<(char, f64)>);

impl Channel<f64, 1> for Hand {
    fn passed(&self, signal: &SVector<f64, 1>, dt: f64) -> Result<(Self, SVector<f64, 1>), Error> {
        self.0.borrow_mut().push(('a', dt));
        Ok((self.clone(), *signal))
    }
}

/// What happens at each tick, as letters in their order, with the period that each was told, in ticks of 1/8 s.
fn acts(every: [u32; 3], lateness: fn(u64) -> u64, ticks: usize) -> Vec<String> {
    let log: Log<(char, f64)> = Log::default();
    let controller = Recorded::new(|_: &SVector<f64, 1>| 0.0);
    let [sensor, called, actuator] = every;
    let hardware = Hardware::new(Eye(log.clone()), Hand(log.clone()))
        .every(sensor, called, actuator)
        .unwrap()
        .late(lateness);
    let shared = log.clone();
    let reference = move |t: f64| {
        shared.borrow_mut().push(('c', 0.0));
        t
    };
    let plant = IntegratorChain::<f64, 1>::new();
    let run =
        Simulation::with_hardware(&plant, hardware, controller, reference, [0.0], 0.125).unwrap();
    let told = |(letter, dt): (char, f64)| {
        if letter == 'c' { "c".to_owned() } else { format!("{letter}{}", dt * 8.0) }
    };
    let tick = |tick: Result<_, Error>| {
        tick.unwrap();
        log.borrow_mut().drain(..).map(told).collect::<Vec<_>>().join(" ")
    };
    run.ticks().take(ticks).map(tick).collect()
}

#[test]
fn within_a_tick_sensors_come_first_then_the_controller_then_the_actuators() {
    assert_eq!(acts([1, 1, 1], |_| 0, 3), ["s1 c a1"; 3]);
}

#[test]
fn everyone_acts_at_multiples_of_the_own_period() {
    let expected =
        ["s2 c a1", "a1", "s2 a1", "c a1", "s2 a1", "a1", "s2 c a1", "a1", "s2 a1", "c a1"];
    assert_eq!(acts([2, 3, 1], |_| 0, 10), expected);
    assert_eq!(
        acts([1, 2, 3], |_| 0, 7),
        ["s1 c a3", "s1", "s1 c", "s1 a3", "s1 c", "s1", "s1 c a3"]
    );
}

/// Calls 0, 1, 2 of period 3 are 1, 0, 2 ticks late.
#[test]
fn a_late_call_waits_for_its_tick() {
    let expected =
        ["s1 a1", "s1 c a1", "s1 a1", "s1 c a1", "s1 a1", "s1 a1", "s1 a1", "s1 a1", "s1 c a1"];
    assert_eq!(acts([1, 3, 1], |k| [1, 0, 2][(k % 3) as usize], 9), expected);
}

/// ẋ = u under u = 1 from the first call on: the command of a tick moves the plant from that tick, and the sensor of a tick sees what the plant
/// did up to it under the input of before.
#[test]
fn a_command_acts_from_its_tick_and_shows_at_the_next() {
    let plant = IntegratorChain::<f64, 1>::new();
    let controller = Recorded::new(|_: &SVector<f64, 1>| 1.0);
    let heard = controller.heard.clone();
    let run = Simulation::new(&plant, controller, |t| t, [0.0], 0.5).unwrap();
    let u: Vec<f64> = run.ticks().take(3).map(|tick| tick.unwrap().u[0]).collect();
    assert_eq!(u, [1.0; 3]);
    let seen: Vec<_> = heard.borrow().iter().map(|(_, seen, _)| *seen).collect();
    for (k, seen) in (0..).map(f64::from).zip(seen) {
        let under = if k > 0.0 { 1.0 } else { 0.0 };
        approx::assert_relative_eq!(seen.x[0], 0.5 * k, max_relative = 1e-15);
        assert_eq!(seen, Measurement::new(seen.x).with_rate([under]).with_applied([under]));
    }
}
