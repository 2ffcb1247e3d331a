//! The spline converges to the curve that its waypoints are taken from.

use brunovsky::trajectory::{ConstantSpeed, Trajectory};

use super::length_of_the_parabola;
use crate::support::order;

/// M waypoints on three quarters of the unit circle.
fn arc<const M: usize>() -> ConstantSpeed<f64, 2, M> {
    let angle = |i: usize| 1.5 * std::f64::consts::PI * i as f64 / (M - 1) as f64;
    ConstantSpeed::new(core::array::from_fn(|i| [angle(i).cos(), angle(i).sin()]), 1.0).unwrap()
}

/// Free ends have x⃛ = 0 where the curve has not, and are off it by O(h³) over O(h), so the length by O(h⁴). On a circle x⃛ is
/// tangential, which moves points along the curve and not off it: one order is won.
#[test]
fn the_length_converges_with_order_four_and_on_a_circle_with_five() {
    fn error<const M: usize>() -> [f64; 2] {
        let x = |i: usize| 0.25 + i as f64 / (M - 1) as f64;
        let points = core::array::from_fn(|i| [x(i), x(i) * x(i)]);
        let parabola = ConstantSpeed::<f64, 2, M>::new(points, 1.0).unwrap();
        let exact = length_of_the_parabola(1.25) - length_of_the_parabola(0.25);
        let three_quarters = 1.5 * std::f64::consts::PI;
        [parabola.length() - exact, arc::<M>().length() - three_quarters].map(f64::abs)
    }
    let (coarse, fine) = (error::<33>(), error::<65>());
    for (i, expected) in [4.0, 5.0].into_iter().enumerate() {
        let measured = order(coarse[i], fine[i]);
        assert!((measured - expected).abs() < 0.2, "order {measured}, not {expected}");
    }
}

#[test]
fn the_middle_of_an_arc_converges_with_order_six() {
    fn error<const M: usize>() -> f64 {
        let r = arc::<M>();
        let off =
            |i: u32| (r.position(r.length() * (0.45 + 0.001 * f64::from(i))).norm() - 1.0).abs();
        (0..=100).map(off).fold(0.0, f64::max)
    }
    let measured = order(error::<33>(), error::<65>());
    assert!((measured - 6.0).abs() < 0.3, "order {measured}");
}
