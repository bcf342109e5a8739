//! Blender: a full angle in radians, watts.

use std::f64::consts::{FRAC_PI_4, PI};

use luminaire::attenuation::InverseSquare;
use luminaire::falloff::Smooth;

use super::{
    FULL_RADIANS, Fall, HALF_TURN, Law, Rows, Spot, Tool, Writer, Written, black_body, cone, exposed, half,
    is_set, row,
};
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::record::Record;
use crate::refusal::Refusal;
use crate::versine::{of_versine, versine};

pub(crate) struct Blender;

impl Tool for Blender {
    /// A black body of luminance 1 (`BKE_light_color` and `svm_math_blackbody_color_rec709`, which fits the same
    /// colours from 800 to 12,000 K).
    fn white(&self, record: &mut Record) -> Result<[f64; 3], Refusal> {
        let kelvin = record.within("temperature", 6500.0, 800.0, 20_000.0)?;
        match is_set(record, "use_temperature", "0")? {
            true => black_body(kelvin, [1e3, 12e3]),
            false => {
                let note = || "`temperature` has no effect without `use_temperature=1`";
                record.notes.extend(record.has("temperature").then(note).map(str::to_owned));
                Ok([1.0; 3])
            }
        }
    }

    /// Smoothstep over the versine, from the edge to `1 - blend` of its versine (`spot_light_attenuation` of Cycles
    /// and EEVEE).
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let outer = half(record, "spot_size", FRAC_PI_4, FULL_RADIANS)?;
        let blend = record.within("spot_blend", 0.15, 0.0, 1.0)?;
        let inner = if blend == 0.0 { outer } else { of_versine((1.0 - blend) * versine(outer)) };
        // The flux of a point light of this power, whatever the cone lets through.
        let intensity = exposed(record, "energy", 10.0)? / (4.0 * PI);
        record.note(
            "the intensity is in watts per steradian; Blender's exporter of glTF multiplies by 683 for candela",
        );
        let radius = record.within("shadow_soft_size", 0.0, 0.0, 1e6)?;
        let spot = Spot::new(record, cone(Smooth.into(), inner, outer)?, intensity, InverseSquare)?;
        // With its soft falloff, Blender divides by `d^2 + r^2`; at distance 1 the difference is the largest.
        Ok(spot.with_distance(radius * radius / (1.0 + radius * radius)))
    }

    fn sun(&self, record: &mut Record) -> Result<f64, Refusal> {
        exposed(record, "energy", 10.0)
    }

    fn writer(&self) -> Option<&'static dyn Writer> {
        Some(&Self)
    }
}

/// The watts of a number of candela or lux, by the 683 lumens a watt of Blender's exporter of glTF.
fn watts(value: f64, usage: Use) -> f64 {
    value / if usage.is_photometric { 683.0 } else { 1.0 }
}

impl Writer for Blender {
    fn family(&self) -> Family {
        Family::SmoothCosine
    }

    fn fall(&self, _: &Law) -> Fall {
        Fall::Decay { decay: 2.0, range: None, window: 2 }
    }

    fn cone(&self, [outer, inner, _]: Free) -> Rows {
        let blend = 1.0 - versine(inner) / versine(outer);
        vec![row("spot_size", (2.0 * outer).min(HALF_TURN)), row("spot_blend", blend)]
    }

    fn rest(&self, light: &Written) -> Rows {
        vec![row("energy", watts(4.0 * PI * light.candela, light.usage))]
    }

    fn sun(&self, irradiance: f64, usage: Use) -> Rows {
        vec![row("energy", watts(irradiance, usage))]
    }

    fn notes(&self, usage: Use) -> Vec<&'static str> {
        let note = "the energy in watts counts 683 lumens a watt, as Blender's exporter of glTF does";
        usage.is_photometric.then_some(note).into_iter().collect()
    }

    fn profile(&self) -> Option<&'static str> {
        Some(
            "Cycles reads the intensities themselves, from the file of `--to ies`, by the node IES Texture of the light",
        )
    }
}
