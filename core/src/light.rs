//! Lights, described in metres, degrees and linear colour.

use crate::{
    color::Rgb,
    cone::Cone,
    error::{Accepted, Error, Parameter},
    profile::{Edge, Profile},
    scalar::{self, Scalar},
    shade::CompiledSpot,
    trig,
    vec3::Vec3,
};

/// A spotlight: a position, an axis, a cone, a colour and an intensity that falls with the square of the distance.
///
/// White and of intensity 1 until told otherwise: a surface that faces it on its axis at a distance of 1 is lit to
/// full scale.
///
/// ```
/// use luminaire::{Angle, Cone, Rgb, Soft, Spot, Vec3};
/// let cone = Cone::from_beam(Soft, Angle::degrees(9.0))?;
/// let spot = Spot::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?
///     .with_color(Rgb::new(1.0, 0.8, 0.6))?
///     .with_intensity(16.0)?;
/// let lit = spot.compile::<f32>()?;
/// assert!((lit.irradiance(Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)) - 1.0).abs() < 1e-6);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Spot<P = Edge> {
    position: Vec3<f32>,
    axis: Vec3<f32>,
    cone: Cone<P>,
    color: Rgb<f32>,
    intensity: f32,
}

impl<P: Profile> Spot<P> {
    /// A white spotlight of intensity 1. The axis points away from the light and need not have unit length.
    ///
    /// # Errors
    /// A position that is not finite; an axis that is zero, not finite, or of a length that cannot be squared.
    pub fn new(position: Vec3<f32>, axis: Vec3<f32>, cone: Cone<P>) -> Result<Self, Error> {
        let (position, axis) = (checked_position(position)?, unit_axis(axis)?);
        Ok(Self { position, axis, cone, color: Rgb::new(1.0, 1.0, 1.0), intensity: 1.0 })
    }

    /// The same spotlight in this linear colour.
    ///
    /// # Errors
    /// A channel outside [0, 1]: brightness is the intensity's part.
    pub fn with_color(self, color: Rgb<f32>) -> Result<Self, Error> {
        for value in [color.red, color.green, color.blue] {
            check_between(Parameter::Color, value, 0.0, 1.0)?;
        }
        Ok(Self { color, ..self })
    }

    /// The same spotlight with this intensity on its axis: 1 lights a facing surface at distance 1 to full scale.
    ///
    /// # Errors
    /// A negative intensity, or one over 1e9.
    pub fn with_intensity(self, intensity: f32) -> Result<Self, Error> {
        check_between(Parameter::Intensity, intensity, 0.0, 1e9)?;
        Ok(Self { intensity, ..self })
    }

    /// The same spotlight with another cone, also of another type of profile.
    pub fn with_cone<Q: Profile>(&self, cone: Cone<Q>) -> Spot<Q> {
        Spot { position: self.position, axis: self.axis, cone, color: self.color, intensity: self.intensity }
    }

    /// Where the light stands.
    pub fn position(&self) -> Vec3<f32> {
        self.position
    }

    /// Where the light points, of unit length.
    pub fn axis(&self) -> Vec3<f32> {
        self.axis
    }

    /// The cone.
    pub fn cone(&self) -> Cone<P> {
        self.cone
    }

    /// The linear colour.
    pub fn color(&self) -> Rgb<f32> {
        self.color
    }

    /// The intensity on the axis.
    pub fn intensity(&self) -> f32 {
        self.intensity
    }

    /// Compiles the light for the format `S`: from here on there are no angles, no divisions and no f32.
    ///
    /// # Errors
    /// A cone narrower than the format can hold: see [`Cone::narrowest`].
    pub fn compile<S: Scalar>(&self) -> Result<CompiledSpot<S, P>, Error> {
        Ok(CompiledSpot {
            position: self.position.map(S::length),
            axis: S::axis(self.axis),
            falloff: self.cone.compile()?,
            outside: scalar::outside_bound(self.cone.outer_versine()),
            intensity: S::gain(self.intensity),
            color: self.color.map(S::from_f32),
        })
    }
}

/// A number in a closed range, or the error that names it. Not a number is outside every range.
fn check_between(parameter: Parameter, value: f32, least: f32, most: f32) -> Result<(), Error> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        Err(Error { parameter, value, accepted: Accepted::Between(least, most) })
    }
}

/// A position of finite components, or the error that shows the first that is not.
fn checked_position(position: Vec3<f32>) -> Result<Vec3<f32>, Error> {
    for value in [position.x, position.y, position.z] {
        check_between(Parameter::Position, value, -f32::MAX, f32::MAX)?;
    }
    Ok(position)
}

/// The axis at unit length, or the error that shows the length it had.
fn unit_axis(axis: Vec3<f32>) -> Result<Vec3<f32>, Error> {
    let length = trig::sqrt(axis.dot(axis));
    if (1e-18..=1e18).contains(&length) {
        Ok(axis.map(|c| c / length))
    } else {
        Err(Error { parameter: Parameter::Axis, value: length, accepted: Accepted::Direction })
    }
}
