use core::f64::consts::FRAC_PI_2;

use brunovsky::{
    channel::{Noise, Saturation},
    plant::Pendulum,
    prelude::*,
};

use super::{About, Law, Row, Story, Trial, World, recorded};
use crate::contestants::{self, Any, Contestant, Facts};

/// A pendulum that is raised from hanging to horizontal, and there takes up half of its mass again, which nobody tells the controller.
pub struct PendulumWorld;

const FACTS: Facts<2> = Facts {
    rate: 4.0,
    delta: 6.0,
    errors: [2.0, 4.0],
    input_gain: 4.0,
    pid_gain: 4.0,
    period: 0.005,
};
const STORY: Story = Story { settled: 4.0, switched: 5.0, steady: 8.0, end: 10.0 };

impl World<2> for PendulumWorld {
    fn about(&self) -> About {
        About {
            name: "pendulum with a wrong mass",
            error: "angle in rad",
            period: FACTS.period,
            story: STORY,
        }
    }

    fn contestants(&self) -> Result<Vec<Contestant<2>>, Error> {
        Ok(contestants::all::<_, 2, 3>(Pendulum::new(1.0, 0.5, 0.1, 9.81)?, FACTS))
    }

    fn run(
        &self,
        make: &dyn Fn() -> Result<Any<2>, Error>,
        _sees_output: bool,
        trial: Trial,
    ) -> Result<Vec<Row>, Error> {
        let model = Pendulum::new(1.0, 0.5, 0.1, 9.81)?;
        let carrying = Pendulum::new(1.5, 0.5, 0.1, 9.81)?;
        let load = FACTS.delta / FACTS.input_gain;
        let plant = Law(|t: f64, x: &SVector<f64, 2>, u: &SVector<f64, 1>| match trial {
            _ if t < STORY.switched => model.derivative(t, x, u),
            Trial::Search => model.derivative(t, x, &u.add_scalar(-load)),
            Trial::Test => carrying.derivative(t, x, u),
        });
        let sensors = Sensors::of_state(Noise::new([2e-4, 2e-3], trial.random())?);
        let hardware = Hardware::new(sensors, Saturation::symmetric([20.0])?);
        let goal = |_| Reference::setpoint(FRAC_PI_2);
        let mut controller = make()?;
        let run = Simulation::with_hardware(
            &plant,
            hardware,
            &mut *controller,
            goal,
            [0.0, 0.0],
            FACTS.period,
        )?;
        recorded(run.substeps(2)?.until(STORY.end)?, |s| {
            let step = FRAC_PI_2 - s.x[0];
            Row { t: s.t, step, error: step.abs(), u: s.u[0] }
        })
    }
}
