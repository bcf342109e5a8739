//! The error of constructors: the rejected parameter and the accepted range.

use core::fmt;

/// A rejected parameter: its name, its value, and the accepted values.
///
/// Only constructors return an `Error`; evaluation never fails. The message has the form
/// `{parameter} = {value}: expected {range}`:
///
/// ```
/// use luminaire::{Angle, Cone, falloff::Soft};
/// let refused = Cone::from_field(Soft, Angle::degrees(400.0)).unwrap_err();
/// assert_eq!(
///     refused.to_string(),
///     "field angle = 400: expected more than 0 and at most 143.13 degrees (full angle)"
/// );
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Error {
    /// The rejected parameter.
    pub parameter: Parameter,
    /// The rejected value; for a vector or a colour, its invalid component, or the vector's length.
    pub value: f32,
    /// The accepted values.
    pub accepted: Expected,
}

/// The name of a parameter, in the terms of the field.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Parameter {
    /// The full angle at which the intensity is 50 % of that on the axis.
    BeamAngle,
    /// The full angle at which the intensity is 10 % of that on the axis.
    FieldAngle,
    /// The full angle from which on there is no light.
    OuterAngle,
    /// The full angle up to which the intensity is that of the axis: the edge of the hotspot.
    InnerAngle,
    /// The full angle of a cutoff, from which on there is no light.
    CutoffAngle,
    /// The versine `1 - cos` of a half angle of a stored cone, or a fraction of the versine of its edge.
    Versine,
    /// The rotation of a projection about its axis, in degrees.
    Roll,
    /// The side length of a gobo in transmissions, or of a shadow map in texels.
    Side,
    /// The derivative of a falloff with respect to `t` at the edge of the cone.
    EdgeSlope,
    /// The derivative of a falloff with respect to `t` in the middle of the cone.
    MiddleSlope,
    /// The sum of the coefficients of a falloff.
    CoefficientSum,
    /// The exponent of a power.
    Exponent,
    /// The `u` up to which an inverted power has full intensity.
    Floor,
    /// The share of the narrow one of two soft falloffs.
    NarrowShare,
    /// The versine of the edge divided by the versine at which the narrow one of two soft falloffs ends.
    NarrowRatio,
    /// A measured intensity.
    Sample,
    /// The number of samples, transmissions or depths.
    SampleCount,
    /// The size of a distribution of intensity: the number of samples along a whole side of its square.
    DistributionSize,
    /// A sample of a distribution on the edge of its square.
    EdgeSample,
    /// The position of a light.
    Position,
    /// The axis of a spotlight or of a measured light.
    Axis,
    /// The direction of the side of a measured light.
    SideDirection,
    /// The angle between the axis and the side of a measured light, in degrees.
    SideAngle,
    /// The intensity of a light; of a spotlight, the intensity on the axis.
    Intensity,
    /// The linear colour of a light or of a material.
    Color,
    /// The number of colours of a palette or a gradient.
    ColorCount,
    /// A coordinate of a place on a screen, in pixels.
    Place,
    /// The distance in pixels between the two places of a linear gradient.
    GradientLength,
    /// The radius of a radial gradient, in pixels.
    GradientRadius,
    /// The width of a sprite, in pixels.
    Width,
    /// The number of normals of a sprite.
    NormalCount,
    /// The number of indices of materials of a sprite.
    MaterialCount,
    /// The number of ramps of a sprite.
    RampCount,
    /// The direction in which a directional light travels.
    Direction,
    /// The position at which the beam of a spotlight ends.
    EndPoint,
    /// A coefficient of a polynomial attenuation.
    Attenuation,
    /// The distance from which on there is no light.
    Range,
    /// A distance of surfaces from a light.
    Distance,
    /// The exponent of a specular lobe.
    Shininess,
    /// The side length of a shadow map in texels.
    ShadowSide,
    /// The linear reflectance of a surface.
    Albedo,
    /// The linear ambient light.
    AmbientLight,
    /// A coordinate of a vertex, or a component of its normal.
    Vertex,
    /// The number of vertices of a mesh.
    VertexCount,
    /// The number of segments of a swept surface or a curve.
    Segments,
    /// The factor on all light before the display.
    Exposure,
    /// The density of haze.
    Density,
    /// The radius of a light in haze.
    SourceRadius,
    /// The exponent of an attenuation with distance.
    Decay,
    /// The correlated colour temperature of a light, in kelvin.
    ColorTemperature,
    /// The x or the y of a CIE 1931 chromaticity.
    Chromaticity,
    /// The value of a DMX channel at an end, in degrees or as a share of full scale.
    ChannelValue,
    /// The number of a slot of a DMX universe.
    Slot,
}

/// The accepted values of a parameter.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum Expected {
    /// A full angle in degrees, more than 0 and at most this value.
    AngleUpTo(f32),
    /// A full angle in degrees of at least this value, the narrowest angle that the number format
    /// can hold. A value above 180 means that the format can hold no angle.
    AngleFrom(f32),
    /// A full angle in degrees in this closed interval.
    AngleBetween(f32, f32),
    /// Exactly this number.
    Exactly(f32),
    /// A finite number in this closed interval.
    Between(f32, f32),
    /// A finite number in this closed interval, for the component of this name.
    Component(&'static str, f32, f32),
    /// A number, more than 0 and at most this value.
    UpTo(f32),
    /// A distance in this closed interval, or no range.
    RangeBetween(f32, f32),
    /// An integer in this closed interval.
    WholeBetween(u32, u32),
    /// A power of two and one, in this closed interval.
    PowerAndOne(u32, u32),
    /// A number of pixels in whole rows of this width.
    RowsOf(u32),
    /// A vector of finite components whose length is neither zero nor too large or small to be
    /// squared in f32.
    Direction,
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::BeamAngle => "beam angle",
            Self::FieldAngle => "field angle",
            Self::OuterAngle => "outer angle",
            Self::InnerAngle => "inner angle",
            Self::CutoffAngle => "cutoff angle",
            Self::Versine => "versine",
            Self::Roll => "roll",
            Self::Side => "side",
            Self::EdgeSlope => "edge slope",
            Self::MiddleSlope => "middle slope",
            Self::CoefficientSum => "sum of coefficients",
            Self::Exponent => "exponent",
            Self::Floor => "floor",
            Self::NarrowShare => "share of the narrow falloff",
            Self::NarrowRatio => "ratio of the narrow falloff",
            Self::Sample => "sample",
            Self::SampleCount => "number of samples",
            Self::DistributionSize => "size of the distribution",
            Self::EdgeSample => "sample on the edge",
            Self::Position => "position",
            Self::Axis => "axis",
            Self::SideDirection => "side",
            Self::SideAngle => "angle between axis and side",
            Self::Intensity => "intensity",
            Self::Color => "color",
            Self::ColorCount => "number of colors",
            Self::Place => "place",
            Self::GradientLength => "length of the gradient",
            Self::GradientRadius => "radius of the gradient",
            Self::Width => "width",
            Self::NormalCount => "number of normals",
            Self::MaterialCount => "number of materials",
            Self::RampCount => "number of ramps",
            Self::Direction => "direction",
            Self::EndPoint => "end point",
            Self::Attenuation => "attenuation coefficient",
            Self::Range => "range",
            Self::Distance => "distance",
            Self::Shininess => "shininess",
            Self::ShadowSide => "side of the shadow map",
            Self::Albedo => "albedo",
            Self::AmbientLight => "ambient light",
            Self::Vertex => "vertex",
            Self::VertexCount => "number of vertices",
            Self::Segments => "number of segments",
            Self::Exposure => "exposure",
            Self::Density => "density",
            Self::SourceRadius => "source radius",
            Self::Decay => "decay",
            Self::ColorTemperature => "color temperature",
            Self::Chromaticity => "chromaticity",
            Self::ChannelValue => "value of the channel",
            Self::Slot => "slot",
        })
    }
}

impl Parameter {
    /// Returns the unit of the limits, where the name does not tell it.
    fn unit(self) -> &'static str {
        match self {
            Self::Roll | Self::SideAngle => " degrees",
            Self::EdgeSample => ", the sample of the same direction on the other half of this edge",
            Self::ColorTemperature => " K",
            _ => "",
        }
    }
}

impl Expected {
    /// The narrowest full angle, in degrees, whose versine is a normal number with any falloff.
    pub(crate) const NARROWEST: f32 = 2e-17;

    /// Returns the expectation of a full angle up to `largest` degrees.
    ///
    /// A positive angle may be too narrow, because its versine underflows.
    pub(crate) fn angle_up_to(largest: f32, value: f32) -> Self {
        if value > 0.0 && value < Self::NARROWEST {
            Self::AngleBetween(Self::NARROWEST, largest)
        } else {
            Self::AngleUpTo(largest)
        }
    }

    /// Returns whether a number is within the limits, as they are before they are rounded.
    fn holds(self, value: f32) -> bool {
        match self {
            Self::AngleUpTo(most) | Self::UpTo(most) => value > 0.0 && value <= most,
            Self::AngleFrom(least) => value >= least,
            Self::AngleBetween(least, most)
            | Self::Between(least, most)
            | Self::Component(_, least, most)
            | Self::RangeBetween(least, most) => (least..=most).contains(&value),
            Self::WholeBetween(least, most) => (least as f32..=most as f32).contains(&value),
            Self::PowerAndOne(least, most) => {
                (least as f32..=most as f32).contains(&value) && (value as u32 - 1).is_power_of_two()
            }
            Self::Exactly(only) => value == only,
            Self::RowsOf(width) => width != 0 && value as u32 % width == 0,
            Self::Direction => false,
        }
    }
}

/// Returns the factor by which a limit is rounded: `scale`, or for an angle below 1 the power of ten
/// that keeps as many digits.
fn scale_of(angle: f32, mut scale: f32) -> f32 {
    let least = scale;
    while angle * scale < least && scale < 1e30 {
        scale *= 10.0;
    }
    scale
}

/// Returns a limit rounded down to a multiple of `1 / scale`.
fn below(limit: f32, scale: f32) -> f32 {
    let steps = (limit * scale) as u32;
    let rounded = steps as f32 / scale;
    if rounded <= limit { rounded } else { steps.saturating_sub(1) as f32 / scale }
}

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            // Limits are rounded towards the inside of the accepted range, so that the angle in the
            // message is accepted.
            Self::AngleUpTo(largest) => {
                let scale = scale_of(largest, 1e2);
                let shown = Number(below(largest, scale));
                write!(f, "more than 0 and at most {shown} degrees (full angle)")
            }
            Self::AngleFrom(narrowest) if narrowest > 180.0 => {
                f.write_str("a number format of more bits: no angle up to 180 degrees is wide enough")
            }
            Self::AngleFrom(narrowest) => {
                let shown = ((narrowest * 1e4) as u32).saturating_add(1) as f32 / 1e4;
                write!(f, "at least {shown} degrees (full angle), or a number format of more bits")
            }
            Self::AngleBetween(least, most) => {
                let scale = scale_of(most, 1e4);
                let (scaled, up_to) = (least * scale, below(most, scale));
                let down = scaled as u32;
                let from = down.saturating_add(u32::from((down as f32) < scaled)) as f32 / scale;
                let from = if down == 0 { least } else { from };
                let [from, up_to] = if from < up_to { [from, up_to] } else { [least, most] };
                if from < up_to {
                    write!(f, "{} to ", Number(from))?;
                }
                write!(f, "{} degrees (full angle)", Number(up_to))
            }
            Self::Exactly(value) => write!(f, "{value}"),
            Self::Between(f32::MIN, f32::MAX) => f.write_str("a finite number"),
            Self::Between(least, most) => write!(f, "a finite number from {least} to {most}"),
            Self::Component(name, least, most) => write!(f, "{} ({name})", Self::Between(least, most)),
            Self::UpTo(most) => write!(f, "more than 0 and at most {most}"),
            Self::RangeBetween(least, most) => {
                write!(f, "a distance from {least} to {most}, or an attenuation without a range")
            }
            Self::WholeBetween(least, most) => write!(f, "a whole number from {least} to {most}"),
            Self::PowerAndOne(least, most) => write!(f, "a power of two and one, from {least} to {most}"),
            Self::RowsOf(width) => write!(f, "whole rows, a multiple of the width {width}"),
            Self::Direction => f.write_str("finite components and a length between 1e-18 and 1e18"),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { parameter, value, accepted } = *self;
        write!(f, "{parameter} = ")?;
        let counts = matches!(
            accepted,
            Expected::WholeBetween(..)
                | Expected::PowerAndOne(..)
                | Expected::RowsOf(_)
                | Expected::Exactly(_)
        );
        if counts && (1.0..1e18).contains(&value) && value as u64 as f32 == value {
            write!(f, "{}", value as u64)?;
        } else {
            // Rounded, a value next to a limit may be within the limits.
            let shown = rounded(value).filter(|&shown| !accepted.holds(shown));
            write!(f, "{}", Number(shown.unwrap_or(value)))?;
        }
        write!(f, ": expected {accepted}{}", parameter.unit())
    }
}

impl core::error::Error for Error {}

/// Returns an error if the value is outside the closed interval. NaN is outside every interval.
pub(crate) fn check_between(parameter: Parameter, value: f32, least: f32, most: f32) -> Result<(), Error> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        Err(Error { parameter, value, accepted: Expected::Between(least, most) })
    }
}

/// Returns an error if the value, a component of a vector or a colour, is outside the closed
/// interval.
pub(crate) fn check_components(
    parameter: Parameter,
    components: [(&'static str, f32); 3],
    least: f32,
    most: f32,
) -> Result<(), Error> {
    for (name, value) in components {
        if !(least..=most).contains(&value) {
            return Err(Error { parameter, value, accepted: Expected::Component(name, least, most) });
        }
    }
    Ok(())
}

/// Returns a number in [0.001, 10,000) rounded to four decimals.
fn rounded(value: f32) -> Option<f32> {
    (1e-3..1e4).contains(&value).then(|| (value * 1e4 + 0.5) as u32 as f32 / 1e4)
}

/// Displays a number in full, or if it is very large or small with an exponent.
struct Number(f32);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        let size = if value < 0.0 { -value } else { value };
        if size == 0.0 || (1e-6..1e12).contains(&size) {
            write!(f, "{value}")
        } else {
            // Without an exponent, the number would have up to 39 digits.
            write!(f, "{value:e}")
        }
    }
}
