//! glTF 2.0 with `KHR_lights_punctual`: half angles in radians, candela.

use std::f64::consts::FRAC_PI_4;

use luminaire::attenuation::{GltfRange, InverseSquare};
use luminaire::falloff::Soft;

use super::{Fall, HALF_RADIANS, Law, Rows, Scene, Spot, Tool, Writer, Written, cone, half, row};
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::read;
use crate::record::Record;
use crate::refusal::Refusal;

pub(crate) struct Gltf;

impl Tool for Gltf {
    fn is_photometric(&self) -> bool {
        true
    }

    fn scene(&self) -> Option<Scene> {
        Some(read::gltf::read)
    }

    /// `t^2` with a hotspot, and the inverse square with the window `1 - (d/r)^4`: the extension's formulas without
    /// the `max(0.001, ..)` of its reference code, which makes a beam darker whose two cosines differ by less.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let range = record.optional("range")?.map(|range| range as f32);
        let outer = half(record, "outerConeAngle", FRAC_PI_4, HALF_RADIANS)?;
        let inner = record.within("innerConeAngle", 0.0, 0.0, outer)?;
        let intensity = record.get("intensity", 1.0)?;
        let attenuation = GltfRange::new(InverseSquare, range)?;
        Spot::new(record, cone(Soft.into(), inner, outer)?, intensity, attenuation)
    }

    fn writer(&self) -> Option<&'static dyn Writer> {
        Some(&Self)
    }
}

impl Writer for Gltf {
    fn family(&self) -> Family {
        Family::SquareCosine { least: 0.0, apart: 0.0 }
    }

    fn fall(&self, law: &Law) -> Fall {
        Fall::Decay { decay: 2.0, range: law.range, window: 1 }
    }

    fn cone(&self, [outer, inner, _]: Free) -> Rows {
        vec![row("innerConeAngle", inner), row("outerConeAngle", outer)]
    }

    fn rest(&self, light: &Written) -> Rows {
        let [_, range] = light.fall.decay();
        let range = (range > 0.0).then(|| row("range", range));
        range.into_iter().chain([row("intensity", light.candela)]).collect()
    }

    fn sun(&self, irradiance: f64, _: Use) -> Rows {
        vec![row("intensity", irradiance)]
    }

    fn profile(&self) -> Option<&'static str> {
        Some(
            "a scene has the intensities themselves in a file beside it, `EXT_lights_ies`: `--output FILE.gltf` writes both",
        )
    }
}
