use core::convert::Infallible;

use rand::{Rng, SeedableRng, TryRng};
use rand_chacha::ChaCha8Rng;

/// One run of an experiment: its index, and random numbers that follow from (seed, index) alone.
///
/// It is a generator of [`rand`], so `run.random_range(0.8..1.2)` and the distributions of `rand_distr` draw from it, and it can be handed on
/// to whatever makes the noise. A clone repeats the numbers from there on: two controllers under the same noise.
///
/// The generator is ChaCha with 8 rounds. The seed is expanded to the key, the index is the number of the stream: a block of numbers is a
/// function of key, stream and position, so streams need not be skipped through and do not overlap.
///
/// # References
/// D. J. Bernstein, "ChaCha, a variant of Salsa20", 2008. J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, "Parallel random numbers: as easy
/// as 1, 2, 3", SC11, 2011 (counter-based generators).
#[derive(Debug, Clone)]
pub struct Run {
    index: u64,
    random: ChaCha8Rng,
}

impl Run {
    /// Run `index` of the ensembles with `seed`.
    pub fn new(seed: u64, index: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(index);
        Self { index, random }
    }

    /// Which run this is, from 0.
    pub fn index(&self) -> u64 {
        self.index
    }
}

impl TryRng for Run {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok(self.random.next_u32())
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        Ok(self.random.next_u64())
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        self.random.fill_bytes(bytes);
        Ok(())
    }
}
