//! Unreal Engine, from its shaders as published: half angles in degrees, centimetres.

use std::f64::consts::PI;

use luminaire::attenuation::{FilamentRange, InverseSquare};
use luminaire::falloff::Soft;

use super::{
    Fall, HALF_DEGREES, Law, Rows, Scene, Spot, Tool, Writer, Written, black_body, cone, half, is_set, row,
};
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::read;
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::text::decode;
use crate::versine::versine;

pub(crate) struct Unreal;

/// By how much the outer half angle in radians exceeds the inner one at least.
const APART: f64 = 0.001;

impl Tool for Unreal {
    fn is_photometric(&self) -> bool {
        true
    }

    fn scene(&self) -> Option<Scene> {
        Some(|bytes| read::unreal::read(&decode(bytes)?))
    }

    /// A black body of luminance 1 (`FLinearColor::MakeFromColorTemperature`).
    fn white(&self, record: &mut Record) -> Result<[f64; 3], Refusal> {
        let kelvin = record.within("Temperature", 6500.0, 0.0, 1e9)?;
        if is_set(record, "bUseTemperature", "0")? { black_body(kelvin, [1e3, 15e3]) } else { Ok([1.0; 3]) }
    }

    /// The square of a line in the cosine, and the inverse square in centimetres with the window `(1 - (d/r)^4)^2`.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let inner = record.within("InnerConeAngle", 0.0, 0.0, 89.0)?.to_radians();
        let outer = half(record, "OuterConeAngle", 44.0, HALF_DEGREES)?;
        let outer = outer.clamp(inner + APART, 89_f64.to_radians() + APART);
        let range = record.within("AttenuationRadius", 1000.0, 0.1, 1e9)? / 100.0;
        let given = record.get("Intensity", 5000.0)?;
        let units = record.word("IntensityUnits", "Unitless");
        let (is_point, level) = (record.kind == Kind::Point, 2.0 * PI * versine(outer));
        let intensity = match units.to_ascii_lowercase().as_str() {
            "candelas" | "candela" | "cd" => given,
            "lumens" | "lumen" | "lm" => given / if is_point { 4.0 * PI } else { level },
            "unitless" => given / 625.0,
            _ => return Err(Refusal::new("IntensityUnits", units, "Candelas, Lumens or Unitless")),
        };
        record.note("Unreal: from its shaders as published, not checked against a running engine");
        if !is_point && units.to_ascii_lowercase().starts_with("lumen") {
            record.note("Unreal spreads lumens evenly over the cone; the falloff then loses some of them");
        }
        if !is_set(record, "bUseInverseSquaredFalloff", "1")? {
            let expected = "True: the kernel has no power of the square of the distance";
            return Err(Refusal::new("bUseInverseSquaredFalloff", "False", expected));
        }
        let attenuation = FilamentRange::new(InverseSquare, Some(range as f32))?;
        let spot = Spot::new(record, cone(Soft.into(), inner, outer)?, intensity, attenuation)?;
        // A centimetre squared is added to the square of the distance.
        let nearest = 100.0 * range / 16.0;
        Ok(spot.with_distance(1.0 / (nearest * nearest + 1.0)))
    }

    fn sun(&self, record: &mut Record) -> Result<f64, Refusal> {
        record.get("Intensity", 10.0)
    }

    fn writer(&self) -> Option<&'static dyn Writer> {
        Some(&Self)
    }
}

impl Writer for Unreal {
    fn family(&self) -> Family {
        Family::SquareCosine { least: 0.0, apart: APART }
    }

    fn widest(&self) -> f64 {
        88.9_f64.to_radians()
    }

    fn fall(&self, law: &Law) -> Fall {
        Fall::Decay { decay: 2.0, range: law.always(), window: 2 }
    }

    fn cone(&self, [outer, inner, _]: Free) -> Rows {
        vec![row("InnerConeAngle", inner.to_degrees()), row("OuterConeAngle", outer.to_degrees())]
    }

    fn rest(&self, light: &Written) -> Rows {
        let [_, range] = light.fall.decay();
        vec![
            // The largest radius that is read stands for none.
            row("AttenuationRadius", (100.0 * range).min(1e9)),
            row("Intensity", light.candela),
            ("IntensityUnits", "Candelas".to_owned()),
        ]
    }

    fn sun(&self, irradiance: f64, _: Use) -> Rows {
        vec![row("Intensity", irradiance)]
    }

    fn notes(&self, _: Use) -> Vec<&'static str> {
        vec!["from Unreal's shaders as published, not checked against a running engine"]
    }

    fn profile(&self) -> Option<&'static str> {
        Some(
            "Unreal reads the intensities themselves, from the file of `--to ies`, as the IES Texture of the light",
        )
    }
}
