use brunovsky::{plant::ThirdOrder, prelude::*};

use crate::{Real, Study};

/// The simulation study: λ = 3, α = 25, h = 0.01 s, set-valued sign, backward difference; x₁, x₂, x₃ ↦ u, u_n, s.
pub struct ThirdOrderLoop(Clelc<ThirdOrder<Real>, Learner, 3>);

type Learner = NeuroFuzzy<FuzzyNetwork<Real, 3, 3>, BackwardDifference<Real>, SlidingMode<Real>>;

impl Study for ThirdOrderLoop {
    type Row = [Real; 3];
    type Shown = [Real; 3];

    fn start() -> Result<Self, Error> {
        let flc = FeedbackLinearization::new(ThirdOrder::new(), Gains::from_lambda(3.0)?);
        let network = FuzzyNetwork::evenly_spaced([2.0, 2.0, 20.0])?;
        let learner = NeuroFuzzy::new(network, BackwardDifference::new(), SlidingMode::new(25.0)?);
        Ok(Self(Clelc::new(flc, learner)))
    }

    fn update(&mut self, row: &[Real; 3]) -> Result<[Real; 3], Error> {
        let command = self.0.update(&Measurement::new(*row), &Reference::setpoint(0.0), 0.01)?;
        Ok([command.u, command.u_n, command.s])
    }
}
