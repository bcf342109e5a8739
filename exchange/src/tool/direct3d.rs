//! Direct3D 9 (`D3DLIGHT9`, and *Attenuation and Spotlight Factor* of its programming guide): full angles in radians.

use luminaire::falloff::AnyFalloff;

use super::{
    FULL_RADIANS, Fall, HALF_TURN, Law, Rows, Spot, Tool, Writer, Written, cone, half, no_cone, polynomial,
    row,
};
use crate::difference::Difference;
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::record::{Kind, Record};
use crate::refusal::Refusal;

pub(crate) struct Direct3d;

const COEFFICIENTS: [&str; 3] = ["attenuation0", "attenuation1", "attenuation2"];

/// The largest range that Direct3D accepts, `sqrt(FLT_MAX)`; any over 1e9 means none.
fn no_range() -> f64 {
    f64::from(f32::MAX).sqrt()
}

/// The members of a cone.
const CONE: [&str; 3] = ["theta", "phi", "falloff"];

impl Tool for Direct3d {
    /// Without a member of another kind, the light that `IDirect3DDevice9::LightEnable` makes of an index that was never
    /// set: a directional one.
    fn kind(&self, record: &Record) -> Kind {
        let is_placed = CONE.iter().chain(&COEFFICIENTS).chain(&["range"]).any(|key| record.has(key));
        if is_placed { Kind::Spot } else { Kind::Directional }
    }

    /// `t^falloff` with a hotspot, divided by `a0 + a1 d + a2 d^2` up to the range.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let mut is_zeroed = true;
        for key in COEFFICIENTS {
            is_zeroed &= record.get(key, 0.0)? == 0.0;
        }
        if is_zeroed {
            let expected = "one that is not 0. A zeroed D3DLIGHT9 divides by 0: runtimes show nothing or the full \
                            light at every distance; for the second give attenuation0=1";
            return Err(Refusal::new(COEFFICIENTS.join(", "), "0, 0, 0", expected));
        }
        // A point light has the members of a cone, too, without an effect.
        for key in CONE {
            record.optional(key)?;
        }
        let is_spot = record.kind == Kind::Spot;
        if is_spot && record.get("phi", 0.0)? == 0.0 {
            let expected = "the full outer angle in radians, such as phi=1. With a zeroed Phi there is no light \
                            but on the axis itself";
            return Err(Refusal::new("phi", 0, expected));
        }
        let range = record.get("range", no_range())?;
        let range = if range > 1e9 { None } else { Some(range as f32) };
        let (attenuation, factor) = polynomial(record, COEFFICIENTS, [0.0; 3], range)?;
        let intensity = record.get("intensity", 1.0)? * factor;
        if !is_spot {
            return Spot::new(record, no_cone()?, intensity, attenuation);
        }
        let outer = half(record, "phi", 0.0, FULL_RADIANS)?;
        let inner = record.within("theta", 0.0, 0.0, 2.0 * outer)? / 2.0;
        let exponent = record.within("falloff", 1.0, 0.0, 1_024.0)?;
        // A step has no inner angle.
        let inner = if exponent == 0.0 { outer } else { inner };
        let cone = cone(AnyFalloff::power(exponent as f32)?, inner, outer)?;
        let is_boundless = exponent < 1.0 && inner < outer;
        let difference = if is_boundless { Difference::AT_THE_EDGE } else { Difference::default() };
        Ok(Spot { difference, ..Spot::new(record, cone, intensity, attenuation)? })
    }

    fn writer(&self) -> Option<&'static dyn Writer> {
        Some(&Self)
    }
}

impl Writer for Direct3d {
    fn family(&self) -> Family {
        Family::Power
    }

    fn fall(&self, law: &Law) -> Fall {
        Fall::Polynomial { coefficients: law.polynomial(), range: law.range }
    }

    fn cone(&self, [outer, inner, exponent]: Free) -> Rows {
        vec![
            row("theta", (2.0 * inner).min(HALF_TURN)),
            row("phi", (2.0 * outer).min(HALF_TURN)),
            row("falloff", exponent),
        ]
    }

    fn rest(&self, light: &Written) -> Rows {
        let [_, range] = light.fall.decay();
        let range = if range > 0.0 { range } else { no_range() };
        let coefficients = COEFFICIENTS.into_iter().zip(light.fall.coefficients());
        let others = [("range", range), ("intensity", light.shown())];
        coefficients.chain(others).map(|(name, value)| row(name, value)).collect()
    }

    fn notes(&self, _: Use) -> Vec<&'static str> {
        vec!["the intensity is a factor of Diffuse, which may be over 1"]
    }
}
