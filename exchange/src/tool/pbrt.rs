//! pbrt versions 3 and 4: half angles in degrees.

use std::f64::consts::PI;

use luminaire::attenuation::InverseSquare;
use luminaire::falloff::{AnyFalloff, IntegerPower, Smooth};

use super::{HALF_DEGREES, Scene, Spot, Tool, black_body, cone, half, luminance};
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
        (if matches!(kind, Kind::Directional | Kind::Ambient) { "L" } else { "I" }, f64::MIN_POSITIVE)
    }

    /// `blackbody`: a temperature in version 4, of luminance 1 (`SpectrumToPhotometric` in `lights.cpp`); in version 3
    /// pairs of a temperature and a factor, of a spectrum whose largest value is 1 (`BlackbodyNormalized`).
    fn white(&self, record: &mut Record) -> Result<[f64; 3], Refusal> {
        let Some(numbers) = record.numbers("blackbody")? else { return Ok([1.0; 3]) };
        let refused = |expected| Refusal::new("blackbody", format!("{numbers:?}"), expected);
        let range = [1e3, 15e3];
        let body = |kelvin: f64| {
            let known = (range[0]..=range[1]).contains(&kelvin);
            if known { black_body(kelvin, range) } else { Err(refused("kelvin from 1000 to 15000")) }
        };
        match *numbers {
            [kelvin] => body(kelvin),
            [kelvin, factor] => Ok(body(kelvin)?.map(|channel| channel * factor * normalized(kelvin))),
            _ => Err(refused("a temperature, or a temperature and a factor")),
        }
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

    /// The luminance all around, of which the half above a surface lights it.
    fn ambient(&self, record: &mut Record) -> Result<f64, Refusal> {
        Ok(PI * scale(record, ["L", "illuminance"], PI)?)
    }
}

/// Returns the luminance of a black body's spectrum over that of a constant spectrum of its largest value, with the
/// CIE's observer of 1931 as C. Wyman and others fit it (*Simple analytic approximations to the CIE XYZ color
/// matching functions*, JCGT 2, 2013).
fn normalized(kelvin: f64) -> f64 {
    // Planck's law over its largest value, at a wavelength in nanometres (Wien).
    const SECOND: f64 = 1.438_777e7;
    const WIEN: f64 = 2.897_772e6;
    let planck = |wavelength: f64| 1.0 / (wavelength.powi(5) * (SECOND / (wavelength * kelvin)).exp_m1());
    let lobe = |wavelength: f64, [height, middle, below, above]: [f64; 4]| {
        let width = if wavelength < middle { below } else { above };
        height * (-0.5 * ((wavelength - middle) / width).powi(2)).exp()
    };
    let seen = |wavelength: f64| {
        lobe(wavelength, [0.821, 568.8, 46.9, 40.5]) + lobe(wavelength, [0.286, 530.9, 16.3, 31.1])
    };
    let wavelengths = || (360..=830).map(f64::from);
    let most = planck(WIEN / kelvin);
    let lit: f64 = wavelengths().map(|at| seen(at) * planck(at) / most).sum();
    lit / wavelengths().map(seen).sum::<f64>()
}

/// Returns the factor of a light on its colour: `scale`, or what gives a luminous flux or an illuminance over a solid
/// angle.
fn scale(record: &mut Record, [color, photometric]: [&str; 2], solid: f64) -> Result<f64, Refusal> {
    let scale = record.get("scale", 1.0)?;
    // In pbrt, 0 is none, and the number is that of the luminance.
    let Some(total) = record.optional(photometric)?.filter(|total| *total > 0.0) else { return Ok(scale) };
    Ok(scale * total / (solid * luminance(record.triple(color, [1.0; 3])?)))
}
