use brunovsky::{
    channel::Saturation,
    controller::unicycle::{Direction, Standstill, UnicycleController},
    plant::IntegratorChain,
    prelude::*,
};

use crate::{Chain, Real, Study};

type Axis = Chain<ModelAided<Real>, SlidingMode<Real>, 2, 3>;
type Pair = UnicycleController<Real, [Axis; 2]>;

/// The robot study, as recommended: λ = 0.3, α = 5, δ = 2, h = 0.2 s, model-aided, |ω| ≤ 0.1 rad/s; p_x, p_y, θ, v and r, ṙ, r̈ of both axes ↦
/// v, ω, and u_n, s of both axes.
pub struct Robot(Limited<Pair, Saturation<Real, 2>, Real, 2>);

impl Study for Robot {
    type Row = [Real; 10];
    type Shown = [Real; 6];

    fn start() -> Result<Self, Error> {
        let flc = FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(0.3)?);
        let network = FuzzyNetwork::evenly_spaced([2.0, 0.4])?;
        let rule = SlidingMode::new(5.0)?.with_switching(Switching::Implicit { delta: 2.0 })?;
        let axis = Clelc::new(flc, NeuroFuzzy::new(network, ModelAided::new(), rule));
        let pair = UnicycleController::new([axis; 2], Direction::Forward, 0.05, Standstill::Hold)?;
        Ok(Self(Limited::new(pair, Saturation::new([0.0, -0.1], [0.8, 0.1])?)))
    }

    fn update(&mut self, row: &[Real; 10]) -> Result<[Real; 6], Error> {
        let [x, y, theta, v, rx, rx_dot, rx_ddot, ry, ry_dot, ry_ddot] = *row;
        let measurement = Measurement::new([x, y, theta, v]);
        let reference =
            [Reference::new([rx, rx_dot], rx_ddot), Reference::new([ry, ry_dot], ry_ddot)];
        let command = self.0.update(&measurement, &reference, 0.2)?;
        let [first, second] = command.asked.decoupled.chains;
        let [v, omega] = command.u.into();
        Ok([v, omega, first.u_n, second.u_n, first.s, second.s])
    }
}
