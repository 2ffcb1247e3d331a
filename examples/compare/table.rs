//! One table of everything, and a file of what was found.

use std::path::Path;

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
        "max abs e at rest",
        "… under Δ",
        "RMS of e under Δ",
        "RMS of u",
        "TV(u) in 1/s",
        "ns a step",
    ]);
    table
}

/// Adds a row for each of the controllers on `plant`.
pub fn add(table: &mut Table, plant: &str, entries: &[Entry]) {
    for entry in entries {
        let mut row = [plant, entry.name, entry.knows].map(str::to_owned).to_vec();
        row.extend(figures(entry));
        row.push(entry.time.map_or("–".to_owned(), |time| format!("{time:.0}")));
        table.add_row(row);
    }
}

fn figures(entry: &Entry) -> [String; 8] {
    let Some((merits, _)) = &entry.result else {
        let reason = if entry.found.is_empty() { "no tuning found" } else { "lost under Δ" };
        let nothing = || "–".to_owned();
        return core::array::from_fn(|i| if i == 0 { reason.to_owned() } else { nothing() });
    };
    let time = |value: Option<f64>| value.map_or("never".to_owned(), figure);
    [
        time(merits.rise),
        time(merits.settling),
        figure(merits.overshoot),
        figure(merits.nominal),
        figure(merits.uncertain),
        figure(merits.rms),
        figure(merits.effort),
        figure(merits.variation),
    ]
}

/// Writes the parameters that were found on each plant.
pub fn write(path: &Path, found: &[(&str, Vec<Entry>)]) -> csv::Result<()> {
    let mut file = csv::Writer::from_path(path)?;
    file.write_record(["plant", "controller", "parameter", "value"])?;
    for (plant, entries) in found {
        for entry in entries {
            for (name, value) in &entry.found {
                file.write_record([plant, entry.name, name, &value.to_string()])?;
            }
        }
    }
    file.flush()?;
    Ok(())
}
