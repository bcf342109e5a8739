//! Measured lights.

use super::{Axis, Emission, check_reach, checked_position, range_above};
use crate::{
    angle::Angle,
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    distribution::Distribution,
    error::{Error, Expected, Parameter},
    number::{self, Scalar},
    shade::CompiledMeasuredLight,
    trig,
    vec3::Vec3,
};

/// A measured light: a position, an axis, a side, a [`Distribution`] of intensity over all directions, two colours, an
/// intensity and an [attenuation](Attenuation).
///
/// It is a luminaire that is not round: a street light, a floodlight, a wall washer, a linear luminaire. Of photometry of
/// type C the axis is the direction down, `gamma = 0`, the side the plane C0, and the front the plane C90: in right-handed
/// coordinates `front = side x axis`. A light that is round is a [`SpotLight`](crate::SpotLight) with a
/// [`Table`](crate::falloff::Table), which takes fewer instructions.
///
/// The light moves, aims, turns about its axis, dims and changes its colour at run time. It does not zoom.
///
/// ```
/// use luminaire::{Fx16, MeasuredLight, light::{Distribution, Symmetry}};
/// // Brightest 45 degrees to the front and to the back, half as bright straight down, and dark to the sides.
/// const SAMPLES: [u16; 9] = [32_768, 16_384, 0, 65_535, 0, 0, 0, 0, 0];
/// let low = Distribution::new(&SAMPLES, 5, Symmetry::Quadrant)?;
/// let light = MeasuredLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], low)?.with_intensity(32.0)?;
/// let lit = light.compile::<Fx16>()?;
/// let up = Fx16::normal([0.0, 1.0, 0.0]);
/// assert!((lit.irradiance(Fx16::point([0.0, 0.0, 0.0]), up).to_f32() - 1.0).abs() < 0.001);
/// let front = lit.irradiance(Fx16::point([0.0, 0.0, -4.0]), up).to_f32();
/// assert!((front - 0.5_f32.sqrt()).abs() < 0.001);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MeasuredLight<'a, A = InverseSquare> {
    position: Vec3<f32>,
    axis: Axis,
    side: Axis,
    distribution: Distribution<'a>,
    attenuation: A,
    emission: Emission,
}

/// The distribution borrows its samples, so that a light can be neither written nor read.
#[cfg(feature = "serde")]
const _: () = {
    use serde::{Deserialize, Deserializer, Serialize, Serializer, de, ser};

    const BORROWED: &str = "distribution = borrowed samples: expected a light without; store the samples";

    impl<A> Serialize for MeasuredLight<'_, A> {
        fn serialize<Out: Serializer>(&self, _: Out) -> Result<Out::Ok, Out::Error> {
            Err(ser::Error::custom(BORROWED))
        }
    }

    impl<'de, A> Deserialize<'de> for MeasuredLight<'_, A> {
        fn deserialize<In: Deserializer<'de>>(_: In) -> Result<Self, In::Error> {
            Err(de::Error::custom(BORROWED))
        }
    }
};

/// The sine of the least angle between axis and side, of 6 degrees.
const LEAST_SINE: f32 = 0.104_528_46;

/// What is added to the versine of the largest angle with light: more than the errors of a place in any format.
const MARGIN: f32 = 1e-3;

impl<'a> MeasuredLight<'a> {
    /// Creates a white light of intensity 1. The axis points away from the light; the side need not be orthogonal to it.
    /// Neither needs unit length.
    ///
    /// # Errors
    /// A position that is not finite; an axis or a side that is zero or not finite, or whose length cannot be squared in
    /// f32; less than 6 degrees between the side and the axis or the opposite of the axis.
    pub fn new(
        position: impl Into<Vec3<f32>>,
        axis: impl Into<Vec3<f32>>,
        side: impl Into<Vec3<f32>>,
        distribution: Distribution<'a>,
    ) -> Result<Self, Error> {
        let position = checked_position(Parameter::Position, position.into())?;
        let (axis, side) = checked_axes(axis.into(), side.into())?;
        let (attenuation, emission) = (InverseSquare, Emission::WHITE);
        Ok(Self { position, axis, side, distribution, attenuation, emission })
    }
}

/// Returns the axis and the side of a light if they have directions of their own.
fn checked_axes(axis: Vec3<f32>, side: Vec3<f32>) -> Result<(Axis, Axis), Error> {
    let (axis, _) = Axis::new(Parameter::Axis, axis)?;
    let (side, _) = Axis::new(Parameter::SideDirection, side)?;
    let sine = sine(axis, side);
    if sine < LEAST_SINE {
        let value = trig::asin(sine).to_degrees();
        let value = if axis.unit.dot(side.unit) < 0.0 { 180.0 - value } else { value };
        return Err(Error {
            parameter: Parameter::SideAngle,
            value,
            accepted: Expected::Between(6.0, 174.0),
        });
    }
    Ok((axis, side))
}

fn dot(a: Vec3<f64>, b: Vec3<f64>) -> f64 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

fn cross(a: Vec3<f64>, b: Vec3<f64>) -> Vec3<f64> {
    Vec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}

fn unit(v: Vec3<f64>) -> Vec3<f64> {
    let length = trig::square_root(dot(v, v));
    v.map(|c| c / length)
}

/// Returns the sine of the angle between axis and side.
fn sine(axis: Axis, side: Axis) -> f32 {
    let front = side.unit.cross(axis.unit);
    trig::sqrt(front.dot(front))
}

emits!(
    MeasuredLight<'a, A>,
    "light, in a direction of full intensity, to full scale; with attenuation, this holds at distance 1.",
    'a, A: Attenuation
);

impl<'a, A: Attenuation> MeasuredLight<'a, A> {
    /// Returns the light with another attenuation.
    pub fn with_attenuation<B: Attenuation>(&self, attenuation: B) -> MeasuredLight<'a, B> {
        let Self { position, axis, side, distribution, emission, .. } = *self;
        MeasuredLight { position, axis, side, distribution, attenuation, emission }
    }

    /// Returns the position of the light.
    pub fn position(&self) -> Vec3<f32> {
        self.position
    }

    /// Returns the side, the front and the axis of the light, of unit length and orthogonal. The side is the one that is
    /// nearest to that given.
    pub fn frame(&self) -> [Vec3<f32>; 3] {
        let axis = self.axis.unit;
        let front = self.side.unit.cross(axis).unit();
        [axis.cross(front).unit(), front, axis]
    }

    /// Returns the axis as it was given, without a rounding error, at another length: see
    /// [`SpotLight::given_axis`](crate::SpotLight::given_axis).
    pub fn given_axis(&self) -> Vec3<f32> {
        self.axis.toward
    }

    /// Returns the side as it was given, without a rounding error, at another length.
    pub fn given_side(&self) -> Vec3<f32> {
        self.side.toward
    }

    /// Returns the distribution.
    pub fn distribution(&self) -> Distribution<'a> {
        self.distribution
    }

    /// Returns the attenuation.
    pub fn attenuation(&self) -> A {
        self.attenuation
    }

    /// Returns the exact intensity in the direction of a vector of any length: the model in f64, without the error of a
    /// number format.
    pub fn exact_intensity(&self, direction: Vec3<f64>) -> f64 {
        let [axis, side] = [self.axis, self.side].map(|axis| unit(axis.toward.map(f64::from)));
        let front = unit(cross(side, axis));
        let along = [cross(axis, front), front, axis].map(|axis| dot(axis, direction));
        f64::from(self.emission.intensity) * self.distribution.exact(along)
    }

    /// Returns the distance from which on a surface that faces the light, in a direction of full intensity, receives less
    /// than `light`: see [`SpotLight::range_above`](crate::SpotLight::range_above).
    pub fn range_above(&self, light: f32) -> f32 {
        range_above(self.attenuation, self.emission.intensity, light)
    }

    /// Returns the full angle of a cone about the axis that holds all light, in every number format; `None` for a light
    /// without one of at most 180 degrees.
    pub fn outer(&self) -> Option<Angle> {
        self.outer_versine().map(Angle::from_versine)
    }

    fn outer_versine(&self) -> Option<f32> {
        self.distribution.end().map(|versine| versine + MARGIN).filter(|versine| *versine <= 1.0)
    }

    /// Returns the sine of the angle between axis and side.
    pub(crate) fn sine(&self) -> f32 {
        sine(self.axis, self.side)
    }

    /// Returns the error of the coarse evaluation of the format `S`.
    pub(crate) fn coarse_error<S: Scalar>(&self) -> f32 {
        S::distribution_error(self.distribution.steepness())
    }

    /// Compiles the light for the format `S`. The compiled light needs no angles and, in fixed
    /// point, no divisions and no floats.
    ///
    /// # Errors
    /// A position beyond [`Scalar::FARTHEST`].
    pub fn compile<S: Scalar>(&self) -> Result<CompiledMeasuredLight<'a, S, A>, Error> {
        check_reach::<S>(self.position)?;
        let [axis, side] = [self.axis, self.side].map(|axis| S::aim(axis.toward, axis.unit));
        // Axes that are 6 degrees apart have a front.
        let [side, front] = number::across::<S>(axis, side).unwrap_or([side; 2]);
        let intensity = self.emission.intensity;
        // Of a light at a right angle or behind, no point is outside: no squared cosine is less than -1.
        let outside = self.outer_versine().map_or(S::from_f32(-2.0), number::outside_bound);
        Ok(CompiledMeasuredLight {
            position: self.position.map(S::length),
            frame: [side, front, axis],
            distribution: self.distribution,
            outside,
            attenuation: self.attenuation.constants::<S>(),
            intensity: S::gain(intensity),
            fine_below: S::fine_below(self.coarse_error::<S>(), intensity, self.attenuation.growth()),
            color: self.emission.color.map(S::from_f32),
            specular_color: self.emission.specular_color.map(S::from_f32),
        })
    }
}
