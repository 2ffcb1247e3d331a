/// A bar that shows how many runs are done, or nothing.
pub(super) struct Progress {
    #[cfg(feature = "progress")]
    bar: indicatif::ProgressBar,
}

#[cfg(feature = "progress")]
impl Progress {
    /// Of `count` runs the first `done` are there already.
    pub fn new(shown: bool, done: u64, count: u64) -> Self {
        use indicatif::{ProgressBar, ProgressStyle};
        if !shown {
            return Self { bar: ProgressBar::hidden() };
        }
        let style = ProgressStyle::with_template("{bar:40} {pos}/{len} runs, {eta} left");
        let bar = ProgressBar::new(count)
            .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
            .with_position(done);
        // The time left is estimated from the runs made here, not from those that were there.
        bar.reset_eta();
        Self { bar }
    }

    /// One more is done.
    pub fn advance(&self) {
        self.bar.inc(1);
    }
}

#[cfg(feature = "progress")]
impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(not(feature = "progress"))]
impl Progress {
    pub fn new(_shown: bool, _done: u64, _count: u64) -> Self {
        Self {}
    }

    pub fn advance(&self) {}
}
