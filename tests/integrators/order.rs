//! The order of every method, measured on problems with known solutions. A new method is one more line in a list.

use brunovsky::{
    Scalar,
    integrators::{DormandPrince, Euler, Heun, Integrator, Rk4},
};
use nalgebra::SVector;
use proptest::prelude::*;

/// An initial value problem ẋ = f(t, x) with its solution.
struct Problem<const N: usize> {
    name: &'static str,
    f: fn(f64, &SVector<f64, N>) -> SVector<f64, N>,
    exact: fn(f64) -> SVector<f64, N>,
    from: f64,
    duration: f64,
}

/// Nonlinear: logistic growth.
const LOGISTIC: Problem<1> = Problem {
    name: "logistic growth",
    f: |_, x| SVector::from([x[0] * (1.0 - x[0])]),
    exact: |t| SVector::from([1.0 / (1.0 + 4.0 * (-t).exp())]),
    from: 0.0,
    duration: 3.0,
};

/// Linear with a coefficient that depends on time, away from t = 0.
const MODULATED: Problem<1> = Problem {
    name: "modulated growth",
    f: |t, x| SVector::from([t.cos() * x[0]]),
    exact: |t| SVector::from([t.sin().exp()]),
    from: 0.5,
    duration: 2.0,
};

/// Nonlinear and dependent on time.
const RATIONAL: Problem<1> = Problem {
    name: "rational",
    f: |t, x| SVector::from([-2.0 * t * x[0] * x[0]]),
    exact: |t| SVector::from([1.0 / (1.0 + t * t)]),
    from: -0.5,
    duration: 2.0,
};

/// Two states: a rotation whose rate is the square of the radius, 1.69 here, plus a drift of the centre with sin t.
const ROTATION: Problem<2> = Problem {
    name: "nonlinear rotation",
    f: |t, x| {
        let (y, z) = (x[0] - t.sin(), x[1]);
        let rate = y * y + z * z;
        SVector::from([-rate * z + t.cos(), rate * y])
    },
    exact: |t| SVector::from([1.3 * (1.69 * t).cos() + t.sin(), 1.3 * (1.69 * t).sin()]),
    from: 0.0,
    duration: 1.5,
};

/// Linear: a damped oscillation in the plane, e^(−t/2) at 3 rad/s.
const LINEAR: Problem<2> = Problem {
    name: "damped oscillation",
    f: |_, x| SVector::from([-0.5 * x[0] - 3.0 * x[1], 3.0 * x[0] - 0.5 * x[1]]),
    exact: |t| SVector::from([(3.0 * t).cos(), (3.0 * t).sin()]) * (-0.5 * t).exp(),
    from: 0.0,
    duration: 2.0,
};

impl<const N: usize> Problem<N> {
    fn error<I: Integrator>(&self, method: &I, steps: u32) -> f64 {
        let start = (self.exact)(self.from);
        let end = method.integrate(self.f, self.from, &start, self.duration, steps);
        (end.unwrap() - (self.exact)(self.from + self.duration)).norm()
    }

    /// The error falls like hᵖ: log₂ of the quotient for h and h/2 is p + O(h).
    fn confirms<I: Integrator>(&self, method: &I, steps: u32) {
        let (coarse, fine) = (self.error(method, steps), self.error(method, 2 * steps));
        let (measured, stated) = ((coarse / fine).log2(), f64::from(I::ORDER));
        assert!(
            (measured - stated).abs() < 0.05,
            "{}: order {measured}, stated {stated}",
            self.name
        );
    }
}

fn has_its_order<I: Integrator>(method: &I) {
    if I::ORDER < 5 {
        LOGISTIC.confirms(method, 320);
        MODULATED.confirms(method, 320);
        RATIONAL.confirms(method, 320);
        ROTATION.confirms(method, 320);
        LINEAR.confirms(method, 320);
    } else {
        // On the others the fifth-order term is so small that the sixth outweighs it until rounding does; there the order conditions
        // have to do (order_conditions.rs).
        LINEAR.confirms(method, 64);
    }
}

/// ẋ = Σ j·cⱼ·tʲ⁻¹ is a quadrature, which a method of order p answers exactly up to degree p; `coefficients` are those of the
/// solution from t⁰ on.
fn quadrature_error<I: Integrator, T: Scalar>(
    method: &I,
    coefficients: &[f64],
    from: f64,
    h: f64,
) -> f64 {
    let num = nalgebra::convert::<f64, T>;
    let derivative = |t: T, _: &SVector<T, 1>| {
        let terms = coefficients.iter().enumerate().skip(1);
        SVector::from([
            terms.fold(T::zero(), |sum, (j, c)| sum + t.powi(j as i32 - 1) * num(c * j as f64))
        ])
    };
    let exact = |t: T| {
        let terms = coefficients.iter().enumerate();
        terms.fold(T::zero(), |sum, (j, c)| sum + t.powi(j as i32) * num(*c))
    };
    let (from, h) = (num(from), num(h));
    let end = method.step(derivative, from, &SVector::from([exact(from)]), h);
    let error: f64 = nalgebra::try_convert(end[0] - exact(from + h)).unwrap();
    error.abs()
}

fn is_exact_up_to_its_order<I: Integrator>(method: &I, coefficients: &[f64], from: f64, h: f64) {
    let degree = I::ORDER as usize;
    // |t| ≤ 3 and |cⱼ| ≤ 2 make terms of up to 4·2·3⁴ = 648, with a handful of roundings each.
    let size = 4.0 * 2.0 * 3.0_f64.powi(I::ORDER);
    let within = &coefficients[..=degree];
    let at_f64 = quadrature_error::<_, f64>(method, within, from, h);
    let at_f32 = quadrature_error::<_, f32>(method, within, from, h);
    assert!(at_f64 <= 16.0 * f64::EPSILON * size, "{at_f64}");
    assert!(at_f32 <= 16.0 * f64::from(f32::EPSILON) * size, "{at_f32}");
    // Of tᵖ⁺¹ the rectangle misses h², the trapezoid h³/2, Simpson's rule h⁵/24, and the weights of Dormand and Prince h⁶/900.
    let mut beyond = vec![0.0; degree + 2];
    beyond[degree + 1] = 1.0;
    let missed = quadrature_error::<_, f64>(method, &beyond, from, h);
    assert!(missed > h.powi(I::ORDER + 1) / 1000.0, "{missed}");
}

/// The tests of one method.
macro_rules! methods {
    ($($module:ident: $method:expr),+ $(,)?) => {
        $(mod $module {
            use super::*;

            #[test]
            fn the_measured_order_is_the_stated_one() {
                has_its_order(&$method);
            }

            proptest! {
                #[test]
                fn quadrature_is_exact_up_to_the_order_and_no_further(
                    coefficients in prop::collection::vec(-2.0..2.0_f64, 6), from in -2.0..2.0_f64, h in 0.1..1.0_f64,
                ) {
                    is_exact_up_to_its_order(&$method, &coefficients, from, h);
                }
            }
        })+
    };
}

methods! {
    euler: Euler,
    heun: Heun,
    rk4: Rk4,
    dormand_prince: DormandPrince,
}
