use brunovsky::{
    Error,
    ensemble::{Ensemble, Run, Runs, rand::RngExt},
    plant::Pendulum,
    prelude::*,
};

/// Pendulums of random mass and start under noise: the RMS of the error and its last value. One in eight has a mass that is refused.
pub fn pendulums() -> Ensemble<'static, 2> {
    Ensemble::new(11, ["RMS in rad", "last, in rad"], |mut run: Run| {
        let believed = Pendulum::new(1.0, 0.5, 0.1, 9.81)?;
        let mass = if run.index() % 8 == 5 { -1.0 } else { run.random_range(0.8..1.2) };
        let true_one = Pendulum::new(mass, 0.5, 0.1, 9.81)?;
        let start = [run.random_range(-0.5..0.5), 0.0];
        let flc = FeedbackLinearization::new(believed, Gains::from_lambda(4.0)?);
        let noisy = |_| Reference::setpoint(run.random_range(-0.1..0.1));
        let mut metrics = ErrorMetrics::default();
        let mut last = 0.0;
        for sample in Simulation::new(&true_one, flc, noisy, start, 0.02)?.until(1.0)? {
            let sample = sample?;
            last = sample.reference.r[0] - sample.x[0];
            metrics.push(sample.t, last)?;
        }
        Ok::<_, Error>([metrics.rms().unwrap_or(0.0), last])
    })
}

/// Runs whose figure is given.
pub fn given(values: &[f64]) -> Runs<1> {
    let figure = |run: Run| Ok::<_, Error>([values[run.index() as usize]]);
    Ensemble::new(0, ["x"], figure).runs(values.len() as u64)
}

/// The probability of k hits among n with probability p each, from the definition.
pub fn binomial(n: u32, k: u32, p: f64) -> f64 {
    let choose = (0..k).fold(1.0, |product, i| product * f64::from(n - i) / f64::from(i + 1));
    choose * p.powi(k as i32) * (1.0 - p).powi((n - k) as i32)
}

/// Asserts that `hits` of `trials` are plausible for a probability of `p`: within five standard deviations, which a correct law exceeds once
/// in some two million seeds.
pub fn assert_plausible(hits: u32, trials: u32, p: f64) {
    let (n, hits) = (f64::from(trials), f64::from(hits));
    let limit = 5.0 * (n * p * (1.0 - p)).sqrt();
    assert!((hits - n * p).abs() <= limit, "{hits} of {n} hits where {} ± {limit} are due", n * p);
}
