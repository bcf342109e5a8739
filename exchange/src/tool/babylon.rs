//! Babylon.js: full angles in radians, and one of three laws by the material.

use std::f64::consts::{FRAC_PI_3, PI};

use luminaire::attenuation::{AnyAttenuation, FilamentRange, InverseSquare, NoAttenuation, SmoothRange};

use super::{FULL_RADIANS, Scene, Spot, Tool, half, opengl, square};
use crate::read;
use crate::record::Record;
use crate::refusal::Refusal;
use crate::text::decode;
use crate::versine::{of_versine, versine};

pub(crate) struct Babylon;

impl Tool for Babylon {
    fn scene(&self) -> Option<Scene> {
        Some(|bytes| read::babylon::read(&decode(bytes)?))
    }

    /// The three laws that materials choose: `standard`, `physical` and `gltf`.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let outer = half(record, "angle", FRAC_PI_3, FULL_RADIANS)?;
        let range = record.optional("range")?.filter(|&range| range < 1e30).map(|range| range as f32);
        let given = record.get("intensity", 1.0)?;
        let mode = record.word("intensityMode", "0").to_ascii_lowercase();
        let intensity = match mode.as_str() {
            "0" | "2" | "automatic" | "luminousintensity" => given,
            "1" | "luminouspower" => given / (4.0 * PI),
            _ => return Err(Refusal::new("intensityMode", mode, "0 or 2 for candela, or 1 for lumens")),
        };
        let exponent = record.within("exponent", 2.0, 0.0, 1_024.0)?;
        let inner = record.get("innerAngle", 0.0)? / 2.0;
        let law = record.word("falloffType", "default").to_ascii_lowercase();
        match law.as_str() {
            "2" | "gltf" => {
                let attenuation = FilamentRange::new(InverseSquare, range)?;
                let (cone, on_axis) = square(inner, outer, 0.001)?;
                Spot::new(record, cone, intensity * on_axis, attenuation)
            }
            "1" | "physical" => {
                // 1 % at the edge of the cone, and light beyond it.
                let kappa = 100_f64.ln() / versine(outer);
                let glow = |angle: f64| (-kappa * versine(angle)).exp();
                let end = of_versine(65_535_f64.ln() / kappa);
                let (cone, difference) = record.tables.cone(0.0, end, [kappa, 0.0, 0.0], &glow)?;
                // What the law leaves behind 90 degrees off the axis is lost.
                Ok(Spot::new(record, cone, intensity, InverseSquare)?.with_angle(difference.max(glow(end))))
            }
            "0" | "3" | "default" | "standard" => {
                if law.starts_with(['0', 'd']) {
                    record.note("the law is that of standard materials; physical ones show falloffType=1");
                }
                let attenuation: AnyAttenuation = match range {
                    None => NoAttenuation.into(),
                    Some(range) => SmoothRange::new(range)?.into(),
                };
                let (cone, _) = opengl::cut_off(exponent, outer)?;
                let spot = Spot::new(record, cone, intensity, attenuation)?;
                if range.is_none() {
                    return Ok(spot);
                }
                record.note(
                    "Babylon's standard materials fall off linearly to the range; the smoothstep in its place differs \
                     by up to 24.6 of 255 codes (at 0.21 and 0.79 of the range)",
                );
                Ok(spot.with_distance(1.0))
            }
            _ => Err(Refusal::new("falloffType", law, "default, physical, gltf or standard")),
        }
    }
}
