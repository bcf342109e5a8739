//! Godot 3 and 4: a half angle in degrees, and an energy in units of full scale.

use std::f64::consts::PI;

use luminaire::falloff::{AnyFalloff, Hard, InvertedIntegerPower, InvertedRealPower, Linear};

use super::{
    Fall, HALF_DEGREES, Law, Rows, Scene, Spot, Tool, Writer, Written, black_body, cone, decay, half, row,
};
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::read;
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::text::decode;

pub(crate) struct Godot;

/// The strengths of a project with physical light units. A scene does not say whether its project has them; a
/// light has these values if it has.
const PHYSICAL: [&str; 2] = ["light_intensity_lumens", "light_intensity_lux"];

/// Returns the energy, with physical light units as candela or lux before the exposure of a camera. Godot spreads
/// the lumens of a spotlight over pi steradians, whatever its angle (`light_storage.cpp`).
fn energy(record: &mut Record) -> Result<f64, Refusal> {
    let energy = record.within("light_energy", 1.0, 0.0, 1e9)?;
    let (key, parts) = match record.kind {
        Kind::Directional | Kind::Ambient => (PHYSICAL[1], 1.0),
        Kind::Point => (PHYSICAL[0], 4.0 * PI),
        Kind::Spot => (PHYSICAL[0], PI),
    };
    let Some(strength) = record.optional(key)? else { return Ok(energy) };
    record.note(format!("`{key}` counts, as with physical light units: the intensity is photometric"));
    Ok(energy * strength / parts)
}

/// The least part of the versine.
const FLOOR: f32 = 1e-4;

impl Tool for Godot {
    fn scene(&self) -> Option<Scene> {
        Some(|bytes| read::godot::read(&decode(bytes)?))
    }

    fn prepare(&self, record: &mut Record) {
        if record.has("omni_range") || record.has("omni_attenuation") {
            record.kind = Kind::Point;
        }
    }

    /// A black body whose strongest channel is 1 (`_color_from_temperature` in `light_3d.cpp`), with the physical
    /// light units of a project.
    fn white(&self, record: &mut Record) -> Result<[f64; 3], Refusal> {
        let given = record.optional("light_temperature")?;
        if given.is_none() && !PHYSICAL.iter().any(|key| record.has(key)) {
            return Ok([1.0; 3]);
        }
        let white = black_body(given.unwrap_or(6500.0), [1e3, 15e3])?;
        let strongest = white.into_iter().fold(0.0, f64::max);
        Ok(white.map(|channel| channel / strongest))
    }

    /// `1 - max(0.0001, u)^p` with the versine `u` and `p = 1 / spot_angle_attenuation`, and
    /// `max(d, 0.0001)^-spot_attenuation` with the window `(1 - (d/r)^4)^2` (`scene_forward_lights_inc.glsl` and
    /// `light_storage.cpp`).
    ///
    /// An integer p gives `1 - u^p`, which differs by `0.0001^p` on the axis. For any other p the falloff keeps the
    /// `max`, and the intensity is scaled to Godot's value on the axis. With exponent 2 the light keeps growing at
    /// distances below 0.0001.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let is_point = record.kind == Kind::Point;
        let [range, attenuation] =
            if is_point { ["omni_range", "omni_attenuation"] } else { ["spot_range", "spot_attenuation"] };
        let outer = half(record, "spot_angle", 45.0, HALF_DEGREES)?;
        // Godot computes this reciprocal when it fills its light buffer.
        let power = 1.0 / record.within("spot_angle_attenuation", 1.0, 1.0 / 128.0, 128.0)? as f32;
        let range = record.within(range, 5.0, 0.001, 1e9)? as f32;
        let exponent = record.within(attenuation, 1.0, 0.0, 16.0)?;
        let energy = energy(record)?;

        let lost = f64::from(FLOOR).powf(power.into());
        let whole = power as u32;
        let (falloff, angle, on_axis): (AnyFalloff, _, _) = match whole {
            _ if whole as f32 != power => {
                (InvertedRealPower::with_floor(power, FLOOR)?.into(), 0.0, 1.0 - lost)
            }
            1 => (Linear.into(), lost, 1.0),
            2 => (Hard.into(), lost, 1.0),
            _ => (InvertedIntegerPower::new(whole)?.into(), lost, 1.0),
        };
        let (attenuation, distance) = decay(exponent, 1e4_f64.powf(exponent), Some(range))?;
        let spot = Spot::new(record, cone(falloff, 0.0, outer)?, energy * on_axis, attenuation)?;
        Ok(spot.with_angle(1.001 * angle).with_distance(distance))
    }

    fn sun(&self, record: &mut Record) -> Result<f64, Refusal> {
        energy(record)
    }

    /// The ambient light of an environment (`light_storage.cpp` and the uniforms of a scene).
    fn ambient(&self, record: &mut Record) -> Result<f64, Refusal> {
        record.within("ambient_light_energy", 1.0, 0.0, 1e9)
    }

    fn writer(&self) -> Option<&'static dyn Writer> {
        Some(&Self)
    }
}

impl Writer for Godot {
    fn family(&self) -> Family {
        Family::Inverted { least: FLOOR.into() }
    }

    fn fall(&self, law: &Law) -> Fall {
        Fall::Decay { decay: law.decay(), range: law.always(), window: 2 }
    }

    fn cone(&self, [outer, _, exponent]: Free) -> Rows {
        vec![row("spot_angle", outer.to_degrees()), row("spot_angle_attenuation", 1.0 / exponent)]
    }

    fn rest(&self, light: &Written) -> Rows {
        let [decay, range] = light.fall.decay();
        let [far, attenuation] = if light.is_point {
            ["omni_range", "omni_attenuation"]
        } else {
            ["spot_range", "spot_attenuation"]
        };
        vec![row(far, range), row(attenuation, decay), row("light_energy", light.shown())]
    }

    fn sun(&self, irradiance: f64, usage: Use) -> Rows {
        vec![row("light_energy", irradiance / usage.full_scale)]
    }
}
