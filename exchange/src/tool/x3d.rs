//! X3D and VRML97 (ISO/IEC 19775-1, 17.4.3): half angles in radians.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use luminaire::attenuation::{AnyAttenuation, CutAt, NoAttenuation, Polynomial};
use luminaire::falloff::Step;

use super::{HALF_RADIANS, Scene, Spot, Tool, cone, half, no_cone};
use crate::read;
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::text::decode;

pub(crate) struct X3d;

impl Tool for X3d {
    fn scene(&self) -> Option<Scene> {
        Some(|bytes| read::x3d::read(&decode(bytes)?))
    }

    /// Linear in the angle, and a step if the beam is wider than the cut-off.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        // The defaults differ by version; VRML97 is version 2.
        let version = record.get("version", 4.0)?;
        let (beam, outer) = match version {
            4.0.. => (3.0 * PI / 16.0, FRAC_PI_2),
            3.2.. => (FRAC_PI_4, FRAC_PI_2),
            _ => (FRAC_PI_2, FRAC_PI_4),
        };
        let outer = half(record, "cutOffAngle", outer, HALF_RADIANS)?;
        let beam = record.get("beamWidth", beam)?;
        let [a, b, c] = record.triple("attenuation", [1.0, 0.0, 0.0])?;
        let range = Some(record.within("radius", 100.0, 0.0, 1e9)? as f32);
        let intensity = record.get("intensity", 1.0)?;
        // The sum is at least 1, as a browser has it; a constant of 0 is what it is capped from.
        let attenuation: AnyAttenuation = if b == 0.0 && c == 0.0 && a <= 1.0 {
            CutAt::new(NoAttenuation, range)?.into()
        } else {
            CutAt::new(Polynomial::new(a as f32, b as f32, c as f32)?, range)?.into()
        };
        if record.kind == Kind::Point {
            return Spot::new(record, no_cone()?, intensity, attenuation);
        }
        if beam >= outer {
            return Spot::new(record, cone(Step.into(), outer, outer)?, intensity, attenuation);
        }
        let inner = beam.max(0.0);
        let fall = |angle: f64| (outer - angle) / (outer - inner);
        let (cone, difference) = record.tables.cone(inner, outer, [0.0; 3], &fall)?;
        Ok(Spot::new(record, cone, intensity, attenuation)?.with_angle(difference))
    }

    fn ambient(&self, record: &mut Record) -> Result<f64, Refusal> {
        record.within("ambientIntensity", 0.0, 0.0, 1.0)
    }
}
