//! Models as data: the numbers that a falloff or a law of the distance is made from, with the values that each
//! may have.
//!
//! `model!` declares a type by its numbers. From these follow the fields, what reads them, storage, source text,
//! and the [`Model`] of the type, from which everything that takes or writes a model by its name follows: words of
//! a command and their help, links, JSON, and the generators of tests.

use crate::error::{Error, Expected, Parameter};

/// A number that a model is made from.
#[derive(Clone, Copy, PartialEq, Debug)]
#[allow(unreachable_pub, reason = "public with the feature arithmetic")]
pub struct Number {
    /// The name of the field.
    pub name: &'static str,
    /// What errors call the number.
    pub parameter: Parameter,
    /// The least and the largest value; a positive number is more than the least.
    pub limits: [f32; 2],
    /// Which numbers between the limits are accepted.
    pub accepts: Accepts,
    /// The value in the sample of a model.
    pub sample: f32,
    /// The least and the largest usual value: of random models, and of a slider.
    pub usual: [f32; 2],
    /// The power of the scene unit in its unit: 1 of a distance, 0 of a number without a unit.
    pub dimension: i8,
    /// The value of the number where it is left out; `None` if it is always there.
    pub default: Option<f32>,
}

/// Which numbers between two limits are accepted.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(unreachable_pub, reason = "public with the feature arithmetic")]
pub enum Accepts {
    /// All, and both limits.
    All,
    /// All and the upper limit, but not the lower one, which is 0.
    Positive,
    /// Whole numbers.
    Whole,
}

impl Number {
    /// A number from one limit to the other, of which a random model has any.
    pub(crate) const fn between(parameter: Parameter, least: f32, most: f32, sample: f32) -> Self {
        let limits = [least, most];
        let accepts = Accepts::All;
        Self { name: "", parameter, limits, accepts, sample, usual: limits, dimension: 0, default: None }
    }

    /// A number of more than 0 and at most a limit, of which random models have such from `least` on.
    pub(crate) const fn positive(parameter: Parameter, least: f32, most: f32, sample: f32) -> Self {
        let (limits, usual, accepts) = ([0.0, most], [least, most], Accepts::Positive);
        Self { name: "", parameter, limits, accepts, sample, usual, dimension: 0, default: None }
    }

    /// The range of a light: a distance in scene units, at most 40 in random models. The squares of both limits, and
    /// the reciprocals of these squares, are well inside the limits of f32.
    pub(crate) const fn range() -> Self {
        Self::between(Parameter::Range, 1e-3, 1e9, 9.0).named("range").usually(0.0, 40.0).of_dimension(1)
    }

    /// A whole number from one limit to the other.
    pub(crate) const fn whole(parameter: Parameter, least: u32, most: u32, sample: u32) -> Self {
        let limits = [least as f32, most as f32];
        Self {
            name: "",
            parameter,
            limits,
            accepts: Accepts::Whole,
            sample: sample as f32,
            usual: limits,
            dimension: 0,
            default: None,
        }
    }

    /// The same number as a field of this name.
    pub(crate) const fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }

    /// The same number, of which random models have values between these.
    pub(crate) const fn usually(self, least: f32, most: f32) -> Self {
        Self { usual: [least, most], ..self }
    }

    /// The same number with a power of the scene unit.
    pub(crate) const fn of_dimension(self, dimension: i8) -> Self {
        Self { dimension, ..self }
    }

    /// The same number, which may be left out.
    pub(crate) const fn or(self, default: f32) -> Self {
        Self { default: Some(default), ..self }
    }

    /// Returns whether the number is the range of a light.
    pub(crate) fn is_range(&self) -> bool {
        self.parameter == Parameter::Range
    }

    /// Returns a value that is accepted.
    ///
    /// # Errors
    /// A value that is not.
    #[inline]
    pub(crate) fn checked(&self, value: f32) -> Result<f32, Error> {
        let [least, most] = self.limits;
        let is_accepted = match self.accepts {
            Accepts::All => value >= least && value <= most,
            Accepts::Positive => value > least && value <= most,
            Accepts::Whole => value >= least && value <= most && value as u32 as f32 == value,
        };
        if is_accepted { Ok(value) } else { Err(self.refusal(value)) }
    }

    /// Returns a whole number that is accepted.
    pub(crate) fn checked_whole(&self, value: u32) -> Result<u32, Error> {
        if self.clamped_whole(value) == value { Ok(value) } else { Err(self.refusal(value as f32)) }
    }

    /// Returns the error for a value that is not accepted.
    fn refusal(&self, value: f32) -> Error {
        let [least, most] = self.limits;
        let accepted = match self.accepts {
            Accepts::All if self.is_range() => Expected::RangeBetween(least, most),
            Accepts::All => Expected::Between(least, most),
            Accepts::Positive => Expected::UpTo(most),
            Accepts::Whole => Expected::WholeBetween(least as u32, most as u32),
        };
        Error { parameter: self.parameter, value, accepted }
    }

    /// Returns a value clamped to the limits; the least for NaN.
    pub(crate) const fn clamped(&self, value: f32) -> f32 {
        let [least, most] = self.limits;
        // `clamp` returns NaN for NaN.
        if value.is_nan() { least } else { value.clamp(least, most) }
    }

    /// Returns a whole number clamped to the limits.
    pub(crate) const fn clamped_whole(&self, value: u32) -> u32 {
        let [least, most] = self.limits;
        let (least, most) = (least as u32, most as u32);
        if value < least {
            least
        } else if value > most {
            most
        } else {
            value
        }
    }

    /// Returns the value in the sample of a model: the default of a number that may be left out.
    #[allow(unreachable_pub, reason = "public with the feature arithmetic")]
    pub fn in_sample(&self) -> f32 {
        self.default.unwrap_or(self.sample)
    }

    /// Returns a value for a number in [0, 1): below 0.2 the least that is accepted, below 0.4 the largest, below 0.6 that
    /// of the sample, and else one that is [`drawn`](Self::drawn).
    ///
    /// A drawn range may be below the least, and a constructor may refuse numbers together that it accepts one by one.
    #[cfg(feature = "arithmetic")]
    pub fn anywhere(&self, number: f32) -> f32 {
        let [least, most] = self.limits;
        match number {
            ..0.2 if self.accepts == Accepts::Positive => f32::from_bits(least.to_bits() + 1),
            ..0.2 => least,
            ..0.4 => most,
            ..0.6 => self.in_sample(),
            _ => self.drawn((number - 0.6) / 0.4),
        }
    }

    /// Returns the value of a random model for a number in [0, 1), between the usual limits. Of positive and of whole
    /// numbers the logarithms are spread evenly.
    #[cfg(feature = "arithmetic")]
    pub fn drawn(&self, number: f32) -> f32 {
        let [least, most] = self.usual;
        let value = if self.accepts == Accepts::All {
            least + (most - least) * number
        } else {
            least * libm::powf(most / least, number)
        };
        if self.accepts == Accepts::Whole { value as u32 as f32 } else { value }
    }
}

/// A model that is made from numbers: none, or a few.
#[allow(unreachable_pub, reason = "public with the feature arithmetic")]
pub trait Model: Copy {
    /// The name of the type.
    #[cfg(feature = "arithmetic")]
    const TYPE: &'static str;
    /// The numbers, in the order of the constructor. Those that may be left out come last.
    const NUMBERS: &'static [Number];

    /// Creates the model from its numbers; those beyond are not read.
    ///
    /// # Errors
    /// Numbers that the constructor refuses. A number that is missing is NaN.
    fn of(numbers: &[f32]) -> Result<Self, Error>;

    /// Returns a number of the model by its place in [`NUMBERS`](Self::NUMBERS); `None` behind the last.
    #[cfg(feature = "arithmetic")]
    fn number(&self, place: usize) -> Option<f32>;
}

/// The largest count of numbers of a model.
#[allow(unreachable_pub, reason = "public with the feature arithmetic")]
pub const MOST_NUMBERS: usize = 3;

/// Returns a value for each number, and NaN behind the last.
pub(crate) fn each(numbers: &[Number], value: impl FnMut(&Number) -> f32) -> [f32; MOST_NUMBERS] {
    let mut values = numbers.iter().map(value);
    core::array::from_fn(|_| values.next().unwrap_or(f32::NAN))
}

/// Returns one of the given values for each number, in their order. A number that may be left out has its default where
/// none is given; any other is NaN.
pub(crate) fn given(numbers: &[Number], values: &[f32]) -> [f32; MOST_NUMBERS] {
    let mut values = values.iter().copied();
    each(numbers, |number| values.next().or(number.default).unwrap_or(f32::NAN))
}

/// Returns the value of a model whose numbers are those of its sample.
#[cfg(feature = "arithmetic")]
pub(crate) fn sample<M: Model>() -> Result<M, Error> {
    M::of(&each(M::NUMBERS, Number::in_sample))
}

/// A number as a field holds it.
pub(crate) trait Field: Copy {
    /// Returns the field for a number, which for a whole number must be one.
    fn of(number: &Number, value: f32) -> Result<Self, Error>;
    /// Returns the number.
    #[cfg(feature = "arithmetic")]
    fn value(self) -> f32;
}

impl Field for f32 {
    /// The constructor checks the range.
    fn of(_: &Number, value: f32) -> Result<Self, Error> {
        Ok(value)
    }

    #[cfg(feature = "arithmetic")]
    fn value(self) -> f32 {
        self
    }
}

impl Field for u32 {
    fn of(number: &Number, value: f32) -> Result<Self, Error> {
        number.checked(value).map(|whole| whole as Self)
    }

    #[cfg(feature = "arithmetic")]
    fn value(self) -> f32 {
        self as f32
    }
}

/// Declares a type by the numbers that it is made from.
///
/// A row is `doc field: type = number;`, where `doc` describes what returns the number. `by` is the checked
/// constructor. A name behind `law` is that of a law of the distance: constants are compiled from it, so that no
/// source text has its numbers.
///
/// ```text
/// model! {
///     /// The quadratic `t (a + (1 - a) t)`.
///     Quadratic {
///         /// Returns the edge slope.
///         edge_slope: f32 = Number::between(Parameter::EdgeSlope, 0.0, 2.0, 0.5);
///     } by Self::new(edge_slope)
/// }
/// ```
macro_rules! model {
    ($(#[$meta:meta])* law $name:ident { $($rows:tt)+ } by $checked:expr) => {
        $crate::model::model! { @type [$(#[$meta])*] $name { $($rows)+ } by $checked }
        $crate::source::named!($name);
    };
    ($(#[$meta:meta])* $name:ident { $($(#[$doc:meta])* $field:ident: $type:ident = $number:expr;)+ }
     by $checked:expr) => {
        $crate::model::model! {
            @type [$(#[$meta])*] $name { $($(#[$doc])* $field: $type = $number;)+ } by $checked
        }
        $crate::model::model! { @bits $name [<Self as $crate::model::Model>::NUMBERS] $($field: $type,)+ }
        $crate::source::written_by_bits!($name);
    };
    (@type [$(#[$meta:meta])*] $name:ident { $($(#[$doc:meta])* $field:ident: $type:ident = $number:expr;)+ }
     by $checked:expr) => {
        $(#[$meta])*
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[derive(Clone, Copy, PartialEq, Debug)]
        pub struct $name {
            $($field: $type,)+
        }

        $crate::stored::stored!($name { $($field: $type),+ } by $checked);

        impl $name {
            $(
                $(#[$doc])*
                pub const fn $field(self) -> $type {
                    self.$field
                }
            )+
        }

        impl $crate::model::Model for $name {
            #[cfg(feature = "arithmetic")]
            const TYPE: &'static str = stringify!($name);
            const NUMBERS: &'static [$crate::model::Number] = &[$($number.named(stringify!($field))),+];

            fn of(numbers: &[f32]) -> Result<Self, $crate::error::Error> {
                let mut given = Self::NUMBERS.iter().zip(numbers.iter().copied().chain(core::iter::repeat(f32::NAN)));
                $(
                    let (number, value) = given.next().unwrap_or((&Self::NUMBERS[0], f32::NAN));
                    let $field: $type = $crate::model::Field::of(number, value)?;
                )+
                $checked
            }

            #[cfg(feature = "arithmetic")]
            fn number(&self, place: usize) -> Option<f32> {
                [$($crate::model::Field::value(self.$field)),+].get(place).copied()
            }
        }
    };
    (@bits $name:ident [$numbers:expr] $field:ident: $type:ident,) => {
        impl $name {
            /// Creates the model from the bits of its number, as [`codegen`](crate::codegen) writes them. The number
            /// is clamped to the accepted range; NaN becomes the least.
            pub const fn from_bits(bits: u32) -> Self {
                Self { $field: $crate::model::model!(@clamped $type, bits, $numbers[0]) }
            }

            /// Returns the bits of the number.
            pub const fn to_bits(self) -> u32 {
                $crate::model::model!(@bits_of $type, self.$field)
            }
        }
    };
    (@bits $name:ident [$numbers:expr] $($field:ident: $type:ident,)+) => {
        impl $name {
            /// Creates the model from the bits of its numbers, as [`codegen`](crate::codegen) writes them. Each number is
            /// clamped to the accepted range; NaN becomes the least. What the constructor asks of several
            /// numbers together may not hold.
            pub const fn from_bits(bits: [u32; $crate::model::model!(@count $($field)+)]) -> Self {
                let [$($field),+] = bits;
                let mut place = 0;
                Self {
                    $($field: {
                        place += 1;
                        $crate::model::model!(@clamped $type, $field, $numbers[place - 1])
                    },)+
                }
            }

            /// Returns the bits of the numbers.
            pub const fn to_bits(self) -> [u32; $crate::model::model!(@count $($field)+)] {
                [$($crate::model::model!(@bits_of $type, self.$field)),+]
            }
        }
    };
    (@count $($field:ident)+) => { <[&str]>::len(&[$(stringify!($field)),+]) };
    (@clamped f32, $bits:expr, $number:expr) => { $number.clamped(f32::from_bits($bits)) };
    (@clamped u32, $bits:expr, $number:expr) => { $number.clamped_whole($bits) };
    (@bits_of f32, $field:expr) => { $field.to_bits() };
    (@bits_of u32, $field:expr) => { $field };
}

/// Declares that types are models without numbers, each with one value, which Rust writes as its name. Those behind
/// `law` are laws of the distance.
macro_rules! plain {
    (law $($name:ident)*) => {
        $crate::source::named!($($name)*);
        $crate::model::plain! { @models $($name)* }
    };
    ($($name:ident)*) => {
        $crate::source::written_by_debug!($($name)*);
        $crate::model::plain! { @models $($name)* }
    };
    (@models $($name:ident)*) => {
        $(impl $crate::model::Model for $name {
            #[cfg(feature = "arithmetic")]
            const TYPE: &'static str = stringify!($name);
            const NUMBERS: &'static [$crate::model::Number] = &[];

            fn of(_: &[f32]) -> Result<Self, $crate::error::Error> {
                Ok(Self)
            }

            #[cfg(feature = "arithmetic")]
            fn number(&self, _: usize) -> Option<f32> {
                None
            }
        })*
    };
}

pub(crate) use {model, plain};
