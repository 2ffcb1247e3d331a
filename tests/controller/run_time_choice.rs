//! Controllers that are chosen at run time: behind `&mut dyn`, in a box, and as parts of others they command what they command by themselves.

use brunovsky::{
    Error, Scalar,
    channel::Saturation,
    controller::{
        AntiWindup, Command, Compensated, Controller, InputOnly, Limited, Measurement, Pid,
        PidGains, Reference,
    },
    learning::{LearningMode, ModelAided, SlidingMode, Switching},
    plant::Pendulum,
};

use crate::{
    at_f32_and_f64,
    support::{flc, learning, num, real},
};

/// A controller of which only the types of its calls are known.
type Object<'a, T, D> =
    dyn Controller<2, 1, Scalar = T, Reference = Reference<T, 2>, Command = D> + 'a;

/// What `controller` answers to a sequence of calls with errors, changes of mode and a reset in it: inputs bit by bit (f32 in f64 is exact).
fn answers<C: Controller<2, 1, Scalar = T, Reference = Reference<T, 2>>, T: Scalar>(
    mut controller: C,
) -> Vec<Result<u64, Error>> {
    let answer = |k: i32| {
        match k {
            60 => controller.set_learning(LearningMode::Frozen),
            80 => controller.set_learning(LearningMode::Off),
            100 => controller.set_learning(LearningMode::Active),
            150 => controller.reset(),
            _ => {}
        }
        let t = 0.01 * f64::from(k);
        let rate = if k % 37 == 36 { f64::INFINITY } else { t.cos() };
        let measurement = Measurement::new([num(t.sin()), num(rate)]);
        let command = controller.update(&measurement, &Reference::setpoint(num(0.3)), num(0.01));
        command.map(|command| real(command.input()[0]).to_bits())
    };
    (0..200).map(answer).collect()
}

fn answers_alike<C, T: Scalar>(controller: C)
where
    C: Controller<2, 1, Scalar = T, Reference = Reference<T, 2>> + Clone,
{
    let alone = answers(controller.clone());
    assert_eq!(alone.iter().filter(|answer| answer.is_err()).count(), 5);

    let mut referred = controller.clone();
    let object: &mut Object<T, C::Command> = &mut referred;
    assert_eq!(answers(object), alone);
    let mut boxed: Box<Object<T, C::Command>> = Box::new(controller.clone());
    assert_eq!(answers(&mut *boxed), alone);
    let mut input_only: Box<Object<T, _>> = Box::new(InputOnly(controller.clone()));
    assert_eq!(answers(&mut *input_only), alone);

    // Below a wrapper and below a compensator.
    let limits = Saturation::symmetric([num::<T>(2.0)]).unwrap();
    let limited = answers(Limited::new(controller.clone(), limits));
    assert_ne!(limited, alone);
    boxed.set_learning(LearningMode::Active);
    boxed.reset();
    assert_eq!(answers(Limited::new(&mut *boxed, limits)), limited);
    let (model, learner) = (pendulum(), *learner::<T>().compensator());
    let compensated = answers(Compensated::new(controller, model, learner));
    assert_ne!(compensated, alone);
    boxed.reset();
    assert_eq!(answers(Compensated::new(&mut *boxed, model, learner)), compensated);
}

fn pendulum<T: Scalar>() -> Pendulum<T> {
    Pendulum::new(num(0.8), num(0.5), num(0.1), num(9.81)).unwrap()
}

fn learner<T: Scalar>() -> crate::support::Learning<Pendulum<T>, ModelAided<T>, T, 2> {
    let switching = Switching::Implicit { delta: num(0.5) };
    let rule = SlidingMode::new(num(5.0)).unwrap().with_switching(switching).unwrap();
    learning(pendulum(), 2.0, ModelAided::new(), rule)
}

fn every_kind<T: Scalar>() {
    answers_alike(flc(pendulum::<T>(), 2.0));
    answers_alike(learner::<T>());
    let gains = PidGains::new(num::<T>(4.0)).unwrap().with_integral_time(num(2.0)).unwrap();
    answers_alike(Pid::new(gains, AntiWindup::None).unwrap());
}

at_f32_and_f64! {
    a_controller_chosen_at_run_time_commands_the_same_bits => every_kind,
}
