use brunovsky::{controller::InputOnly, plant::Pendulum, prelude::*};

use super::support::flc;

type Any =
    dyn Controller<2, 1, Scalar = f64, Reference = Reference<f64, 2>, Command = SVector<f64, 1>>;

/// Behind a `dyn`, of one type with others, a controller does what it does, and is reset, frozen and refused as it is.
#[test]
fn a_choice_at_run_time_is_the_controller_bit_for_bit() {
    let model = Pendulum::new(1.0, 0.5, 0.1, 9.81).unwrap();
    let learner = || {
        let network = FuzzyNetwork::<_, 2, 3>::evenly_spaced([1.0, 2.0]).unwrap();
        NeuroFuzzy::new(network, ModelAided::new(), SlidingMode::new(5.0).unwrap())
    };
    let mut plain = Clelc::new(flc(model, 3.0), learner());
    let mut hidden = InputOnly(plain);
    let hidden: &mut Any = &mut hidden;
    for k in 0..300 {
        match k {
            100 => [
                plain.set_learning(LearningMode::Frozen),
                hidden.set_learning(LearningMode::Frozen),
            ],
            150 => [
                plain.set_learning(LearningMode::Active),
                hidden.set_learning(LearningMode::Active),
            ],
            200 => [plain.reset(), hidden.reset()],
            _ => [(); 2],
        };
        let t = 0.01 * f64::from(k);
        let seen = Measurement::new([(1.3 * t).sin(), 0.7 * t.cos()]);
        let reference = Reference::new([t.sin(), t.cos()], -t.sin());
        assert_eq!(
            plain.update(&seen, &reference, -0.01),
            hidden.update(&seen, &reference, -0.01).map(|_| unreachable!())
        );
        let command = plain.update(&seen, &reference, 0.01).unwrap();
        assert_eq!(
            hidden.update(&seen, &reference, 0.01).unwrap()[0].to_bits(),
            command.u.to_bits()
        );
    }
}

#[test]
fn what_the_caller_refuses_is_not_taken() {
    let mut hidden = InputOnly(flc(brunovsky::plant::IntegratorChain::<f64, 2>::new(), 3.0));
    let refusal = Error::Missing { name: "consent" };
    let seen = Measurement::new([0.0, 0.0]);
    let mut asked = None;
    let refused = hidden.update_if(&seen, &Reference::setpoint(1.0), 0.01, &mut |u| {
        asked = Some(*u);
        Err(refusal)
    });
    assert_eq!(refused, Err(refusal));
    assert_eq!(asked, Some(SVector::from([9.0])));
}
