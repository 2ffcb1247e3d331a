//! CLELC of a double integrator, written in one function: what the composed one is compared with.

use brunovsky::{
    Error,
    controller::ClelcCommand,
    learning::{AdaptationRule, ClosedLoop, ErrorRate},
    plant::IntegratorChain,
    prelude::*,
};
use replay::Real;

/// The parts of the composed controller, without a controller or a compensator around them.
#[derive(Clone, Copy)]
pub struct ByHand {
    model: IntegratorChain<Real, 2>,
    gains: Gains<Real, 2>,
    network: FuzzyNetwork<Real, 2, 3>,
    source: ModelAided<Real>,
    rule: SlidingMode<Real>,
    last: Real,
}

impl ByHand {
    /// The law with the parts of [`chain`](replay::chain) that learn by `rule`.
    pub fn new(rule: SlidingMode<Real>) -> Result<Self, Error> {
        Ok(Self {
            model: IntegratorChain::new(),
            gains: Gains::from_lambda(2.0)?,
            network: FuzzyNetwork::evenly_spaced([2.0; 2])?,
            source: ModelAided::new(),
            rule,
            last: 0.0,
        })
    }

    /// The command for the coming period, with the checks of the composed controller: computes first, changes itself last.
    pub fn update(
        &mut self,
        measurement: &Measurement<Real, 2, 1>,
        reference: &Reference<Real, 2>,
        dt: Real,
    ) -> Result<ClelcCommand<Real>, Error> {
        if finite("dt", dt)? <= 0.0 {
            return Err(Error::NotPositive { name: "dt", value: dt.into() });
        }
        measurement.validate()?;
        reference.validate()?;
        let (x, e) = (measurement.x, reference.r - measurement.x);
        let u_f = reference.r_n_dot;
        let u_b = finite("u_b", self.gains.feedback(&e))?;
        let drift = finite("a(x)", self.model.drift(&x))?;
        let gain = finite("b(x)", self.model.input_gain(&x))?;
        for (index, e) in e.iter().enumerate() {
            if !e.is_finite() {
                return Err(Error::NonFiniteEntry { name: "e", index, value: (*e).into() });
            }
        }

        let applied = measurement.applied.map_or(self.last, |applied| applied[0]);
        let rate = measurement.x_dot.map(|x_dot| x_dot[1]);
        let learning = LearningMode::Active;
        let at = ClosedLoop {
            x,
            e,
            u_f,
            u_b,
            drift,
            gain,
            u: applied,
            asked: self.last,
            rate,
            learning,
        };
        // The rule has no memory: it needs no copy.
        let (mut network, mut source) = (self.network, self.source);
        self.rule.follow(&mut network, &e);
        let firing = network.fire(&e);
        let known = network.output(&firing);
        let s = finite("s", source.error_rate(&at, known, dt)? + u_b)?;
        self.rule.adapt(&mut network, &firing, s, dt);
        let u_n = finite("u_n", network.output(&firing))?;
        let nu = u_f + u_b + u_n;
        let u = (nu - drift) / gain;
        if !u.is_finite() {
            finite("-a(x) + nu", nu - drift)?;
            return Err(Error::Singular { name: "b(x)", value: gain.into() });
        }

        (self.network, self.source, self.last) = (network, source, u);
        Ok(ClelcCommand { u, u_f, u_b, u_n, s })
    }
}

fn finite(name: &'static str, x: Real) -> Result<Real, Error> {
    if x.is_finite() { Ok(x) } else { Err(Error::NonFinite { name, value: x.into() }) }
}
