//! The paper's claims, each beside what was measured.

use std::path::Path;

use comfy_table::{Table, presets::ASCII_MARKDOWN};
use serde::Serialize;

/// One statement of the paper and what became of it.
#[derive(Serialize)]
pub struct Claim {
    experiment: &'static str,
    claim: String,
    paper: String,
    measured: String,
    verdict: &'static str,
}

impl Claim {
    /// A claim of `experiment` for which the paper says `paper` and we `measured` something that bears it out or does not.
    pub fn new(
        experiment: &'static str,
        claim: impl Into<String>,
        paper: impl Into<String>,
        measured: impl Into<String>,
        borne_out: bool,
    ) -> Self {
        Self {
            experiment,
            claim: claim.into(),
            paper: paper.into(),
            measured: measured.into(),
            verdict: if borne_out { "reproduced" } else { "not reproduced" },
        }
    }
}

/// An empty table for the terminal.
pub fn headed<const N: usize>(header: [&str; N]) -> Table {
    let mut table = Table::new();
    table.load_preset(ASCII_MARKDOWN).set_header(header);
    table
}

/// The claims as a table for the terminal.
pub fn table(claims: &[Claim]) -> Table {
    let mut table = headed(["claim", "paper", "measured", "verdict"]);
    for claim in claims {
        table.add_row([&claim.claim, &claim.paper, &claim.measured, claim.verdict]);
    }
    table
}

/// Writes the claims as CSV.
pub fn write(path: &Path, claims: &[Claim]) -> csv::Result<()> {
    let mut file = csv::Writer::from_path(path)?;
    for claim in claims {
        file.serialize(claim)?;
    }
    file.flush()?;
    Ok(())
}
