//! The square that a spotlight projects, on which a gobo or a shadow map lies.

use super::projected::ProjectedPoint;
use crate::{
    angle::Angle,
    attenuation::Attenuation,
    cone::Cone,
    error::{Error, Expected, Parameter, check_between},
    falloff::{Falloff, Step},
    light::{SpotLight, check_reach},
    number::Scalar,
    trig,
    vec3::Vec3,
};

/// The square around the cone of a spotlight, orthogonal to its axis.
///
/// The square is flat, like a square on a wall that faces the light, and the edge of the cone
/// touches the middles of the square's four sides. Coordinates on the square are therefore
/// proportional to the tangent of the angle off axis. A cone over 160 degrees has no square.
///
/// [`right`](Self::right) and [`up`](Self::up) are the directions that a viewer at the light sees
/// as right and up when looking along the axis of the light, in right-handed coordinates with y
/// upwards. For a light that points straight down or up, within one degree, these directions are
/// defined by convention. The top of the square lies towards `-z` if the light points down, and
/// towards `z` if the light points up, as if the axis leaned slightly towards `-z`.
///
/// ```
/// use luminaire::{Angle, Cone, SpotLight, Vec3, falloff::Soft, projector::Projection};
/// let cone = Cone::from_outer(Soft, Angle::degrees(90.0))?;
/// let spot = SpotLight::new(Vec3::new(0.0, 1.0, 4.0), Vec3::new(0.0, 0.0, -1.0), cone)?;
/// let square = Projection::of(&spot)?.compile::<f32>()?;
/// // On the wall at z = 0 the square has a side of 8. The point lies 1/4 of a side to the right of
/// // its centre, and 1/8 of a side above it.
/// let place = square.project(Vec3::new(2.0, 2.0, 0.0));
/// assert_eq!((place.column, place.row, place.depth), (49_152, 24_576, 4.0));
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Projection {
    position: Vec3<f32>,
    right: Vec3<f32>,
    up: Vec3<f32>,
    axis: Vec3<f32>,
    outer: Angle,
    tangent: f32,
}

/// Squared sine of the angle from the vertical below which an axis counts as vertical: about one
/// degree.
const UPRIGHT: f32 = 3.0e-4;

impl Projection {
    /// The widest outer angle. Towards 180 degrees the square would become infinitely large.
    pub const WIDEST: Angle = Angle::degrees(160.0);

    /// Returns the upright square around the cone of a spotlight.
    ///
    /// # Errors
    /// An outer angle over 160 degrees.
    pub fn of<P: Falloff, A: Attenuation>(spot: &SpotLight<P, A>) -> Result<Self, Error> {
        let (cone, axis) = (spot.cone(), spot.axis());
        let (outer, versine) = (cone.outer(), cone.outer_versine());
        if versine > Self::WIDEST.versine() {
            let accepted = Expected::AngleUpTo(Self::WIDEST.to_degrees());
            return Err(Error { parameter: Parameter::OuterAngle, value: outer.to_degrees(), accepted });
        }
        let tangent = trig::sqrt(versine * (2.0 - versine)) / (1.0 - versine);
        let right = right_of(axis);
        Ok(Self { position: spot.position(), right, up: right.cross(axis), axis, outer, tangent })
    }

    /// Returns the same square, rolled about the axis: clockwise, as seen from the light.
    ///
    /// Multiples of 90 degrees are exact.
    ///
    /// # Errors
    /// A roll outside -360 to 360 degrees.
    pub fn turned(&self, roll: Angle) -> Result<Self, Error> {
        let degrees = roll.to_degrees();
        check_between(Parameter::Roll, degrees, -360.0, 360.0)?;
        let quarters = (degrees / 90.0 + 4.5) as i32 - 4;
        let rest = (degrees - 90.0 * quarters as f32).to_radians();
        let half_sine = trig::sin(0.5 * rest);
        // `cosine^2 + sine^2` is 1, also if `half_sine` has an error.
        let cosine = 1.0 - 2.0 * half_sine * half_sine;
        let sine = 2.0 * half_sine * trig::sqrt(1.0 - half_sine * half_sine);
        let (right, up) = (self.right, self.up);
        let turned = Self {
            right: right.zip(up, |r, u| cosine * r - sine * u),
            up: up.zip(right, |u, r| cosine * u + sine * r),
            ..*self
        };
        Ok((0..quarters.rem_euclid(4)).fold(turned, |square, _| square.quarter_turned()))
    }

    fn quarter_turned(self) -> Self {
        Self { right: self.up.map(|c| -c), up: self.right, ..self }
    }

    /// Returns the position of the light.
    pub fn position(&self) -> Vec3<f32> {
        self.position
    }

    /// Returns the direction to the right on the square, of unit length.
    pub fn right(&self) -> Vec3<f32> {
        self.right
    }

    /// Returns the direction up on the square, of unit length.
    pub fn up(&self) -> Vec3<f32> {
        self.up
    }

    /// Returns the direction of the light, of unit length.
    pub fn axis(&self) -> Vec3<f32> {
        self.axis
    }

    /// Returns the tangent of the outer half angle: half a side of the square at a depth of 1.
    pub fn tangent(&self) -> f32 {
        self.tangent
    }

    /// Compiles the square for the format `S`.
    ///
    /// # Errors
    /// A cone narrower than [`Cone::narrowest`] of [`Step`], the limit of the format for every
    /// falloff. A position beyond [`Scalar::FARTHEST`].
    pub fn compile<S: Scalar>(&self) -> Result<CompiledProjection<S>, Error> {
        check_reach::<S>(self.position)?;
        let narrowest = Cone::narrowest::<S>(Step);
        if self.outer < narrowest {
            let accepted = Expected::AngleFrom(narrowest.to_degrees());
            return Err(Error { parameter: Parameter::OuterAngle, value: self.outer.to_degrees(), accepted });
        }
        let down = self.up.map(|c| -c);
        Ok(CompiledProjection {
            position: self.position.map(S::length),
            frame: S::frame([self.right, down, self.axis], self.tangent),
        })
    }
}

/// Returns the direction to the right of a viewer who looks along an axis, of unit length.
///
/// The result is exactly horizontal unless the axis is vertical.
fn right_of(axis: Vec3<f32>) -> Vec3<f32> {
    let Vec3 { x, y, z } = axis;
    let level = x * x + z * z;
    if level >= UPRIGHT {
        let length = trig::sqrt(level);
        Vec3::new(-z / length, 0.0, x / length)
    } else {
        let length = trig::sqrt(x * x + y * y);
        Vec3::new(y.abs() / length, if y < 0.0 { x } else { -x } / length, 0.0)
    }
}

/// A [`Projection`] compiled for the format `S`. Made by [`Projection::compile`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledProjection<S: Scalar> {
    pub(crate) position: Vec3<S::Length>,
    pub(crate) frame: S::Frame,
}

impl<S: Scalar> CompiledProjection<S> {
    /// Creates a compiled projection from its parts, as [`codegen`](crate::codegen) writes them.
    pub const fn from_parts(position: Vec3<S::Length>, frame: S::Frame) -> Self {
        Self { position, frame }
    }

    /// Returns the position of a point on the square, and its depth.
    ///
    /// `point` is in the unit of the light's position.
    #[inline(always)]
    pub fn project(&self, point: Vec3<S::Length>) -> ProjectedPoint<S> {
        let ([column, row], depth) = S::project(&self.frame, self.position, point);
        ProjectedPoint { column, row, depth }
    }
}
