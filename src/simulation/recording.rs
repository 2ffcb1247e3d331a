use std::path::Path;

/// Signals over time as a table: named columns of numbers, written to and read from CSV files (feature `csv`).
///
/// Numbers are written so that the same `f64` is read again, to the last bit; what is not finite is written as `NaN`, `inf` and `-inf`.
///
/// ```
/// use brunovsky::{plant::IntegratorChain, prelude::*, simulation::Recording};
///
/// let plant = IntegratorChain::<f64, 2>::new();
/// let flc = FeedbackLinearization::new(plant, Gains::from_lambda(2.0)?);
/// let run = Simulation::new(&plant, flc, |_| Reference::setpoint(1.0), [0.0, 0.0], 0.01)?;
/// let samples = run.until(5.0)?.collect::<Result<Vec<_>, _>>()?;
///
/// let recording = Recording::of(&samples, &[("t", |s| s.t), ("x1", |s| s.x[0]), ("u", |s| s.u[0])]);
/// let mut file = Vec::new();
/// recording.write(&mut file)?;
/// assert_eq!(Recording::read(&file[..])?, recording);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

/// Why a recording was not read or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RecordingError {
    /// The file cannot be read or written, or its rows differ in length.
    #[error(transparent)]
    Csv(#[from] csv::Error),
    /// A field that is not a number.
    #[error("row {row} of column {column} is {text:?}, not a number")]
    NotANumber {
        /// The row, counted from 1 after that of the names.
        row: usize,
        /// The column's name.
        column: String,
        /// What stands there.
        text: String,
    },
}

/// A name, and what stands in the column for a sample.
pub type Column<'a, S> = (&'a str, fn(&S) -> f64);

impl Recording {
    /// The `samples`, one row each, with a name and a value for each column.
    pub fn of<'a, S: 'a>(samples: impl IntoIterator<Item = &'a S>, columns: &[Column<S>]) -> Self {
        let row = |sample| columns.iter().map(|(_, value)| value(sample)).collect();
        Self {
            names: columns.iter().map(|(name, _)| (*name).to_owned()).collect(),
            rows: samples.into_iter().map(row).collect(),
        }
    }

    /// The names of the columns.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The rows, with a value for each column.
    pub fn rows(&self) -> &[Vec<f64>] {
        &self.rows
    }

    /// The values of a column, if there is one of that name.
    pub fn column(&self, name: &str) -> Option<impl Iterator<Item = f64> + Clone> {
        let place = self.names.iter().position(|own| own == name)?;
        Some(self.rows.iter().filter_map(move |row| row.get(place).copied()))
    }

    /// Two columns as points, to be drawn.
    pub fn points(&self, x: &str, y: &str) -> Option<impl Iterator<Item = (f64, f64)> + Clone> {
        Some(self.column(x)?.zip(self.column(y)?))
    }

    /// Writes CSV: a row of names, then the numbers.
    ///
    /// # Errors
    /// [`RecordingError::Csv`].
    pub fn write(&self, to: impl std::io::Write) -> Result<(), RecordingError> {
        let mut file = csv::Writer::from_writer(to);
        file.write_record(&self.names)?;
        for row in &self.rows {
            // The shortest decimal that is read as this number, with an exponent where that is shorter.
            file.write_record(row.iter().map(|value| format!("{value:?}")))?;
        }
        Ok(file.flush().map_err(csv::Error::from)?)
    }

    /// Reads what [`write`](Self::write) has written, or any CSV of numbers with a row of names.
    ///
    /// # Errors
    /// [`RecordingError::Csv`] or [`RecordingError::NotANumber`].
    pub fn read(from: impl std::io::Read) -> Result<Self, RecordingError> {
        let mut file = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(from);
        let names: Vec<_> = file.headers()?.iter().map(str::to_owned).collect();
        let mut rows = Vec::new();
        for (i, record) in file.records().enumerate() {
            let record = record?;
            let fields = names.iter().zip(&record).map(|(name, text)| {
                text.parse().map_err(|_| RecordingError::NotANumber {
                    row: i + 1,
                    column: name.clone(),
                    text: text.to_owned(),
                })
            });
            rows.push(fields.collect::<Result<_, _>>()?);
        }
        Ok(Self { names, rows })
    }

    /// Writes a CSV file.
    ///
    /// # Errors
    /// As [`write`](Self::write).
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), RecordingError> {
        self.write(std::fs::File::create(path).map_err(csv::Error::from)?)
    }

    /// Reads a CSV file.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn load(path: impl AsRef<Path>) -> Result<Self, RecordingError> {
        Self::read(std::fs::File::open(path).map_err(csv::Error::from)?)
    }
}
