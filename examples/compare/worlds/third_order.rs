use brunovsky::{
    channel::{Noise, Saturation},
    plant::ThirdOrder,
    prelude::*,
};

use super::{About, Law, Row, Story, Trial, World, recorded};
use crate::contestants::{self, Any, Contestant, Facts};

/// The paper's third-order system from its initial state to rest, and then Δ = 5·sin t.
pub struct ThirdOrderWorld;

const FACTS: Facts<3> = Facts {
    rate: 3.0,
    delta: 5.0,
    errors: [2.0, 2.0, 20.0],
    input_gain: 1.0,
    pid_gain: 1.0,
    period: 0.01,
};
const STORY: Story = Story { settled: 8.0, switched: 10.0, steady: 15.0, end: 20.0 };

impl World<3> for ThirdOrderWorld {
    fn about(&self) -> About {
        About { name: "third-order system", error: "x₁", period: FACTS.period, story: STORY }
    }

    fn contestants(&self) -> Result<Vec<Contestant<3>>, Error> {
        Ok(contestants::all::<_, 3, 3>(ThirdOrder::new(), FACTS))
    }

    fn run(
        &self,
        make: &dyn Fn() -> Result<Any<3>, Error>,
        _sees_output: bool,
        trial: Trial,
    ) -> Result<Vec<Row>, Error> {
        let model = ThirdOrder::new();
        let plant = Law(|t: f64, x: &SVector<f64, 3>, u: &SVector<f64, 1>| {
            let delta = match trial {
                _ if t < STORY.switched => 0.0,
                Trial::Search => FACTS.delta,
                Trial::Test => 5.0 * t.sin(),
            };
            model.derivative(t, x, &u.add_scalar(delta))
        });
        let sensors = Sensors::of_state(Noise::new([1e-3, 3e-3, 1e-2], trial.random())?);
        let hardware = Hardware::new(sensors, Saturation::symmetric([100.0])?);
        let (goal, start) = (|_| Reference::setpoint(0.0), [1.0, -1.0, -10.0]);
        let mut controller = make()?;
        let run = Simulation::with_hardware(
            &plant,
            hardware,
            &mut *controller,
            goal,
            start,
            FACTS.period,
        )?;
        recorded(run.substeps(2)?.until(STORY.end)?, |s| Row {
            t: s.t,
            step: -s.x[0],
            error: s.x[0].abs(),
            u: s.u[0],
        })
    }
}
