use nalgebra::{SMatrix, SVector};

use crate::{
    Error, Scalar,
    controller::{
        Accept, ChainControllers, Command, Controller, Decoupling, DecouplingCommand, Measurement,
        Reference, unicycle::Direction,
    },
    error::{finite, positive, remembered, value},
    learning::LearningMode,
    plant::{Decouplable, Unicycle},
};

/// What a [`UnicycleController`] does where the robot is slower than its minimum speed, and ω = (u₂·cos θ − u₁·sin θ)/v has no sense.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Standstill {
    /// Answers with [`Error::Singular`].
    Refuse,
    /// Inverts the law as if the robot had the minimum speed, in its direction of travel: ω stays bounded, and the robot gets going.
    Hold,
}

/// Dynamic feedback linearization of the unicycle (eq_transformation): from accelerations (u₁, u₂) that one controller an axis asks
/// for, ξ = u₁·cos θ + u₂·sin θ and ω = (u₂·cos θ − u₁·sin θ)/v; the speed command follows by v̇ = ξ.
///
/// Any two controllers of order-2 chains will do: the same kind twice as an array, or two kinds as a pair. The reference is one
/// [`Reference`] an axis, position and velocity with the acceleration as highest derivative.
///
/// Measured is x = (p_x, p_y, θ, v) in m, m, rad, m/s; the command is (v, ω) in m/s and rad/s, ω > 0 to the left, v < 0 in reverse. `applied`, if
/// the drives report it, is (v, ω) too: what they really asked of the motors.
///
/// It is [`Decoupling`] of the [`Unicycle`] plant, whose input is (ξ, ω), with the integrator from ξ to v added.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnicycleController<T: Scalar, C> {
    decoupling: Decoupling<Moving<T>, C, 4, 2, 2>,
    standstill: Standstill,
    /// The speed command at the start of the last period and at its end; the robot's own speed before the first.
    speeds: Option<[T; 2]>,
}

/// The unicycle, inverted as if it never were slower than a minimum speed.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Moving<T> {
    direction: Direction,
    min_speed: T,
}

impl<T: Scalar> Decouplable<4, 2, 2> for Moving<T> {
    type Scalar = T;

    fn chains(&self, x: &SVector<T, 4>) -> [SVector<T, 2>; 2] {
        Unicycle::new().chains(x)
    }

    fn chain_drift(&self, x: &SVector<T, 4>) -> SVector<T, 2> {
        Unicycle::new().chain_drift(x)
    }

    fn decoupling_matrix(&self, x: &SVector<T, 4>) -> SMatrix<T, 2, 2> {
        Unicycle::new().decoupling_matrix(x)
    }

    fn inverted_matrix(&self, x: &SVector<T, 4>) -> SMatrix<T, 2, 2> {
        let mut moving = *x;
        if moving[3].abs() < self.min_speed {
            moving[3] = self.direction.sign::<T>() * self.min_speed;
        }
        Unicycle::new().decoupling_matrix(&moving)
    }

    fn chain_rates(&self, x: &SVector<T, 4>, x_dot: &SVector<T, 4>) -> SVector<T, 2> {
        Unicycle::new().chain_rates(x, x_dot)
    }
}

/// A command of [`UnicycleController`] and how it came about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnicycleCommand<T, D> {
    /// The speed v in m/s.
    pub v: T,
    /// The yaw rate ω in rad/s.
    pub omega: T,
    /// The acceleration ξ = v̇ in m/s², ω, the accelerations (u₁, u₂) in m/s² as `nu`, and what each axis' controller decided.
    pub decoupled: DecouplingCommand<T, D, 2>,
}

impl<T: Scalar, D: Copy> Command<T, 2> for UnicycleCommand<T, D> {
    fn input(&self) -> SVector<T, 2> {
        SVector::from([self.v, self.omega])
    }
}

impl<T: Scalar, C: ChainControllers<T, 2, 2>> UnicycleController<T, C> {
    /// A controller for a robot that starts off in `direction`, with `axes` deciding the accelerations along x and y. Below `min_speed` > 0 in
    /// m/s it does what `standstill` says.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for the minimum speed.
    pub fn new(
        axes: C,
        direction: Direction,
        min_speed: T,
        standstill: Standstill,
    ) -> Result<Self, Error> {
        let model = Moving { direction, min_speed: positive("min_speed", min_speed)? };
        let decoupling = unlimited(Decoupling::new(model, axes))?;
        Ok(Self { decoupling, standstill, speeds: None })
    }

    /// The controllers of the two axes.
    pub fn axes(&self) -> &C {
        self.decoupling.chains()
    }

    /// The controllers of the two axes, to be changed.
    pub fn axes_mut(&mut self) -> &mut C {
        self.decoupling.chains_mut()
    }
}

/// det B = v: what is too slow is judged by the minimum speed alone.
fn unlimited<T: Scalar, C: ChainControllers<T, 2, 2>>(
    decoupling: Decoupling<Moving<T>, C, 4, 2, 2>,
) -> Result<Decoupling<Moving<T>, C, 4, 2, 2>, Error> {
    let limit = T::max_value().unwrap_or(decoupling.model().min_speed.recip());
    decoupling.with_max_condition(limit)
}

impl<T: Scalar, C: ChainControllers<T, 2, 2>> Controller<4, 2> for UnicycleController<T, C> {
    type Scalar = T;
    type Reference = [Reference<T, 2>; 2];
    type Command = UnicycleCommand<T, C::Commands>;

    /// # Errors
    /// Those of [`Decoupling`], [`Error::Singular`] for a speed below the minimum if that is to be refused, and [`Error::NonFinite`] for a
    /// speed command so large that its change over the next period would leave the range of the scalar.
    fn update_if(
        &mut self,
        measurement: &Measurement<T, 4, 2>,
        reference: &Self::Reference,
        dt: T,
        accept: Accept<Self::Command>,
    ) -> Result<Self::Command, Error> {
        positive("dt", dt)?;
        measurement.validate()?;
        let speed = measurement.x[3];
        if self.standstill == Standstill::Refuse && speed.abs() < self.decoupling.model().min_speed
        {
            return Err(Error::Singular { name: "v", value: value(speed) });
        }
        // The drives report speeds, and what the loop asked for is their change. Before the first sample it asked for none, and the
        // extension starts from the speed that the robot has.
        let [before, asked] = self.speeds.unwrap_or([speed; 2]);
        let reached = match measurement.applied {
            Some(applied) if self.speeds.is_some() => applied[0],
            _ => asked,
        };
        let applied = measurement.applied.map(|applied| [(reached - before) / dt, applied[1]]);
        let extended = Measurement { applied: applied.map(SVector::from), ..*measurement };
        let command = |decoupled: DecouplingCommand<T, C::Commands, 2>| UnicycleCommand {
            v: reached + decoupled.u[0] * dt,
            omega: decoupled.u[1],
            decoupled,
        };
        let decoupled = self.decoupling.update_if(&extended, reference, dt, &mut |decoupled| {
            let command = command(*decoupled);
            finite("v", command.v)?;
            remembered("applied v/dt", reached, dt)?;
            remembered("v/dt", command.v, dt)?;
            accept(&command)
        })?;
        let command = command(decoupled);

        self.speeds = Some([reached, command.v]);
        Ok(command)
    }

    fn reset(&mut self) {
        self.decoupling.reset();
        self.speeds = None;
    }

    fn set_learning(&mut self, mode: LearningMode) {
        self.decoupling.set_learning(mode);
    }
}

checked! {
    [T: Scalar] Moving<T>, [T] { direction: Direction, min_speed: T } =>
    positive("min_speed", min_speed).map(|_| Self { direction, min_speed })
}

checked! {
    [T: Scalar, C] UnicycleController<T, C>, [T, C; C: ChainControllers<T, 2, 2>]
    {
        decoupling: Decoupling<Moving<T>, C, 4, 2, 2>,
        standstill: Standstill,
        speeds: Option<[T; 2]>,
    } =>
    known("last v", speeds.iter().flatten().copied())
        .and_then(|()| unlimited(decoupling))
        .map(|decoupling| Self { decoupling, standstill, speeds })
}
