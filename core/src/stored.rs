//! Serialisation of descriptions by `serde`: a constructor checks what is read.

/// Implements serialisation of a type by its fields, and deserialisation by an expression of these
/// fields that returns a `Result`. Without the feature `serde` the macro does nothing.
///
/// ```text
/// stored!(Decay { exponent: f32, most: f32 } by Self::new(exponent, most));
/// stored!([P: Falloff] Cone<P> { falloff: P, outer: f32 } by Self::from_versines(falloff, outer));
/// ```
#[cfg(feature = "serde")]
macro_rules! stored {
    ($([$($generic:ident: $bound:path),*])? $name:ident $(<$($argument:ident),*>)?
     { $($field:ident: $type:ty),* } by $checked:expr) => {
        #[allow(non_camel_case_types, reason = "type parameters have the names of the fields")]
        const _: () = {
            use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};

            // A type parameter per field, named like the field: no macro can number them.
            #[derive(Serialize, Deserialize)]
            #[serde(deny_unknown_fields)]
            struct Stored<$($field),*> {
                $($field: $field),*
            }

            impl<$($($generic: $bound),*)?> Serialize for $name $(<$($argument),*>)?
            where
                $($type: Serialize),*
            {
                fn serialize<Out: Serializer>(&self, serializer: Out) -> Result<Out::Ok, Out::Error> {
                    let Self { $($field),*, .. } = self;
                    Stored { $($field),* }.serialize(serializer)
                }
            }

            impl<'de, $($($generic: $bound),*)?> Deserialize<'de> for $name $(<$($argument),*>)?
            where
                $($type: Deserialize<'de>),*
            {
                fn deserialize<In: Deserializer<'de>>(deserializer: In) -> Result<Self, In::Error> {
                    let Stored { $($field),* } = Stored::<$($type),*>::deserialize(deserializer)?;
                    $checked.map_err(In::Error::custom)
                }
            }
        };
    };
}

#[cfg(not(feature = "serde"))]
macro_rules! stored {
    ($($tokens:tt)*) => {};
}

pub(crate) use stored;
