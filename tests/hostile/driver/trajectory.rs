//! Constructors, derivatives and limits of every trajectory.

use brunovsky::{
    Error,
    trajectory::{
        Boundary, Circle, ConstantSpeed, FigureEight, Line, MinimumJerk, Quintic, Trajectory,
    },
};

use super::{Bytes, Float, attack, numbers::Numbers};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = attacked::<T>(bytes);
}

fn attacked<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    match bytes.byte() % 9 {
        0 => {
            let line = Line::<T, 2>::new(bytes.numbers(), bytes.numbers())?;
            limited(&line, bytes);
            followed(&line, bytes);
        }
        1 => {
            let [radius, rate] = bytes.parameters();
            let circle = Circle::<T>::new(bytes.numbers(), radius, rate, bytes.number())?;
            limited(&circle, bytes);
            followed(&circle, bytes);
        }
        2 => {
            let [length, width, rate] = bytes.parameters();
            let eight = FigureEight::<T>::new(length, width, rate)?;
            if bytes.byte() == 255 {
                limited(&eight, bytes);
            }
            followed(&eight, bytes);
        }
        3 => {
            let quintic =
                Quintic::<T, 2>::new(boundary(bytes), boundary(bytes), bytes.parameter())?;
            assert!(quintic.duration().are_finite());
            if bytes.byte() == 255 {
                limited(&quintic, bytes);
            }
            followed(&quintic, bytes);
        }
        4 => {
            let (start, end) = (bytes.numbers(), bytes.numbers());
            followed(&Quintic::<T, 3>::rest_to_rest(start, end, bytes.parameter())?, bytes);
        }
        5 => followed(&MinimumJerk::<T, 2, 2>::new(points(bytes), times(bytes))?, bytes),
        6 => {
            let (points, times) = (points(bytes), times(bytes));
            let [start, end] = [0; 2].map(|_| [bytes.numbers(), bytes.numbers()]);
            followed(&MinimumJerk::<T, 2, 4>::with_ends(points, times, start, end)?, bytes);
        }
        7 => on_constant_speed::<T, 2>(bytes)?,
        _ => on_constant_speed::<T, 4>(bytes)?,
    }
    Ok(())
}

fn on_constant_speed<T: Float, const M: usize>(bytes: &mut Bytes) -> Result<(), Error> {
    let curve = ConstantSpeed::<T, 2, M>::new(points(bytes), bytes.parameter())?;
    assert!([curve.length(), curve.duration()].are_finite());
    // Where the inversion of the arc length begins and ends.
    for t in [nalgebra::zero(), curve.duration()] {
        let _ = curve.jet::<3>(t);
    }
    followed(&curve, bytes);
    Ok(())
}

fn boundary<T: Float>(bytes: &mut Bytes) -> Boundary<T, 2> {
    Boundary::new(bytes.numbers(), bytes.numbers(), bytes.numbers())
}

fn points<T: Float, const M: usize>(bytes: &mut Bytes) -> [[T; 2]; M] {
    core::array::from_fn(|_| bytes.numbers())
}

/// Any times, or the sums of some periods.
fn times<T: Float, const M: usize>(bytes: &mut Bytes) -> [T; M] {
    if bytes.odd() {
        return bytes.numbers();
    }
    let mut t = bytes.number::<T>();
    core::array::from_fn(|_| {
        t += bytes.parameter();
        t
    })
}

/// At any time there is an answer, and none that a controller would take for a time that is none.
fn followed<T: Float, P: Trajectory<D, Scalar = T>, const D: usize>(
    trajectory: &P,
    bytes: &mut Bytes,
) {
    for _ in 0..4 {
        let t = bytes.number::<T>();
        let position = trajectory.position(t);
        let [same, ..] = trajectory.jet::<6>(t);
        let references = trajectory.references::<2>(t);
        if !t.are_finite() {
            assert!(!position.are_finite(), "{position} at {t}");
            assert!(references.iter().any(|reference| reference.validate().is_err()));
        } else if position.are_finite() {
            assert_eq!(same.bits(), position.bits());
        }
    }
}

fn limited<T: Float, P: Trajectory<D, Scalar = T>, const D: usize>(
    trajectory: &P,
    bytes: &mut Bytes,
) {
    if let Ok(limits) = trajectory.limits(bytes.number(), bytes.number()) {
        assert!([limits.speed, limits.acceleration].are_finite(), "{limits:?}");
        assert!(limits.yaw_rate.are_finite(), "{limits:?}");
    }
}
