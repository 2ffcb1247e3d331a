//! Networks with everything learned, for `serde`.

use core::{fmt, marker::PhantomData};

use nalgebra::SVector;
use serde::{
    Deserialize, Deserializer, Serialize, Serializer,
    de::{DeserializeOwned, Error as _, SeqAccess, Visitor},
};

use super::{
    FuzzyNetwork, Gaussian, Grid, Inputs, PerRule, Rules,
    travel::{Flowed, Travel},
};
use crate::{
    Error, Scalar, array,
    error::{finite, finite_vector},
};

checked! {
    [T: Scalar, const I: usize, const K: usize] FuzzyNetwork<T, I, K>, [T; Inputs<I>: Grid]
    {
        memberships: Array<Array<Gaussian<T>, K>, I> = Array(memberships.map(Array)),
        consequents: Rules<T, I, K>,
        travel: Option<Way<T, I>> = travel.as_ref().map(Way::of),
    } =>
    Self::new(memberships.0.map(|row| row.0)).resumed(&consequents, travel)
}

/// A [`Travel`] without what follows from the memberships and the consequents.
struct Way<T, const I: usize> {
    at: SVector<T, I>,
    moved: T,
    flowed: [Flowed<T>; I],
}

checked! {
    [T: Scalar, const I: usize] Way<T, I>, [T]
    { at: SVector<T, I>, moved: T, flowed: Array<Flowed<T>, I> = Array(*flowed) } =>
    finite_vector("input of the travel", &at).and_then(|()| {
        Ok(Self { at, moved: finite("move of the consequents", moved)?, flowed: flowed.0 })
    })
}

checked! {
    [T: Scalar] Flowed<T>, [T] { by: T, least: T, most: T } =>
    known("flow of the antecedents", [by, least, most]).and_then(|()| {
        not_negative("flow back from the start", -least)?;
        not_negative("flow back to come", by - least)?;
        not_negative("flow to come", most - by)?;
        not_negative("flow from the start", most)?;
        Ok(Self { by, least, most })
    })
}

impl<T: Scalar, const I: usize> Way<T, I> {
    fn of<const K: usize>(travel: &Travel<T, I, K>) -> Self {
        Self { at: travel.at, moved: travel.moved, flowed: travel.flowed }
    }

    /// The travel of `memberships` that has come as far as this.
    ///
    /// # Errors
    /// [`Error`] if memberships would leave the range of `T` before the bounds of the flow: both d and σ only fall or only grow between them.
    fn travel<const K: usize>(
        self,
        memberships: &[[Gaussian<T>; K]; I],
    ) -> Result<Travel<T, I, K>, Error> {
        for (row, flowed) in memberships.iter().zip(&self.flowed) {
            for (membership, by) in row.iter().flat_map(|m| [(m, flowed.least), (m, flowed.most)]) {
                let flowed = membership.flowed(by);
                Gaussian::new(flowed.centre(), flowed.width())?;
            }
        }
        // No flow is to be bounded here, so the bounds do not matter.
        let travel = Travel::new(self.at, memberships, T::one(), T::one());
        Ok(Travel { moved: self.moved, flowed: self.flowed, ..travel })
    }
}

impl<T: Scalar, const I: usize, const K: usize> FuzzyNetwork<T, I, K>
where
    Inputs<I>: Grid,
{
    /// The same with `consequents` from the start of the travel, on its `way`.
    fn resumed(mut self, consequents: &[T], way: Option<Way<T, I>>) -> Result<Self, Error> {
        let Some(way) = way else { return self.set_consequents(consequents).map(|()| self) };
        let moved = way.moved;
        self.travel = Some(way.travel(&self.memberships)?);
        self.set_consequents(consequents)?;
        if let Some(travel) = &mut self.travel {
            travel.moved = moved;
            finite("u_n", travel.output())?;
        }
        for consequent in self.consequents().iter() {
            finite("consequent", *consequent)?;
        }
        Ok(self)
    }
}

impl<V: PerRule + Serialize, const I: usize, const K: usize> Serialize for Rules<V, I, K>
where
    Inputs<I>: Grid,
{
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        array::serialize(self, serializer)
    }
}

impl<'de, V: PerRule + DeserializeOwned, const I: usize, const K: usize> Deserialize<'de>
    for Rules<V, I, K>
where
    Inputs<I>: Grid,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let rules = Rules::<(), I, K>::filled(()).len();
        deserializer.deserialize_tuple(rules, Values(PhantomData))
    }
}

struct Values<V, const I: usize, const K: usize>(PhantomData<V>);

impl<'de, V: PerRule + DeserializeOwned, const I: usize, const K: usize> Visitor<'de>
    for Values<V, I, K>
where
    Inputs<I>: Grid,
{
    type Value = Rules<V, I, K>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{K}^{I} values")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<Self::Value, A::Error> {
        let first = entries.next_element()?.ok_or_else(|| A::Error::invalid_length(0, &self))?;
        let mut rules = Rules::filled(first);
        array::fill(&mut rules, 1, &mut entries)?;
        Ok(rules)
    }
}
