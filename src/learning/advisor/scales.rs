use super::quantile::Quantile;
use crate::{Error, Scalar, scalar::constant};

/// Windows of 1, 2, 4, …, 2¹¹ samples.
const SCALES: usize = 12;
/// From twenty values on the largest one is above the 95 % quantile.
const ENOUGH: u32 = 20;

/// First and second differences of a signal's means over windows of doubling length.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(bound(
        serialize = "T: Scalar + serde::Serialize",
        deserialize = "T: Scalar + serde::de::DeserializeOwned"
    ))
)]
pub(super) struct Scales<T>([Scale<T>; SCALES]);

/// The means over windows of one length.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Scale<T> {
    /// The mean that waits for a second one, to be a window of twice the length.
    half: Option<T>,
    last: Option<T>,
    before: Option<T>,
    step: Quantile<T>,
    bend: Quantile<T>,
}

/// The window at which a signal is seen best.
pub(super) struct Chosen<T> {
    /// Its length in samples.
    pub periods: f64,
    /// The quantile of |first difference|.
    pub step: T,
    /// That of |second difference|, over it.
    pub clarity: T,
}

impl<T: Scalar> Scales<T> {
    pub fn new() -> Self {
        let nothing = Scale {
            half: None,
            last: None,
            before: None,
            step: Quantile::new(),
            bend: Quantile::new(),
        };
        Self([nothing; SCALES])
    }

    pub fn push(&mut self, sample: T) {
        let mut mean = sample;
        for scale in &mut self.0 {
            match scale.take(mean) {
                Some(longer) => mean = longer,
                None => return,
            }
        }
    }

    /// The quantile of |second difference| from sample to sample.
    pub fn bend(&self) -> T {
        let [finest, ..] = &self.0;
        finest.bend.value()
    }

    /// The window at which the second difference is the smallest part of the first.
    pub fn clearest(&self) -> Result<Chosen<T>, Error> {
        let (mut periods, mut best) = (1.0, None::<Chosen<T>>);
        for scale in self.0.iter().take_while(|scale| scale.bend.count() >= ENOUGH) {
            let (step, bend) = (scale.step.value(), scale.bend.value());
            // A scale at which nothing moves says nothing of how clearly.
            let clarity =
                if step > T::zero() { bend / step } else { constant(f64::from(f32::MAX)) };
            if best.as_ref().is_none_or(|best| clarity < best.clarity) {
                best = Some(Chosen { periods, step, clarity });
            }
            periods *= 2.0;
        }
        let [finest, ..] = &self.0;
        let found = finest.step.count() as usize + usize::from(finest.last.is_some());
        let expected = ENOUGH as usize + 2;
        best.ok_or(Error::Length { name: "record of the uncertainty", expected, found })
    }
}

impl<T: Scalar> Scale<T> {
    /// Takes the next mean, and gives the one of the next longer window if it completes it.
    fn take(&mut self, mean: T) -> Option<T> {
        if let Some(last) = self.last {
            self.step.push((mean - last).abs());
            if let Some(before) = self.before {
                self.bend.push(((mean - last) - (last - before)).abs());
            }
        }
        (self.before, self.last) = (self.last, Some(mean));
        match self.half.take() {
            None => {
                self.half = Some(mean);
                None
            }
            Some(half) => Some((half + mean) * constant(0.5)),
        }
    }
}

checked! {
    [T: Scalar] Scale<T>, [T]
    {
        half: Option<T>,
        last: Option<T>,
        before: Option<T>,
        step: Quantile<T>,
        bend: Quantile<T>,
    } =>
    known("mean of the uncertainty", [half, last, before].into_iter().flatten())
        .map(|()| Self { half, last, before, step, bend })
}
