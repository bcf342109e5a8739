//! Angles that can't be mistaken for one another: a data sheet's full angle and a graphics library's half.

use crate::trig;

/// A full cone angle, from edge to edge through the axis: what data sheets, GDTF and Direct3D give.
///
/// ```
/// use luminaire::{Angle, HalfAngle};
/// assert_eq!(Angle::degrees(15.0), HalfAngle::degrees(7.5).into());
/// ```
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub struct Angle {
    degrees: f32,
}

/// Half a cone angle, from the axis to the edge: what OpenGL, glTF and three.js give.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub struct HalfAngle {
    degrees: f32,
}

impl Angle {
    /// A full angle in degrees.
    pub const fn degrees(degrees: f32) -> Self {
        Self { degrees }
    }

    /// A full angle in radians.
    pub const fn radians(radians: f32) -> Self {
        Self { degrees: radians.to_degrees() }
    }

    /// The full angle in degrees.
    pub const fn to_degrees(self) -> f32 {
        self.degrees
    }

    /// The full angle in radians.
    pub const fn to_radians(self) -> f32 {
        self.degrees.to_radians()
    }

    /// The versine of the **half** angle, `1 - cos(angle / 2)`, without the cancellation: 0 to 2 for 0 to 360
    /// degrees, relative error under 4e-7.
    pub fn versine(self) -> f32 {
        let sine = trig::sin((self.degrees / 4.0).to_radians());
        2.0 * sine * sine
    }

    /// The full angle whose half has this versine; the inverse of [`Angle::versine`] for versines from 0 to 2.
    pub fn from_versine(versine: f32) -> Self {
        Self { degrees: 4.0 * trig::asin(trig::sqrt(versine / 2.0)).to_degrees() }
    }
}

impl HalfAngle {
    /// A half angle in degrees.
    pub const fn degrees(degrees: f32) -> Self {
        Self { degrees }
    }

    /// A half angle in radians.
    pub const fn radians(radians: f32) -> Self {
        Self { degrees: radians.to_degrees() }
    }

    /// The half angle in degrees.
    pub const fn to_degrees(self) -> f32 {
        self.degrees
    }

    /// The half angle in radians.
    pub const fn to_radians(self) -> f32 {
        self.degrees.to_radians()
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
