use brunovsky::{
    channel::{Noise, Saturation},
    controller::unicycle::{Direction, Standstill, UnicycleController},
    plant::{IntegratorChain, TrackedRobot, Traction},
    prelude::*,
    simulation::Truth,
    trajectory::ConstantSpeed,
};

use super::{About, Law, Row, Story, Trial, World, recorded};
use crate::contestants::{self, Any, Contestant, Facts};

/// A tracked robot that starts 1 m beside its path and comes from firm onto soft ground, where its tracks slip, the more in turns.
///
/// All laws stand behind the unicycle's decoupling, one for each axis: what they see of it is a chain of two integrators.
pub struct RobotWorld;

const FACTS: Facts<2> = Facts {
    rate: 0.3,
    delta: 0.02,
    errors: [2.0, 0.4],
    input_gain: 1.0,
    pid_gain: 0.1,
    period: 0.2,
};
const STORY: Story = Story { settled: 40.0, switched: 50.0, steady: 100.0, end: 200.0 };
const SPEED: f64 = 0.4;
/// What the search puts on the yaw rate, in rad/s: as much as Δ at this speed.
const LOAD: f64 = FACTS.delta / SPEED;

/// Of soft ground at (x, y): it slips by 10 % lengthwise and, more or less, by half in yaw.
fn soft(x: f64, y: f64) -> Traction<f64> {
    let yaw = 0.5 + 0.1 * (0.17 * x + 0.5).sin() * (0.27 * y).cos();
    Traction { longitudinal: 0.9, yaw, side: 0.1 }
}

impl World<2> for RobotWorld {
    fn about(&self) -> About {
        About {
            name: "tracked robot",
            error: "distance across the first leg in m",
            period: FACTS.period,
            story: STORY,
        }
    }

    fn contestants(&self) -> Result<Vec<Contestant<2>>, Error> {
        Ok(contestants::all::<_, 2, 3>(IntegratorChain::new(), FACTS))
    }

    fn run(
        &self,
        make: &dyn Fn() -> Result<Any<2>, Error>,
        _sees_output: bool,
        trial: Trial,
    ) -> Result<Vec<Row>, Error> {
        let firm = Traction { longitudinal: 1.0, yaw: 1.0, side: 0.0 };
        let firm = TrackedRobot::new(0.3, move |_, _| firm)?;
        let slipping = TrackedRobot::new(0.3, soft)?;
        let plant = Law(|t: f64, x: &SVector<f64, 5>, u: &SVector<f64, 2>| match trial {
            _ if t < STORY.switched => firm.derivative(t, x, u),
            Trial::Search => firm.derivative(t, x, &(u - SVector::from([0.0, LOAD]))),
            Trial::Test => slipping.derivative(t, x, u),
        });
        let path = ConstantSpeed::<f64, 2, 5>::new(
            [[0.0, 0.0], [24.0, 0.0], [44.0, 12.0], [60.0, 6.0], [90.0, 6.0]],
            SPEED,
        )?;
        // Position, heading and speed over ground.
        let shown = |truth: &Truth<f64, 5, 2>| {
            let [x, y] = [truth.x_dot[0], truth.x_dot[1]];
            let (sin, cos) = truth.x[2].sin_cos();
            SVector::from([truth.x[0], truth.x[1], truth.x[2], x * cos + y * sin])
        };
        let noise = Noise::new([0.005, 0.005, 0.002, 0.005], trial.random())?;
        let limits = Saturation::new([0.0, -0.3], [2.0 * SPEED, 0.3])?;
        let hardware = Hardware::new(Sensors::new(shown, noise), limits);
        let (mut along, mut across) = (make()?, make()?);
        let axes = [&mut *along, &mut *across];
        let controller = UnicycleController::new(axes, Direction::Forward, 0.05, Standstill::Hold)?;
        let start = [0.0, 1.0, 0.0, SPEED, 0.0];
        let goal = |t| path.references(t);
        let run =
            Simulation::with_hardware(&plant, hardware, controller, goal, start, FACTS.period)?;
        recorded(run.substeps(4)?.until(STORY.end)?, |s| {
            let [x, y] = [0, 1].map(|axis| s.reference[axis].r[0] - s.x[axis]);
            Row { t: s.t, step: y, error: x.hypot(y), u: s.u[1] }
        })
    }
}
