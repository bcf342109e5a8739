//! Full and half cone angles as distinct types, for data sheets and graphics libraries.

use crate::trig;

/// A full cone angle, from edge to edge through the axis, as in data sheets, GDTF and Direct3D.
///
/// ```
/// use luminaire::{Angle, HalfAngle};
/// assert_eq!(Angle::degrees(15.0), HalfAngle::degrees(7.5).into());
/// ```
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub struct Angle {
    degrees: f32,
}

/// A half cone angle, from the axis to the edge, as in OpenGL, glTF and three.js.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub struct HalfAngle {
    degrees: f32,
}

impl Angle {
    /// Creates a full angle from degrees.
    pub const fn degrees(degrees: f32) -> Self {
        Self { degrees }
    }

    /// Creates a full angle from radians.
    pub const fn radians(radians: f32) -> Self {
        Self { degrees: radians.to_degrees() }
    }

    /// Returns the full angle in degrees.
    pub const fn to_degrees(self) -> f32 {
        self.degrees
    }

    /// Returns the full angle in radians.
    pub const fn to_radians(self) -> f32 {
        self.degrees.to_radians()
    }

    /// Returns the versine of the **half** angle, `1 - cos(angle / 2)`, computed without
    /// cancellation. For full angles of 0 to 360 degrees the result is in [0, 2], with a relative
    /// error under 4e-7.
    pub fn versine(self) -> f32 {
        let sine = trig::sin((self.degrees / 4.0).to_radians());
        2.0 * sine * sine
    }

    /// Returns the full angle whose half has this versine: the inverse of [`Angle::versine`] for
    /// versines in [0, 2].
    pub fn from_versine(versine: f32) -> Self {
        Self { degrees: 4.0 * trig::asin(trig::sqrt(versine / 2.0)).to_degrees() }
    }
}

impl HalfAngle {
    /// Creates a half angle from degrees.
    pub const fn degrees(degrees: f32) -> Self {
        Self { degrees }
    }

    /// Creates a half angle from radians.
    pub const fn radians(radians: f32) -> Self {
        Self { degrees: radians.to_degrees() }
    }

    /// Returns the half angle in degrees.
    pub const fn to_degrees(self) -> f32 {
        self.degrees
    }

    /// Returns the half angle in radians.
    pub const fn to_radians(self) -> f32 {
        self.degrees.to_radians()
    }
}

/// A full angle, or a half angle as a full one.
///
/// The trait is sealed: its types are [`Angle`] and [`HalfAngle`]. A number alone is neither.
#[diagnostic::on_unimplemented(
    message = "expected an angle: `Angle::degrees(..)`, the full angle of a data sheet, or `HalfAngle::degrees(..)`",
    label = "not an angle",
    note = "a field angle of 15 degrees is `Angle::degrees(15.0)`, which is `HalfAngle::degrees(7.5)`"
)]
pub trait IntoAngle: Copy + sealed::Sealed {
    /// Returns the full angle.
    fn into_angle(self) -> Angle;
}

mod sealed {
    pub trait Sealed {}

    impl Sealed for super::Angle {}
    impl Sealed for super::HalfAngle {}
}

impl IntoAngle for Angle {
    fn into_angle(self) -> Angle {
        self
    }
}

impl IntoAngle for HalfAngle {
    fn into_angle(self) -> Angle {
        self.into()
    }
}

impl From<HalfAngle> for Angle {
    fn from(half: HalfAngle) -> Self {
        Self { degrees: 2.0 * half.degrees }
    }
}

impl From<Angle> for HalfAngle {
    fn from(full: Angle) -> Self {
        Self { degrees: full.degrees / 2.0 }
    }
}
