//! The lights of other tools, from their own numbers: one function a tool.
//!
//! A function reads the values of a record by the names, units and defaults of its tool, and returns a
//! spotlight; a point light is that spotlight without its cone. The kernel's own
//! [`import`] has the tools whose lights it holds exactly; the others are below.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use luminaire::attenuation::{
    AnyAttenuation, CutAt, FilamentRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, IntegerPower, Smooth, Soft, Step};
use luminaire::import::{self, Difference, Imported, OpenGlLight};
use luminaire::{Cone, DirectionalLight, PointLight, Rgb, SpotLight, Vec3};

use crate::lamp::Lamp;
use crate::limits::within;
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::system::System;
use crate::versine::{full, of_versine, versine};

type Spot = Imported<SpotLight<AnyFalloff, AnyAttenuation>>;

/// Returns the light of a record.
///
/// # Errors
/// A value that the tool does not accept or the kernel cannot hold, with the place of the record.
pub(crate) fn lamp(system: System, mut record: Record) -> Result<Lamp, Refusal> {
    let place = if record.place.is_empty() { record.name.clone() } else { record.place.clone() };
    let mut lamp = convert(system, &mut record).map_err(|refusal| refusal.at(place))?;
    // No value of a file is passed over in silence. Of the version, the reader has told what matters.
    let unused = record.unused().filter(|key| *key != "version");
    lamp.notes.extend(unused.map(|key| format!("`{key}` has no effect")));
    Ok(lamp)
}

/// Returns the light of a record whose place is known.
pub(crate) fn convert(system: System, record: &mut Record) -> Result<Lamp, Refusal> {
    let (key, least) = match (system, record.kind) {
        (System::Pbrt, Kind::Directional) => ("L", f64::MIN_POSITIVE),
        (System::Pbrt, _) => ("I", f64::MIN_POSITIVE),
        _ => ("color", 1.0),
    };
    let channels = record.triple(key, [1.0; 3])?;
    // A channel over 1 is more light, not another colour; in pbrt the channels are the intensity.
    let strongest = channels.into_iter().fold(least, f64::max);
    let [red, green, blue] = channels.map(|channel| (channel / strongest) as f32);
    let color = Rgb::new(red, green, blue);
    let (light, difference, intensity): (AnyLight, _, _) = if record.kind == Kind::Directional {
        let intensity = sun(system, record)?;
        (DirectionalLight::new(vector(record.axis))?.into(), Difference::default(), intensity)
    } else {
        let Imported { light, difference } = spotlight(system, record)?;
        let intensity = f64::from(light.intensity());
        if record.kind == Kind::Point {
            let point = PointLight::new(light.position())?.with_attenuation(light.attenuation());
            (point.into(), Difference { angle: 0.0, place: 0.0, ..difference }, intensity)
        } else {
            (light.into(), difference, intensity)
        }
    };
    let light = light.with_color(color)?.with_intensity((intensity * strongest) as f32)?;
    let notes = std::mem::take(&mut record.notes);
    Ok(Lamp { difference, notes, ..Lamp::new(&*record.name, light) })
}

/// Returns the light as a spotlight, whatever its kind: a point light is that without its cone.
fn spotlight(system: System, record: &mut Record) -> Result<Spot, Refusal> {
    match system {
        System::Gltf => gltf(record),
        System::Three => three(record),
        System::Godot => godot(record),
        System::OpenGl => opengl(record),
        System::Direct3d => direct3d(record),
        System::Blender => blender(record),
        System::Usd => usd(record),
        System::X3d => x3d(record),
        System::Pbrt => pbrt(record),
        System::Unreal => unreal(record),
        System::Unity => unity(record),
        System::Bevy => bevy(record),
        System::Babylon => babylon(record),
        System::Ies | System::Eulumdat | System::Gdtf | System::Ofl | System::Luminaire => {
            Err(Refusal::new("system", system, "a file of it, or a tool with numbers"))
        }
    }
}

/// Returns the irradiance of a directional light on a facing surface.
fn sun(system: System, record: &mut Record) -> Result<f64, Refusal> {
    match system {
        System::Usd => {
            // The sun is a disk of this full angle; with `normalize`, the intensity is the irradiance.
            let sine = (record.within("angle", 0.53, 0.0, 180.0)? / 2.0).to_radians().sin();
            let brightness = exposed(record, "intensity", 50_000.0)?;
            Ok(if is_set(record, "normalize", "0")? || sine == 0.0 {
                brightness
            } else {
                brightness * PI * sine * sine
            })
        }
        System::Godot => record.get("light_energy", 1.0),
        System::Bevy => record.get("illuminance", 10_000.0),
        System::Blender => exposed(record, "energy", 10.0),
        System::Pbrt => pbrt_scale(record, ["L", "illuminance"], 1.0),
        System::Unreal => record.get("Intensity", 10.0),
        _ => record.get("intensity", 1.0),
    }
}

fn vector(v: glam::DVec3) -> Vec3<f32> {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}

fn is_set(record: &mut Record, key: &str, default: &str) -> Result<bool, Refusal> {
    Ok(match record.word(key, default).to_ascii_lowercase().as_str() {
        "0" | "false" => false,
        "1" | "true" => true,
        other => return Err(Refusal::new(key, other, "0, 1, false or true")),
    })
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

fn spot(
    record: &Record,
    cone: Cone<AnyFalloff>,
    intensity: f64,
    attenuation: impl Into<AnyAttenuation>,
    angle: f64,
) -> Result<Spot, Refusal> {
    let light = SpotLight::new(vector(record.position), vector(record.axis), cone)?
        .with_intensity(intensity as f32)?;
    let difference = Difference { angle: angle.min(1.0) as f32, ..Difference::default() };
    Ok(Imported { light: light.with_attenuation(attenuation.into()), difference })
}

fn gltf(record: &mut Record) -> Result<Spot, Refusal> {
    let range = record.optional("range")?.map(|range| range as f32);
    let outer = half(record, "outerConeAngle", FRAC_PI_4, HALF_RADIANS)?;
    let light = import::Gltf {
        inner_cone_angle: record.near("innerConeAngle", 0.0, 0.0, outer)? as f32,
        outer_cone_angle: outer as f32,
        range,
        intensity: record.get("intensity", 1.0)? as f32,
    };
    Ok(light.import(vector(record.position), vector(record.axis))?)
}

fn three(record: &mut Record) -> Result<Spot, Refusal> {
    let light = import::Three {
        angle: half(record, "angle", PI / 3.0, HALF_RADIANS)? as f32,
        penumbra: record.near("penumbra", 0.0, 0.0, 1.0)? as f32,
        distance: record.get("distance", 0.0)? as f32,
        decay: record.near("decay", 2.0, 0.0, 16.0)? as f32,
        intensity: record.get("intensity", 1.0)? as f32,
    };
    Ok(light.import(vector(record.position), vector(record.axis))?)
}

fn godot(record: &mut Record) -> Result<Spot, Refusal> {
    let is_point = record.kind == Kind::Point;
    let [range, attenuation] =
        if is_point { ["omni_range", "omni_attenuation"] } else { ["spot_range", "spot_attenuation"] };
    let light = import::Godot {
        spot_angle: half(record, "spot_angle", 45.0, HALF_DEGREES)?.to_degrees() as f32,
        spot_angle_attenuation: record.near("spot_angle_attenuation", 1.0, 1.0 / 128.0, 128.0)? as f32,
        spot_range: record.get(range, 5.0)? as f32,
        spot_attenuation: record.near(attenuation, 1.0, 0.0, 16.0)? as f32,
        light_energy: record.get("light_energy", 1.0)? as f32,
    };
    Ok(light.import(vector(record.position), vector(record.axis))?)
}

fn opengl(record: &mut Record) -> Result<Spot, Refusal> {
    let cutoff = record.near("spot_cutoff", 180.0, 0.0, 90.0)?;
    let cutoff = within(cutoff, 180.0, 180.0).unwrap_or(cutoff);
    if cutoff == 180.0 {
        record.kind = Kind::Point;
    }
    let light = import::OpenGl {
        spot_cutoff: cutoff as f32,
        spot_exponent: record.near("spot_exponent", 0.0, 0.0, 1_024.0)? as f32,
        constant_attenuation: record.get("constant_attenuation", 1.0)? as f32,
        linear_attenuation: record.get("linear_attenuation", 0.0)? as f32,
        quadratic_attenuation: record.get("quadratic_attenuation", 0.0)? as f32,
        intensity: record.get("intensity", 1.0)? as f32,
    };
    let Imported { light, difference } = light.import(vector(record.position), vector(record.axis))?;
    Ok(match light {
        OpenGlLight::Spot(light) => Imported { light, difference },
        OpenGlLight::Point(point) => {
            let any = cone(Soft.into(), 0.0, FRAC_PI_2)?;
            spot(record, any, point.intensity().into(), point.attenuation(), 0.0)?
        }
    })
}

fn direct3d(record: &mut Record) -> Result<Spot, Refusal> {
    let mut coefficient = |key| record.get(key, 0.0).map(|number| number as f32);
    let attenuation0 = coefficient("attenuation0")?;
    let attenuation1 = coefficient("attenuation1")?;
    let attenuation2 = coefficient("attenuation2")?;
    let phi = record.near("phi", 0.0, 0.0, PI)?;
    if [attenuation0, attenuation1, attenuation2] == [0.0; 3] {
        let expected = "one that is not 0. A zeroed D3DLIGHT9 divides by 0: runtimes show nothing or the full \
                        light at every distance; for the second give attenuation0=1";
        return Err(Refusal::new("attenuation0, attenuation1, attenuation2", "0, 0, 0", expected));
    }
    if record.kind == Kind::Spot && phi == 0.0 {
        let expected = "the full outer angle in radians, such as phi=1. With a zeroed Phi there is no light \
                        but on the axis itself";
        return Err(Refusal::new("phi", 0, expected));
    }
    let phi = if record.kind == Kind::Spot { phi } else { 1.0 };
    let light = import::Direct3d {
        theta: record.near("theta", 0.0, 0.0, phi)? as f32,
        phi: phi as f32,
        falloff: record.near("falloff", 1.0, 0.0, 1_024.0)? as f32,
        attenuation0,
        attenuation1,
        attenuation2,
        range: record.get("range", f64::from(f32::MAX).sqrt())? as f32,
        intensity: record.get("intensity", 1.0)? as f32,
    };
    Ok(light.import(vector(record.position), vector(record.axis))?)
}

/// Blender's spotlight (`spot_light_attenuation` of Cycles and EEVEE): smoothstep over the versine, from
/// the edge to `1 - blend` of its versine.
fn blender(record: &mut Record) -> Result<Spot, Refusal> {
    let outer = half(record, "spot_size", PI / 4.0, FULL_RADIANS)?;
    let blend = record.within("spot_blend", 0.15, 0.0, 1.0)?;
    let inner = of_versine((1.0 - blend) * versine(outer));
    // The flux of a point light of this power, whatever the cone lets through.
    let intensity = exposed(record, "energy", 10.0)? / (4.0 * PI);
    record.note(
        "the intensity is in watts per steradian; Blender's exporter of glTF multiplies by 683 for candela",
    );
    let radius = record.within("shadow_soft_size", 0.0, 0.0, 1e6)?;
    let mut imported = spot(record, cone(Smooth.into(), inner, outer)?, intensity, InverseSquare, 0.0)?;
    // With its soft falloff, Blender divides by `d^2 + r^2`; at distance 1 the difference is the largest.
    imported.difference.distance = (radius * radius / (1.0 + radius * radius)) as f32;
    Ok(imported)
}

/// Returns a strength times a power of 2.
fn exposed(record: &mut Record, key: &str, default: f64) -> Result<f64, Refusal> {
    Ok(record.get(key, default)? * record.within("exposure", 0.0, -64.0, 64.0)?.exp2())
}

/// A sphere or a disk of UsdLux as a point, with the cone of its shaping: smoothstep in the angle, times
/// the power `focus` of the cosine.
fn usd(record: &mut Record) -> Result<Spot, Refusal> {
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
    if record.kind == Kind::Point {
        let any = cone(Soft.into(), 0.0, FRAC_PI_2)?;
        return spot(record, any, intensity, InverseSquare, 0.0);
    }
    let lowest = if focus > 0.0 { angle.min(90.0) } else { within(angle, 0.0, 90.0).unwrap_or(angle) };
    if !(lowest > 0.0 && lowest <= 90.0) {
        let expected = "over 0 and at most 90 degrees (half angle), or 180 for none: the kernel's spotlights end \
                        at 90 degrees off the axis";
        return Err(Refusal::new("shaping:cone:angle", angle, expected));
    }
    let (outer, edge) = (lowest.to_radians(), angle.to_radians());
    let softness = record.within("shaping:cone:softness", 0.0, 0.0, 1.0)?;
    let start = edge * (1.0 - softness);
    let shaped = |angle: f64| {
        let t = if edge > start { ((edge - angle) / (edge - start)).clamp(0.0, 1.0) } else { 1.0 };
        t * t * (3.0 - 2.0 * t) * if focus > 0.0 { angle.cos().max(0.0).powf(focus) } else { 1.0 }
    };
    if focus == 0.0 && start >= edge {
        return spot(record, cone(Step.into(), outer, outer)?, intensity, InverseSquare, 0.0);
    }
    let inner = if focus > 0.0 { 0.0 } else { start.min(outer) };
    let (cone, difference) = record.tables.cone(inner, outer, [edge, start, focus], &shaped)?;
    spot(record, cone, intensity, InverseSquare, difference)
}

/// The spotlight of X3D and VRML97 (ISO/IEC 19775-1, 17.4.3): linear in the angle, and a step if the beam
/// is wider than the cut-off.
fn x3d(record: &mut Record) -> Result<Spot, Refusal> {
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
    let range = record.within("radius", 100.0, 0.0, 1e9)? as f32;
    let intensity = record.get("intensity", 1.0)?;
    // The sum is at least 1, as a browser has it; a constant of 0 is what it is capped from.
    let attenuation: AnyAttenuation = if b == 0.0 && c == 0.0 && a <= 1.0 {
        CutAt::new(NoAttenuation, Some(range))?.into()
    } else {
        CutAt::new(Polynomial::new(a as f32, b as f32, c as f32)?, Some(range))?.into()
    };
    if record.kind == Kind::Point {
        return spot(record, cone(Soft.into(), 0.0, FRAC_PI_2)?, intensity, attenuation, 0.0);
    }
    if beam >= outer {
        return spot(record, cone(Step.into(), outer, outer)?, intensity, attenuation, 0.0);
    }
    let inner = beam.max(0.0);
    let fall = |angle: f64| (outer - angle) / (outer - inner);
    let (cone, difference) = record.tables.cone(inner, outer, [0.0; 3], &fall)?;
    spot(record, cone, intensity, attenuation, difference)
}

/// Returns the factor of a light of pbrt on its colour: `scale`, or what gives a luminous flux or an
/// illuminance over a solid angle.
fn pbrt_scale(record: &mut Record, [color, photometric]: [&str; 2], solid: f64) -> Result<f64, Refusal> {
    let scale = record.get("scale", 1.0)?;
    // In pbrt, 0 is none, and the number is that of the luminance.
    let Some(total) = record.optional(photometric)?.filter(|total| *total > 0.0) else { return Ok(scale) };
    let [red, green, blue] = record.triple(color, [1.0; 3])?;
    Ok(scale * total / (solid * (0.2126 * red + 0.7152 * green + 0.0722 * blue)))
}

/// The spotlight of pbrt: smoothstep in the cosine in version 4, the fourth power of a line in version 3.
fn pbrt(record: &mut Record) -> Result<Spot, Refusal> {
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
    let intensity = pbrt_scale(record, ["I", "power"], solid)?;
    spot(record, cone, intensity, InverseSquare, 0.0)
}

/// Unreal's spotlight: the square of a line in the cosine, and the inverse square in centimetres with the
/// window `(1 - (d/r)^4)^2`.
fn unreal(record: &mut Record) -> Result<Spot, Refusal> {
    let inner = record.within("InnerConeAngle", 0.0, 0.0, 89.0)?.to_radians();
    let outer = half(record, "OuterConeAngle", 44.0, HALF_DEGREES)?;
    let outer = outer.clamp(inner + 0.001, 89_f64.to_radians() + 0.001);
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
    let mut imported = spot(record, cone(Soft.into(), inner, outer)?, intensity, attenuation, 0.0)?;
    // A centimetre squared is added to the square of the distance.
    let nearest = 100.0 * range / 16.0;
    imported.difference.distance = (1.0 / (nearest * nearest + 1.0)) as f32;
    Ok(imported)
}

/// The spotlight of Unity's Universal Render Pipeline: the square of a line in the cosine, full angles,
/// and the inverse square with the window `(1 - (d/r)^4)^2`.
fn unity(record: &mut Record) -> Result<Spot, Refusal> {
    let outer = half(record, "spotAngle", 30.0, FULL_DEGREES)?;
    let inner = record.within("innerSpotAngle", 21.802_08, 0.0, 180.0)?.to_radians() / 2.0;
    let range = record.within("range", 10.0, 0.001, 1e9)? as f32;
    // The unit in which the inspector shows the intensity; the shaders have none.
    record.word("lightUnit", "0");
    let intensity = record.get("intensity", 1.0)?;
    record.note(
        "Unity: from the shaders of its Universal Render Pipeline, not checked against a running engine",
    );
    let attenuation = FilamentRange::new(InverseSquare, Some(range))?;
    let (cone, on_axis) = square(inner, outer, 0.001)?;
    spot(record, cone, intensity * on_axis, attenuation, 0.0)
}

/// Bevy's spotlight: glTF's cone, and the flux of a point light of this intensity in lumens.
fn bevy(record: &mut Record) -> Result<Spot, Refusal> {
    let outer = half(record, "outer_angle", FRAC_PI_4, HALF_RADIANS)?;
    let inner = record.within("inner_angle", 0.0, 0.0, PI)?;
    let range = record.within("range", 20.0, 0.001, 1e9)? as f32;
    let intensity = record.get("intensity", 1_000_000.0)? / (4.0 * PI);
    let attenuation = FilamentRange::new(InverseSquare, Some(range))?;
    let (cone, on_axis) = square(inner, outer, 1e-4)?;
    spot(record, cone, intensity * on_axis, attenuation, 0.0)
}

/// The three laws of Babylon's spotlight, which its materials choose: `standard`, `physical` and `gltf`.
fn babylon(record: &mut Record) -> Result<Spot, Refusal> {
    let outer = half(record, "angle", PI / 3.0, FULL_RADIANS)?;
    let range = record.optional("range")?.filter(|&range| range < 1e30).map(|range| range as f32);
    let given = record.get("intensity", 1.0)?;
    let mode = record.word("intensityMode", "0").to_ascii_lowercase();
    let intensity = match mode.as_str() {
        "0" | "2" | "automatic" | "luminousintensity" => given,
        "1" | "luminouspower" => given / (4.0 * PI),
        _ => return Err(Refusal::new("intensityMode", mode, "0 or 2 for candela, or 1 for lumens")),
    };
    let exponent = record.near("exponent", 2.0, 0.0, 1_024.0)?;
    let inner = record.get("innerAngle", 0.0)? / 2.0;
    let law = record.word("falloffType", "default").to_ascii_lowercase();
    match law.as_str() {
        "2" | "gltf" => {
            let attenuation = FilamentRange::new(InverseSquare, range)?;
            let (cone, on_axis) = square(inner, outer, 0.001)?;
            spot(record, cone, intensity * on_axis, attenuation, 0.0)
        }
        "1" | "physical" => {
            // 1 % at the edge of the cone, and light beyond it.
            let kappa = 100_f64.ln() / versine(outer);
            let glow = |angle: f64| (-kappa * versine(angle)).exp();
            let end = of_versine(65_535_f64.ln() / kappa);
            let (cone, difference) = record.tables.cone(0.0, end, [kappa, 0.0, 0.0], &glow)?;
            // What the law leaves behind 90 degrees off the axis is lost.
            spot(record, cone, intensity, InverseSquare, difference.max(glow(end)))
        }
        "0" | "3" | "default" | "standard" => {
            if law.starts_with(['0', 'd']) {
                record.note("the law is that of standard materials; physical ones show falloffType=1");
            }
            let light = import::OpenGl {
                spot_cutoff: outer.to_degrees() as f32,
                spot_exponent: exponent as f32,
                ..import::OpenGl::default()
            };
            let imported = light.import(vector(record.position), vector(record.axis))?;
            let OpenGlLight::Spot(light) = imported.light else {
                return Err(Refusal::new("angle", 2.0 * outer, "less than a full turn"));
            };
            let attenuation: AnyAttenuation = match range {
                None => NoAttenuation.into(),
                Some(range) => SmoothRange::new(range)?.into(),
            };
            let mut imported = spot(record, light.cone(), intensity, attenuation, 0.0)?;
            if range.is_some() {
                imported.difference.distance = 1.0;
                record.note(
                    "Babylon's standard materials fall off linearly to the range; the smoothstep in its place differs \
                     by up to 24.6 of 255 codes (at 0.21 and 0.79 of the range)",
                );
            }
            Ok(imported)
        }
        _ => Err(Refusal::new("falloffType", law, "default, physical, gltf or standard")),
    }
}
