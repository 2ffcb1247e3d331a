//! Curves through waypoints are saved as those, and loaded by going through them again.

use nalgebra::SVector;
use serde::{
    Deserialize, Deserializer, Serialize, Serializer,
    de::{DeserializeOwned, Error},
};

use super::{ConstantSpeed, MinimumJerk};
use crate::{Scalar, array::Array};

/// M points in D dimensions.
type Points<T, const D: usize, const M: usize> = Array<Array<T, D>, M>;

fn saved<T, const D: usize, const M: usize>(points: [[T; D]; M]) -> Points<T, D, M> {
    Array(points.map(Array))
}

fn loaded<T, const D: usize, const M: usize>(points: Points<T, D, M>) -> [[T; D]; M] {
    points.0.map(|point| point.0)
}

#[derive(Serialize, Deserialize)]
#[serde(
    rename = "MinimumJerk",
    bound(serialize = "T: Scalar + Serialize", deserialize = "T: Scalar + DeserializeOwned"),
    deny_unknown_fields
)]
struct Timed<T, const D: usize, const M: usize> {
    points: Points<T, D, M>,
    times: Array<T, M>,
    start: [SVector<T, D>; 2],
    end: [SVector<T, D>; 2],
}

impl<T: Scalar + Serialize, const D: usize, const M: usize> Serialize for MinimumJerk<T, D, M> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (points, times, [start, end]) = self.parameters();
        Timed { points: saved(points), times: Array(times), start, end }.serialize(serializer)
    }
}

impl<'de, T: Scalar + DeserializeOwned, const D: usize, const M: usize> Deserialize<'de>
    for MinimumJerk<T, D, M>
{
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        let Timed { points, times, start, end } = Timed::deserialize(deserializer)?;
        let [start, end] = [start, end].map(|end| end.map(<[T; D]>::from));
        Self::with_ends(loaded(points), times.0, start, end).map_err(S::Error::custom)
    }
}

#[derive(Serialize, Deserialize)]
#[serde(
    rename = "ConstantSpeed",
    bound(serialize = "T: Scalar + Serialize", deserialize = "T: Scalar + DeserializeOwned"),
    deny_unknown_fields
)]
struct Steady<T, const D: usize, const M: usize> {
    points: Points<T, D, M>,
    speed: T,
}

impl<T: Scalar + Serialize, const D: usize, const M: usize> Serialize for ConstantSpeed<T, D, M> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (points, speed) = self.parameters();
        Steady { points: saved(points), speed }.serialize(serializer)
    }
}

impl<'de, T: Scalar + DeserializeOwned, const D: usize, const M: usize> Deserialize<'de>
    for ConstantSpeed<T, D, M>
{
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        let Steady { points, speed } = Steady::deserialize(deserializer)?;
        Self::new(loaded(points), speed).map_err(S::Error::custom)
    }
}
