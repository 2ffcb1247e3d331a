//! An operator who presses every button twice.

use brunovsky::{
    controller::{
        Command, Controller, FeedbackLinearization, Gains, Measurement, Mode, Reference, Supervised,
    },
    learning::LearningMode,
    plant::IntegratorChain,
};

/// Between two samples: manual, an input, and manual again, which is not taking over.
#[test]
fn selecting_the_present_mode_keeps_the_input_that_was_set() {
    let base = FeedbackLinearization::new(
        IntegratorChain::<f64, 1>::new(),
        Gains::from_lambda(1.0).unwrap(),
    );
    let mut supervised = Supervised::new(base, [1.0]).unwrap();
    supervised.select(Mode::Automatic(LearningMode::Active));
    let sample = |supervised: &mut Supervised<_, f64, 1>| {
        let command = supervised.update(&Measurement::new([0.0]), &Reference::setpoint(2.0), 0.1);
        command.unwrap().input()[0]
    };
    assert_eq!(sample(&mut supervised), 2.0);
    supervised.select(Mode::Manual);
    supervised.set_manual([5.0]).unwrap();
    supervised.select(Mode::Manual);
    assert_eq!(sample(&mut supervised), 5.0);
}
