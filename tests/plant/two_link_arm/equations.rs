//! The arm by its equations of motion: chains, drift and decoupling matrix that come out by differentiation are those written by hand.

use brunovsky::plant::{RelativeDegree, SmoothPlant};

use super::*;

/// Differs from the law written by hand by at most 1e-12 of the larger of the terms that it is a sum of.
fn off(found: f64, by_hand: f64, scale: f64) -> f64 {
    (found - by_hand).abs() / scale.max(1.0)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_differentiation_finds_is_the_law_by_hand(p in parameters(), x in state()) {
        let arm = p.arm::<f64>();
        let found = arm.linearized::<2>(x).unwrap().linearization(&x).unwrap();
        prop_assert_eq!(found.chains, arm.chains(&x));
        let (q, q_dot) = halves(&x);
        let (b, a) = (arm.decoupling_matrix(&x), arm.chain_drift(&x));
        let [friction, gravity] = [SVector::from(p.friction).amax() * q_dot.amax(), arm.gravity_torque(&q).amax()];
        let torque = (arm.coriolis_matrix(&q, &q_dot) * q_dot).amax() + friction + gravity;
        for i in 0..2 {
            let scale = 2.0 * b.amax() * torque;
            prop_assert!(off(found.drift[i], a[i], scale) <= 1e-12, "{} {}", found.drift, a);
            for j in 0..2 {
                prop_assert!(off(found.matrix[(i, j)], b[(i, j)], b.amax()) <= 1e-12, "{} {}", found.matrix, b);
            }
        }
    }

    #[test]
    fn a_measured_rate_says_the_same_of_the_chains(
        p in parameters(), x in state(), rate in prop::array::uniform4(-9.0..9.0_f64),
    ) {
        let arm = p.arm::<f64>();
        let rate = SVector::from(rate);
        let chain = arm.linearized::<2>(x).unwrap();
        prop_assert_eq!(chain.chain_rates(&x, &rate), arm.chain_rates(&x, &rate));
    }

    #[test]
    fn each_joint_has_relative_degree_2(p in parameters(), x in state()) {
        let found: RelativeDegree<f64, 4, 2> = p.arm::<f64>().relative_degree(x).unwrap();
        prop_assert_eq!((found.degrees, found.zero_dynamics()), ([2; 2], 0));
    }
}
