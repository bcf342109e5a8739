//! The tools that describe a light by numbers: a file for each, with all that is known of it.
//!
//! A [`Tool`] turns the values of a record, by the names, units and defaults of the tool, into a spotlight; a point
//! light is that spotlight without its cone. A [`Writer`] turns a light into such values.

pub(crate) mod babylon;
pub(crate) mod bevy;
pub(crate) mod blender;
pub(crate) mod direct3d;
pub(crate) mod gltf;
pub(crate) mod godot;
pub(crate) mod opengl;
pub(crate) mod pbrt;
pub(crate) mod three;
pub(crate) mod unity;
pub(crate) mod unreal;
pub(crate) mod usd;
pub(crate) mod x3d;

use std::f64::consts::{FRAC_PI_2, PI};

use luminaire::attenuation::{
    AnyAttenuation, CutAt, Decay, FilamentRange, InverseSquare, NoAttenuation, Polynomial, Windowed,
};
use luminaire::falloff::{AnyFalloff, Soft, Step};
use luminaire::{Cone, Rgb, SpotLight, Vec3};

use crate::difference::Difference;
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::read::Found;
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::versine::{full, of_versine, versine};

/// Reads the lights of a scene.
pub(crate) type Scene = fn(&[u8]) -> Result<Found, Refusal>;

/// A tool whose lights are read.
pub(crate) trait Tool {
    /// Whether intensities are in candela, or in lumens that become candela.
    fn is_photometric(&self) -> bool {
        false
    }

    /// What reads the lights of a scene in the tool's files, if there are such files.
    fn scene(&self) -> Option<Scene> {
        None
    }

    /// Returns the kind of a light whose numbers leave it open.
    fn kind(&self, _: &Record) -> Kind {
        Kind::Spot
    }

    /// Returns the values of a record in the names that the others of this trait read, and its kind.
    fn prepare(&self, _: &mut Record) {}

    /// Returns the name of the colour, and the value of its channels that leaves the intensity unchanged.
    fn color(&self, _: Kind) -> (&'static str, f64) {
        ("color", 1.0)
    }

    /// Returns the white of the light's colour temperature, as the tool has it: its colour is multiplied by it.
    fn white(&self, _: &mut Record) -> Result<[f64; 3], Refusal> {
        Ok([1.0; 3])
    }

    /// Returns the light of a record as a spotlight, whatever its kind: a point light is that without its cone.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal>;

    /// Returns the irradiance of a directional light on a facing surface.
    fn sun(&self, record: &mut Record) -> Result<f64, Refusal> {
        record.get("intensity", 1.0)
    }

    /// Returns the irradiance of ambient light.
    fn ambient(&self, _: &mut Record) -> Result<f64, Refusal> {
        let expected = "spot, point or directional: ambient light of this tool is not read";
        Err(Refusal::new("kind", "ambient", expected))
    }

    /// What writes a light for the tool, if that is possible.
    fn writer(&self) -> Option<&'static dyn Writer> {
        None
    }
}

/// A tool that parameters of a light can be written for.
pub(crate) trait Writer {
    /// The falloff over the angle.
    fn family(&self) -> Family;

    /// The widest half angle in radians that the tool does not clamp.
    fn widest(&self) -> f64 {
        FRAC_PI_2
    }

    /// Returns the law of the tool for a light: that with the least difference.
    fn fall(&self, law: &Law) -> Fall;

    /// Returns the values of the cone.
    fn cone(&self, free: Free) -> Rows;

    /// Returns the values beside the cone.
    fn rest(&self, light: &Written) -> Rows;

    /// Returns the values of a directional light of this irradiance.
    fn sun(&self, irradiance: f64, usage: Use) -> Rows {
        vec![row("intensity", irradiance / usage.full_scale)]
    }

    /// Returns how the tool reads a photometric file itself, in a sentence.
    fn profile(&self) -> Option<&'static str> {
        None
    }

    /// Returns what to know of the tool, a sentence each.
    fn notes(&self, _: Use) -> Vec<&'static str> {
        Vec::new()
    }
}

/// Values of a tool by their names.
pub(crate) type Rows = Vec<(&'static str, String)>;

/// Returns a value with seven digits, without an exponent and without zeros at the end.
pub(crate) fn row(name: &'static str, value: f64) -> (&'static str, String) {
    let digits = (6.0 - value.abs().max(1e-12).log10().floor()).clamp(0.0, 12.0) as usize;
    let text = format!("{value:.digits$}");
    let is_fraction = text.contains('.');
    (name, if is_fraction { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text })
}

/// The law of a light over the distance, which a tool is to show.
pub(crate) struct Law {
    /// The name in the list of the kernel.
    pub(crate) name: &'static str,
    pub(crate) numbers: Vec<f64>,
    pub(crate) range: Option<f64>,
    /// The distance of the surface that counts.
    pub(crate) throw: f64,
}

impl Law {
    /// Returns the law as a power of the distance, the inverse square for what is none.
    fn decay(&self) -> f64 {
        match self.name {
            "constant" => 0.0,
            "decay" => self.numbers[0],
            _ => 2.0,
        }
    }

    /// Returns the law as one over a polynomial, the inverse square for what is none.
    fn polynomial(&self) -> [f64; 3] {
        match self.name {
            "constant" => [1.0, 0.0, 0.0],
            "polynomial" => [self.numbers[0], self.numbers[1], self.numbers[2]],
            _ => [0.0, 0.0, 1.0],
        }
    }

    /// Returns the range for a tool that cannot do without one: where there is none, one that takes less than 0.1
    /// codes at 2 throws.
    fn always(&self) -> Option<f64> {
        self.range.or(Some(20.0 * self.throw))
    }
}

/// The law of a tool over the distance.
#[derive(Clone, Copy)]
pub(crate) enum Fall {
    /// A power of the distance, times a power of `1 - (d/r)^4` if there is a range.
    Decay { decay: f64, range: Option<f64>, window: i32 },
    /// One over a polynomial, up to a range.
    Polynomial { coefficients: [f64; 3], range: Option<f64> },
}

impl Fall {
    /// Returns the attenuation factor at a distance.
    pub(crate) fn at(self, d: f64) -> f64 {
        match self {
            Self::Decay { decay, range, window } => {
                let window = range.map_or(1.0, |range| (1.0 - (d / range).powi(4)).max(0.0).powi(window));
                window * d.powf(-decay)
            }
            Self::Polynomial { range: Some(range), .. } if d > range => 0.0,
            Self::Polynomial { coefficients: [constant, linear, quadratic], .. } => {
                1.0 / (constant + d * (linear + d * quadratic))
            }
        }
    }

    /// Returns the exponent of a power of the distance, and the range; 0 for none.
    fn decay(self) -> [f64; 2] {
        match self {
            Self::Decay { decay, range, .. } => [decay, range.unwrap_or_default()],
            Self::Polynomial { range, .. } => [2.0, range.unwrap_or_default()],
        }
    }

    /// Returns the coefficients of a polynomial.
    fn coefficients(self) -> [f64; 3] {
        if let Self::Polynomial { coefficients, .. } = self { coefficients } else { [0.0, 0.0, 1.0] }
    }
}

/// A light in the numbers that tools share.
pub(crate) struct Written {
    /// The intensity on the axis, at distance 1 by the law.
    pub(crate) candela: f64,
    pub(crate) fall: Fall,
    pub(crate) usage: Use,
    pub(crate) is_point: bool,
}

impl Written {
    /// Returns the intensity in units of full scale.
    fn shown(&self) -> f64 {
        self.candela / self.usage.full_scale
    }
}

/// A light that was read, as a spotlight, and its difference from the original.
pub(crate) struct Spot {
    pub(crate) light: SpotLight<AnyFalloff, AnyAttenuation>,
    pub(crate) difference: Difference,
}

impl Spot {
    /// Creates the light of a record without a difference.
    pub(crate) fn new(
        record: &Record,
        cone: Cone<AnyFalloff>,
        intensity: f64,
        attenuation: impl Into<AnyAttenuation>,
    ) -> Result<Self, Refusal> {
        let light = SpotLight::new(vector(record.position), vector(record.axis), cone)?
            .with_intensity(intensity as f32)?
            .with_attenuation(attenuation.into());
        Ok(Self { light, difference: Difference::default() })
    }

    /// Returns the light with this difference over the angle.
    pub(crate) fn with_angle(self, difference: f64) -> Self {
        Self { difference: Difference { angle: difference.min(1.0) as f32, ..self.difference }, ..self }
    }

    /// Returns the light with this difference over the distance.
    pub(crate) fn with_distance(self, difference: f64) -> Self {
        Self { difference: Difference { distance: difference.min(1.0) as f32, ..self.difference }, ..self }
    }
}

/// Returns a vector for the kernel.
pub(crate) fn vector(v: glam::DVec3) -> Vec3<f32> {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}

/// Returns whether a value is set to true.
fn is_set(record: &mut Record, key: &str, default: &str) -> Result<bool, Refusal> {
    Ok(match record.word(key, default).to_ascii_lowercase().as_str() {
        "0" | "false" => false,
        "1" | "true" => true,
        other => return Err(Refusal::new(key, other, "0, 1, false or true")),
    })
}

/// Returns the luminance of a linear colour.
fn luminance([red, green, blue]: [f64; 3]) -> f64 {
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

/// Returns the light of a black body of luminance 1, of a temperature that the tool clamps.
fn black_body(kelvin: f64, [least, most]: [f64; 2]) -> Result<[f64; 3], Refusal> {
    Ok(<[f32; 3]>::from(Rgb::black_body(kelvin.clamp(least, most) as f32)?).map(f64::from))
}

/// Returns a strength times a power of 2.
fn exposed(record: &mut Record, key: &str, default: f64) -> Result<f64, Refusal> {
    Ok(record.get(key, default)? * record.within("exposure", 0.0, -64.0, 64.0)?.exp2())
}

/// Returns a cone with full intensity up to a half angle in radians, and a step if nothing is left for a
/// falloff.
fn cone(falloff: AnyFalloff, inner: f64, outer: f64) -> Result<Cone<AnyFalloff>, Refusal> {
    if full(inner) >= full(outer) {
        return Ok(Cone::from_outer(AnyFalloff::from(Step), full(outer))?);
    }
    let cone = Cone::from_outer(falloff, full(outer))?;
    Ok(if inner > 0.0 { cone.with_inner(full(inner))? } else { cone })
}

/// Returns any cone, for a light that has none.
fn no_cone() -> Result<Cone<AnyFalloff>, Refusal> {
    cone(Soft.into(), 0.0, FRAC_PI_2)
}

/// Returns the cone of the square of a line in the cosine, which the tool divides by at least `least`,
/// and what this leaves on the axis of a narrow beam.
fn square(inner: f64, outer: f64, least: f64) -> Result<(Cone<AnyFalloff>, f64), Refusal> {
    let edge = versine(outer);
    let start = edge - (edge - versine(inner.min(outer))).max(least);
    let on_axis = if start < 0.0 { (edge / least).powi(2) } else { 1.0 };
    Ok((cone(Soft.into(), of_versine(start.max(0.0)), outer)?, on_axis))
}

/// The units of a cone: its name, and what turns a number into a half angle in radians.
type Unit = (&'static str, f64);
const HALF_RADIANS: Unit = ("radians (half angle)", 1.0);
const FULL_RADIANS: Unit = ("radians (full angle)", 0.5);
const HALF_DEGREES: Unit = ("degrees (half angle)", PI / 180.0);
const FULL_DEGREES: Unit = ("degrees (full angle)", PI / 360.0);

/// Pi, whose seven digits are no more than it.
const HALF_TURN: f64 = PI - 6e-7;

/// Returns a half angle in radians of a value, at most 90 degrees.
fn half(record: &mut Record, key: &str, default: f64, (name, unit): Unit) -> Result<f64, Refusal> {
    let (most, value) = (FRAC_PI_2 / unit, record.get(key, default)?);
    // The last digit of a right angle that was written with few of them.
    if value > 0.0 && value <= most * (1.0 + 1e-6) {
        return Ok((value * unit).min(FRAC_PI_2));
    }
    let expected = format!(
        "over 0 and at most {} {name}: the kernel's spotlights end at 90 degrees off the axis",
        (most * 1e6).round() / 1e6
    );
    let degrees = value.to_radians();
    let remedy = if unit >= 0.5 && degrees > 0.0 && degrees <= most {
        format!("; {value} degrees are {degrees:.6} radians")
    } else {
        String::new()
    };
    Err(Refusal::new(key, value, expected + &remedy))
}

/// The largest factor of an attenuation in the kernel, 2^64.
const BRIGHTEST: f64 = 18_446_744_073_709_551_616.0;

/// Returns the attenuation `d^-exponent`, at most `most`, with the window `(1 - (d/r)^4)^2` for a range, and its
/// largest relative difference: the inverse square has no cap, and no law has one over 2^64.
fn decay(exponent: f64, most: f64, range: Option<f32>) -> Result<(AnyAttenuation, f64), Refusal> {
    if exponent == 0.0 {
        return Ok((Windowed::new(NoAttenuation, range)?.into(), 0.0));
    }
    if exponent == 2.0 {
        return Ok((FilamentRange::new(InverseSquare, range)?.into(), 0.0));
    }
    let held = most.min(BRIGHTEST);
    let law = Windowed::new(Decay::new(exponent as f32, held as f32)?, range)?;
    // At the nearest distance that `Difference` compares.
    let nearest = f64::from(range.unwrap_or(16.0)) / 16.0;
    let original = nearest.powf(-exponent).min(most);
    Ok((law.into(), 1.001 * (1.0 - held / original.max(held))))
}

/// Returns the attenuation `1 / (a0 + a1 d + a2 d^2)`, uncapped, and its factor on the intensity.
///
/// If the constant `a0` is small or 0, points at a distance below 0.001 get the light of a point at distance 0.001.
fn polynomial(
    record: &mut Record,
    keys: [&str; 3],
    defaults: [f64; 3],
    range: Option<f32>,
) -> Result<(AnyAttenuation, f64), Refusal> {
    const MOST: f64 = 1e9;
    const NEAREST: f64 = 1e-3;
    let mut coefficients = [0.0; 3];
    for ((own, key), default) in coefficients.iter_mut().zip(keys).zip(defaults) {
        *own = record.within(key, default, 0.0, MOST)?;
    }
    let [constant, linear, quadratic] = coefficients;
    if coefficients.iter().all(|own| *own < 1e-6) {
        let value = format_args!("{constant}, {linear}, {quadratic}");
        return Err(Refusal::new(keys.join(", "), value, "one of at least 0.000001"));
    }
    Ok(if linear == 0.0 && quadratic == 0.0 {
        (CutAt::new(NoAttenuation, range)?.into(), 1.0 / constant)
    } else if constant == 0.0 && linear == 0.0 {
        (CutAt::new(InverseSquare, range)?.into(), 1.0 / quadratic)
    } else {
        // The kernel's polynomial is capped at 1. The coefficients and the intensity are scaled so that the
        // cap never applies.
        let has_constant = linear.max(quadratic) <= MOST * constant;
        let least = if has_constant { constant } else { constant + NEAREST * (linear + NEAREST * quadratic) };
        let [a, b, c] = coefficients.map(|own| (own / least) as f32);
        (CutAt::new(Polynomial::new(a, b, c)?, range)?.into(), 1.0 / least)
    })
}
