//! One table of everything.

use comfy_table::{Table, presets::ASCII_MARKDOWN};

use crate::Entry;

/// Three significant digits.
fn figure(value: f64) -> String {
    let magnitude = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    if (-4.0..4.0).contains(&magnitude) {
        format!("{value:.*}", (2.0 - magnitude).max(0.0) as usize)
    } else {
        format!("{value:.2e}")
    }
}

/// The table without rows.
pub fn headed() -> Table {
    let mut table = Table::new();
    table.load_preset(ASCII_MARKDOWN).set_header([
        "plant",
        "controller",
        "had to know",
        "rise in s",
        "settling in s",
        "overshoot in %",
        "max abs e",
        "… under Δ",
        "RMS of e",
        "RMS of u",
        "TV(u) in 1/s",
        "found",
        "ns/step",
    ]);
    table
}

/// Adds a row for each of the controllers on `plant`.
pub fn add(table: &mut Table, plant: &str, entries: &[Entry]) {
    for entry in entries {
        let mut row = vec![plant.to_owned(), entry.name.to_owned(), entry.knows.to_owned()];
        match &entry.result {
            Some((parameters, merits, _)) => {
                let time = |value: Option<f64>| value.map_or("never".to_owned(), figure);
                row.extend([time(merits.rise), time(merits.settling)]);
                row.extend(
                    [
                        merits.overshoot,
                        merits.nominal,
                        merits.uncertain,
                        merits.rms,
                        merits.effort,
                        merits.variation,
                    ]
                    .map(figure),
                );
                let found =
                    parameters.iter().map(|(name, value)| format!("{name} {}", figure(*value)));
                row.push(found.collect::<Vec<_>>().join(", "));
            }
            None => {
                row.extend(
                    ["lost"; 1].map(str::to_owned).into_iter().chain(vec!["–".to_owned(); 8]),
                )
            }
        }
        row.push(entry.time.map_or("–".to_owned(), |time| format!("{time:.0}")));
        table.add_row(row);
    }
}
