//! pbrt versions 3 and 4: half angles in degrees.

use std::f64::consts::PI;

use luminaire::attenuation::InverseSquare;
use luminaire::falloff::{AnyFalloff, IntegerPower, Smooth};

use super::{HALF_DEGREES, Scene, Spot, Tool, cone, half};
use crate::read;
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::text::decode;

pub(crate) struct Pbrt;

impl Tool for Pbrt {
    fn scene(&self) -> Option<Scene> {
        Some(|bytes| read::pbrt::read(&decode(bytes)?))
    }

    /// The channels are the intensity.
    fn color(&self, kind: Kind) -> (&'static str, f64) {
        (if kind == Kind::Directional { "L" } else { "I" }, f64::MIN_POSITIVE)
    }

    /// Smoothstep in the cosine in version 4, the fourth power of a line in version 3.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let version = record.word("version", "4");
        let falloff: AnyFalloff = match version.as_str() {
            "3" => IntegerPower::new(4)?.into(),
            "4" => Smooth.into(),
            _ => return Err(Refusal::new("version", version, "3 or 4")),
        };
        let outer = half(record, "coneangle", 30.0, HALF_DEGREES)?;
        let delta = record.within("conedeltaangle", 5.0, 0.0, outer.to_degrees())?.to_radians();
        let cone = cone(falloff, outer - delta, outer)?;
        let solid = if record.kind == Kind::Point { 4.0 * PI } else { f64::from(cone.lumens(1.0)) };
        let intensity = scale(record, ["I", "power"], solid)?;
        Spot::new(record, cone, intensity, InverseSquare)
    }

    fn sun(&self, record: &mut Record) -> Result<f64, Refusal> {
        scale(record, ["L", "illuminance"], 1.0)
    }
}

/// Returns the factor of a light on its colour: `scale`, or what gives a luminous flux or an illuminance over a solid
/// angle.
fn scale(record: &mut Record, [color, photometric]: [&str; 2], solid: f64) -> Result<f64, Refusal> {
    let scale = record.get("scale", 1.0)?;
    // In pbrt, 0 is none, and the number is that of the luminance.
    let Some(total) = record.optional(photometric)?.filter(|total| *total > 0.0) else { return Ok(scale) };
    let [red, green, blue] = record.triple(color, [1.0; 3])?;
    Ok(scale * total / (solid * (0.2126 * red + 0.7152 * green + 0.0722 * blue)))
}
