//! Arrays of any length for `serde`, which knows those up to 32.

use core::{fmt, marker::PhantomData};

use serde::{
    Deserialize, Deserializer, Serialize, Serializer,
    de::{Error, SeqAccess, Visitor},
    ser::SerializeTuple,
};

/// An array that is saved as a tuple.
#[derive(Clone, Copy)]
pub(crate) struct Array<T, const N: usize>(pub [T; N]);

impl<T: Serialize, const N: usize> Serialize for Array<T, N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serialize(&self.0, serializer)
    }
}

impl<'de, T: Deserialize<'de> + Copy, const N: usize> Deserialize<'de> for Array<T, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_tuple(N, Entries(PhantomData))
    }
}

/// The values as a tuple.
pub(crate) fn serialize<T: Serialize, S: Serializer>(
    values: &[T],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let mut tuple = serializer.serialize_tuple(values.len())?;
    values.iter().try_for_each(|value| tuple.serialize_element(value))?;
    tuple.end()
}

/// Overwrites the places from number `start` on with the next entries.
pub(crate) fn fill<'de, T: Deserialize<'de>, A: SeqAccess<'de>>(
    places: &mut [T],
    start: usize,
    entries: &mut A,
) -> Result<(), A::Error> {
    let length = places.len();
    for (i, place) in places.iter_mut().enumerate().skip(start) {
        let missing = || A::Error::custom(format_args!("{i} entries instead of {length}"));
        *place = entries.next_element()?.ok_or_else(missing)?;
    }
    Ok(())
}

struct Entries<T, const N: usize>(PhantomData<T>);

impl<'de, T: Deserialize<'de> + Copy, const N: usize> Visitor<'de> for Entries<T, N> {
    type Value = Array<T, N>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{N} entries")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<Array<T, N>, A::Error> {
        let first = if N == 0 { None } else { entries.next_element()? };
        let Some(first) = first else {
            let empty = <[T; N]>::try_from(&[][..]).map(Array);
            return empty.map_err(|_| A::Error::invalid_length(0, &self));
        };
        let mut array = [first; N];
        fill(&mut array, 1, &mut entries)?;
        Ok(Array(array))
    }
}
