//! Does learning that never stops stay what it was? CLELC for a very long time under noise and a drifting disturbance.
//!
//! Decade by decade, from 10⁴ steps on: the error and what has not been learned, with confidence intervals; the parameters, which must stay
//! bounded; subnormal numbers, which would slow a processor down and must not appear; and the time of a step. Four months at 100 Hz are
//!
//! `cargo run --release --example long_run -- --steps 1e9`

mod observed;
mod statistics;
mod world;

use anyhow::{Result, ensure};
use brunovsky::{
    learning::{AdaptationRule, Antecedents, ErrorRate},
    plant::IntegratorChain,
    prelude::*,
};
use clap::Parser;
use comfy_table::{Table, presets::ASCII_MARKDOWN};
use observed::{Decade, real};
use world::{DT, World};

#[derive(Parser)]
struct Options {
    /// Steps of each variant, such as 1e9.
    #[arg(long, default_value = "1e6")]
    steps: f64,
    /// Only the variants whose name contains this.
    #[arg(long, default_value = "")]
    only: String,
}

/// The decades of a run of `steps`; `rates` says whether ẋ is measured.
fn run<T: Scalar, E, R>(
    steps: u64,
    learner: NeuroFuzzy<FuzzyNetwork<T, 2, 3>, E, R>,
    rates: bool,
) -> Result<Vec<Decade>>
where
    E: ErrorRate<T, 2> + Clone,
    R: AdaptationRule<FuzzyNetwork<T, 2, 3>> + Clone,
{
    let num = |value: f64| -> T { brunovsky::nalgebra::convert(value) };
    let flc = FeedbackLinearization::new(IntegratorChain::new(), Gains::from_lambda(num(2.0))?);
    let mut clelc = Clelc::new(flc, learner);
    let (rest, dt, mut world) = (Reference::setpoint(T::zero()), num(DT), World::new());
    let mut decades = Vec::new();
    let (mut first, mut end) = (0, 10_000);
    while first < steps {
        end = end.min(steps);
        let mut decade = Decade::new(first, end);
        for k in first..end {
            let seen = Measurement::new(world.measured().map(num));
            let seen = if rates { seen.with_rate(world.rate().map(num)) } else { seen };
            let command = clelc.update(&seen, &rest, dt)?;
            decade.see(-world.x[0], world.delta, &command);
            if k % 1000 == 0 || k + 1 == end {
                decade.look_into(clelc.compensator().network(), &-seen.x);
            }
            world.move_on(real(command.u));
        }
        decades.push(decade.over());
        (first, end) = (end, end.saturating_mul(10));
    }
    Ok(decades)
}

/// All variants in the scalar `T`.
fn variants<T: Scalar>(scalar: &str, options: &Options, table: &mut Table) -> Result<()> {
    let num = |value: f64| -> T { brunovsky::nalgebra::convert(value) };
    let flowing = SlidingMode::new(num(5.0))?;
    let fixed = flowing.with_antecedents(Fixed);
    let name = |moving: &str| format!("{scalar}, {moving}");
    for decades in signs(&name("flow, model-aided"), ModelAided::new(), flowing, options, table)? {
        // Under the flow w̃ is constant, and the consequents have nowhere else to go.
        let most = decades.iter().map(Decade::astray).fold(0.0, f64::max);
        ensure!(most <= 4.0 * real(T::default_epsilon()), "{scalar}, flow: {most} off w̃");
    }
    signs(&name("fixed, model-aided"), ModelAided::new(), fixed, options, table)?;
    signs(&name("fixed, measured"), Measured, fixed, options, table)?;
    Ok(())
}

/// The decades of each sign.
fn signs<T: Scalar, E, A>(
    name: &str,
    error_rate: E,
    rule: SlidingMode<T, A>,
    options: &Options,
    table: &mut Table,
) -> Result<Vec<Vec<Decade>>>
where
    E: ErrorRate<T, 2> + Copy,
    A: Antecedents<FuzzyNetwork<T, 2, 3>> + Copy,
{
    let num = |value: f64| -> T { brunovsky::nalgebra::convert(value) };
    let network = FuzzyNetwork::evenly_spaced([num(0.1); 2])?;
    let mut runs = Vec::new();
    for (sign, switching) in
        [("set-valued", Switching::SetValued), ("δ = 0.5", Switching::Implicit { delta: num(0.5) })]
    {
        let name = format!("{name}, {sign}");
        if !name.contains(&options.only) {
            continue;
        }
        let learner = NeuroFuzzy::new(network, error_rate, rule.with_switching(switching)?);
        let decades = run(options.steps as u64, learner, name.contains("measured"))?;
        for decade in decades.iter().skip(1) {
            ensure!(decade.subnormal == 0, "{} subnormal numbers in {name}", decade.subnormal);
            table.add_row(decade.row(&name, decades.last()));
        }
        runs.push(decades);
    }
    Ok(runs)
}

fn main() -> Result<()> {
    let options = Options::parse();
    ensure!((1e5..=1e13).contains(&options.steps), "{} steps", options.steps);
    let mut table = Table::new();
    table.load_preset(ASCII_MARKDOWN).set_header(Decade::HEADER);
    variants::<f64>("f64", &options, &mut table)?;
    variants::<f32>("f32", &options, &mut table)?;
    println!("{table}");
    Ok(())
}
