use brunovsky::plot::{Figure, Line};
use proptest::prelude::*;

use crate::support::{Drawn, value};

/// The power of ten that an axis' label carries.
fn factor(drawn: &Drawn, label: &str) -> f64 {
    let text = drawn.texts().find(|text| text.text.starts_with(label)).unwrap();
    let Some((_, raised)) = text.text.split_once("(×10") else { return 1.0 };
    let plain: String = raised
        .trim_end_matches(')')
        .chars()
        .map(|c| match c {
            '⁻' => '-',
            '¹' => '1',
            '²' => '2',
            '³' => '3',
            c => char::from_u32(c as u32 - '⁰' as u32 + '0' as u32).unwrap(),
        })
        .collect();
    10.0_f64.powi(plain.parse().unwrap())
}

proptest! {
    #[test]
    fn ticks_are_round_evenly_spaced_and_true(
        middle in -1.0..1.0_f64,
        span in 0.01..10.0_f64,
        power in -12..12_i32,
    ) {
        let scale = 10.0_f64.powi(power);
        let range = (middle - span) * scale..(middle + span) * scale;
        let figure = Figure::new("abscissa", "y").x_range(range.clone()).line(Line::new("", [(0.0, 0.0), (0.0, 1.0)]).clone());
        // The line lies outside of most ranges; y needs one of its own.
        let drawn = Drawn::of(&figure.y_range(0.0..1.0));
        let factor = factor(&drawn, "abscissa");
        let ticks = drawn.x_ticks();
        prop_assert!((3..=20).contains(&ticks.len()), "{} ticks", ticks.len());

        let step = (ticks[1].0 - ticks[0].0) * factor;
        let mantissa = step / 10.0_f64.powf(step.log10().floor());
        prop_assert!([1.0, 2.0, 5.0, 10.0].iter().any(|round| (mantissa - round).abs() < 1e-6), "step {step}");

        let [(left, _), (right, _)] = drawn.frame();
        for tick in &ticks {
            let place = left + (tick.0 * factor - range.start) / (range.end - range.start) * (right - left);
            prop_assert!((place - tick.1).abs() <= 1.5, "{} is at {}, not at {place}", tick.0, tick.1);
        }
        // None is missing at the ends.
        prop_assert!(ticks[0].0 * factor - step < range.start + 1e-6 * step);
        prop_assert!(ticks[ticks.len() - 1].0 * factor + step > range.end - 1e-6 * step);
    }
}

#[test]
fn zero_has_no_sign_and_negative_numbers_a_minus() {
    let drawn = Drawn::of(&Figure::new("x", "y").line(Line::new("", [(-1.0, -1.0), (1.0, 1.0)])));
    let labels: Vec<_> =
        drawn.texts().map(|text| text.text.clone()).filter(|text| value(text).is_some()).collect();
    assert!(labels.iter().any(|label| label == "0.0"));
    assert!(labels.iter().all(|label| !label.contains('-') && label != "−0.0"));
    assert!(labels.iter().any(|label| label.starts_with('−')));
}

#[test]
fn a_constant_is_shown_in_the_middle() {
    for level in [0.0, 7.0, -1e-6, 1e9] {
        let drawn =
            Drawn::of(&Figure::over_time("y").line(Line::new("a", [(0.0, level), (1.0, level)])));
        let [(_, top), (_, bottom)] = drawn.frame();
        let line = &drawn.lines("#0072B2")[0];
        assert!((line[0].1 - (top + bottom) / 2.0).abs() <= 1.5);
    }
}
