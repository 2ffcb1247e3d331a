//! What a controller sees of the truth, and that a seed decides all of it.

use brunovsky::{
    channel::{Bias, Dropout, Ideal, Noise, Quantization, Wander},
    controller::Measurement,
    plant::IntegratorChain,
    simulation::{Hardware, Sensors, Simulation, Truth},
};
use nalgebra::SVector;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::Recorded;

const PLANT: IntegratorChain<f64, 2> = IntegratorChain::new();

/// One number of two states, through a channel; the report of the actuators arrives, ẋ does not.
#[test]
fn a_sensor_shows_its_output_through_its_channel() {
    let angle = |truth: &Truth<f64, 2, 1>| SVector::from([truth.x[0] + 0.5 * truth.x[1]]);
    let sensor = Sensors::new(angle, Bias::new([10.0]).unwrap());
    let law = Recorded::new(|y: &SVector<f64, 1>| y[0]);
    let hardware = Hardware::new(sensor, Ideal);
    let run = Simulation::with_hardware(&PLANT, hardware, law, |t| t, [1.0, 2.0], 0.5).unwrap();
    let mut applied = 0.0;
    for sample in run.take(5) {
        let sample = sample.unwrap();
        let y = sample.x[0] + 0.5 * sample.x[1] + 10.0;
        assert_eq!(sample.seen, Measurement::new([y]).with_applied([applied]));
        assert_eq!(sample.u[0], y);
        applied = y;
    }
}

#[test]
fn actuators_that_do_not_report_leave_it_to_the_controller() {
    let sensor = Sensors::of_state(Ideal).unreported();
    let law = Recorded::new(|x: &SVector<f64, 2>| -x[0]);
    let run = Simulation::with_hardware(
        &PLANT,
        Hardware::new(sensor, Ideal),
        law,
        |t| t,
        [1.0, 0.0],
        0.1,
    )
    .unwrap();
    for sample in run.take(5) {
        let sample = sample.unwrap();
        assert_eq!(sample.seen, Measurement::new(sample.x));
    }
}

/// Everything random at once: sensors, losses, jitter.
fn seen(seed: u64) -> Vec<(f64, Measurement<f64, 2, 1>, f64)> {
    let stream = |number| {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(number);
        random
    };
    let noise = Noise::new([0.01, 0.02], stream(0)).unwrap();
    let wander = Wander::new([0.1, 0.0], 2.0, stream(1)).unwrap();
    let lossy = Dropout::new(0.2, stream(2)).unwrap();
    let digits = Quantization::new([0.001, 0.001]).unwrap();
    let sensor = Sensors::of_state((wander, (noise, (digits, lossy))));
    let mut jitter = stream(3);
    let actuator = Noise::new([0.05], stream(4)).unwrap();
    let hardware = Hardware::new(sensor, actuator)
        .every(2, 5, 1)
        .unwrap()
        .late(move |_| jitter.random_range(0..4));
    let law = Recorded::new(|x: &SVector<f64, 2>| -2.0 * x[0] - 2.0 * x[1]);
    let heard = law.heard.clone();
    let run = Simulation::with_hardware(&PLANT, hardware, law, |t| t, [1.0, 0.0], 0.01).unwrap();
    run.until(5.0).unwrap().for_each(|sample| assert!(sample.is_ok()));
    heard.take()
}

#[test]
fn the_seed_decides_every_bit() {
    let once = seen(3);
    assert_eq!(once.len(), 100);
    assert_eq!(once, seen(3));
    assert_ne!(once, seen(4));
    // Jitter and losses are there.
    assert!(once.iter().any(|(_, _, dt)| *dt != once[1].2));
    assert!(once.windows(2).any(|pair| pair[0].1.x == pair[1].1.x));
}
