//! Cones of light: designed from the angle that a data sheet gives, compiled to a falloff that knows no angles.

use crate::{
    angle::Angle,
    error::{Accepted, Error, Parameter},
    profile::{Edge, Profile},
    scalar::{Offset, Ray, Scalar},
    vec3::Vec3,
};

/// A cone of light with an edge profile: full intensity on the axis, none from the outer angle outwards.
///
/// Any one of its three angles fixes the other two (Hast 2004, sections 2 and 3). All are full angles.
///
/// ```
/// use luminaire::{Angle, Cone, Soft};
/// let cone = Cone::from_field(Soft, Angle::degrees(15.0))?;
/// assert!((cone.beam().to_degrees() - 9.81).abs() < 0.005);
/// assert!((cone.outer().to_degrees() - 18.15).abs() < 0.005);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Cone<P = Edge> {
    profile: P,
    /// The versine of the outer half angle, in (0, 1].
    outer: f32,
}

impl<P: Profile> Cone<P> {
    /// The cone that has a tenth of its intensity left at this angle.
    ///
    /// # Errors
    /// An angle that is not more than 0, or whose outer angle would pass 180 degrees: the largest field angle is
    /// 143.13 degrees for a soft edge and 174.11 for a hard one.
    pub fn from_field(profile: P, field: impl Into<Angle>) -> Result<Self, Error> {
        Self::from_angle(profile, field.into(), profile.field_versine(), Parameter::FieldAngle)
    }

    /// The cone that has half of its intensity left at this angle.
    ///
    /// # Errors
    /// An angle that is not more than 0, or whose outer angle would pass 180 degrees: the largest beam angle is
    /// 90 degrees for a soft edge and 145.93 for a hard one.
    pub fn from_beam(profile: P, beam: impl Into<Angle>) -> Result<Self, Error> {
        Self::from_angle(profile, beam.into(), profile.beam_versine(), Parameter::BeamAngle)
    }

    /// The cone that ends at this angle.
    ///
    /// # Errors
    /// An angle that is not more than 0, or more than 180 degrees.
    pub fn from_outer(profile: P, outer: impl Into<Angle>) -> Result<Self, Error> {
        Self::from_angle(profile, outer.into(), 1.0, Parameter::OuterAngle)
    }

    /// The cone whose given angle lies at `fraction` of its outer versine.
    fn from_angle(profile: P, angle: Angle, fraction: f32, parameter: Parameter) -> Result<Self, Error> {
        let largest = Angle::from_versine(fraction);
        if angle > Angle::degrees(0.0) && angle <= largest {
            let outer = angle.versine() / fraction;
            Ok(Self { profile, outer: outer.min(1.0) })
        } else {
            let accepted = Accepted::AngleUpTo(largest.to_degrees());
            Err(Error { parameter, value: angle.to_degrees(), accepted })
        }
    }

    /// The edge profile.
    pub fn profile(&self) -> P {
        self.profile
    }

    /// The full angle at which half the intensity is left.
    pub fn beam(&self) -> Angle {
        Angle::from_versine(self.outer * self.profile.beam_versine())
    }

    /// The full angle at which a tenth of the intensity is left.
    pub fn field(&self) -> Angle {
        Angle::from_versine(self.outer * self.profile.field_versine())
    }

    /// The full angle from which on no light is left.
    pub fn outer(&self) -> Angle {
        Angle::from_versine(self.outer)
    }

    /// The versine of half the outer angle, in (0, 1].
    pub fn outer_versine(&self) -> f32 {
        self.outer
    }

    /// The same cone with another type of profile: what turns a choice made at run time into a type.
    pub fn with_profile<Q: Profile>(&self, profile: Q) -> Cone<Q> {
        Cone { profile, outer: self.outer }
    }

    /// The narrowest outer angle of this profile that the format `S` evaluates within half a step of eight bits,
    /// on exact inputs: the format's error of direction, magnified by the profile's steepness, reaches 1/510.
    pub fn narrowest<S: Scalar>(profile: P) -> Angle {
        let half = S::DIRECTION_ERROR * profile.steepness() * 510.0;
        Angle::radians(2.0 * half)
    }

    /// Compiles the cone for the format `S`.
    ///
    /// # Errors
    /// A cone narrower than [`Cone::narrowest`] of its profile in this format.
    pub fn compile<S: Scalar>(&self) -> Result<Falloff<S, P>, Error> {
        let narrowest = Self::narrowest::<S>(self.profile);
        if self.outer() < narrowest {
            return Err(Error {
                parameter: Parameter::OuterAngle,
                value: self.outer().to_degrees(),
                accepted: Accepted::AngleFrom(narrowest.to_degrees()),
            });
        }
        Ok(Falloff { ramp: S::ramp(0.0, self.outer), profile: self.profile })
    }
}

/// A cone compiled for the format `S`: from the versine of the angle off axis to the intensity.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Falloff<S: Scalar, P = Edge> {
    ramp: S::Ramp,
    profile: P,
}

impl<S: Scalar, P: Profile> Falloff<S, P> {
    /// The versine nearest to a value, in the scale of this cone.
    pub fn versine(&self, value: f32) -> S::Versine {
        S::versine(self.ramp, value)
    }

    /// The intensity in a direction from the light, which has an axis.
    #[inline(always)]
    pub fn toward(&self, ray: <S::Offset as Offset<S>>::Ray, axis: Vec3<S::Unit>) -> S {
        self.at(ray.versine(axis, self.ramp))
    }

    /// The intensity at a versine, in the scale of [`versine`](Self::versine): exactly 1 at versine 0, exactly 0 from the outer versine on, monotone between.
    #[inline(always)]
    pub fn at(&self, versine: S::Versine) -> S {
        self.profile.intensity(S::rise(self.ramp, versine))
    }

    /// The same falloff with another type of profile.
    #[inline(always)]
    pub fn with_profile<Q: Profile>(&self, profile: Q) -> Falloff<S, Q> {
        Falloff { ramp: self.ramp, profile }
    }

    /// The edge profile.
    pub fn profile(&self) -> P {
        self.profile
    }
}
