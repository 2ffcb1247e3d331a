//! A sweep runs every replica at every point, with the same random numbers at each.

use std::{fs, path::Path};

use brunovsky::{
    Error,
    ensemble::{Axis, Design, Ensemble, RecordError, Run, Sweep, rand::RngExt},
};

fn grid() -> Design<2> {
    let a = Axis::linear("a", 0.0, 2.0).unwrap();
    let b = Axis::linear("b", 0.0, 10.0).unwrap();
    Design::grid([a.levels(3).unwrap(), b.levels(2).unwrap()])
}

/// a + b + noise; fails at a = 2, b = 10 in every second replica.
fn sweep(design: Design<2>, replicas: u64) -> Sweep<'static, 2, 1> {
    let experiment = |[a, b]: [f64; 2], mut run: Run| {
        if a + b > 11.5 && run.index() % 2 == 1 {
            return Err(Error::NotBelow { name: "a + b", value: a + b, limit: 11.5 });
        }
        Ok([a + b + run.random::<f64>()])
    };
    Sweep::new(design, replicas, 3, ["sum"], experiment).unwrap()
}

#[test]
fn every_point_has_its_replicas_with_common_random_numbers() {
    let map = sweep(grid(), 4).map();
    let noise = Ensemble::new(3, ["noise"], |mut run: Run| Ok::<_, Error>([run.random::<f64>()]));
    let mut cells = 0;
    for ([a, b], runs) in map.cells() {
        assert_eq!(runs.outcomes().len(), 4);
        for (replica, [sum]) in runs.completed() {
            let [noise] = noise.run(replica).unwrap();
            assert_eq!(*sum, a + b + noise);
        }
        let failed = if a + b > 11.5 { 2 } else { 0 };
        assert_eq!(runs.failures().count(), failed);
        cells += 1;
    }
    assert_eq!(cells, 6);
}

#[test]
fn values_come_row_by_row() {
    let values =
        sweep(grid(), 1).map().values(|runs| runs.outcomes()[0].as_ref().unwrap()[0].floor());
    assert_eq!(values, [0.0, 10.0, 1.0, 11.0, 2.0, 12.0]);
}

#[test]
fn one_run_alone_is_that_of_the_map() {
    let sweep = sweep(grid(), 4);
    let map = sweep.map();
    for (point, (_, runs)) in (0..).zip(map.cells()) {
        for (replica, outcome) in (0..).zip(runs.outcomes()) {
            assert_eq!(&sweep.run(point, replica), outcome);
        }
    }
    assert_eq!(sweep.run(0, 4), Err("there is no replica 4".to_string()));
    assert_eq!(sweep.run(6, 0), Err("there is no point 6".to_string()));
    assert_eq!(sweep.run(u64::MAX, 0), Err(format!("there is no point {}", u64::MAX / 4)));
}

#[test]
fn zero_replicas_are_refused() {
    let none = Sweep::new(grid(), 0, 0, ["x"], |_, _| Ok::<_, Error>([0.0]));
    assert_eq!(none.err(), Some(Error::NotPositive { name: "replicas", value: 0.0 }));
}

#[test]
fn a_recorded_sweep_is_the_sweep_and_belongs_to_its_design() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sweep.csv");
    let _ = fs::remove_file(&path);
    let whole = sweep(grid(), 4).recorded(&path, "").unwrap();
    assert_eq!(whole, sweep(grid(), 4).map());
    let bytes = fs::read(&path).unwrap();
    fs::write(&path, &bytes[..2 * bytes.len() / 3]).unwrap();
    assert_eq!(sweep(grid(), 4).recorded(&path, "").unwrap(), whole);
    assert_eq!(fs::read(&path).unwrap(), bytes);

    let axes = [("a", 2.0), ("b", 10.0)].map(|(name, high)| Axis::linear(name, 0.0, high).unwrap());
    let scattered = Design::latin_hypercube(axes, 6, 0).unwrap();
    for other in [sweep(grid(), 3), sweep(scattered, 4)] {
        assert!(matches!(other.recorded(&path, ""), Err(RecordError::Foreign { .. })));
    }
    fs::remove_file(&path).unwrap();
}

/// With one replica the mean is the value, the interval is infinite; where it fails the fields are empty.
#[test]
fn the_map_is_written_as_csv() {
    let points = vec![[1.0, 2.0], [2.0, 10.0], [-0.0, 0.25]];
    let design = Design::listed(["a", "b, in m"], points).unwrap();
    let experiment = |[a, b]: [f64; 2], _: Run| if b < 5.0 { Ok([a, b]) } else { Err("far") };
    let sweep = Sweep::new(design, 1, 0, ["x", "y"], experiment).unwrap();
    let mut file = Vec::new();
    sweep.map().write_csv(&mut file, 0.95).unwrap();
    let wanted = "a,\"b, in m\",runs,failed,\"x, mean\",\"x, low\",\"x, high\",\"y, mean\",\"y, low\",\"y, high\"\n\
                  1.0,2.0,1,0,1.0,-inf,inf,2.0,-inf,inf\n\
                  2.0,10.0,1,1,,,,,,\n\
                  -0.0,0.25,1,0,0.0,-inf,inf,0.25,-inf,inf\n";
    assert_eq!(String::from_utf8(file).unwrap(), wanted);
    assert!(sweep.map().write_csv(Vec::new(), 95.0).is_err());
}
