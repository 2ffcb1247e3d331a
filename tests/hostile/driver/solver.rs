//! Integration with adaptive steps, events included.

use brunovsky::{
    Error,
    integrators::{Adaptive, Crossing, DormandPrince, Embedded, Events, Rodas, Tolerance},
};
use nalgebra::SVector;

use super::{Bytes, Float, attack, numbers::Numbers};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // Settings that are refused end the attack.
    let _ = if bytes.odd() {
        attacked::<_, T>(DormandPrince, bytes)
    } else {
        attacked::<_, T>(Rodas::new(), bytes)
    };
}

fn attacked<M: Embedded<T, 2>, T: Float>(method: M, bytes: &mut Bytes) -> Result<(), Error> {
    let tolerance = Tolerance::new(bytes.parameter(), bytes.parameter())?;
    let mut settings = Adaptive::new(method, tolerance).with_step_limit(20)?;
    if bytes.odd() {
        settings = settings.with_first_step(bytes.parameter())?;
    }
    if bytes.odd() {
        settings = settings.with_longest_step(bytes.parameter())?;
    }
    let (t, x, jump) = (bytes.number::<T>(), bytes.vector::<T, 2>(), [bytes.number::<T>()]);
    let mut answers = *bytes;
    let field = |t: T, x: &SVector<T, 2>| {
        assert!(t.are_finite(), "asked for {t}");
        match answers.byte() % 4 {
            0 => -x,
            1 => SVector::from([x[1], -x[0]]),
            2 => x.component_mul(x),
            _ => answers.vector(),
        }
    };
    let mut solver = settings.solve(field, t, x)?.with_discontinuities(&jump)?;
    let mut events = Events::new(
        |_, x: &SVector<T, 2>| [x[0], x[1]],
        [Crossing::both(), Crossing::falling().terminal()],
    );
    while !bytes.is_empty() {
        let (time, state) = (solver.time(), *solver.state());
        let kind = bytes.byte() % 5;
        // A terminal event may lie within the step that holds an event reported before.
        let earliest = if kind == 3 { solver.step_start() } else { time };
        let there = if bytes.odd() { bytes.number() } else { time + bytes.parameter() };
        let found = match kind {
            0 => solver.step().map(|()| None),
            1 => solver.advance(there).map(|x| Some(*x)),
            2 => solver.at(there).map(Some),
            3 => solver.next_event(there, &mut events).map(|event| event.map(|event| event.x)),
            _ => solver.restart(bytes.vector::<T, 2>()).map(|()| None),
        };
        assert!(solver.time().are_finite() && solver.state().are_finite());
        assert!(solver.time() >= earliest, "back from {time} to {}", solver.time());
        match found {
            Ok(x) => assert!(x.is_none_or(|x| x.are_finite()), "{x:?}"),
            // A refused restart changes nothing; the others stand at the last good step.
            Err(_) if kind == 4 => assert!(solver.time() == time && *solver.state() == state),
            Err(_) => {}
        }
    }
    Ok(())
}
