//! UsdLux: half angles in degrees, and a luminance.

use std::f64::consts::PI;

use luminaire::attenuation::InverseSquare;
use luminaire::falloff::Step;

use super::{
    Fall, Law, Rows, Scene, Spot, Tool, Writer, Written, cone, exposed, is_set, luminance, no_cone, row,
};
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::limits::within;
use crate::read::{self, Found};
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::text::decode;

pub(crate) struct Usd;

/// The colours of black bodies in linear sRGB from 1,000 to 10,000 K, each 500 K (`blackbody.cpp` of OpenUSD, after
/// J. Walker, *Colour Rendering of Spectra*).
const BLACK_BODIES: [[f64; 3]; 19] = [
    [1.0, 0.027_490, 0.0],
    [1.0, 0.149_664, 0.0],
    [1.0, 0.256_644, 0.008_095],
    [1.0, 0.372_033, 0.067_450],
    [1.0, 0.476_725, 0.153_601],
    [1.0, 0.570_376, 0.259_196],
    [1.0, 0.653_480, 0.377_155],
    [1.0, 0.726_878, 0.501_606],
    [1.0, 0.791_543, 0.628_050],
    [1.0, 0.848_462, 0.753_228],
    [1.0, 0.898_581, 0.874_905],
    [1.0, 0.942_771, 0.991_642],
    [0.906_947, 0.890_456, 1.0],
    [0.828_247, 0.841_838, 1.0],
    [0.765_791, 0.801_896, 1.0],
    [0.715_255, 0.768_579, 1.0],
    [0.673_683, 0.740_423, 1.0],
    [0.638_992, 0.716_359, 1.0],
    [0.609_681, 0.695_588, 1.0],
];

/// Reads a stage as text.
fn scene(bytes: &[u8]) -> Result<Found, Refusal> {
    if [&b"PXR-USDC"[..], b"PK"].iter().any(|head| bytes.starts_with(head)) {
        return Err(Refusal::new("file", "a binary stage", "text: usdcat -o file.usda FILE"));
    }
    read::usd::read(&decode(bytes)?)
}

impl Tool for Usd {
    fn scene(&self) -> Option<Scene> {
        Some(scene)
    }

    /// The spline of `UsdLuxBlackbodyTemperatureAsRgb`, of luminance 1.
    fn white(&self, record: &mut Record) -> Result<[f64; 3], Refusal> {
        let kelvin = record.within("colorTemperature", 6500.0, -1e9, 1e9)?;
        if !is_set(record, "enableColorTemperature", "0")? {
            return Ok([1.0; 3]);
        }
        let last = BLACK_BODIES.len() - 1;
        let place = ((kelvin - 1000.0) / 500.0).clamp(0.0, last as f64);
        let (start, part) = (place as usize, place.fract());
        // Its ends are repeated.
        let knots =
            [start.saturating_sub(1), start, start + 1, start + 2].map(|at| BLACK_BODIES[at.min(last)]);
        let color = [0, 1, 2].map(|channel| {
            let [a, b, c, d] = knots.map(|knot| knot[channel]);
            let cubic = [b, (c - a) / 2.0, a - 2.5 * b + 2.0 * c - d / 2.0, 1.5 * (b - c) + (d - a) / 2.0];
            cubic.into_iter().rev().fold(0.0, |sum, own| sum * part + own)
        });
        let luminance = luminance(color);
        Ok(color.map(|channel| (channel / luminance).max(0.0)))
    }

    /// A sphere or a disk as a point, with the cone of its shaping: smoothstep in the angle, times the power `focus`
    /// of the cosine. A sphere without shaping, whose cone has 180 degrees, is a point light.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let is_disk = record.word("disk", "0") == "1";
        let radius = record.within("radius", 0.5, 0.0, 1e9)?;
        // A sphere of this radiance looks like a disk of its cross section from everywhere.
        let size = match (is_set(record, "normalize", "0")?, is_set(record, "treatAsPoint", "0")?) {
            (true, _) if is_disk => 1.0,
            (true, _) => 0.25,
            (false, true) if radius == 0.0 => 1.0,
            (false, _) => PI * radius * radius,
        };
        let intensity = exposed(record, "intensity", 1.0)? * size;
        if radius > 0.0 {
            record.note(format!(
                "a source of radius {radius} became a point: only surfaces that face it get the same light nearby"
            ));
        }
        let focus = record.within("shaping:focus", 0.0, 0.0, 1024.0)? + f64::from(u8::from(is_disk));
        let angle = record.within("shaping:cone:angle", if is_disk { 90.0 } else { 180.0 }, 0.0, 180.0)?;
        let softness = record.within("shaping:cone:softness", 0.0, 0.0, 1.0)?;
        if focus == 0.0 && softness == 0.0 && within(angle, 180.0, 180.0).is_some() {
            record.kind = Kind::Point;
        }
        if record.kind == Kind::Point {
            return Spot::new(record, no_cone()?, intensity, InverseSquare);
        }
        let lowest = if focus > 0.0 { angle.min(90.0) } else { within(angle, 0.0, 90.0).unwrap_or(angle) };
        if !(lowest > 0.0 && lowest <= 90.0) {
            let expected = "over 0 and at most 90 degrees (half angle), or 180 for a point light: the kernel's spotlights end \
                            at 90 degrees off the axis";
            return Err(Refusal::new("shaping:cone:angle", angle, expected));
        }
        let (outer, edge) = (lowest.to_radians(), angle.to_radians());
        let start = edge * (1.0 - softness);
        let shaped = |angle: f64| {
            let t = if edge > start { ((edge - angle) / (edge - start)).clamp(0.0, 1.0) } else { 1.0 };
            t * t * (3.0 - 2.0 * t) * if focus > 0.0 { angle.cos().max(0.0).powf(focus) } else { 1.0 }
        };
        if focus == 0.0 && start >= edge {
            return Spot::new(record, cone(Step.into(), outer, outer)?, intensity, InverseSquare);
        }
        let inner = if focus > 0.0 { 0.0 } else { start.min(outer) };
        let (cone, difference) = record.tables.cone(inner, outer, [edge, start, focus], &shaped)?;
        Ok(Spot::new(record, cone, intensity, InverseSquare)?.with_angle(difference))
    }

    fn sun(&self, record: &mut Record) -> Result<f64, Refusal> {
        // The sun is a disk of this full angle; with `normalize`, the intensity is the irradiance.
        let sine = (record.within("angle", 0.53, 0.0, 180.0)? / 2.0).to_radians().sin();
        let brightness = exposed(record, "intensity", 50_000.0)?;
        let is_irradiance = is_set(record, "normalize", "0")? || sine == 0.0;
        Ok(if is_irradiance { brightness } else { brightness * PI * sine * sine })
    }

    /// A dome of this luminance all around, of which the half above a surface lights it.
    fn ambient(&self, record: &mut Record) -> Result<f64, Refusal> {
        Ok(PI * exposed(record, "intensity", 1.0)?)
    }

    fn writer(&self) -> Option<&'static dyn Writer> {
        Some(&Self)
    }
}

impl Writer for Usd {
    fn family(&self) -> Family {
        Family::SmoothAngle
    }

    fn fall(&self, _: &Law) -> Fall {
        Fall::Decay { decay: 2.0, range: None, window: 2 }
    }

    fn cone(&self, [outer, inner, _]: Free) -> Rows {
        vec![row("shaping:cone:angle", outer.to_degrees()), row("shaping:cone:softness", 1.0 - inner / outer)]
    }

    fn rest(&self, light: &Written) -> Rows {
        vec![row("normalize", 1.0), row("radius", 0.01), row("intensity", 4.0 * light.candela)]
    }

    fn sun(&self, irradiance: f64, _: Use) -> Rows {
        vec![row("normalize", 1.0), row("intensity", irradiance)]
    }

    fn profile(&self) -> Option<&'static str> {
        Some(
            "a stage has the intensities themselves in a file beside it, `shaping:ies:file`: `--output FILE.usda` writes both",
        )
    }
}
