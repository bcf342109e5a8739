//! Bevy: half angles in radians, lumens of a point light.

use std::f64::consts::{FRAC_PI_4, PI};

use luminaire::attenuation::{FilamentRange, InverseSquare};

use super::{Fall, HALF_RADIANS, Law, Rows, Spot, Tool, Writer, Written, half, row, square};
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::record::Record;
use crate::refusal::Refusal;

pub(crate) struct Bevy;

/// What the line in the cosine is divided by at least.
const LEAST: f64 = 1e-4;

impl Tool for Bevy {
    fn is_photometric(&self) -> bool {
        true
    }

    /// glTF's cone, and the flux of a point light of this intensity in lumens.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let outer = half(record, "outer_angle", FRAC_PI_4, HALF_RADIANS)?;
        let inner = record.within("inner_angle", 0.0, 0.0, PI)?;
        let range = record.within("range", 20.0, 0.001, 1e9)? as f32;
        let intensity = record.get("intensity", 1_000_000.0)? / (4.0 * PI);
        let attenuation = FilamentRange::new(InverseSquare, Some(range))?;
        let (cone, on_axis) = square(inner, outer, LEAST)?;
        Spot::new(record, cone, intensity * on_axis, attenuation)
    }

    fn sun(&self, record: &mut Record) -> Result<f64, Refusal> {
        record.get("illuminance", 10_000.0)
    }

    fn writer(&self) -> Option<&'static dyn Writer> {
        Some(&Self)
    }
}

impl Writer for Bevy {
    fn family(&self) -> Family {
        Family::SquareCosine { least: LEAST, apart: 0.0 }
    }

    fn fall(&self, law: &Law) -> Fall {
        Fall::Decay { decay: 2.0, range: law.always(), window: 2 }
    }

    fn cone(&self, [outer, inner, _]: Free) -> Rows {
        vec![row("inner_angle", inner), row("outer_angle", outer)]
    }

    fn rest(&self, light: &Written) -> Rows {
        let [_, range] = light.fall.decay();
        vec![row("range", range), row("intensity", 4.0 * PI * light.candela)]
    }

    fn sun(&self, irradiance: f64, _: Use) -> Rows {
        vec![row("illuminance", irradiance)]
    }
}
