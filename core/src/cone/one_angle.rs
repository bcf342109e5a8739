//! Cones from one angle.

use super::Cone;
use crate::{
    angle::{Angle, IntoAngle},
    error::{Error, Expected, Parameter},
    falloff::{Falloff, Hard, Power, Soft},
};

impl Cone<Soft> {
    /// Creates the cone with a soft falloff and this field angle, at which the intensity is 10 %:
    /// see [`from_field`](Cone::from_field).
    ///
    /// # Errors
    /// A field angle outside (0, 143.13] degrees.
    pub fn soft(field: impl IntoAngle) -> Result<Self, Error> {
        Self::from_field(Soft, field)
    }
}

impl Cone<Hard> {
    /// Creates the cone with a hard falloff and this field angle, at which the intensity is 10 %:
    /// see [`from_field`](Cone::from_field).
    ///
    /// # Errors
    /// A field angle outside (0, 174.11] degrees.
    pub fn hard(field: impl IntoAngle) -> Result<Self, Error> {
        Self::from_field(Hard, field)
    }
}

impl<P: Falloff> Cone<P> {
    /// Creates the cone with this field angle, at which the intensity is 10 %.
    ///
    /// # Errors
    /// An angle that is not more than 0, or whose outer angle would exceed 180 degrees. The largest
    /// field angle is 143.13 degrees for a soft falloff and 174.11 for a hard one.
    pub fn from_field(falloff: P, field: impl IntoAngle) -> Result<Self, Error> {
        Self::from_angle(falloff, field.into_angle(), falloff.field_versine(), Parameter::FieldAngle)
    }

    /// Creates the cone with this beam angle, at which the intensity is 50 %.
    ///
    /// # Errors
    /// An angle that is not more than 0, or whose outer angle would exceed 180 degrees. The largest
    /// beam angle is 90 degrees for a soft falloff and 145.93 for a hard one.
    pub fn from_beam(falloff: P, beam: impl IntoAngle) -> Result<Self, Error> {
        Self::from_angle(falloff, beam.into_angle(), falloff.beam_versine(), Parameter::BeamAngle)
    }

    /// Creates the cone with this outer angle, at which the light ends.
    ///
    /// # Errors
    /// An angle outside (0, 180] degrees.
    pub fn from_outer(falloff: P, outer: impl IntoAngle) -> Result<Self, Error> {
        Self::from_angle(falloff, outer.into_angle(), 1.0, Parameter::OuterAngle)
    }

    /// Creates the cone in which the versine of this angle is `fraction` times the outer versine.
    fn from_angle(falloff: P, angle: Angle, fraction: f32, parameter: Parameter) -> Result<Self, Error> {
        let largest = Angle::from_versine(fraction);
        let outer = angle.versine() / fraction;
        // The versine of a tiny positive angle may underflow to zero.
        if angle > Angle::degrees(0.0) && angle <= largest && outer >= f32::MIN_POSITIVE {
            Ok(Self::open(falloff, 0.0, outer.min(1.0)))
        } else {
            let value = angle.to_degrees();
            Err(Error { parameter, value, accepted: Expected::angle_up_to(largest.to_degrees(), value) })
        }
    }
}

impl<const N: u32> Cone<Power<N>> {
    /// Creates OpenGL's spotlight with `GL_SPOT_EXPONENT` N and this `GL_SPOT_CUTOFF`.
    ///
    /// The intensity of this cone is `cos^N` of the angle off axis, and 0 from the cutoff on
    /// (OpenGL 2.1 specification, section 2.14.1). OpenGL's cutoff is a
    /// [`HalfAngle`](crate::HalfAngle) of at most 90 degrees; OpenGL's special value of 180 degrees
    /// means a point light, and no cone.
    ///
    /// With an outer angle of 180 degrees, `t = 1 - versine` is the cosine, so the falloff is
    /// [`Power`]. The intensity jumps at the cutoff, as in OpenGL.
    ///
    /// ```
    /// use luminaire::{Cone, HalfAngle, falloff::Power};
    /// let cone = Cone::<Power<32>>::opengl(HalfAngle::degrees(30.0))?;
    /// assert!((cone.beam().to_degrees() / 2.0 - 11.88).abs() < 0.01);
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    ///
    /// # Errors
    /// A cutoff that is not more than 0, or over 180 degrees as a full angle.
    pub fn opengl(cutoff: impl IntoAngle) -> Result<Self, Error> {
        Self::open(Power, 0.0, 1.0).with_cutoff(cutoff)
    }
}
