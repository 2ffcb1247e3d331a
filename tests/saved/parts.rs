use brunovsky::{
    actuator::Ideal,
    controller::unicycle::{Direction, Heading},
    fuzzy::{FuzzyNetwork, Gaussian},
    integrators::{Euler, Heun, Rk4},
    learning::{Monitor, SlidingMode, Watchdog},
    plant::{Traction, Unicycle},
    trajectory::{Boundary, Circle, ConstantSpeed, FigureEight, Line, MinimumJerk, Quintic},
};

use crate::support::{Number, comes_back, num, reference};

in_both_precisions! {
    networks_of_every_size_come_back,
    trajectories_come_back,
    watchers_come_back,
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
    brunovsky::fuzzy::Inputs<I>: brunovsky::fuzzy::Grid,
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
    comes_back(&(Euler, Heun, Rk4, Ideal));
    comes_back(&Unicycle::<T>::new());
    comes_back(&Traction::<T>::new(odd(1), odd(2), -odd::<T>(3)).unwrap());
}
