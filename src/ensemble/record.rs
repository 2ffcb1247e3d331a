use std::{
    format,
    fs::{File, OpenOptions, TryLockError},
    io::{self, Read, Seek, SeekFrom, Write},
    path::Path,
    string::{String, ToString},
    vec::Vec,
};

use super::{Outcome, runner::finite};

/// Why a file of runs was refused, or could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RecordError {
    /// The file could not be opened, read or written.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The file belongs to another version, seed, configuration or set of figures, or is no file of runs at all.
    #[error("the file begins with {found:?}, not with {expected:?}")]
    Foreign {
        /// What this ensemble's file begins with.
        expected: String,
        /// As much of what the file begins with.
        found: String,
    },
    /// A line that is not the next run.
    #[error("the line of run {index} is not one: {line:?}")]
    Malformed {
        /// The run that should be there.
        index: u64,
        /// What is there.
        line: String,
    },
    /// A run of the file, repeated, came out differently: the experiment is not the same.
    #[error("run {index} is {repeated:?} now and {recorded:?} in the file")]
    Changed {
        /// The run.
        index: u64,
        /// Its line in the file.
        recorded: String,
        /// What its line would be now.
        repeated: String,
    },
    /// Another process has the file open for writing.
    #[error("the file is being written by another process")]
    Busy,
}

/// A file of runs, open at its end.
pub(super) struct Record {
    file: File,
}

impl Record {
    /// Opens or begins the file, and reads the runs that are in it; `repeat` runs one of them again.
    pub fn open<const M: usize>(
        path: &Path,
        seed: u64,
        names: &[&'static str; M],
        configuration: &str,
        repeat: impl Fn(u64) -> Outcome<M>,
    ) -> Result<(Self, Vec<Outcome<M>>), RecordError> {
        let mut file =
            OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => return Err(RecordError::Busy),
            // Not every file system can lock; the file is usable all the same.
            Err(TryLockError::Error(e)) if e.kind() != io::ErrorKind::Unsupported => {
                return Err(e.into());
            }
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes)?;

        let header = header(seed, names, configuration)?;
        let Some(lines) = bytes.strip_prefix(&*header) else {
            // A file that was torn in its header is begun again; one that begins differently belongs to someone else.
            if !header.starts_with(&bytes) {
                let found = bytes.get(..header.len()).unwrap_or(&bytes);
                return Err(RecordError::Foreign { expected: text(&header), found: text(found) });
            }
            file.set_len(0)?;
            file.seek(SeekFrom::Start(0))?;
            file.write_all(&header)?;
            return Ok((Self { file }, Vec::new()));
        };

        // What follows the last end of line was torn.
        let whole = lines.iter().rposition(|&byte| byte == b'\n').map_or(0, |last| last + 1);
        let lines = lines.get(..whole).unwrap_or_default();
        let mut done = Vec::new();
        for (index, line) in (0..).zip(lines.split_inclusive(|&byte| byte == b'\n')) {
            let outcome = decode(index, line, names);
            done.push(outcome.ok_or_else(|| RecordError::Malformed { index, line: text(line) })?);
        }
        if let Some(recorded) = done.first() {
            let (recorded, repeated) = (encode(0, recorded)?, encode(0, &repeat(0))?);
            if recorded != repeated {
                let (recorded, repeated) = (text(&recorded), text(&repeated));
                return Err(RecordError::Changed { index: 0, recorded, repeated });
            }
        }
        let end = (header.len() + whole) as u64;
        file.set_len(end)?;
        file.seek(SeekFrom::Start(end))?;
        Ok((Self { file }, done))
    }

    /// Appends run `index`, the next one: a single write, so that at most its line is torn.
    pub fn append<const M: usize>(&mut self, index: u64, outcome: &Outcome<M>) -> io::Result<()> {
        self.file.write_all(&encode(index, outcome)?)
    }

    /// Waits until everything is on the disk.
    pub fn finish(self) -> io::Result<()> {
        self.file.sync_all()
    }
}

/// The first line, a comment, and the names of the columns.
fn header(seed: u64, names: &[&'static str], configuration: &str) -> io::Result<Vec<u8>> {
    let version = env!("CARGO_PKG_VERSION");
    let configuration = configuration.escape_debug();
    let mut header = format!("# brunovsky {version}, seed {seed}, {configuration}\n").into_bytes();
    let columns = ["run"].into_iter().chain(names.iter().copied()).chain(["failure"]);
    header.extend(line(columns)?);
    Ok(header)
}

/// Run `index` as a line: figures in the shortest form that reads back to the same bits.
fn encode<const M: usize>(index: u64, outcome: &Outcome<M>) -> io::Result<Vec<u8>> {
    let (figures, failure) = match outcome {
        Ok(figures) => (figures.map(|figure| format!("{figure:?}")), ""),
        Err(reason) => (core::array::from_fn(|_| String::new()), reason.as_str()),
    };
    let index = index.to_string();
    let fields = [index.as_str()].into_iter();
    line(fields.chain(figures.iter().map(String::as_str)).chain([failure]))
}

/// The outcome that `line` is the encoding of, if it is one of run `index`.
fn decode<const M: usize>(
    index: u64,
    line: &[u8],
    names: &[&'static str; M],
) -> Option<Outcome<M>> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(line);
    let record = reader.records().next()?.ok()?;
    let reason = record.get(M + 1)?;
    let outcome = if reason.is_empty() {
        let mut figures = [0.0; M];
        for (figure, field) in figures.iter_mut().zip(record.iter().skip(1)) {
            *figure = field.parse().ok()?;
        }
        finite(names, figures)
    } else {
        Err(reason.to_string())
    };
    (encode(index, &outcome).ok()? == line).then_some(outcome)
}

fn line<'a>(fields: impl Iterator<Item = &'a str>) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(fields)?;
    writer.into_inner().map_err(csv::IntoInnerError::into_error)
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).trim_end().to_string()
}
