use brunovsky::{
    channel::{Noise, Saturation},
    controller::Decoupling,
    plant::{FlexibleJoint, IntegratorChain, SmoothPlant},
    prelude::*,
};

use super::{About, Law, Row, Story, Trial, World, recorded};
use crate::contestants::{self, Any, Contestant, Facts};

/// A joint with a spring in it that turns its link by 0.3 rad, and whose motor then loses 30 % of its torque and 5 N·m.
///
/// Those who see the output turn the motor by the angle of the link; for the others the model makes a chain of four integrators of the joint.
pub struct FlexibleJointWorld;

const FACTS: Facts<4> = Facts {
    rate: 15.0,
    // What 6 N·m do: b = k/(I·J) = 1000.
    delta: 6000.0,
    errors: [0.1, 2.0, 40.0, 800.0],
    input_gain: 1000.0,
    pid_gain: 20.0,
    period: 0.002,
};
const STORY: Story = Story { settled: 1.5, switched: 2.0, steady: 3.0, end: 4.0 };
const GOAL: f64 = 0.3;

fn model() -> Result<FlexibleJoint<f64>, Error> {
    FlexibleJoint::new(1.0, 0.5, 500.0, 10.0)
}

impl World<4> for FlexibleJointWorld {
    fn about(&self) -> About {
        About {
            name: "flexible joint",
            error: "angle of the link in rad",
            period: FACTS.period,
            story: STORY,
        }
    }

    fn contestants(&self) -> Result<Vec<Contestant<4>>, Error> {
        Ok(contestants::all::<_, 4, 2>(IntegratorChain::new(), FACTS))
    }

    fn run(
        &self,
        make: &dyn Fn() -> Result<Any<4>, Error>,
        sees_output: bool,
        trial: Trial,
    ) -> Result<Vec<Row>, Error> {
        let model = model()?;
        let load = FACTS.delta / FACTS.input_gain;
        let plant = Law(|t: f64, x: &SVector<f64, 4>, u: &SVector<f64, 1>| {
            let received = match trial {
                _ if t < STORY.switched => *u,
                Trial::Search => u.add_scalar(-load),
                Trial::Test => (u * 0.7).add_scalar(-5.0),
            };
            model.derivative(t, x, &received)
        });
        let sensors = Sensors::of_state(Noise::new([1e-5, 1e-4, 1e-5, 1e-4], trial.random())?);
        let hardware = Hardware::new(sensors, Saturation::symmetric([150.0])?);
        let (h, start) = (FACTS.period, [0.0; 4]);
        let row = |t, x: &SVector<f64, 4>, u: &SVector<f64, 1>| {
            let step = GOAL - x[0];
            Row { t, step, error: step.abs(), u: u[0] }
        };
        let mut controller = make()?;
        if sees_output {
            let goal = |_| Reference::setpoint(GOAL);
            let run =
                Simulation::with_hardware(&plant, hardware, &mut *controller, goal, start, h)?;
            return recorded(run.substeps(2)?.until(STORY.end)?, |s| row(s.t, &s.x, &s.u));
        }
        let chains = Decoupling::new(model.linearized::<4>(start)?, [&mut *controller]);
        let goal = |_| [Reference::setpoint(GOAL)];
        let run = Simulation::with_hardware(&plant, hardware, chains, goal, start, h)?;
        recorded(run.substeps(2)?.until(STORY.end)?, |s| row(s.t, &s.x, &s.u))
    }
}
