use std::{collections::BTreeMap, vec::Vec};

/// Results that come in any order, put in order and given to a `sink` as soon as all before them are there.
pub(super) struct InOrder<T, F> {
    results: Vec<T>,
    waiting: BTreeMap<u64, T>,
    sink: F,
}

impl<T, F> InOrder<T, F> {
    /// After the results 0, 1, … that are `done` already and not given to `sink` again.
    pub fn new(done: Vec<T>, sink: F) -> Self {
        Self { results: done, waiting: BTreeMap::new(), sink }
    }

    /// Takes the result `index`.
    pub fn take<E>(&mut self, index: u64, result: T) -> Result<(), E>
    where
        F: FnMut(u64, &T) -> Result<(), E>,
    {
        self.waiting.insert(index, result);
        loop {
            let next = self.results.len() as u64;
            let Some(result) = self.waiting.remove(&next) else { return Ok(()) };
            (self.sink)(next, &result)?;
            self.results.push(result);
        }
    }

    /// The results, in order up to the first that is missing.
    pub fn into_results(self) -> Vec<T> {
        self.results
    }
}
