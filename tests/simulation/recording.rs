use brunovsky::simulation::{Column, Recording, RecordingError};
use proptest::prelude::*;

fn file(recording: &Recording) -> Vec<u8> {
    let mut file = Vec::new();
    recording.write(&mut file).unwrap();
    file
}

proptest! {
    #[test]
    fn every_number_is_read_as_it_was_written(bits in prop::collection::vec(any::<[u64; 2]>(), 0..20)) {
        let rows: Vec<_> = bits.iter().map(|bits| bits.map(f64::from_bits)).collect();
        let written = Recording::of(&rows, &[("a", |row| row[0]), ("b", |row| row[1])]);
        let read = Recording::read(&file(&written)[..]).unwrap();
        prop_assert_eq!(read.names(), written.names());
        prop_assert_eq!(read.rows().len(), rows.len());
        for (read, row) in read.rows().iter().zip(&rows) {
            for (read, value) in read.iter().zip(row) {
                // There are many NaNs and CSV knows one.
                prop_assert!(read.to_bits() == value.to_bits() || (read.is_nan() && value.is_nan()));
            }
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "[-0-9a.,e\n\" ]{0,60}") {
        if let Ok(read) = Recording::read(text.as_bytes()) {
            prop_assert!(read.rows().iter().all(|row| row.len() == read.names().len()));
        }
    }
}

#[test]
fn names_may_hold_commas_and_quotes() {
    let names = ["x, in m", "the \"true\" one", "ẋ₁ in m/s"];
    let columns: [Column<f64>; 3] =
        [(names[0], |x| *x), (names[1], |x| -x), (names[2], |x| 2.0 * x)];
    let written = Recording::of(&[1.0, 0.1], &columns);
    let read = Recording::read(&file(&written)[..]).unwrap();
    assert_eq!(read, written);
    assert_eq!(read.names(), names);
    assert_eq!(read.column(names[2]).unwrap().collect::<Vec<_>>(), [2.0, 0.2]);
    assert_eq!(
        read.points(names[0], names[1]).unwrap().collect::<Vec<_>>(),
        [(1.0, -1.0), (0.1, -0.1)]
    );
    assert!(read.column("x").is_none());
}

#[test]
fn files_of_others_are_read() {
    let read = Recording::read("t, x\n 0, 1e-3\n0.5 ,-2\n".as_bytes()).unwrap();
    assert_eq!(read.rows(), [[0.0, 1e-3], [0.5, -2.0]]);
}

#[test]
fn what_is_not_a_number_is_named() {
    let refused = Recording::read("t,x\n0,1\n1,one\n".as_bytes()).unwrap_err();
    assert_eq!(refused.to_string(), "row 2 of column x is \"one\", not a number");
    let refused = Recording::read("t,x\n0,1\n1\n".as_bytes()).unwrap_err();
    assert!(matches!(refused, RecordingError::Csv(_)));
}

#[test]
fn a_file_is_saved_and_loaded() {
    let path = std::env::temp_dir().join(format!("brunovsky-recording-{}.csv", std::process::id()));
    let written = Recording::of(&[0.1, 0.2], &[("x", |x: &f64| *x)]);
    written.save(&path).unwrap();
    let read = Recording::load(&path);
    std::fs::remove_file(&path).unwrap();
    assert_eq!(read.unwrap(), written);
    assert!(Recording::load(&path).is_err());
}
