//! A control loop in a timer's interrupt: a pendulum, a commissioning sequence (operator, feedback, learning), limits, a watchdog, and an
//! answer to every error. The machine is replaced by its model with other parameters, so that the program can run in an emulator.
#![no_std]
#![no_main]

use brunovsky::{
    Error,
    actuator::Saturation,
    learning::{Bounded, Watch},
    plant::Pendulum,
    prelude::*,
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

type Learner = NeuroFuzzy<f32, ModelAided<f32>, Bounded<SlidingMode<f32>, f32>, 2, 3>;
type Limiting = Limited<Clelc<Pendulum<f32>, Learner, 2>, Saturation<f32, 1>, f32, 1>;

struct Loop {
    controller: Supervised<Limiting, f32, 1>,
    watchdog: Watchdog<f32>,
    watch: Option<Watch<f32>>,
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
        let network = FuzzyNetwork::evenly_spaced([0.5, 2.0])?;
        let learner = NeuroFuzzy::new(network, ModelAided::new(), Bounded::new(rule, 30.0)?);
        let limited = Limited::new(Clelc::new(flc, learner), Saturation::symmetric([8.0])?);
        // The load asks for up to 9 N·m/(kg·m²) more than the model knows, once in 2π s.
        let certificate = rule.certificate(PERIOD, 10.0)?;
        let promised = certificate.tracking_bound(8.0, 2)?;
        Ok(Self {
            controller: Supervised::new(limited, [10.0])?,
            watchdog: Watchdog::new(certificate, 2.0, 0.1)?,
            watch: None,
            promised: promised.ok_or(Error::Missing { name: "promise" })?,
            machine: Machine::new()?,
            torque: 0.0,
            errors: 0,
            k: 0,
        })
    }

    fn tick(&mut self) {
        self.commissioning();
        let x = self.machine.sensors();
        let t = self.k as f32 * PERIOD;
        let (sin, cos) = brunovsky::elementary::sin_cos(t);
        let reference = Reference::new([sin, cos], -sin);
        match self.controller.update(&Measurement::new(x), &reference, PERIOD) {
            Ok(command) => {
                self.torque = command.u[0];
                if let Ok(decided) = command.asked {
                    self.watch = self.watchdog.update(decided.asked.s).ok();
                }
            }
            // One bad sample: the drive holds, the controller is as before. Many: the operator has to decide.
            Err(_) => self.errors += 1,
        }
        if self.errors > 10 {
            self.controller.select(Mode::Manual);
        }
        if self.watch.is_some_and(|watch| watch.tripped) {
            self.controller.select(Mode::Automatic(LearningMode::Off));
        }
        self.machine.drive(self.torque);
        self.k += 1;
        self.judge(x, reference);
    }

    /// Half a second by hand, one and a half of plain feedback, then learning.
    fn commissioning(&mut self) {
        match self.k {
            500 => self.controller.select(Mode::Automatic(LearningMode::Off)),
            2000 => {
                self.watchdog.reset();
                self.controller.select(Mode::Automatic(LearningMode::Active));
            }
            _ => {}
        }
    }

    /// After ten seconds the emulation ends; well if the error is within what theory promises, and nothing has tripped.
    fn judge(&self, x: SVector<f32, 2>, reference: Reference<f32, 2>) {
        if self.k == 10_000 {
            let tripped = self.watch.is_none_or(|watch| watch.tripped);
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
