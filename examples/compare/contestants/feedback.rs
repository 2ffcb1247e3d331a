//! Feedback of the output, and of the state by a model.

use brunovsky::{controller::ActiveDisturbanceRejection, prelude::*};

use super::{Contestant, Facts, Parameter, around};

/// The parameters of [`pid`].
pub fn pid_parameters<const N: usize>(facts: Facts<N>) -> [Parameter; 4] {
    let time = around(1.0 / facts.rate, 30.0);
    let filter = [facts.period, 1.0 / facts.rate];
    [("K", around(facts.pid_gain, 30.0)), ("T_i", time), ("T_d", time), ("T_f", filter)]
}

/// A PID controller whose anti-windup follows from its times by the usual rule.
pub fn pid<const N: usize>([k, t_i, t_d, t_f]: [f64; 4]) -> Result<Pid<f64, N>, Error> {
    let gains = PidGains::new(k)?.with_integral_time(t_i)?.with_derivative_time(t_d, t_f)?;
    Pid::new(gains, AntiWindup::BackCalculation { tracking_time: (t_i * t_d).sqrt() })
}

/// The parameters of [`lqr`].
pub fn lqr_parameters<const N: usize>(facts: Facts<N>) -> [Parameter; 2] {
    [facts.lambda(), ("√q₂/λ", [0.01, 10.0])]
}

/// Feedback linearization with gains that are optimal for e₁² weighted with λ²ᴺ, e₂² with q₂·λ²ᴺ⁻², and u_b² with 1.
pub fn lqr<P: FeedbackLinearizable<N, Scalar = f64>, const N: usize>(
    model: P,
    period: f64,
    [lambda, ratio]: [f64; 2],
) -> Result<FeedbackLinearization<P, N>, Error> {
    let first = lambda.powi(N as i32);
    let weights = SVector::from_fn(|i, _| match i {
        0 => first * first,
        1 => (ratio * first / lambda).powi(2),
        _ => 0.0,
    });
    Ok(FeedbackLinearization::new(model, Gains::sampled_lqr(weights, 1.0, period)?))
}

/// PID, ADRC, feedback linearization with three kinds of gains, and an adaptive one.
pub fn of<P, const N: usize>(model: P, facts: Facts<N>) -> Vec<Contestant<N>>
where
    P: FeedbackLinearizable<N, Scalar = f64> + Copy + Send + Sync + 'static,
{
    let Facts { rate, input_gain, period, .. } = facts;
    let lambda = facts.lambda();
    vec![
        Contestant::new("PID", "y", &pid_parameters(facts), move |p| {
            pid::<N>([p[0], p[1], p[2], p[3]])
        })
        .on_output(),
        Contestant::new(
            "ADRC",
            "y, b₀",
            &[lambda, ("ω_o", around(5.0 * rate, 5.0))],
            move |p| {
                ActiveDisturbanceRejection::<_, N>::new(Gains::from_lambda(p[0])?, p[1], input_gain)
            },
        )
        .on_output(),
        Contestant::new("FLC", "x, model", &[lambda], move |p| {
            Ok(FeedbackLinearization::new(model, Gains::from_lambda(p[0])?))
        }),
        Contestant::new("LQR", "x, model", &lqr_parameters(facts), move |p| {
            lqr(model, period, [p[0], p[1]])
        }),
        Contestant::new(
            "backstepping",
            "x, model",
            &[("c₁", lambda.1), ("c₂ … c_n", lambda.1)],
            move |p| {
                Backstepping::new(model, SVector::from_fn(|i, _| if i == 0 { p[0] } else { p[1] }))
            },
        ),
        Contestant::new(
            "MRAC",
            "x, model, φ = (1, x₁)",
            &[lambda, ("γ", around(rate.powi(2 * N as i32 - 1), 1000.0))],
            move |p| {
                let base = FeedbackLinearization::new(model, Gains::from_lambda(p[0])?);
                let phi = |x: &SVector<f64, N>| SVector::from([1.0, x[0]]);
                // Weights that measure e_i in λ^(1−i)·e₁, so that γ = λ²ᴺ⁻¹ learns at the rate λ or so.
                let q = SVector::from_fn(|i, _| p[0].powi(2 - 2 * i as i32));
                ModelReferenceAdaptive::<_, _, N, 2>::new(base, phi, p[1], q)
            },
        ),
    ]
}
