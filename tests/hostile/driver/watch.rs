//! Certificate, monitor and watchdog.

use core::fmt::Debug;

use brunovsky::{
    Error,
    learning::{Certificate, Monitor, Watchdog},
};

use super::{Bytes, Float, attack, numbers::Numbers, parts::switching};

attack!();

fn run<T: Float>(bytes: &mut Bytes) {
    // A constructor that refuses its parameters ends the attack.
    let _ = attacked::<T>(bytes);
}

fn attacked<T: Float>(bytes: &mut Bytes) -> Result<(), Error> {
    let (alpha, sign) = (bytes.parameter(), switching(bytes));
    let certificate = Certificate::<T>::new(alpha, sign, bytes.parameter(), bytes.parameter())?;
    assert!(certificate.boundary_layer_residual().are_finite());
    assert!(certificate.residual().are_finite());
    assert!(certificate.chattering_amplitude().are_finite());
    assert!(!certificate.step_ratio().wide().is_nan());
    if let Ok(time) = certificate.reaching_time(bytes.number()) {
        assert!(time.are_finite());
    }
    let order = if bytes.odd() { bytes.word() as i32 } else { bytes.byte().into() };
    if let Ok(bound) = certificate.tracking_bound(bytes.parameter(), order) {
        assert!(bound.are_finite());
    }
    let slack = bytes.parameter();
    if bytes.odd() {
        let monitor = Monitor::new(certificate, slack)?;
        on(monitor, Monitor::update, Monitor::reset, bytes);
    } else {
        let watchdog = Watchdog::new(certificate, slack, bytes.parameter())?;
        on(watchdog, Watchdog::update, Watchdog::reset, bytes);
    }
    Ok(())
}

/// Attacks what watches s.
fn on<W: Copy + PartialEq + Debug, T: Float, V: Numbers>(
    fresh: W,
    update: fn(&mut W, T) -> Result<V, Error>,
    reset: fn(&mut W),
    bytes: &mut Bytes,
) {
    let good = !bytes.wild;
    let (mut tried, mut spared, mut snapshot) = (fresh, fresh, fresh);
    let mut wild = false;
    while !bytes.is_empty() {
        match bytes.byte() % 8 {
            0 => {
                (tried, spared, wild) = (fresh, fresh, false);
                reset(&mut tried);
                assert!(tried == fresh, "reset is not as new");
            }
            1 => snapshot = tried,
            2 => {
                (tried, spared) = (snapshot, snapshot);
                wild = true;
            }
            _ => {
                bytes.wild = false;
                let s = bytes.number();
                let answer = update(&mut tried, s);
                if let Ok(answer) = &answer {
                    assert!(answer.are_finite(), "not finite");
                    let again = update(&mut spared, s).map(|answer| answer.bits());
                    assert_eq!(again, Ok(answer.bits()), "a refused s left a trace");
                }
                assert!(tried == spared, "a refused s left a trace");
                assert!(!good || wild || bytes.wild || answer.is_ok(), "a good s is refused");
                wild |= bytes.wild;
            }
        }
    }
}
