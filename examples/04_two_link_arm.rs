//! An arm lifts a load of 1.5 kg that its controller knows nothing of: feedback linearization alone, and with learning in each joint.
//!
//! The load is an uncertainty Δ of both joints: gravity pulls harder, and the same torque accelerates less. Feedback alone carries it
//! with an error of −Δ/k₁ in each joint; the learned terms take it over, and the errors go to zero.

use brunovsky::{
    controller::Decoupling,
    plant::{IntegratorChain, Link, TwoLinkArm},
    prelude::*,
    trajectory::{Quintic, Trajectory},
};

const REST: [f64; 2] = [-1.2, 0.6];

fn main() -> Result<(), Error> {
    let upper = Link { mass: 2.0, length: 0.35, centre: 0.15, inertia: 0.02 };
    let lower = Link { mass: 1.5, length: 0.3, centre: 0.15, inertia: 0.015 };
    let believed = TwoLinkArm::new([upper, lower], [0.1, 0.1], 9.81)?;
    let loaded = believed.with_payload(1.5)?;
    let lift = Quintic::rest_to_rest(REST, [0.3, 1.2], 2.0)?;

    let joint = FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(8.0)?);
    let network = FuzzyNetwork::<_, 2, 3>::evenly_spaced([0.5, 2.0])?;
    let rule = SlidingMode::new(2000.0)?;
    let learning = Clelc::new(joint, NeuroFuzzy::new(network, ModelAided::new(), rule));
    let flc = Decoupling::new(believed, [joint; 2]);
    let clelc = Decoupling::new(believed, [learning; 2]);

    let reference = |t| lift.references(t);
    let x0 = [REST[0], REST[1], 0.0, 0.0];
    let without = Simulation::new(&loaded, flc, reference, x0, 0.005)?.until(4.0)?;
    let with = Simulation::new(&loaded, clelc, reference, x0, 0.005)?.until(4.0)?;

    println!(
        "         FLC                  CLELC                (e in rad, u_b and u_n in rad/s²)"
    );
    println!("t in s   e₁       e₂          e₁       e₂          u_b₁     u_n₁     u_b₂     u_n₂");
    for (flc, clelc) in without.zip(with).step_by(100) {
        let (flc, clelc) = (flc?, clelc?);
        let e = |x: SVector<f64, 4>, joint: usize| lift.position(flc.t)[joint] - x[joint];
        let [first, second] = clelc.command.chains;
        println!(
            "{:5.1} {:8.4} {:8.4}    {:8.4} {:8.4}    {:8.2} {:8.2} {:8.2} {:8.2}",
            flc.t,
            e(flc.x, 0),
            e(flc.x, 1),
            e(clelc.x, 0),
            e(clelc.x, 1),
            first.u_b,
            first.u_n,
            second.u_b,
            second.u_n
        );
    }
    Ok(())
}
