//! Lights, described in metres, degrees and linear colour.
//!
//! Every light has an intensity. All but [`AmbientLight`] have two colours, one for diffuse light
//! and one for highlights. The defaults are white and intensity 1.

/// Implements the colours and the intensity of a described light, which are in its field `emission`. `$full` ends the
/// sentence "An intensity of 1 lights a surface that faces the".
macro_rules! emits {
    ($light:ty, $full:literal $(, $lifetime:lifetime)? $(, $parameter:ident: $bound:ident)*) => {
        impl<$($lifetime,)? $($parameter: $bound),*> $light {
            /// Returns the light with this linear colour, also for highlights.
            ///
            /// # Errors
            /// A channel outside [0, 1]: brightness belongs in the intensity.
            pub fn with_color(self, color: Rgb<f32>) -> Result<Self, Error> {
                Ok(Self { emission: self.emission.with_color(color)?, ..self })
            }

            /// Returns the light with highlights in this linear colour.
            ///
            /// # Errors
            /// A channel outside [0, 1].
            pub fn with_specular_color(self, color: Rgb<f32>) -> Result<Self, Error> {
                Ok(Self { emission: self.emission.with_specular_color(color)?, ..self })
            }

            /// Returns the light with this intensity. An intensity of 1 lights a surface that faces the
            #[doc = $full]
            ///
            /// # Errors
            /// A negative intensity, or one over 1e9.
            pub fn with_intensity(self, intensity: f32) -> Result<Self, Error> {
                Ok(Self { emission: self.emission.with_intensity(intensity)?, ..self })
            }

            /// Returns the light in white of a correlated colour temperature in kelvin, also for highlights, as
            /// [`Rgb::from_kelvin`] has it.
            ///
            /// The luminance stays: the intensity is that of the strongest channel, and of candela or lux
            /// [`intensity`](Self::intensity) times [`Rgb::luminance`] remains. 2,700 K makes it 1.94 times that of
            /// white.
            ///
            /// # Errors
            /// A temperature outside [1000, 25,000], or an intensity that exceeds 1e9.
            pub fn with_kelvin(self, kelvin: f32) -> Result<Self, Error> {
                Ok(Self { emission: self.emission.with_kelvin(kelvin)?, ..self })
            }

            /// Returns the linear colour.
            pub fn color(&self) -> Rgb<f32> {
                self.emission.color
            }

            /// Returns the linear colour of the highlights.
            pub fn specular_color(&self) -> Rgb<f32> {
                self.emission.specular_color
            }

            /// Returns the intensity.
            pub fn intensity(&self) -> f32 {
                self.emission.intensity
            }
        }
    };
}

mod ambient;
mod directional;
#[cfg(feature = "fixed")]
mod integer;
mod measured;
mod point;
mod spot;

pub use self::{
    ambient::AmbientLight, directional::DirectionalLight, measured::MeasuredLight, point::PointLight,
    spot::SpotLight,
};
pub use crate::{
    cone::CompiledCone,
    distribution::{Distribution, Symmetry},
    material::CompiledMaterial,
    points::{AlongX, Points, SurfacePoint, SurfacePoints},
    row::{Block, Row},
    shade::{
        CompiledDirectionalLight, CompiledMeasuredLight, CompiledPointLight, CompiledSpotLight, Incident,
        LightModel, QuickSpotLight,
    },
};

#[cfg(feature = "fixed")]
pub use self::integer::{IntegerCone, Refusal};

use crate::{
    attenuation::Attenuation,
    color::{Rgb, checked_color},
    error::{Error, Expected, Parameter, check_between, check_components},
    number::Scalar,
    stored::stored,
    trig,
    vec3::Vec3,
};

/// The intensity and the colours of a light.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
struct Emission {
    color: Rgb<f32>,
    specular_color: Rgb<f32>,
    intensity: f32,
}

stored!(Emission { color: Rgb<f32>, specular_color: Rgb<f32>, intensity: f32 } by {
    let white = Self::WHITE.with_intensity(intensity);
    white.and_then(|light| light.with_color(color)).and_then(|light| light.with_specular_color(specular_color))
});

impl Emission {
    const WHITE: Self =
        Self { color: Rgb::new(1.0, 1.0, 1.0), specular_color: Rgb::new(1.0, 1.0, 1.0), intensity: 1.0 };

    fn with_color(self, color: Rgb<f32>) -> Result<Self, Error> {
        checked_color(color)?;
        Ok(Self { color, specular_color: color, ..self })
    }

    fn with_specular_color(self, specular_color: Rgb<f32>) -> Result<Self, Error> {
        Ok(Self { specular_color: checked_color(specular_color)?, ..self })
    }

    fn with_kelvin(self, kelvin: f32) -> Result<Self, Error> {
        let white = Rgb::from_kelvin(kelvin)?;
        let (strongest, luminance) = (white.strongest(), self.intensity * self.color.luminance());
        self.with_color(white.map(|channel| channel / strongest))?.with_intensity(luminance * strongest)
    }

    fn with_intensity(self, intensity: f32) -> Result<Self, Error> {
        check_between(Parameter::Intensity, intensity, 0.0, 1e9)?;
        Ok(Self { intensity, ..self })
    }
}

/// Returns the distance from which on the irradiance of a facing surface is less than `light`.
fn range_above<A: Attenuation>(attenuation: A, intensity: f32, light: f32) -> f32 {
    if A::is_inverse_square::<f32>(&attenuation.constants()) {
        if light > 0.0 {
            // The factor is more than the rounding errors of the roots and the quotient.
            let distance = trig::sqrt(intensity) / trig::sqrt(light) * (1.0 + 4.0 * f32::EPSILON);
            return if distance > f32::MIN_POSITIVE { distance } else { f32::MIN_POSITIVE };
        }
        return f32::INFINITY;
    }
    // Positive floats have the order of their bits. The factor is more than the error of a power.
    let (mut near, mut far) = (0, f32::INFINITY.to_bits());
    while far - near > 1 {
        let middle = u32::midpoint(near, far);
        let factor = attenuation.exact(f32::from_bits(middle).into()) * (1.0 + 1e-9);
        if f64::from(intensity) * factor < f64::from(light) { far = middle } else { near = middle }
    }
    f32::from_bits(far)
}

/// Returns the position if all components are finite, or an error that shows the first component
/// that is not finite.
fn checked_position(parameter: Parameter, position: Vec3<f32>) -> Result<Vec3<f32>, Error> {
    check_components(parameter, components(position), -f32::MAX, f32::MAX)?;
    Ok(position)
}

/// Returns an error if a format cannot hold the position of a light. The position is not saturated,
/// because saturation would move the light.
pub(crate) fn check_reach<S: Scalar>(position: Vec3<f32>) -> Result<(), Error> {
    check_components(Parameter::Position, components(position), -S::FARTHEST, S::FARTHEST)
}

/// Returns the components of a vector with their names.
fn components(vector: Vec3<f32>) -> [(&'static str, f32); 3] {
    [("x", vector.x), ("y", vector.y), ("z", vector.z)]
}

/// The axis of a light.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
struct Axis {
    /// The axis normalised to unit length, within the rounding error of f32.
    unit: Vec3<f32>,
    /// The given axis without rounding, scaled by a power of two so that the largest component is
    /// in [1/2, 1].
    toward: Vec3<f32>,
}

/// Serialised as a vector. The axis is rebuilt from it without another rounding.
#[cfg(feature = "serde")]
impl serde::Serialize for Axis {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.toward.serialize(serializer)
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Axis {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let axis = Self::new(Parameter::Axis, Vec3::deserialize(deserializer)?);
        axis.map(|(axis, _)| axis).map_err(serde::de::Error::custom)
    }
}

impl Axis {
    /// Returns the axis along a vector and the length of the vector, or an error that shows the
    /// length.
    fn new(parameter: Parameter, vector: Vec3<f32>) -> Result<(Self, f32), Error> {
        let [x, y, z] = [vector.x, vector.y, vector.z].map(f32::abs);
        let exponent = 253_u32.saturating_sub(x.max(y).max(z).to_bits() >> 23).max(1);
        let [scale, back] = [exponent, 254 - exponent].map(|exponent| f32::from_bits(exponent << 23));
        // From the scaled axis alone, so that a stored light is read back with the same bits.
        let toward = vector.map(|c| c * scale);
        let scaled = trig::sqrt(toward.dot(toward));
        let length = scaled * back;
        if !(1e-18..=1e18).contains(&length) {
            return Err(Error { parameter, value: length, accepted: Expected::Direction });
        }
        Ok((Self { unit: toward.map(|c| c / scaled), toward }, length))
    }
}
