//! The random numbers of a run against the generator's definition and against their statistics.

use brunovsky::ensemble::{
    Run,
    rand::{Rng, RngExt},
};

use crate::support::assert_plausible;

fn words(mut run: Run, count: usize) -> Vec<u64> {
    (0..count).map(|_| run.next_u64()).collect()
}

#[test]
fn a_run_follows_from_its_seed_and_its_index() {
    assert_eq!(words(Run::new(3, 5), 100), words(Run::new(3, 5), 100));
    assert_ne!(words(Run::new(3, 5), 100), words(Run::new(3, 6), 100));
    assert_ne!(words(Run::new(3, 5), 100), words(Run::new(4, 5), 100));
    assert_eq!(Run::new(3, 5).index(), 5);
}

#[test]
fn a_clone_repeats_what_is_to_come() {
    let mut run = Run::new(3, 5);
    run.next_u32();
    assert_eq!(words(run.clone(), 100), words(run, 100));
}

/// The bytes are those of the words, little-endian, as a ChaCha key stream is defined.
#[test]
fn words_and_bytes_are_the_same_stream() {
    let mut bytes = [0; 64];
    Run::new(1, 2).fill_bytes(&mut bytes);
    let mut run = Run::new(1, 2);
    for chunk in bytes.chunks(4) {
        assert_eq!(run.next_u32().to_le_bytes(), chunk);
    }
}

/// A quarter of the pairs of independent uniform numbers has both below a half; neighbouring runs and neighbouring seeds alike.
#[test]
fn neighbouring_runs_are_independent() {
    let below = |seed, index| Run::new(seed, index).random::<f64>() < 0.5;
    let pairs = 100_000;
    let runs = (0..pairs).filter(|&i| below(0, u64::from(i)) && below(0, u64::from(i) + 1));
    assert_plausible(runs.count() as u32, pairs, 0.25);
    let seeds = (0..pairs).filter(|&i| below(u64::from(i), 0) && below(u64::from(i) + 1, 0));
    assert_plausible(seeds.count() as u32, pairs, 0.25);
}
