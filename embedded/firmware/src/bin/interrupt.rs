//! A control loop in a timer's interrupt: a pendulum, a commissioning sequence (operator, feedback, learning), limits, a watchdog, and an
//! answer to every error. The machine is replaced by its model with other parameters, so that the program can run in an emulator.
#![no_std]
#![no_main]

use brunovsky::{
    Error, channel::Saturation, elementary::sin_cos, learning::Bounded, plant::Pendulum, prelude::*,
};
use cortex_m::peripheral::{Peripherals, syst::SystClkSource};
use cortex_m_rt::{entry, exception};
use firmware::{exit, failed};

/// The period in seconds, and what the timer counts in it at the board's 25 MHz.
const PERIOD: f32 = 0.001;
const COUNTS: u32 = 25_000;

#[entry]
fn main() -> ! {
    let Some(peripherals) = Peripherals::take() else { failed() };
    let mut timer = peripherals.SYST;
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(COUNTS - 1);
    timer.clear_current();
    timer.enable_interrupt();
    timer.enable_counter();
    loop {
        cortex_m::asm::wfi();
    }
}

/// The loop is made at the first tick and lives in the handler, which is never interrupted by itself.
#[exception]
fn SysTick() {
    static mut LOOP: Option<Loop> = None;
    if LOOP.is_none() {
        *LOOP = Loop::new().ok();
    }
    match LOOP {
        Some(control) => control.tick(),
        None => failed(),
    }
}

type Learner = NeuroFuzzy<FuzzyNetwork<f32, 2, 3>, ModelAided<f32>, Bounded<SlidingMode<f32>, f32>>;
type Learning = Clelc<Pendulum<f32>, Guarded<Learner, f32>, 2>;
type Controlled = Limited<Supervised<Learning, f32, 1>, Saturation<f32, 1>, f32, 1>;

struct Loop {
    controller: Controlled,
    /// What learning leaves of the error, in rad.
    promised: f32,
    machine: Machine,
    /// What the drive goes on receiving when a sample brought no command.
    torque: f32,
    errors: u32,
    k: u32,
}

impl Loop {
    fn new() -> Result<Self, Error> {
        let model = Pendulum::new(1.0, 0.5, 0.05, 9.81)?;
        let flc = FeedbackLinearization::new(model, Gains::from_lambda(8.0)?);
        let rule = SlidingMode::new(40.0)?.with_switching(Switching::Implicit { delta: 0.5 })?;
        // The load asks for up to 9 rad/s² more than the model knows, once in 2π s.
        let certificate = rule.certificate(PERIOD, 10.0)?;
        let network = FuzzyNetwork::evenly_spaced([0.5, 2.0])?;
        let learner = NeuroFuzzy::new(network, ModelAided::new(), Bounded::new(rule, 30.0)?);
        let guarded = Guarded::new(learner, Watchdog::new(certificate, 2.0, 0.5)?);
        let clelc = Clelc::new(flc, guarded.with_fallback(50.0)?);
        let supervised = Supervised::new(clelc, [10.0])?;
        Ok(Self {
            controller: Limited::new(supervised, Saturation::symmetric([8.0])?),
            promised: certificate
                .tracking_bound(8.0, 2)?
                .ok_or(Error::Missing { name: "promise" })?,
            machine: Machine::new()?,
            torque: 0.0,
            errors: 0,
            k: 0,
        })
    }

    fn tick(&mut self) {
        self.commissioning();
        let x = self.machine.sensors();
        let (sin, cos) = sin_cos(self.k as f32 * PERIOD);
        let reference = Reference::new([sin, cos], -sin);
        match self.controller.update(&Measurement::new(x), &reference, PERIOD) {
            Ok(command) => self.torque = command.u[0],
            // One bad sample: the drive holds, the controller is as before. Many: the operator has to decide.
            Err(_) => self.errors += 1,
        }
        if self.errors > 10 {
            self.controller.controller_mut().select(Mode::Manual);
        }
        self.machine.drive(self.torque);
        self.k += 1;
        self.judge(x, reference);
    }

    /// Half a second by hand, one and a half of plain feedback, then learning.
    fn commissioning(&mut self) {
        let supervised = self.controller.controller_mut();
        match self.k {
            500 => supervised.select(Mode::Automatic(LearningMode::Off)),
            2000 => supervised.select(Mode::Automatic(LearningMode::Active)),
            _ => {}
        }
    }

    /// After ten seconds the emulation ends; well if the error is within what theory promises, and nothing has tripped.
    fn judge(&self, x: SVector<f32, 2>, reference: Reference<f32, 2>) {
        if self.k == 10_000 {
            let tripped = self.controller.controller().controller().compensator().tripped();
            let learned = (reference.r[0] - x[0]).abs() <= self.promised;
            exit(if learned && !tripped && self.errors == 0 { Ok(()) } else { Err(()) });
        }
    }
}

/// Stands for encoder and drive: a pendulum with half a kilogram more than the model knows of.
struct Machine {
    pendulum: Pendulum<f32>,
    x: SVector<f32, 2>,
}

impl Machine {
    fn new() -> Result<Self, Error> {
        Ok(Self { pendulum: Pendulum::new(1.5, 0.5, 0.05, 9.81)?, x: SVector::zeros() })
    }

    fn sensors(&self) -> SVector<f32, 2> {
        self.x
    }

    fn drive(&mut self, torque: f32) {
        let u = SVector::from([torque]);
        let field = |t: f32, x: &SVector<f32, 2>| self.pendulum.derivative(t, x, &u);
        if let Ok(x) = Rk4.integrate(field, 0.0, &self.x, PERIOD, 1) {
            self.x = x;
        }
    }
}
