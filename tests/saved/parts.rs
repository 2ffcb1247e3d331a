use std::fmt::Debug;

use brunovsky::{
    channel::{
        Bias, Channel, DeadZone, Delay, Dropout, Ideal, Lag, Noise, Quantization, RateLimit,
        Saturation, Wander,
    },
    controller::unicycle::{Direction, Heading},
    fuzzy::{FuzzyNetwork, Gaussian, Grid, Inputs},
    integrators::{
        Adaptive, Crossing, DormandPrince, Euler, Heun, Rk4, Rodas, Statistics, Tolerance,
    },
    learning::{Advisor, Monitor, SlidingMode, Watchdog},
    nalgebra::SVector,
    plant::{
        BallAndBeam, CartPole, CartPoleOutput, DcMotor, Duffing, Electromagnet, FlexibleJoint,
        Linearized, MagneticLevitation, MotorDrivenLink, Quadrotor, QuadrotorAttitude, Traction,
        Unicycle,
    },
    simulation::{ErrorMetrics, StepInfo, TotalVariation},
    trajectory::{Boundary, Circle, ConstantSpeed, FigureEight, Line, MinimumJerk, Quintic},
};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use serde::{Serialize, de::DeserializeOwned};

use crate::support::{Number, comes_back, num, reference, reloaded};

in_both_precisions! {
    networks_of_every_size_come_back,
    trajectories_come_back,
    watchers_come_back,
    plants_come_back,
    channels_go_on,
    integrators_come_back,
    figures_of_merit_go_on,
    an_advisor_goes_on,
    what_has_no_memory_comes_back,
}

/// Inputs that have no short decimal.
fn odd<T: Number>(i: usize) -> T {
    num::<T>((i as f64 + 0.1).sqrt()) / num(3.0)
}

fn networks_of_every_size_come_back<T: Number>() {
    comes_back(&learned::<T, 1, 40>());
    comes_back(&learned::<T, 2, 3>());
    comes_back(&learned::<T, 3, 2>());
    comes_back(&learned::<T, 6, 2>());
}

fn learned<T: Number, const I: usize, const K: usize>() -> FuzzyNetwork<T, I, K>
where
    Inputs<I>: Grid,
{
    let memberships = core::array::from_fn(|i| {
        core::array::from_fn(|k| Gaussian::new(odd(i + k), odd(i + 2 * k)).unwrap())
    });
    let mut network = FuzzyNetwork::new(memberships);
    let consequents: Vec<T> = (0..network.consequents().len()).map(odd).collect();
    network.set_consequents(&consequents).unwrap();
    network
}

fn trajectories_come_back<T: Number>() {
    comes_back(&Line::new([odd::<T>(1), odd(2), odd(3)], [odd(4), odd(5), odd(6)]).unwrap());
    comes_back(&Circle::<T>::new([odd(1), odd(2)], odd(3), odd(4), odd(5)).unwrap());
    comes_back(&FigureEight::<T>::new(odd(1), odd(2), odd(3)).unwrap());
    let boundary =
        |i| Boundary::<T, 2>::new([odd(i), odd(2 * i)], [odd(3 * i), odd(i)], [odd(5), odd(i)]);
    comes_back(&boundary(2));
    comes_back(&Quintic::new(boundary(1), boundary(3), odd(4)).unwrap());
    let points = core::array::from_fn::<_, 40, _>(|i| [odd::<T>(i), odd(i * i)]);
    let times = core::array::from_fn(odd);
    comes_back(&MinimumJerk::new(points, times).unwrap());
    let ends = [[odd(1), odd(2)], [odd(3), odd(4)]];
    comes_back(&MinimumJerk::with_ends(points, times, ends, ends).unwrap());
    let points = core::array::from_fn::<_, 9, _>(|i| [odd::<T>(i), odd::<T>(i * i)]);
    comes_back(&ConstantSpeed::new(points, odd(2)).unwrap());
}

fn watchers_come_back<T: Number>() {
    let certificate = SlidingMode::new(odd::<T>(9)).unwrap().certificate(odd(1), odd(2)).unwrap();
    comes_back(&certificate);
    let mut monitor = Monitor::new(certificate, odd(1)).unwrap();
    let mut watchdog = Watchdog::new(certificate, odd(1), odd(2)).unwrap();
    let mut heading = Heading::<T>::new(Direction::Reverse);
    for k in 0..20 {
        comes_back(&monitor);
        comes_back(&watchdog);
        comes_back(&heading);
        monitor.update(odd(30 - k)).unwrap();
        watchdog.update(odd(40)).unwrap();
        heading.update(&[reference(k as u32, 0.0), reference(k as u32, 1.0)]).unwrap();
    }
    assert!(watchdog.tripped());
}

fn what_has_no_memory_comes_back<T: Number>() {
    comes_back(&(Euler, Heun, Rk4, DormandPrince, Ideal));
    comes_back(&Unicycle::<T>::new());
    comes_back(&reference::<T, 3>(2, 0.0));
    comes_back(&Traction::<T>::new(odd(1), odd(2), -odd::<T>(3)).unwrap());
}

fn plants_come_back<T: Number>() {
    comes_back(&Duffing::<T>::new(odd(1), odd(2), -odd::<T>(3)).unwrap());
    comes_back(&BallAndBeam::<T>::new(num(0.4), odd(2)).unwrap());
    // A ball that slides.
    comes_back(&BallAndBeam::<T>::new(num(0.0), odd(2)).unwrap());
    let friction = [odd::<T>(4), odd(5)];
    for output in [CartPoleOutput::Position, CartPoleOutput::Angle] {
        comes_back(&CartPole::new(odd(1), odd(2), odd(3), friction, odd(6), output).unwrap());
    }
    let magnet =
        Electromagnet::<T> { far: odd(1), near: odd(2), range: odd(3), resistance: odd(4) };
    comes_back(&MagneticLevitation::new(odd(5), odd(6), odd(7), magnet).unwrap());
    let motor = DcMotor::<T> { torque: odd(1), inductance: odd(2), resistance: odd(3) };
    comes_back(&MotorDrivenLink::new(odd(4), odd(5), odd(6), motor).unwrap());
    comes_back(&FlexibleJoint::<T>::new(odd(1), odd(2), odd(3), odd(4)).unwrap());
    let attitude = QuadrotorAttitude::<T>::new([odd(1), odd(2), odd(3)]).unwrap();
    comes_back(&attitude);
    let quadrotor = Quadrotor::new(odd(4), attitude, odd(5)).unwrap();
    comes_back(&quadrotor);
    let at = quadrotor.hover([odd(6), odd(7), odd(8)], odd(9));
    let degrees = Quadrotor::<T>::DEGREES;
    comes_back(&Linearized::<_, 14, 4, 4>::with_degrees(quadrotor, degrees, at).unwrap());
}

fn channels_go_on<T: Number>() {
    fn goes_on<T: Number, C>(mut channel: C)
    where
        C: Channel<T, 2> + Serialize + DeserializeOwned + PartialEq + Debug,
    {
        let mut loaded = Vec::new();
        for k in 0..20 {
            comes_back(&channel);
            loaded.extend(reloaded(&channel));
            let signal = SVector::from([odd(k), -odd::<T>(2 * k)]);
            let (next, arrived) = channel.passed(&signal, num(0.1)).unwrap();
            for loaded in &mut loaded {
                let (passed, same) = loaded.passed(&signal, num(0.1)).unwrap();
                assert_eq!((&passed, same), (&next, arrived));
                *loaded = passed;
            }
            channel = next;
        }
    }
    let size = SVector::from([odd::<T>(1), odd(2)]);
    let random = || ChaCha8Rng::seed_from_u64(7);
    goes_on::<T, _>(Ideal);
    goes_on(Saturation::new(-size, size).unwrap());
    goes_on(RateLimit::new(size).unwrap().starting_at(size).unwrap());
    goes_on((Bias::new(size).unwrap(), DeadZone::new(size).unwrap()));
    goes_on((Lag::new(size).unwrap(), Quantization::new(size).unwrap()));
    goes_on(Delay::<T, 2, 0>::new());
    goes_on(Delay::<T, 2, 40>::new().starting_at(size).unwrap());
    goes_on(Noise::new(size, random()).unwrap());
    goes_on(Wander::new(size, odd(3), random()).unwrap());
    goes_on(Dropout::<T, _, 2>::new(0.4, random()).unwrap());
}

fn integrators_come_back<T: Number>() {
    let tolerance = Tolerance::<T, 2>::per_component(odd(1), [odd::<T>(2), odd(3)]).unwrap();
    comes_back(&tolerance);
    let method = Adaptive::new(DormandPrince, tolerance);
    comes_back(&method);
    comes_back(&method.with_first_step(odd(1)).unwrap().with_step_limit(7).unwrap());
    comes_back(&Adaptive::new(Rodas::autonomous(), tolerance).with_longest_step(odd(1)).unwrap());
    comes_back(&[Crossing::rising(), Crossing::falling().terminal(), Crossing::both()]);
    comes_back(&Statistics { evaluations: u64::MAX, accepted: 2, ..Statistics::default() });
}

fn figures_of_merit_go_on<T: Number>() {
    let mut info = StepInfo::<T>::new(odd(1), odd(3)).unwrap();
    let mut metrics = ErrorMetrics::<T>::default();
    let mut variation = TotalVariation::<T>::default();
    for k in 0..60 {
        comes_back(&info);
        comes_back(&metrics);
        comes_back(&variation);
        let t = 0.1 * f64::from(k);
        let y: T = odd::<T>(1) + (odd::<T>(3) - odd(1)) * num(1.0 - (-t).exp() * (3.0 * t).cos());
        info.push(num(t), y).unwrap();
        metrics.push(num(t), y).unwrap();
        variation.push(y).unwrap();
    }
    assert!(info.settling_time().is_some());
}

fn an_advisor_goes_on<T: Number>() {
    let mut advisor = Advisor::<T>::new(num(0.01)).unwrap();
    let mut loaded = Vec::new();
    for k in 0..3000 {
        // While the quantiles of one scale or another fill up, and later.
        if k < 60 || k == 2047 {
            comes_back(&advisor);
        }
        if k % 700 == 7 {
            loaded.extend(reloaded(&advisor));
        }
        let s: T = num(5.0 * (0.013 * f64::from(k)).sin() + 0.1 * (f64::from(k) * 17.3).sin());
        advisor.push(odd(3), s).unwrap();
        loaded.iter_mut().for_each(|loaded| loaded.push(odd(3), s).unwrap());
    }
    let recommendation = advisor.recommend().unwrap();
    comes_back(&recommendation);
    for loaded in loaded {
        assert_eq!(loaded, advisor);
        assert_eq!(loaded.recommend().unwrap(), recommendation);
    }
}
