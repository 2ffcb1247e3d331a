//! A joint with a spring in it, controlled from its equations, and how much of a wrong model learning can make good.
//!
//! Differentiation turns ẋ = f(x) + g(x)·u, y = h(x) into the chain z = (q, q̇, q̈, q⃛), whose last equation the torque enters; the true
//! joint is the same type with other parameters. What they change in that last equation, learning takes over: all of a wrong motor.
//! But q̈ and q⃛ are computed with the model's weight and spring, so with another load or spring z is not what the link does, and learning makes
//! the *model's* error vanish: the loop rests where k₁·(r − q) = k₃·z₃, with an acceleration z₃ that the model sees and the link does not have.
//! Only higher gains (k₃/k₁ = 6/λ²) or a better model make that smaller. FLC has a second error, −Δ/k₁, which may even be of the other sign.

use core::f64::consts::FRAC_PI_2;

use brunovsky::{
    controller::Decoupling,
    plant::{Decouplable, FlexibleJoint, IntegratorChain, SmoothPlant},
    prelude::*,
    trajectory::{Quintic, Trajectory},
};

/// The largest |r − q| on the way up and r − q at rest, in rad, and the state there.
fn lift<P, C>(truth: &P, controller: C) -> Result<(f64, f64, SVector<f64, 4>), Error>
where
    P: Plant<4, 1, Scalar = f64>,
    C: Controller<4, 1, Scalar = f64, Reference = [Reference<f64, 4>; 1]>,
{
    let way = Quintic::rest_to_rest([0.0], [FRAC_PI_2], 2.0)?;
    let reference = |t| way.references(t);
    let (mut largest, mut error, mut x) = (0.0_f64, 0.0, SVector::zeros());
    for sample in Simulation::new(truth, controller, reference, [0.0; 4], 0.001)?.until(6.0)? {
        let sample = sample?;
        (error, x) = (way.position(sample.t)[0] - sample.x[0], sample.x);
        largest = largest.max(error.abs());
    }
    Ok((largest, error, x))
}

fn main() -> Result<(), Error> {
    // A link of 1 kg·m² and 10 N·m of weight, a motor of 0.5 kg·m² behind its gear, a spring of 500 N·m/rad.
    let believed = FlexibleJoint::new(1.0, 0.5, 500.0, 10.0)?;
    let model = believed.linearized::<4>([0.0; 4])?;
    let gains = Gains::from_lambda(20.0)?;
    let flc = FeedbackLinearization::new(IntegratorChain::new(), gains);
    let network = FuzzyNetwork::<_, 4, 2>::evenly_spaced([0.1, 2.0, 40.0, 800.0])?;
    let rule = SlidingMode::new(100_000.0)?;
    let clelc = Clelc::new(flc, NeuroFuzzy::new(network, ModelAided::new(), rule));

    // A payload of 0.5 kg at 0.4 m.
    let (inertia, weight) = (1.0 + 0.5 * 0.4 * 0.4, 10.0 + 0.5 * 9.81 * 0.4);
    let truths = [
        ("nothing", believed, 0.0),
        ("motor: inertia +40 %", FlexibleJoint::new(1.0, 0.7, 500.0, 10.0)?, 0.0),
        ("motor: 5 N·m are lost", believed, 5.0),
        ("spring: stiffness −20 %", FlexibleJoint::new(1.0, 0.5, 400.0, 10.0)?, 0.0),
        ("payload: 0.5 kg at 0.4 m", FlexibleJoint::new(inertia, 0.5, 500.0, weight)?, 0.0),
        ("spring and payload", FlexibleJoint::new(inertia, 0.5, 400.0, weight)?, 0.0),
    ];

    println!("r − q in mrad            largest on the way       at rest            k₃/k₁·z₃");
    println!("what is wrong              FLC     CLELC       FLC     CLELC        CLELC");
    for (name, joint, lost) in truths {
        // Where the torque enters, θ̈ = …/J.
        let truth =
            Uncertain::matched(joint, |_, _: &SVector<f64, 4>, _: &SVector<f64, 1>| -lost / 0.5);
        let (way, rest, _) = lift(&truth, Decoupling::new(&model, [flc]))?;
        let (learned_way, learned_rest, x) = lift(&truth, Decoupling::new(&model, [clelc]))?;
        let [z] = model.chains(&x);
        let k = gains.as_vector();
        println!(
            "{name:<24} {:8.2} {:8.2}   {:8.2} {:8.2}     {:8.2}",
            1e3 * way,
            1e3 * learned_way,
            1e3 * rest,
            1e3 * learned_rest,
            1e3 * k[2] / k[0] * z[2]
        );
    }
    Ok(())
}
