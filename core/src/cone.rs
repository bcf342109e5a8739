//! Cones of light: designed from the angle that a data sheet gives, compiled to a falloff that knows no angles.

mod compiled;
mod two_angles;

pub use self::compiled::CompiledCone;

use crate::{
    angle::Angle,
    error::{Error, Expected, Parameter},
    falloff::{Falloff, Hard, Power, Soft, SoftOrHard},
    number::{HALF_A_CODE, Scalar, Slopes, float::positive},
    search::bisect,
};

/// A cone of light with an edge profile: full intensity on the axis, none from the outer angle outwards.
///
/// Any one of its beam, field and outer angles fixes the other two (Hast 2004, sections 2 and 3);
/// [`Cone::from_beam_and_field`] takes two, and picks the profile. Two parts may be added:
///
/// - a **hotspot** ([`with_inner`](Self::with_inner)): full intensity up to an inner angle, and the profile between it
///   and the outer one. Inner and outer angle in one make a step.
/// - a **cutoff** ([`with_cutoff`](Self::with_cutoff)): nothing from an angle on that is tighter than the outer
///   one, as a barn door or an iris would have it. It costs nothing per point.
///
/// All are full angles.
///
/// ```
/// use luminaire::{Angle, Cone, falloff::Soft};
/// let cone = Cone::from_field(Soft, Angle::degrees(15.0))?;
/// assert!((cone.beam().to_degrees() - 9.81).abs() < 0.005);
/// assert!((cone.outer().to_degrees() - 18.15).abs() < 0.005);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Cone<P = SoftOrHard> {
    profile: P,
    /// The versine of the inner half angle, in [0, outer]; 0 without a hotspot.
    inner: f32,
    /// The versine of the half angle at which the profile ends, in (0, 1].
    outer: f32,
    /// The versine from which on there is no light: `outer`, or that of a tighter cutoff.
    limit: f32,
}

impl<P: Falloff> Cone<P> {
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
        let outer = angle.versine() / fraction;
        // An angle above zero may be so small that its versine is none.
        if angle > Angle::degrees(0.0) && angle <= largest && outer >= f32::MIN_POSITIVE {
            Ok(Self::open(profile, 0.0, outer.min(1.0)))
        } else {
            let accepted = Expected::AngleUpTo(largest.to_degrees());
            Err(Error { parameter, value: angle.to_degrees(), accepted })
        }
    }

    /// A cone without a cutoff.
    fn open(profile: P, inner: f32, outer: f32) -> Self {
        Self { profile, inner, outer, limit: outer }
    }

    /// The same cone with a hotspot: full intensity up to this angle, and the profile from there to the outer angle,
    /// which stays. Beam and field move outwards. 0 takes the hotspot away; the outer angle makes a step.
    ///
    /// # Errors
    /// An angle that is negative or larger than the one at which the profile ends.
    pub fn with_inner(self, inner: impl Into<Angle>) -> Result<Self, Error> {
        let angle = inner.into();
        let inner = angle.versine();
        if angle >= Angle::degrees(0.0) && angle <= Angle::degrees(180.0) && inner <= self.outer {
            Ok(Self { inner, ..self })
        } else {
            let accepted = Expected::AngleBetween(0.0, Angle::from_versine(self.outer).to_degrees());
            Err(Error { parameter: Parameter::InnerAngle, value: angle.to_degrees(), accepted })
        }
    }

    /// The same cone, cut off: nothing from this angle on. Within it the light is as before.
    ///
    /// # Errors
    /// An angle that is not more than 0, or larger than the one at which the profile ends.
    pub fn with_cutoff(self, cutoff: impl Into<Angle>) -> Result<Self, Error> {
        let angle = cutoff.into();
        let limit = angle.versine();
        // As above: a versine of none would be a cone without any light.
        let range = f32::MIN_POSITIVE..=self.outer;
        if angle > Angle::degrees(0.0) && angle <= Angle::degrees(180.0) && range.contains(&limit) {
            Ok(Self { limit, ..self })
        } else {
            let accepted = Expected::AngleUpTo(Angle::from_versine(self.outer).to_degrees());
            Err(Error { parameter: Parameter::CutoffAngle, value: angle.to_degrees(), accepted })
        }
    }

    /// The edge profile.
    pub fn profile(&self) -> P {
        self.profile
    }

    /// The full angle up to which the intensity is that of the axis; 0 without a hotspot. Never over
    /// [`outer`](Self::outer).
    pub fn inner(&self) -> Angle {
        Angle::from_versine(self.inner.min(self.limit))
    }

    /// The full angle up to which at least half the intensity is left: where the profile falls to a half, or the
    /// cutoff if that comes first.
    pub fn beam(&self) -> Angle {
        self.angle_at(self.profile.beam_versine())
    }

    /// The full angle up to which at least a tenth of the intensity is left: where the profile falls to a tenth,
    /// or the cutoff if that comes first.
    pub fn field(&self) -> Angle {
        self.angle_at(self.profile.field_versine())
    }

    /// The full angle from which on no light is left: where the profile ends, or the cutoff if that comes first.
    pub fn outer(&self) -> Angle {
        Angle::from_versine(self.limit)
    }

    /// Whether there is a hotspot.
    pub fn has_hotspot(&self) -> bool {
        self.inner > 0.0
    }

    /// Whether a cutoff cuts the cone off before its profile ends.
    pub fn has_cutoff(&self) -> bool {
        self.limit < self.outer
    }

    /// The versine of half the [`outer`](Self::outer) angle, in (0, 1].
    pub fn outer_versine(&self) -> f32 {
        self.limit
    }

    /// The angle of a profile's `u`, within the cutoff.
    fn angle_at(&self, u: f32) -> Angle {
        Angle::from_versine((self.inner + u * (self.outer - self.inner)).min(self.limit))
    }

    /// The same cone with another type of profile: what turns a choice made at run time into a type.
    pub fn with_profile<Q: Falloff>(&self, profile: Q) -> Cone<Q> {
        Cone { profile, inner: self.inner, outer: self.outer, limit: self.limit }
    }

    /// The luminous flux in lumens of this cone with so many candela on its axis: `2 pi` times the integral of the
    /// intensity over the versine, with hotspot and cutoff. Relative error under 2e-5 (searched).
    pub fn lumens(&self, candela: f32) -> f32 {
        candela * self.solid_angle()
    }

    /// The intensity in candela on the axis of this cone when it gives so many lumens: the inverse of
    /// [`lumens`](Self::lumens). Infinite for a table without any light.
    pub fn candela(&self, lumens: f32) -> f32 {
        lumens / self.solid_angle()
    }

    /// The solid angle in steradians that would take the same flux at full intensity.
    fn solid_angle(&self) -> f32 {
        let span = self.outer - self.inner;
        let versine = if self.limit <= self.inner {
            self.limit
        } else {
            self.inner + span * self.profile.integral((self.limit - self.inner) / span)
        };
        core::f32::consts::TAU * versine
    }

    /// The narrowest outer angle of this profile, without a hotspot, that the format `S` evaluates within half a linear
    /// code, 1/510, on exact inputs: the format's error of direction, magnified by the profile's steepness, and all other
    /// roundings reach it there. A hotspot makes the profile steeper; a step, which no format can hold to an
    /// intensity, is in its place within 1/510 of its half angle.
    ///
    /// In `f32` that holds wherever light and point are. It is more than 180 degrees where the format holds no cone of the
    /// profile, as `Fx16` none of an inverted power of 99.
    pub fn narrowest<S: Scalar>(profile: P) -> Angle {
        narrowest::<S>(&slopes(profile, 0.0))
    }

    /// Compiles the cone for the format `S`.
    ///
    /// # Errors
    /// A cone narrower than [`Cone::narrowest`] of its profile in this format, a hotspot that makes its edge too
    /// steep, or a cutoff that is too narrow.
    pub fn compile<S: Scalar>(&self) -> Result<CompiledCone<S, P>, Error> {
        self.compile_with_error().map(|(cone, _)| cone)
    }

    /// The compiled cone, and the `Arithmetic::coarse_error` by which its ramp was chosen.
    pub(crate) fn compile_with_error<S: Scalar>(&self) -> Result<(CompiledCone<S, P>, f32), Error> {
        self.check::<S>()?;
        let Self { inner, outer, limit, .. } = *self;
        let error = S::coarse_error(&self.slopes(inner), outer, limit);
        let ramp = if error <= HALF_A_CODE { S::ramp } else { S::fine_ramp };
        Ok((CompiledCone::new(ramp(inner, outer, limit), self.profile), error))
    }

    /// The slopes of the cone, if it had this inner versine.
    fn slopes(&self, inner: f32) -> Slopes {
        if inner < self.outer { slopes(self.profile, inner / self.outer) } else { Slopes::STEP }
    }

    /// Whether the format can hold the cone: or which of its angles it cannot.
    fn check<S: Scalar>(&self) -> Result<(), Error> {
        let refused =
            |parameter, value: Angle, accepted| Err(Error { parameter, value: value.to_degrees(), accepted });
        let (outer, step) = (Angle::from_versine(self.outer), narrowest::<S>(&Slopes::STEP));
        let is_step = self.inner >= self.outer;
        let least = if is_step { step } else { Self::narrowest::<S>(self.profile) };
        if outer < least {
            return refused(Parameter::OuterAngle, outer, Expected::AngleFrom(least.to_degrees()));
        }
        if self.outer() < step {
            return refused(Parameter::CutoffAngle, self.outer(), Expected::AngleFrom(step.to_degrees()));
        }
        let holds = |inner| outer >= narrowest::<S>(&self.slopes(inner));
        if holds(self.inner) {
            return Ok(());
        }
        let widest = Angle::from_versine(bisect(0.0, self.inner, holds));
        refused(Parameter::InnerAngle, self.inner(), Expected::AngleBetween(0.0, widest.to_degrees()))
    }
}

impl Cone<Soft> {
    /// The cone with a soft edge that has a tenth of its intensity left at this angle: see
    /// [`from_field`](Cone::from_field).
    ///
    /// # Errors
    /// A field angle that is not more than 0, or more than 143.13 degrees.
    pub fn soft(field: impl Into<Angle>) -> Result<Self, Error> {
        Self::from_field(Soft, field)
    }
}

impl Cone<Hard> {
    /// The cone with a hard edge that has a tenth of its intensity left at this angle: see
    /// [`from_field`](Cone::from_field).
    ///
    /// # Errors
    /// A field angle that is not more than 0, or more than 174.11 degrees.
    pub fn hard(field: impl Into<Angle>) -> Result<Self, Error> {
        Self::from_field(Hard, field)
    }
}

impl<const N: u32> Cone<Power<N>> {
    /// OpenGL's spotlight of `GL_SPOT_EXPONENT` N and this `GL_SPOT_CUTOFF`: the cosine of the angle off axis to the
    /// power N, and nothing from the cutoff on (OpenGL 2.1 specification, section 2.14.1). The cutoff is a
    /// [`HalfAngle`](crate::HalfAngle) of at most 90 degrees there; the cutoff of 180 degrees, a point light, is
    /// none of a cone.
    ///
    /// With an outer angle of 180 degrees `t` is `1 - versine`, which is the cosine: the power is that of
    /// [`Power`], and the light jumps at the cutoff as it does in OpenGL.
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
    pub fn opengl(cutoff: impl Into<Angle>) -> Result<Self, Error> {
        Self::open(Power, 0.0, 1.0).with_cutoff(cutoff)
    }
}

/// The slopes of a profile around a hotspot whose versine is that share of the outer one, in [0, 1).
fn slopes<P: Falloff>(profile: P, hotspot: f32) -> Slopes {
    /// So narrow a rim that all of it is at the edge, where the slope over the argument is half of that over the angle.
    const RIM: f32 = 1.0 / 1024.0;
    let fraction = profile.steepness(1.0 - RIM) * RIM / 2.0;
    Slopes { angle: profile.steepness(hotspot), fraction: fraction * (1.0 + RIM) }
}

/// The narrowest outer angle of these slopes that a format holds; 360 degrees and more where it holds none.
fn narrowest<S: Scalar>(edge: &Slopes) -> Angle {
    let room = positive(HALF_A_CODE - S::rounding(edge));
    Angle::radians(2.0 * S::DIRECTION_ERROR * edge.angle / room)
}
