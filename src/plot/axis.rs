use std::ops::Range;

use crate::{
    Error,
    error::{below, finite},
};

/// One axis of a figure: a label with the unit, and what it shows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Axis {
    pub label: String,
    /// What to show, if not everything.
    pub range: Option<Range<f64>>,
    /// What to leave free beyond the data at each end, as a part of their span.
    pub margin: f64,
}

/// Where the ticks of a range are, and what stands beside them.
pub(super) struct Ticks {
    pub places: Vec<(f64, String)>,
    /// The power of ten that the labels are multiples of.
    pub exponent: i32,
}

impl Axis {
    pub fn new(label: impl Into<String>, margin: f64) -> Self {
        Self { label: label.into(), range: None, margin }
    }

    /// The range shown where the data are `values`.
    pub fn shown(&self, values: impl Iterator<Item = f64>) -> Result<Range<f64>, Error> {
        if let Some(range) = &self.range {
            return checked(range.clone());
        }
        let (low, high) = values
            .filter(|value| value.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        if low > high {
            return Err(Error::Missing { name: "points of the figure" });
        }
        let margin = (high - low) * self.margin;
        // A constant is shown in the middle; so is what differs by no more than rounding.
        let least = 1e-9 * low.abs().max(high.abs());
        let margin = match high - low {
            span if span > least => margin,
            _ if high == 0.0 && low == 0.0 => 1.0,
            _ => 0.5 * low.abs().max(high.abs()),
        };
        checked(low - margin..high + margin)
    }

    /// The label, with the factor that the tick labels leave out.
    pub fn label(&self, exponent: i32) -> String {
        if exponent == 0 {
            return self.label.clone();
        }
        let digits = exponent.to_string();
        let raised = digits.chars().map(|digit| match digit {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
        });
        format!("{} (×10{})", self.label, raised.collect::<String>())
    }
}

fn checked(range: Range<f64>) -> Result<Range<f64>, Error> {
    finite("start of the range of an axis", range.start)?;
    finite("end of the range of an axis", range.end)?;
    below("start of the range of an axis", range.start, range.end)?;
    finite("span of an axis", range.end - range.start)?;
    Ok(range)
}

impl Ticks {
    /// About `wanted` ticks within `range`, at multiples of 1, 2 or 5 times a power of ten.
    pub fn of(range: &Range<f64>, wanted: f64) -> Self {
        let rough = (range.end - range.start) / wanted.max(1.0);
        let power = rough.log10().floor() as i32;
        let (factor, power) = match rough / 10.0_f64.powi(power) {
            // The nearest by ratio.
            mantissa if mantissa < 2.0_f64.sqrt() => (1.0, power),
            mantissa if mantissa < 10.0_f64.sqrt() => (2.0, power),
            mantissa if mantissa < 50.0_f64.sqrt() => (5.0, power),
            _ => (1.0, power + 1),
        };
        // A quotient by 10ⁿ is the number nearest to a decimal fraction, a product with 10⁻ⁿ is not.
        let step = match power {
            ..0 => factor / 10.0_f64.powi(-power),
            _ => factor * 10.0_f64.powi(power),
        };
        let largest = range.start.abs().max(range.end.abs());
        let order = largest.log10().floor() as i32;
        let exponent = if (-3..5).contains(&order) { 0 } else { order };
        let decimals = usize::try_from(exponent - power).unwrap_or(0);
        // Ticks on the ends themselves belong to the range whatever their rounding.
        let slack = 1e-9 * (range.end - range.start);
        let first = ((range.start - slack) / step).ceil();
        let places = (0..64).map(|i| (first + f64::from(i)) * step);
        let places = places.take_while(|place| *place <= range.end + slack).map(|place| {
            // −0 is 0 to a reader.
            let place = if place == 0.0 { 0.0 } else { place };
            let text = format!("{:.decimals$}", place / 10.0_f64.powi(exponent));
            (place, text.replace('-', "−"))
        });
        Self { places: places.collect(), exponent }
    }
}
