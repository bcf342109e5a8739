//! Cones of light, designed from the angles of a data sheet.
//!
//! A compiled cone is a function of the versine and needs no angles.

mod compiled;
mod one_angle;
mod two_angles;
mod zoom;

pub use self::compiled::CompiledCone;

use crate::{
    angle::{Angle, IntoAngle},
    error::{Error, Expected, Parameter, check_between},
    falloff::{Falloff, Formula, Soft, slope_beside_axis},
    number::{HALF_A_CODE, Quick, Scalar, Slopes, float::positive},
    search::bisect,
    stored::stored,
    trig,
};

/// A cone of light with an angular falloff: full intensity on the axis, 0 from the outer angle
/// outwards.
///
/// For a given falloff, any one of the beam, field and outer angles determines the other two (Hast
/// 2004, sections 2 and 3). [`Cone::from_beam_and_field`] takes two angles and chooses the falloff.
/// A cone has two options:
///
/// - a **hotspot** ([`with_inner`](Self::with_inner)): full intensity up to an inner angle, and the
///   falloff between the inner and the outer angle. If the inner and the outer angle are equal, the
///   cone is a step.
/// - a **cutoff** ([`with_cutoff`](Self::with_cutoff)): no light outside an angle that is smaller
///   than the outer angle, as behind a barn door or an iris. A cutoff costs nothing per point.
///
/// All angles are full angles.
///
/// ```
/// use luminaire::{Angle, Cone, falloff::Soft};
/// let cone = Cone::from_field(Soft, Angle::degrees(15.0))?;
/// assert!((cone.beam().to_degrees() - 9.81).abs() < 0.005);
/// assert!((cone.outer().to_degrees() - 18.15).abs() < 0.005);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Cone<P = Soft> {
    falloff: P,
    /// The versine of the inner half angle, in [0, outer]; 0 without a hotspot.
    inner: f32,
    /// The versine of the half angle at which the falloff ends, in (0, 1].
    outer: f32,
    /// The versine from which on there is no light: `outer`, or the versine of a smaller cutoff.
    limit: f32,
}

stored!([P: Falloff] Cone<P> { falloff: P, inner: f32, outer: f32, limit: f32 } by Self::from_versines(falloff, [inner, outer, limit]));

impl<P: Falloff> Cone<P> {
    /// Creates a cone from the versines of half its inner angle, half the angle at which the falloff
    /// ends, and half its outer angle: the inverse of [`versines`](Self::versines).
    ///
    /// # Errors
    /// An inner or a last versine larger than the second, or a versine outside (0, 1]; the first may
    /// be 0.
    pub fn from_versines(falloff: P, [inner, outer, limit]: [f32; 3]) -> Result<Self, Error> {
        check_between(Parameter::Versine, outer, f32::MIN_POSITIVE, 1.0)?;
        check_between(Parameter::Versine, inner, 0.0, outer)?;
        check_between(Parameter::Versine, limit, f32::MIN_POSITIVE, outer)?;
        Ok(Self { falloff, inner, outer, limit })
    }

    /// Creates a cone without a cutoff.
    fn open(falloff: P, inner: f32, outer: f32) -> Self {
        Self { falloff, inner, outer, limit: outer }
    }

    /// Returns the cone with a hotspot: full intensity up to this angle.
    ///
    /// The falloff is then between this angle and the outer angle. The outer angle stays the same;
    /// beam and field angle become larger. An inner angle of 0 removes the hotspot. An inner angle
    /// equal to the outer angle makes a step.
    ///
    /// # Errors
    /// An angle that is negative or larger than the angle at which the falloff ends.
    pub fn with_inner(self, inner: impl IntoAngle) -> Result<Self, Error> {
        let angle = inner.into_angle();
        let inner = angle.versine();
        if angle >= Angle::degrees(0.0) && angle <= Angle::degrees(180.0) && inner <= self.outer {
            Ok(Self { inner, ..self })
        } else {
            let accepted = Expected::AngleBetween(0.0, widest(self.outer));
            Err(Error { parameter: Parameter::InnerAngle, value: angle.to_degrees(), accepted })
        }
    }

    /// Returns the cone with a cutoff: no light from this angle on. The intensity inside the cutoff
    /// does not change.
    ///
    /// # Errors
    /// An angle that is not more than 0, or larger than the angle at which the falloff ends.
    pub fn with_cutoff(self, cutoff: impl IntoAngle) -> Result<Self, Error> {
        let angle = cutoff.into_angle();
        let limit = angle.versine();
        // A cutoff with versine 0 would leave no light.
        let range = f32::MIN_POSITIVE..=self.outer;
        if angle > Angle::degrees(0.0) && angle <= Angle::degrees(180.0) && range.contains(&limit) {
            Ok(Self { limit, ..self })
        } else {
            let (value, largest) = (angle.to_degrees(), widest(self.outer));
            let accepted = Expected::angle_up_to(largest, value);
            Err(Error { parameter: Parameter::CutoffAngle, value, accepted })
        }
    }

    /// Returns the angular falloff.
    pub fn falloff(&self) -> P {
        self.falloff
    }

    /// Returns the full inner angle, up to which the intensity is that of the axis; 0 without a
    /// hotspot. The inner angle is at most [`outer`](Self::outer).
    pub fn inner(&self) -> Angle {
        Angle::from_versine(self.inner.min(self.limit))
    }

    /// Returns the full beam angle, at which the falloff reaches 50 %, or a smaller cutoff.
    pub fn beam(&self) -> Angle {
        self.angle_at(self.falloff.beam_versine())
    }

    /// Returns the full field angle, at which the falloff reaches 10 %, or a smaller cutoff.
    pub fn field(&self) -> Angle {
        self.angle_at(self.falloff.field_versine())
    }

    /// Returns the full angle from which on there is no light.
    ///
    /// This is the angle at which the falloff ends, or a smaller cutoff.
    pub fn outer(&self) -> Angle {
        Angle::from_versine(self.limit)
    }

    /// Returns whether the cone has a hotspot.
    pub fn has_hotspot(&self) -> bool {
        self.inner > 0.0
    }

    /// Returns whether a cutoff ends the cone before its falloff does.
    pub fn has_cutoff(&self) -> bool {
        self.limit < self.outer
    }

    /// Returns the versine of half the [`outer`](Self::outer) angle, in (0, 1].
    pub fn outer_versine(&self) -> f32 {
        self.limit
    }

    /// Returns the versines of half the inner angle, half the angle at which the falloff ends, and
    /// half the outer angle. The last is less than the second if the cone has a cutoff.
    pub fn versines(&self) -> [f32; 3] {
        [self.inner, self.outer, self.limit]
    }

    /// Returns the full angle at which the falloff's argument is `t = 1 - u`, or a smaller cutoff.
    fn angle_at(&self, u: f32) -> Angle {
        Angle::from_versine((self.inner + u * (self.outer - self.inner)).min(self.limit))
    }

    /// Returns the same cone with its falloff converted to another type: from a run-time choice to
    /// a concrete type.
    pub fn with_falloff<Q: Falloff>(&self, falloff: Q) -> Cone<Q> {
        Cone { falloff, inner: self.inner, outer: self.outer, limit: self.limit }
    }

    /// Returns the luminous flux in lumens for an intensity on the axis in candela.
    ///
    /// The luminous flux is `2 pi` times the integral of the intensity over the versine, including
    /// hotspot and cutoff. The relative error is under 2e-5 (searched).
    pub fn lumens(&self, candela: f32) -> f32 {
        candela * self.solid_angle()
    }

    /// Returns the intensity on the axis in candela for a luminous flux in lumens: the inverse of
    /// [`lumens`](Self::lumens). The intensity is infinite for a table that is 0 everywhere.
    pub fn candela(&self, lumens: f32) -> f32 {
        lumens / self.solid_angle()
    }

    /// Returns the intensity of the falloff on the axis: 1, except for a table that begins with less.
    fn on_axis(&self) -> f32 {
        match self.falloff.formula() {
            Formula::Samples([first, ..]) => f32::from(*first) / 65_535.0,
            Formula::Knots([first, ..]) => first.intensity(0.0),
            _ => 1.0,
        }
    }

    /// Returns the solid angle, in steradians, that at constant full intensity would have the flux
    /// of the cone.
    fn solid_angle(&self) -> f32 {
        let span = self.outer - self.inner;
        let hotspot = self.on_axis() * self.inner.min(self.limit);
        let versine = if self.limit <= self.inner {
            hotspot
        } else {
            hotspot + span * self.falloff.integral((self.limit - self.inner) / span)
        };
        core::f32::consts::TAU * versine
    }

    /// Returns the narrowest outer angle that the format `S` evaluates with this falloff within
    /// half a linear code, 1/510.
    ///
    /// The result assumes exact inputs and a cone without a hotspot, because a hotspot makes the
    /// falloff steeper. At the returned angle the error bound is just 1/510. The error bound is the
    /// format's error of the direction multiplied by the steepness of the falloff, plus all other
    /// rounding errors. For a step, no format bounds the error of the intensity; the position of
    /// the step's edge is within 1/510 of the half angle. So is that of an infinite slope on the axis, where a
    /// difference of the lengths of direction and axis is magnified, too.
    ///
    /// In `f32` the error bound holds for all positions of light and point. The result exceeds 180
    /// degrees if the format can hold no cone with this falloff, such as `Fx16` with an inverted
    /// power of 99.
    pub fn narrowest<S: Scalar>(falloff: P) -> Angle {
        narrowest::<S>(&slopes(falloff, 0.0))
    }

    /// Compiles the cone for the format `S`.
    ///
    /// # Errors
    /// An outer angle below [`Cone::narrowest`] for this falloff and format, a hotspot that makes
    /// the edge too steep, or a cutoff that is too narrow.
    pub fn compile<S: Scalar>(&self) -> Result<CompiledCone<S, P>, Error> {
        self.compile_with_error().map(|(cone, _)| cone)
    }

    /// Compiles the cone, and also returns the cone's `Errors::coarse_error`.
    ///
    /// The coarse error selects between the coarse and the fine ramp.
    pub(crate) fn compile_with_error<S: Scalar>(&self) -> Result<(CompiledCone<S, P>, f32), Error> {
        let error = self.checked_error::<S>()?;
        Ok((self.compile_for(error), error))
    }

    /// Compiles the cone for an `Errors::coarse_error`.
    fn compile_for<S: Scalar>(&self, error: f32) -> CompiledCone<S, P> {
        let ramp = if error <= HALF_A_CODE { S::ramp } else { S::fine_ramp };
        CompiledCone::new(ramp(self.inner, self.outer, self.limit), self.falloff)
    }

    /// Returns the `Errors::coarse_error`, or an error if the format cannot hold the cone.
    fn checked_error<S: Scalar>(&self) -> Result<f32, Error> {
        self.check::<S>()?;
        Ok(S::coarse_error(&self.slopes(self.inner), self.outer, self.limit))
    }

    /// Compiles the cone for the quick evaluation.
    pub(crate) fn compile_quick<S: Quick>(&self) -> Result<CompiledCone<S, P>, Error> {
        self.check::<S>()?;
        Ok(CompiledCone::new(S::quick_ramp(self.inner, self.outer, self.limit), self.falloff))
    }

    /// Returns the bounds of the derivatives that this cone would have with this inner versine.
    fn slopes(&self, inner: f32) -> Slopes {
        if inner < STEEPEST * self.outer { slopes(self.falloff, inner / self.outer) } else { Slopes::STEP }
    }

    /// Returns an error if the format cannot hold one of the angles. The error names the angle.
    fn check<S: Scalar>(&self) -> Result<(), Error> {
        let refused =
            |parameter, value: Angle, accepted| Err(Error { parameter, value: value.to_degrees(), accepted });
        let (outer, step) = (Angle::from_versine(self.outer), narrowest::<S>(&Slopes::STEP));
        let is_step = self.inner >= self.outer;
        let least = if is_step { step } else { Self::narrowest::<S>(self.falloff) };
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
        // Less than the limit by the roundings between angle and versine, so that it is accepted.
        let widest = Angle::from_versine(bisect(0.0, self.inner, holds) * (1.0 - 1e-6));
        // The inner angle as given, although a smaller cutoff may end the hotspot.
        let inner = Angle::from_versine(self.inner);
        refused(Parameter::InnerAngle, inner, Expected::AngleBetween(0.0, widest.to_degrees()))
    }
}

/// The widest hotspot of a cone that is no step, as a part of the outer versine: so narrow a ramp is a step, because its
/// versines differ by a few ULP.
const STEEPEST: f32 = 1.0 - 1.0 / 1_048_576.0;

/// Returns the widest full angle in degrees whose versine is at most this one.
fn widest(versine: f32) -> f32 {
    let mut degrees = Angle::from_versine(versine).to_degrees();
    while degrees > 0.0 && Angle::degrees(degrees).versine() > versine {
        degrees = f32::from_bits(degrees.to_bits().saturating_sub(1));
    }
    degrees
}

/// Returns bounds of the derivatives of a falloff with a hotspot. `hotspot` is the inner versine
/// divided by the outer versine, in [0, 1).
fn slopes<P: Falloff>(falloff: P, hotspot: f32) -> Slopes {
    /// Relative width of a falloff between two versines so close that the versine is nearly
    /// constant.
    ///
    /// Here the derivative with respect to the falloff's argument `t` is the derivative with
    /// respect to the angle, multiplied by half this width.
    const RIM: f32 = 1.0 / 1024.0;
    let fraction = falloff.steepness(1.0 - RIM) * RIM / 2.0;
    Slopes {
        angle: falloff.steepness(hotspot),
        fraction: fraction * (1.0 + RIM),
        beside_axis: slope_beside_axis(falloff.formula(), hotspot),
    }
}

/// Returns the narrowest outer angle that a format can hold with these bounds of the derivatives.
///
/// The result is 360 degrees or more if the format can hold no cone.
///
/// With a half angle `a`, the direction turns by a part of it, and lengths that differ by `l` change a versine by
/// `l^2 / 2`, which is `l^2 / a^2` of the outer versine.
fn narrowest<S: Scalar>(edge: &Slopes) -> Angle {
    let room = positive(HALF_A_CODE - S::rounding(edge));
    let [turned, shortened] = errors_of_direction::<S>(edge).map(|error| error / room);
    if edge.beside_axis == 0.0 {
        return Angle::radians(2.0 * turned);
    }
    // The root of `a^2 = turned a + shortened`.
    Angle::radians(turned + trig::sqrt(turned * turned + 4.0 * shortened))
}

/// Returns by how much the direction changes an intensity, times the half angle and times its square: see
/// [`narrowest`].
fn errors_of_direction<S: Scalar>(edge: &Slopes) -> [f32; 2] {
    let length = S::fine_stages(0.0).length as f32;
    [S::DIRECTION_ERROR * edge.angle, length * length * edge.beside_axis]
}
