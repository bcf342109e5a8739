//! three.js: a half angle in radians, candela.

use std::f64::consts::FRAC_PI_3;

use luminaire::falloff::Smooth;

use super::{Fall, HALF_RADIANS, Law, Rows, Scene, Spot, Tool, Writer, Written, cone, decay, half, row};
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::read;
use crate::record::Record;
use crate::refusal::Refusal;
use crate::text::decode;

pub(crate) struct Three;

impl Tool for Three {
    fn is_photometric(&self) -> bool {
        true
    }

    fn scene(&self) -> Option<Scene> {
        Some(|bytes| read::three::read(&decode(bytes)?))
    }

    /// Smoothstep in the cosine, and `1 / max(d^decay, 0.01)` with the window `(1 - (d/r)^4)^2` (the shader chunk
    /// `lights_pars_begin` and `WebGLLights`). With decay 2 the light keeps growing at distances below 0.1.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let outer = half(record, "angle", FRAC_PI_3, HALF_RADIANS)?;
        let inner = outer * (1.0 - record.within("penumbra", 0.0, 0.0, 1.0)?);
        let range = Some(record.within("distance", 0.0, 0.0, 1e9)? as f32).filter(|range| *range != 0.0);
        let (attenuation, distance) = decay(record.within("decay", 2.0, 0.0, 16.0)?, 100.0, range)?;
        let (cone, intensity) = (cone(Smooth.into(), inner, outer)?, record.get("intensity", 1.0)?);
        Ok(Spot::new(record, cone, intensity, attenuation)?.with_distance(distance))
    }

    fn ambient(&self, record: &mut Record) -> Result<f64, Refusal> {
        record.get("intensity", 1.0)
    }

    fn writer(&self) -> Option<&'static dyn Writer> {
        Some(&Self)
    }
}

impl Writer for Three {
    fn family(&self) -> Family {
        Family::SmoothCosine
    }

    fn fall(&self, law: &Law) -> Fall {
        Fall::Decay { decay: law.decay(), range: law.range, window: 2 }
    }

    fn cone(&self, [outer, inner, _]: Free) -> Rows {
        vec![row("angle", outer), row("penumbra", 1.0 - inner / outer)]
    }

    fn rest(&self, light: &Written) -> Rows {
        let [decay, range] = light.fall.decay();
        vec![row("decay", decay), row("distance", range), row("intensity", light.candela)]
    }

    fn sun(&self, irradiance: f64, _: Use) -> Rows {
        vec![row("intensity", irradiance)]
    }

    fn profile(&self) -> Option<&'static str> {
        Some(
            "IESLoader reads the intensities themselves, from the file of `--to ies`, as `iesMap` of an IESSpotLight (WebGPU)",
        )
    }
}
