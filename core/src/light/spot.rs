//! Spotlights.

use super::{Axis, Emission, check_reach, checked_position, range_above};
use crate::{
    attenuation::{Attenuation, InverseSquare, SmoothRange},
    color::Rgb,
    cone::{CompiledCone, Cone},
    error::{Error, Parameter},
    falloff::{Falloff, Soft},
    number::{self, Quick, Scalar},
    shade::{CompiledSpotLight, QuickSpotLight},
    stored::stored,
    vec3::Vec3,
};

/// A spotlight: a position, an axis, a cone, two colours, an intensity and an
/// [attenuation](Attenuation).
///
/// The default attenuation is the inverse-square law; the default colour is white and the default
/// intensity 1. So a surface that faces the light, on the axis at distance 1, is lit to full scale.
/// `SpotLight` without parameters has the soft edge of [`Cone::soft`].
///
/// ```
/// use luminaire::{Angle, Cone, Rgb, SpotLight, Vec3, falloff::Soft};
/// let cone = Cone::from_beam(Soft, Angle::degrees(9.0))?;
/// let spot = SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?
///     .with_color(Rgb::new(1.0, 0.8, 0.6))?
///     .with_intensity(16.0)?;
/// let lit = spot.compile::<f32>()?;
/// assert!((lit.irradiance(Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)) - 1.0).abs() < 1e-6);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SpotLight<P = Soft, A = InverseSquare> {
    position: Vec3<f32>,
    axis: Axis,
    cone: Cone<P>,
    attenuation: A,
    emission: Emission,
}

stored!([P: Falloff, A: Attenuation] SpotLight<P, A> {
    position: Vec3<f32>, axis: Axis, cone: Cone<P>, attenuation: A, emission: Emission
} by checked_position(Parameter::Position, position)
    .map(|position| Self { position, axis, cone, attenuation, emission }));

impl<P: Falloff> SpotLight<P> {
    /// Creates a white spotlight of intensity 1. The axis points away from the light and need not
    /// have unit length.
    ///
    /// # Errors
    /// A position that is not finite; an axis that is zero or not finite, or whose length cannot be
    /// squared in f32.
    pub fn new(
        position: impl Into<Vec3<f32>>,
        axis: impl Into<Vec3<f32>>,
        cone: Cone<P>,
    ) -> Result<Self, Error> {
        let (position, axis) = (position.into(), axis.into());
        let position = checked_position(Parameter::Position, position)?;
        let (axis, _) = Axis::new(Parameter::Axis, axis)?;
        Ok(Self { position, axis, cone, attenuation: InverseSquare, emission: Emission::WHITE })
    }
}

impl<P: Falloff> SpotLight<P, SmoothRange> {
    /// Creates a white spotlight of intensity 1 that points at `end` and fades smoothly to 0 at
    /// `end`. The vector from `position` to `end` gives axis and range, as in the dual-cone
    /// article.
    ///
    /// ```
    /// use luminaire::{Angle, Cone, SpotLight, Vec3, falloff::Soft};
    /// let cone = Cone::from_field(Soft, Angle::degrees(30.0))?;
    /// let spot = SpotLight::between(Vec3::new(0.0, 5.0, 0.0), Vec3::new(0.0, 1.0, 0.0), cone)?;
    /// assert_eq!((spot.axis().y, spot.attenuation().range()), (-1.0, 4.0));
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    ///
    /// # Errors
    /// A position or an end point that is not finite, or a distance between them outside 0.001 to
    /// 1e9.
    pub fn between(
        position: impl Into<Vec3<f32>>,
        end: impl Into<Vec3<f32>>,
        cone: Cone<P>,
    ) -> Result<Self, Error> {
        let (position, end) = (position.into(), end.into());
        let position = checked_position(Parameter::Position, position)?;
        let end = checked_position(Parameter::EndPoint, end)?;
        let (axis, range) = Axis::new(Parameter::EndPoint, end.zip(position, |e, p| e - p))?;
        Ok(Self { position, axis, cone, attenuation: SmoothRange::new(range)?, emission: Emission::WHITE })
    }
}

emits!(
    SpotLight<P, A>,
    "light, on the axis of the light, to full scale; with attenuation, this holds at distance 1.",
    P: Falloff, A: Attenuation
);

impl<P: Falloff, A: Attenuation> SpotLight<P, A> {
    /// Returns the spotlight with another cone, which may have another type of falloff.
    pub fn with_cone<Q: Falloff>(&self, cone: Cone<Q>) -> SpotLight<Q, A> {
        let Self { position, axis, attenuation, emission, .. } = *self;
        SpotLight { position, axis, cone, attenuation, emission }
    }

    /// Returns the spotlight with another axis, which need not have unit length.
    ///
    /// # Errors
    /// An axis that is zero or not finite, or whose length cannot be squared in f32.
    pub fn with_axis(&self, axis: Vec3<f32>) -> Result<Self, Error> {
        let (axis, _) = Axis::new(Parameter::Axis, axis)?;
        Ok(Self { axis, ..*self })
    }

    /// Returns the spotlight with another attenuation.
    pub fn with_attenuation<B: Attenuation>(&self, attenuation: B) -> SpotLight<P, B> {
        let Self { position, axis, cone, emission, .. } = *self;
        SpotLight { position, axis, cone, attenuation, emission }
    }

    /// Returns the position of the light.
    pub fn position(&self) -> Vec3<f32> {
        self.position
    }

    /// Returns the direction in which the light points, of unit length.
    pub fn axis(&self) -> Vec3<f32> {
        self.axis.unit
    }

    /// Returns the axis as it was given, without a rounding error, at another length: its largest
    /// component is in [1/2, 1]. A light with this axis compiles to the same bits.
    pub fn given_axis(&self) -> Vec3<f32> {
        self.axis.toward
    }

    /// Returns the axis in the format `S`. The result is computed from the unrounded axis, so that
    /// in `Fx32` a point on the given axis is also on the axis of the compiled light.
    fn axis_in<S: Scalar>(&self) -> Vec3<S::Unit> {
        S::aim(self.axis.toward, self.axis.unit)
    }

    /// Returns the cone.
    pub fn cone(&self) -> Cone<P> {
        self.cone
    }

    /// Returns the attenuation.
    pub fn attenuation(&self) -> A {
        self.attenuation
    }

    /// Returns the distance from which on a surface that faces the light on its axis receives less than
    /// `light`: `sqrt(I / light)` with the inverse square, infinity if the light never falls so low.
    ///
    /// The distance is rounded up. It is that of the exact attenuation, without the error of a number
    /// format. A surface that is farther away than the range above [`Pixel::FIRST_STEP`] shows no
    /// step of this light alone without dither:
    ///
    /// ```
    /// use luminaire::{Angle, Cone, SpotLight, display::{Pixel, Rgb565}};
    /// let cone = Cone::soft(Angle::degrees(36.0))?;
    /// let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_intensity(16.0)?;
    /// // The first step of green is 0.000614.
    /// let range = spot.range_above(Rgb565::FIRST_STEP);
    /// assert!((range - (16.0 / Rgb565::FIRST_STEP).sqrt()).abs() < 0.001); // 161 units
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    ///
    /// [`Pixel::FIRST_STEP`]: crate::display::Pixel::FIRST_STEP
    pub fn range_above(&self, light: f32) -> f32 {
        range_above(self.attenuation, self.emission.intensity, light)
    }

    /// Compiles the light for the format `S`. The compiled light needs no angles and, in fixed
    /// point, no divisions and no floats.
    ///
    /// # Errors
    /// A cone that the format cannot hold: see [`Cone::narrowest`]. A position beyond
    /// [`Scalar::FARTHEST`].
    pub fn compile<S: Scalar>(&self) -> Result<CompiledSpotLight<S, P, A>, Error> {
        check_reach::<S>(self.position)?;
        let (cone, error) = self.cone.compile_with_error::<S>()?;
        Ok(self.compiled(cone, &self.cone, error))
    }

    /// Compiles the light with its own cone and with another one, for
    /// [`zoomed`](CompiledSpotLight::zoomed) between the two.
    ///
    /// Both lights have the falloff of this light. Each cone between the two keeps the accuracy of
    /// the format, half a linear code, at every part of the way (derived): if one of them needs the fine
    /// evaluation of `Fx16`, all have it. Two lights that are compiled singly zoom, too, but the error of a cone
    /// between them has no bound.
    ///
    /// The chords of a cone between have errors of their own, so a zoom needs a little more room than a single light: in `Fx32`
    /// the narrowest cone of a zoom is 1.75 times as wide as [`Cone::narrowest`], and in `f32` the
    /// steepest edge is 0.7 times as steep.
    ///
    /// Two lights of [`compile_quick`](Self::compile_quick) zoom as two that are compiled singly. A cone between
    /// theirs may be a little too steep to be compiled by itself. Its [bound](Self::quick_error_bound) is that of the cone of
    /// [`Cone::zoomed`], which may exceed that of either: by up to 1.11 times for soft edges, and by 1.47 times for powers where
    /// one of the two has a wide hotspot (searched).
    ///
    /// ```
    /// use luminaire::{Angle, Cone, Fx16, SpotLight};
    /// let [narrow, wide] = [10.0, 50.0].map(|degrees| Cone::soft(Angle::degrees(degrees)));
    /// let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], narrow?)?;
    /// let [narrow, wide] = spot.compile_zoom::<Fx16>(&wide?)?;
    /// let between = narrow.zoomed(&wide, Fx16::from_bits(1 << 13)); // halfway: 14 fraction bits
    /// let point = Fx16::point([1.0, 0.0, 0.0]);
    /// assert_eq!(narrow.falloff_at(point), Fx16::ZERO);
    /// assert!(between.falloff_at(point) > Fx16::ZERO && between.falloff_at(point) < wide.falloff_at(point));
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`compile`](Self::compile), for one of the two cones. Two cones between which the format cannot hold a
    /// cone; the error names an angle of one of them, and the angles with which the other one zooms:
    ///
    /// - a cone that is next to the narrowest of the format, or next to its steepest edge;
    /// - cones between that are steeper than both: from a narrow cone to a wide one with a wider hotspot;
    /// - a step together with a cone that is none: between them an edge is steeper than any;
    /// - in fixed point, a hotspot of so few units of a versine that it is nearly lost, together with a steep edge;
    /// - in fixed point, a cutoff within the hotspot of one of the two alone: its ramp is that of a step.
    ///
    /// ```
    /// use luminaire::{Angle, Cone, Fx16, SpotLight};
    /// let soft = Cone::soft(Angle::degrees(10.0))?;
    /// let step = Cone::from_outer(soft.falloff(), Angle::degrees(50.0))?.with_inner(Angle::degrees(50.0))?;
    /// let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], soft)?;
    /// let refused = spot.compile_zoom::<Fx16>(&step).unwrap_err();
    /// assert_eq!(refused.to_string(), "inner angle = 50: expected 0 to 48.1928 degrees (full angle)");
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    pub fn compile_zoom<S: Scalar>(&self, other: &Cone<P>) -> Result<[CompiledSpotLight<S, P, A>; 2], Error> {
        check_reach::<S>(self.position)?;
        let ([own, others], error) = self.cone.compile_zoom::<S>(other)?;
        Ok([self.compiled(own, &self.cone, error), self.compiled(others, other, error)])
    }

    /// Returns the light with a compiled cone, of which the coarse error is at most `error`.
    fn compiled<S: Scalar>(
        &self,
        compiled: CompiledCone<S, P>,
        cone: &Cone<P>,
        error: f32,
    ) -> CompiledSpotLight<S, P, A> {
        let intensity = self.emission.intensity;
        CompiledSpotLight {
            position: self.position.map(S::length),
            axis: self.axis_in::<S>(),
            cone: compiled,
            outside: number::outside_bound(cone.outer_versine()),
            attenuation: self.attenuation.constants::<S>(),
            intensity: S::gain(intensity),
            fine_below: S::fine_below(error, intensity, self.attenuation.growth()),
            color: self.emission.color.map(S::from_f32),
            specular_color: self.emission.specular_color.map(S::from_f32),
        }
    }

    /// Compiles the light for the quick evaluation of the format `S`.
    ///
    /// The quick evaluation takes fewer instructions and has a larger error;
    /// [`quick_error_bound`](Self::quick_error_bound) derives a bound of this error.
    ///
    /// In `Fx16` the quick evaluation takes two thirds of the instructions of the standard one, and
    /// the error grows as the cone gets narrower: use it for a display with few bits. `f32` and `Fx32`
    /// have one evaluation only.
    ///
    /// ```
    /// use luminaire::{Cone, Fx16, HalfAngle, SpotLight, Vec3, falloff::Soft};
    /// let cone = Cone::from_outer(Soft, HalfAngle::degrees(15.0))?;
    /// let spot = SpotLight::new(Vec3::new(0.0, 2.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?;
    /// assert!(spot.quick_error_bound::<Fx16>(2.0..=9.0)?.codes() < 0.5);
    /// let light = spot.with_intensity(4.0)?.compile_quick::<Fx16>()?;
    /// let lit = light.irradiance(Fx16::point([0.0, 0.0, 0.0]), Fx16::normal([0.0, 1.0, 0.0]));
    /// assert!((lit.to_f32() - 1.0).abs() < 0.001);
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`compile`](Self::compile): both evaluations accept the same cones.
    pub fn compile_quick<S: Quick>(&self) -> Result<QuickSpotLight<S, P, A>, Error> {
        check_reach::<S>(self.position)?;
        Ok(QuickSpotLight {
            position: self.position.map(S::length),
            axis: S::quick_axis(self.axis_in::<S>()),
            cone: self.cone.compile_quick::<S>()?,
            outside: number::outside_bound(self.cone.outer_versine()),
            attenuation: self.attenuation.constants::<S>(),
            intensity: S::gain(self.emission.intensity),
            color: self.emission.color.map(S::from_f32),
            specular_color: self.emission.specular_color.map(S::from_f32),
        })
    }
}
