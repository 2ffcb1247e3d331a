//! Saving and loading with `serde` (feature `serde`): what is loaded is built again, with every check of its constructor.

/// Lets a struct be saved as it is, and loaded through an expression that checks what it promises.
///
/// ```text
/// checked! { [T: Scalar] Gaussian<T>, [T] { centre: T, width: T } => Self::new(centre, width) }
/// ```
///
/// Named are
///
/// * the generics, and the type;
/// * what of it has to be serializable itself, and after a semicolon further bounds;
/// * every field with its type, or with the type that it is saved as and the expression for that: `lags: Array<T, M> = Array(*lags)`; after a
///   semicolon those that follow from the others;
/// * from these a `Result<Self, Error>`: the constructor, or `Self { … }` after a look at what the constructor does not set, with [`known`] and
///   the checks of [`error`](crate::error).
///
/// A field that is forgotten does not compile; one that is missing in a file, or not known, is refused. Without the feature it is nothing.
macro_rules! checked {
    (
        [$($generics:tt)*] $name:ident<$($argument:ident),*>, [$($part:ty),* $(; $($bound:tt)*)?]
        { $($field:ident: $kind:ty $(= $form:expr)?),* $(,)? $(; $($derived:ident),*)? } => $built:expr
    ) => {
        #[cfg(feature = "serde")]
        const _: () = {
            // Not every type needs all of them.
            #[allow(unused_imports)]
            use crate::{
                array::Array,
                checked::known,
                error::{at_most, finite, not_negative, positive, positive_vector},
            };
            #[allow(unused_imports)]
            use serde::{
                Deserialize, Deserializer, Serialize, Serializer,
                de::{DeserializeOwned, Error as _},
            };

            #[derive(Serialize)]
            #[serde(bound = "")]
            struct Saved<'saved, $($generics)*>
            where
                $($part: Serialize,)* $($($bound)*)?
            {
                $($field: &'saved $kind),*
            }

            #[derive(Deserialize)]
            #[serde(bound = "", deny_unknown_fields)]
            struct Loaded<$($generics)*>
            where
                $($part: DeserializeOwned,)* $($($bound)*)?
            {
                $(
                    #[serde(deserialize_with = "crate::checked::present")]
                    $field: $kind
                ),*
            }

            impl<$($generics)*> Serialize for $name<$($argument),*>
            where
                $($part: Serialize,)* $($($bound)*)?
            {
                fn serialize<Sink: Serializer>(&self, sink: Sink) -> Result<Sink::Ok, Sink::Error> {
                    let Self { $($field,)* $($($derived: _),*)? } = self;
                    Saved::<$($argument),*> { $($field: form!($field $(, $form)?)),* }.serialize(sink)
                }
            }

            impl<'de, $($generics)*> Deserialize<'de> for $name<$($argument),*>
            where
                $($part: DeserializeOwned,)* $($($bound)*)?
            {
                fn deserialize<Source: Deserializer<'de>>(
                    source: Source,
                ) -> Result<Self, Source::Error> {
                    let Loaded { $($field),* } = Loaded::<$($argument),*>::deserialize(source)?;
                    let built: Result<Self, crate::Error> = $built;
                    built.map_err(Source::Error::custom)
                }
            }
        };
    };
}

/// The reference to what of a field is saved: the field, or the expression for it.
#[cfg(feature = "serde")]
macro_rules! form {
    ($field:ident) => {
        $field
    };
    ($field:ident, $form:expr) => {
        &$form
    };
}

/// A field as it is. That it is asked for by name makes a missing one an error, where `serde` alone takes a missing `Option` for `None`.
#[cfg(feature = "serde")]
pub(crate) fn present<'de, F: serde::Deserialize<'de>, Source: serde::Deserializer<'de>>(
    source: Source,
) -> Result<F, Source::Error> {
    F::deserialize(source)
}

/// Checks that everything remembered is finite.
#[cfg(feature = "serde")]
pub(crate) fn known<T: crate::Scalar>(
    name: &'static str,
    values: impl IntoIterator<Item = T>,
) -> Result<(), crate::Error> {
    values.into_iter().try_for_each(|value| crate::error::finite(name, value).map(|_| ()))
}
