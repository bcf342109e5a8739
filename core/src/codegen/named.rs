//! What generated source says by name.

use core::fmt::{self, Formatter};

use super::Source;
use crate::number::Scalar;

/// A type that the source of a light has to name, because no value of it is part of the light.
pub trait Named {
    /// Writes the type's name.
    ///
    /// # Errors
    /// Those of the formatter.
    fn write_name(out: &mut Formatter<'_>) -> fmt::Result;
}

/// A number format whose values can be written as constant expressions: every one.
pub trait SourceScalar:
    Scalar<
        Length: Source,
        Unit: Source,
        Weight: Source,
        Ramp: Source,
        Frame: Source,
        Gain: Source,
        Irradiance: Source,
    > + Source
    + Named
{
}
