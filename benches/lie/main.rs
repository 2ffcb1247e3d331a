use std::hint::black_box;

use brunovsky::{
    Scalar,
    differentiation::{Dual, Smooth},
    plant::{Along, Flow, SmoothPlant},
};
use criterion::{Criterion, criterion_group, criterion_main};

/// A link driven through a spring: I·q̈ = −m·g·l·sin q − k·(q − θ), J·θ̈ = k·(q − θ) + u.
#[derive(Clone, Copy)]
pub struct FlexibleJoint<T> {
    link: T,
    motor: T,
    weight: T,
    stiffness: T,
}

impl<T: Scalar> SmoothPlant<4, 1> for FlexibleJoint<T> {
    type Scalar = T;

    fn drift_field<S: Smooth<T>>(&self, [q, q_dot, theta, theta_dot]: [S; 4]) -> [S; 4] {
        let spring = (q - theta) * self.stiffness;
        let weight = q.sin() * self.weight;
        [q_dot, -(weight + spring) / self.link, theta_dot, spring / self.motor]
    }

    fn input_fields<S: Smooth<T>>(&self, _: [S; 4]) -> [[S; 4]; 1] {
        [[S::zero(), S::zero(), S::zero(), S::from(self.motor.recip())]]
    }

    fn outputs<S: Smooth<T>>(&self, [q, ..]: [S; 4]) -> [S; 1] {
        [q]
    }
}

/// (z, a, b) as in the textbook.
pub fn textbook<T: Scalar>(p: &FlexibleJoint<T>, x: &[T; 4]) -> ([T; 4], T, T) {
    let [q, w, th, thd] = *x;
    let (sin, cos) = q.sin_cos();
    let (mgl, k, i, j) = (p.weight / p.link, p.stiffness, p.link, p.motor);
    let acc = -mgl * sin - k / i * (q - th);
    let jerk = -mgl * cos * w - k / i * (w - thd);
    let a =
        mgl * sin * (w * w + mgl * cos + k / i) + k / i * (q - th) * (k / i + k / j + mgl * cos);
    ([q, w, acc, jerk], a, k / (i * j))
}

#[inline(never)]
fn hand(p: &FlexibleJoint<f64>, x: &[f64; 4]) -> ([f64; 4], f64, f64) {
    textbook(p, x)
}

#[inline(never)]
fn ours(p: &FlexibleJoint<f64>, x: &[f64; 4]) -> ([f64; 4], f64, f64) {
    let [g] = p.input_fields(*x);
    let start: [Dual<f64, 1>; 4] = core::array::from_fn(|i| Dual { value: x[i], slopes: [g[i]] });
    let lie = <Along as Flow<4>>::lie(p, &start);
    (lie.chains[0], lie.drift[0], lie.slopes[0][0])
}

fn all(c: &mut Criterion) {
    let p = FlexibleJoint { link: 1.2, motor: 0.3, weight: 9.0, stiffness: 100.0 };
    let xs: Vec<[f64; 4]> = (0..256)
        .map(|k| core::array::from_fn(|i| 0.4 + (0.02 * k as f64 + i as f64).sin()))
        .collect();
    for x in &xs {
        let (a, b) = (hand(&p, x), ours(&p, x));
        assert!((a.1 - b.1).abs() < 1e-9 * a.1.abs().max(1e4), "{a:?} {b:?}");
        assert!((a.2 - b.2).abs() < 1e-9 * a.2.abs(), "{a:?} {b:?}");
    }
    let mut k = 0;
    c.bench_function("hand", |bench| {
        bench.iter(|| {
            k = (k + 1) % xs.len();
            hand(black_box(&p), black_box(&xs[k]))
        })
    });
    c.bench_function("ours", |bench| {
        bench.iter(|| {
            k = (k + 1) % xs.len();
            ours(black_box(&p), black_box(&xs[k]))
        })
    });
}
criterion_group!(benches, all);
criterion_main!(benches);
