//! PID, linear-quadratic regulators and state feedback, model reference adaptive control, backstepping.

use brunovsky::{
    Error,
    controller::{
        AntiWindup, Backstepping, BacksteppingCommand, Gains, Leakage, ModelReferenceAdaptive,
        ModelReferenceAdaptiveCommand, Pid, PidCommand, PidGains, Projection, Regressor,
        StateFeedback, StateRegressor,
        lqr::{self, Regulator, Weights},
    },
    plant::IntegratorChain,
};
use nalgebra::{SMatrix, SVector};

use super::{
    Bytes, Float, attack,
    controller::{Attack, Decode},
    numbers::Numbers,
    parts::{Model, flc},
};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = match bytes.byte() % 8 {
        0 => on_pid::<T, 1>(bytes),
        1 => on_pid::<T, 3>(bytes),
        2 => on_regulators::<T>(bytes),
        3 => on_state_feedback::<T>(bytes),
        4 => on_backstepping::<T>(bytes),
        5 => on_linear_adaptive::<T>(bytes),
        _ => on_adaptive::<T>(bytes),
    };
}

impl<T: Float> Numbers for PidCommand<T> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.u, self.u_p, self.u_i, self.u_d].each(see);
    }
}

impl<T: Float> Numbers for ModelReferenceAdaptiveCommand<T> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.u, self.u_f, self.u_b, self.u_a, self.s].each(see);
    }
}

impl<T: Float, const N: usize> Numbers for BacksteppingCommand<T, N> {
    fn each(&self, see: &mut impl FnMut(f64)) {
        [self.u, self.u_f, self.u_b].each(see);
        self.z.each(see);
    }
}

impl<T: Float, const N: usize> Decode for SVector<T, N> {
    fn decode(bytes: &mut Bytes) -> Self {
        bytes.vector()
    }
}

fn pid_gains<T: Float>(bytes: &mut Bytes) -> Result<PidGains<T>, Error> {
    let gains = if bytes.odd() {
        let k = PidGains::new(bytes.number())?.with_integral_time(bytes.parameter())?;
        k.with_derivative_time(bytes.parameter(), bytes.parameter())?
    } else {
        PidGains::parallel(bytes.number(), bytes.number(), bytes.number(), bytes.parameter())?
    };
    if bytes.odd() { gains.with_weights(bytes.number(), bytes.number()) } else { Ok(gains) }
}

fn on_pid<T: Float, const N: usize>(bytes: &mut Bytes) -> Result<(), Error> {
    let anti_windup = match bytes.byte() % 3 {
        0 => AntiWindup::None,
        1 => AntiWindup::BackCalculation { tracking_time: bytes.parameter() },
        _ => AntiWindup::Conditional { tolerance: bytes.parameter() },
    };
    let pid = Pid::<T, N>::new(pid_gains(bytes)?, anti_windup)?;
    let attack = Attack {
        settle: |pid: &mut Pid<T, N>| {
            let one = PidGains::new(T::one()).and_then(|gains| pid.set_gains(gains));
            assert_eq!(one, Ok(()));
        },
        meddle: retune,
        ..Attack::plain::<N, 1>(!bytes.wild)
    };
    attack.on(&pid, bytes);
    Ok(())
}

/// Other gains, or another start.
fn retune<T: Float, const N: usize>(pid: &mut Pid<T, N>, bytes: &mut Bytes) {
    let before = *pid;
    let refused = if bytes.odd() {
        pid_gains(bytes).is_ok_and(|gains| pid.set_gains(gains).is_err())
    } else {
        pid.start_at(bytes.number()).is_err()
    };
    assert!(!refused || *pid == before, "a refused setting left a trace");
}

fn matrix<T: Float, const M: usize, const N: usize>(bytes: &mut Bytes) -> SMatrix<T, M, N> {
    SMatrix::from_fn(|_, _| bytes.number())
}

/// On the diagonal, or anything.
fn weights<T: Float, const NX: usize, const NU: usize>(
    bytes: &mut Bytes,
) -> Result<Weights<T, NX, NU>, Error> {
    if bytes.odd() {
        return Weights::diagonal(bytes.parameters::<T, NX>(), bytes.parameters::<T, NU>());
    }
    let (q, r) = (matrix::<T, NX, NX>(bytes), matrix::<T, NU, NU>(bytes));
    Weights::with_cross(q * q.transpose(), r * r.transpose(), matrix(bytes))
}

/// What is solved is finite, symmetric, and solves its equation by half of the digits.
fn on_regulators<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let (a, b) = (matrix::<T, 3, 3>(bytes), matrix::<T, 3, 2>(bytes));
    let weights = weights(bytes)?;
    let seen = |found: Result<Regulator<T, 3, 2>, Error>| {
        if let Ok(Regulator { gain, value, residual }) = found {
            assert!(gain.iter().chain(value.iter()).all(|x| x.are_finite()));
            assert_eq!(value, value.transpose());
            assert!(residual <= T::default_epsilon().sqrt());
        }
    };
    seen(lqr::continuous(&a, &b, &weights));
    seen(lqr::discrete(&a, &b, &weights));
    seen(lqr::sampled(&a, &b, &weights, bytes.parameter()));
    if let Ok(p) = lqr::lyapunov(&a, weights.q()) {
        assert!(p.iter().all(|x| x.are_finite()));
    }
    for gains in [
        Gains::<T, 4>::lqr(bytes.parameters::<T, 4>(), bytes.parameter()),
        Gains::sampled_lqr(bytes.parameters::<T, 4>(), bytes.parameter(), bytes.parameter()),
    ] {
        assert!(gains.is_err() || gains.is_ok_and(|gains| gains.as_vector().are_finite()));
    }
    Ok(())
}

fn on_state_feedback<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let gain = if bytes.odd() {
        let weights = weights(bytes)?;
        lqr::continuous(&matrix::<T, 2, 2>(bytes), &matrix::<T, 2, 1>(bytes), &weights)?.gain
    } else {
        matrix(bytes)
    };
    let controller = StateFeedback::<T, 2, 1>::new(gain, bytes.vector::<T, 1>())?;
    // An extreme gain may come out of moderate numbers.
    let moderate = gain.iter().all(|k| k.abs() < nalgebra::convert(1e6));
    Attack::plain(moderate && !bytes.wild).on(&controller, bytes);
    Ok(())
}

fn on_backstepping<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    if bytes.odd() {
        let chain = IntegratorChain::<T, 4>::new();
        let controller = Backstepping::new(chain, bytes.parameters::<T, 4>())?;
        Attack::plain(!bytes.wild).on(&controller, bytes);
    } else {
        let (model, answers) = Model::<T>::decode(bytes)?;
        let controller = Backstepping::new(model, bytes.parameters::<T, 2>())?;
        Attack::plain(answers && !bytes.wild).on(&controller, bytes);
    }
    Ok(())
}

/// φ = (1, x₁², x₁·x₂): it grows, and vanishes.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Products;

impl<T: Float> Regressor<T, 2, 3> for Products {
    fn regressor(&self, x: &SVector<T, 2>) -> SVector<T, 3> {
        SVector::from([T::one(), x[0] * x[0], x[0] * x[1]])
    }
}

fn leakage<T: Float>(bytes: &mut Bytes) -> Leakage<T> {
    match bytes.byte() % 3 {
        0 => Leakage::None,
        1 => Leakage::Sigma { sigma: bytes.parameter() },
        _ => Leakage::Error { sigma: bytes.parameter() },
    }
}

fn projection<T: Float, const L: usize>(bytes: &mut Bytes) -> Projection<T, L> {
    match bytes.byte() % 3 {
        0 => Projection::None,
        1 => Projection::Ball { radius: bytes.parameter() },
        _ => Projection::Box { lower: bytes.vector(), upper: bytes.vector() },
    }
}

/// Every option of `new`, a controller of any kind.
macro_rules! with_options {
    ($new:expr, $bytes:ident) => {{
        let mut controller = $new.with_leakage(leakage($bytes))?;
        if $bytes.odd() {
            controller = controller.with_projection(projection($bytes))?;
        }
        if $bytes.odd() {
            controller = controller.with_parameters($bytes.vector())?;
        }
        if $bytes.odd() {
            let [rate, lower, upper] = $bytes.parameters();
            controller = controller.with_unknown_effectiveness(rate, [lower, upper])?;
        }
        if $bytes.odd() {
            controller = controller.with_model_at($bytes.vector())?;
        }
        controller
    }};
}

fn on_linear_adaptive<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let base = flc(IntegratorChain::<T, 3>::new(), bytes)?;
    let (rate, q) = (bytes.parameter(), bytes.parameters::<T, 3>());
    let new = ModelReferenceAdaptive::<_, _, 3, 3>::new(base, StateRegressor, rate, q)?;
    let controller = with_options!(new, bytes);
    Attack::plain(!bytes.wild).on(&controller, bytes);
    Ok(())
}

fn on_adaptive<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let (model, answers) = Model::<T>::decode(bytes)?;
    let base = flc(model, bytes)?;
    let (rate, q) = (bytes.parameter(), bytes.parameters::<T, 2>());
    let new = ModelReferenceAdaptive::<_, _, 2, 3>::new(base, Products, rate, q)?;
    let controller = with_options!(new, bytes);
    Attack::plain(answers && !bytes.wild).on(&controller, bytes);
    Ok(())
}
