//! Published light formulas of other tools, in f64, written from each tool's source, shader or
//! specification, and independent of the crates of this workspace.
//!
//! Each function returns the irradiance of a surface that faces the light. The arguments are the values
//! of the light by the names of the tool's files, the kind of the light, the angle off the axis in radians
//! from 0 to pi, and the distance in the tool's unit of length. A value that is not given has the tool's
//! default; where the tool has none, the result is NaN. White light is assumed, and a light of no size.
//!
//! The unit is that of the tool: lux where the intensity is photometric, W/m^2 in Blender, and a plain
//! factor in Godot, OpenGL, Direct3D 9, X3D, Unity and the standard material of Babylon.js. A white
//! diffuse surface shows the irradiance divided by pi in glTF, three.js, Blender, USD, pbrt, Unreal,
//! Bevy and the PBR material of Babylon.js, and the irradiance itself in the others.
#![allow(dead_code, reason = "each test uses some of the formulas")]

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, PI};

macro_rules! named {
    ($($name:ident),+) => { [$((stringify!($name), $name as Formula)),+] };
}

/// The kind of a light.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    Spot,
    Point,
    Directional,
}

/// Irradiance from values, kind, angle off the axis in radians, and distance.
pub(crate) type Formula = fn(&[(&str, f64)], Kind, f64, f64) -> f64;

/// The formulas by the names of their tools.
pub(crate) const FORMULAS: [(&str, Formula); 13] =
    named!(gltf, three, godot, opengl, direct3d, blender, usd, x3d, pbrt, unreal, unity, bevy, babylon);

/// Returns the values in the order of the defaults.
///
/// # Panics
/// A value whose name has no default here.
fn read<const N: usize>(values: &[(&str, f64)], defaults: [(&str, f64); N]) -> [f64; N] {
    for (name, _) in values {
        assert!(defaults.iter().any(|default| default.0 == *name), "{name}: expected a value of the tool");
    }
    defaults
        .map(|(name, default)| values.iter().rfind(|value| value.0 == name).map_or(default, |value| value.1))
}

/// Binds the values of a light: `variable: "name in the tool" = default`.
macro_rules! light {
    ($values:ident; $($variable:ident: $name:literal = $default:expr),+) => {
        let [$($variable),+] = read($values, [$(($name, $default)),+]);
    };
}

/// Limits a value to [0, 1].
fn saturate(x: f64) -> f64 {
    x.clamp(0.0, 1.0)
}

/// Cubic step from 0 at `from` to 1 at `to`. For equal ends, where shading languages leave the result
/// undefined, a jump after the common end.
fn smoothstep(from: f64, to: f64, x: f64) -> f64 {
    let t = if from == to { f64::from(u8::from(x > to)) } else { saturate((x - from) / (to - from)) };
    t * t * (3.0 - 2.0 * t)
}

/// Linear ramp in the cosine, from 0 at the outer to 1 at the inner half angle in radians. The difference
/// of the cosines is at least `least`.
fn ramp(angle: f64, inner: f64, outer: f64, least: f64) -> f64 {
    saturate((angle.cos() - outer.cos()) / (inner.cos() - outer.cos()).max(least))
}

/// `1 - (d / range)^4`, at least 0.
fn window(distance: f64, range: f64) -> f64 {
    saturate(1.0 - (distance / range).powi(4))
}

/// glTF 2.0, extension KHR_lights_punctual (KhronosGroup/glTF, README.md, "Range Property" and "Inner and
/// Outer Cone Angles"; recommended, not required). Half angles in radians, candela or lux.
pub(crate) fn gltf(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; intensity: "intensity" = 1.0, range: "range" = f64::INFINITY,
        inner: "innerConeAngle" = 0.0, outer: "outerConeAngle" = FRAC_PI_4);
    let range = if range > 0.0 { range } else { f64::INFINITY };
    let attenuation = window(distance, range) / distance.powi(2);
    match kind {
        Kind::Directional => intensity,
        Kind::Point => intensity * attenuation,
        Kind::Spot => intensity * attenuation * ramp(angle, inner, outer, 1e-3).powi(2),
    }
}

/// three.js (npm `three` 0.187.0, ShaderChunk/lights_pars_begin.glsl.js: `getSpotAttenuation`,
/// `getDistanceAttenuation`; WebGLLights.js: `setup`). Half angle in radians, candela or lux. A distance
/// of 0 is no range.
pub(crate) fn three(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; intensity: "intensity" = 1.0, range: "distance" = 0.0,
        outer: "angle" = FRAC_PI_3, penumbra: "penumbra" = 0.0, decay: "decay" = 2.0);
    let fade = if range > 0.0 { window(distance, range).powi(2) } else { 1.0 };
    let attenuation = fade / distance.powf(decay).max(0.01);
    match kind {
        Kind::Directional => intensity,
        Kind::Point => intensity * attenuation,
        Kind::Spot => {
            let inner = outer * (1.0 - penumbra);
            intensity * attenuation * smoothstep(outer.cos(), inner.cos(), angle.cos())
        }
    }
}

/// Godot 4 (godotengine/godot, scene_forward_lights_inc.glsl: `get_omni_attenuation`,
/// `light_process_spot`; light_storage.cpp: the reciprocal of the angle attenuation in f32, the least range;
/// doc/classes/SpotLight3D.xml, OmniLight3D.xml). Half angle in degrees. The processor multiplies the
/// energy by pi, which the diffuse term divides away. Physical light units are not covered.
pub(crate) fn godot(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; energy: "light_energy" = 1.0, spot_angle: "spot_angle" = 45.0,
        angle_attenuation: "spot_angle_attenuation" = 1.0, spot_range: "spot_range" = 5.0,
        spot_attenuation: "spot_attenuation" = 1.0, omni_range: "omni_range" = 5.0,
        omni_attenuation: "omni_attenuation" = 1.0);
    let fall = |range: f64, decay: f64| {
        window(distance, range.max(0.001)).powi(2) * distance.max(0.0001).powf(-decay)
    };
    match kind {
        Kind::Directional => energy,
        Kind::Point => energy * fall(omni_range, omni_attenuation),
        Kind::Spot => {
            let edge = spot_angle.to_radians().cos();
            let rim = ((1.0 - angle.cos().max(edge)) / (1.0 - edge)).max(0.0001);
            energy
                * fall(spot_range, spot_attenuation)
                * (1.0 - rim.powf(f64::from(1.0 / angle_attenuation as f32)))
        }
    }
}

/// OpenGL 2.1 (specification, section 2.14.1 and table 2.10). Half angle in degrees; 180 is a point light.
pub(crate) fn opengl(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; intensity: "intensity" = 1.0, cutoff: "spot_cutoff" = 180.0,
        exponent: "spot_exponent" = 0.0, constant: "constant_attenuation" = 1.0,
        linear: "linear_attenuation" = 0.0, quadratic: "quadratic_attenuation" = 0.0);
    let attenuation = 1.0 / (constant + linear * distance + quadratic * distance.powi(2));
    match kind {
        Kind::Directional => intensity,
        Kind::Point => intensity * attenuation,
        Kind::Spot if cutoff == 180.0 => intensity * attenuation,
        Kind::Spot if angle.cos() < cutoff.to_radians().cos() => 0.0,
        Kind::Spot => intensity * attenuation * angle.cos().max(0.0).powf(exponent),
    }
}

/// Direct3D 9 (SDK, "Attenuation and Spotlight Factor" and D3DLIGHT9). Full angles in radians. A light of
/// zeros, the default, has no range. `intensity` is the factor on the light's colour.
pub(crate) fn direct3d(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; intensity: "intensity" = 1.0, theta: "theta" = 0.0, phi: "phi" = 0.0,
        falloff: "falloff" = 0.0, a0: "attenuation0" = 0.0, a1: "attenuation1" = 0.0,
        a2: "attenuation2" = 0.0, range: "range" = 0.0);
    let (rho, inner, outer) = (angle.cos(), (theta / 2.0).cos(), (phi / 2.0).cos());
    let spot = match kind {
        Kind::Directional => return intensity,
        Kind::Point => 1.0,
        Kind::Spot if rho > inner => 1.0,
        Kind::Spot if rho <= outer => 0.0,
        Kind::Spot => ((rho - outer) / (inner - outer)).powf(falloff),
    };
    if distance > range { 0.0 } else { intensity * spot / (a0 + a1 * distance + a2 * distance.powi(2)) }
}

/// Blender (PyPI `bpy` 5.0.1, cycles/source/kernel/light/spot.h: `spot_light_attenuation`; rendered with
/// Cycles). Full angle in radians; the blend is a share of the versine. W, or W/m^2 for a sun. The
/// default soft falloff adds the square of the radius to that of the distance.
pub(crate) fn blender(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; energy: "energy" = 10.0, exposure: "exposure" = 0.0,
        size: "spot_size" = FRAC_PI_4, blend: "spot_blend" = 0.15,
        radius: "shadow_soft_size" = 0.0);
    let edge = (size / 2.0).cos();
    let spot = match kind {
        Kind::Directional => return energy * exposure.exp2(),
        Kind::Point => 1.0,
        Kind::Spot => smoothstep(edge, edge + (1.0 - edge) * blend, angle.cos()),
    };
    energy * exposure.exp2() * spot / (4.0 * PI * (distance.powi(2) + radius.powi(2)))
}

/// UsdLux (PyPI `usd-core` 26.11, usdLux/resources/usdLux/schema.usda: LightAPI, ShapingAPI, SphereLight,
/// DistantLight). Intensity in cd/m^2, divided by the area of the sphere with `normalize`. Half angle in
/// degrees; the softness is a share of it, and the step a cubic of the angle. `angle`, of a DistantLight,
/// is full, in degrees. Names without the prefix `inputs:`.
pub(crate) fn usd(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; intensity: "intensity" = if kind == Kind::Directional { 5e4 } else { 1.0 },
        exposure: "exposure" = 0.0, normalize: "normalize" = 0.0, radius: "radius" = 0.5,
        extent: "angle" = 0.53, cone: "shaping:cone:angle" = 90.0,
        softness: "shaping:cone:softness" = 0.0, focus: "shaping:focus" = 0.0);
    let luminance = intensity * exposure.exp2();
    let half = (extent.to_radians() / 2.0).clamp(0.0, PI);
    let (projected, area) = match kind {
        Kind::Directional if half == 0.0 => (1.0, 1.0),
        Kind::Directional if half <= FRAC_PI_2 => (PI * half.sin().powi(2), PI * half.sin().powi(2)),
        Kind::Directional => (PI, PI * (2.0 - half.sin().powi(2))),
        _ if normalize != 0.0 => (0.25 / distance.powi(2), 1.0), // the radius cancels
        _ => (PI * (radius / distance).powi(2), 1.0),
    };
    let irradiance = luminance * projected / if normalize == 0.0 { 1.0 } else { area };
    let cutoff = cone.to_radians();
    match kind {
        Kind::Spot if angle > cutoff => 0.0,
        Kind::Spot => {
            let start = cutoff * (1.0 - saturate(softness));
            irradiance * (1.0 - smoothstep(start, cutoff, angle)) * angle.cos().abs().powf(focus.max(0.0))
        }
        _ => irradiance,
    }
}

/// X3D (ISO/IEC 19775-1, Lighting component, "Lighting equations"; the shader of npm `x_ite` 15.0.1) and
/// VRML97 (ISO/IEC 14772-1, SpotLight; `version` 2). Half angles in radians, a ramp linear in the angle.
/// The default angles of X3D 4 are from PyPI `x3d` and `x_ite`, those of 3.2 and 3.3 from its schema.
pub(crate) fn x3d(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    let version = values.iter().find(|value| value.0 == "version").map_or(4.0, |value| value.1);
    let angles = match version {
        4.0.. => (0.589_049, FRAC_PI_2),
        3.2.. => (FRAC_PI_4, FRAC_PI_2),
        _ => (FRAC_PI_2, FRAC_PI_4),
    };
    light!(values; _version: "version" = 4.0, intensity: "intensity" = 1.0, radius: "radius" = 100.0,
        beam: "beamWidth" = angles.0, cut: "cutOffAngle" = angles.1, a0: "attenuation0" = 1.0,
        a1: "attenuation1" = 0.0, a2: "attenuation2" = 0.0);
    let spot = match kind {
        Kind::Directional => return intensity,
        Kind::Point => 1.0,
        Kind::Spot if angle >= cut => 0.0,
        Kind::Spot if angle <= beam => 1.0,
        Kind::Spot => (angle - cut) / (beam - cut),
    };
    let attenuation = 1.0 / (a0 + a1 * distance + a2 * distance.powi(2)).max(1.0);
    if distance > radius { 0.0 } else { intensity * spot * attenuation }
}

/// pbrt 3 (mmp/pbrt-v3, lights/spot.cpp: `SpotLight::Falloff`, `CreateSpotLight`) and pbrt 4 (mmp/pbrt-v4,
/// lights.cpp: `SpotLight::I`, `SpotLight::Create`), by `version`. Half angles in degrees. In pbrt 4 a
/// power in lumens is spread by the integral of the falloff, and `I` of 1 is a candela.
pub(crate) fn pbrt(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; version: "version" = 4.0, intensity: "I" = 1.0, radiance: "L" = 1.0,
        scale: "scale" = 1.0, power: "power" = -1.0, illuminance: "illuminance" = -1.0,
        cone: "coneangle" = 30.0, delta: "conedeltaangle" = 5.0);
    let (end, start) = (cone.to_radians().cos(), (cone - delta).to_radians().cos());
    let (spot, angles) = match kind {
        Kind::Directional => return radiance * scale * if illuminance > 0.0 { illuminance } else { 1.0 },
        Kind::Point => (1.0, 4.0 * PI),
        Kind::Spot if version < 4.0 && angle.cos() >= start => (1.0, f64::NAN),
        Kind::Spot if version < 4.0 => (saturate((angle.cos() - end) / (start - end)).powi(4), f64::NAN),
        Kind::Spot => (smoothstep(end, start, angle.cos()), 2.0 * PI * (1.0 - (start + end) / 2.0)),
    };
    let power = if power > 0.0 { power / angles } else { 1.0 };
    intensity * scale * power * spot / distance.powi(2)
}

/// Unreal Engine 5 (SpotLightComponent.cpp, PointLightComponent.cpp: `ComputeLightBrightness`;
/// DeferredLightingCommon.ush: `GetLocalLightAttenuation`). Not checked against a running program. Half
/// angles in degrees, distances in centimetres, result in lux. `IntensityUnits`: 0 none, of which 625 are
/// a candela; 1 candela; 2 lumens.
pub(crate) fn unreal(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; intensity: "Intensity" = if kind == Kind::Directional { 10.0 } else { 5000.0 },
        unit: "IntensityUnits" = 0.0, inner: "InnerConeAngle" = 0.0, outer: "OuterConeAngle" = 44.0,
        radius: "AttenuationRadius" = 1000.0, squared: "bUseInverseSquaredFalloff" = 1.0,
        exponent: "LightFalloffExponent" = 8.0);
    let inner = inner.clamp(0.0, 89.0).to_radians();
    let outer = outer.to_radians().clamp(inner + 0.001, 89_f64.to_radians() + 0.001);
    let (spot, angles) = match kind {
        Kind::Directional => return intensity,
        Kind::Point => (1.0, 4.0 * PI),
        Kind::Spot => (ramp(angle, inner, outer, 0.0).powi(2), 2.0 * PI * (1.0 - outer.cos())),
    };
    if squared == 0.0 {
        return intensity * spot * (1.0 - saturate((distance / radius).powi(2))).powf(exponent);
    }
    let candela = intensity * [1.0 / 625.0, 1.0, 1.0 / angles][unit as usize];
    candela * spot * window(distance, radius).powi(2) * 1e4 / (distance.powi(2) + 1.0)
}

/// Unity, universal render pipeline (Unity-Technologies/Graphics, RealtimeLights.hlsl:
/// `DistanceAttenuation`, `AngleAttenuation`, `GetAdditionalPerObjectLight`; UniversalRenderPipelineCore.cs:
/// `GetPunctualLightDistanceAttenuation`, `GetSpotAngleAttenuation`). Not checked against a running
/// program. Full angles in degrees. The least square of a distance is the least normal half float.
pub(crate) fn unity(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; intensity: "intensity" = 1.0, range: "range" = 10.0, outer: "spotAngle" = 30.0,
        inner: "innerSpotAngle" = 21.802_08);
    let [inner, outer] = [inner, outer].map(|full| full.to_radians() / 2.0);
    let attenuation = window(distance, range.max(0.01)).powi(2) / distance.powi(2).max(0.5_f64.powi(14));
    match kind {
        Kind::Directional => intensity,
        Kind::Point => intensity * attenuation,
        Kind::Spot => intensity * attenuation * ramp(angle, inner, outer, 1e-3).powi(2),
    }
}

/// Bevy (crates `bevy_pbr`, `bevy_light` 0.20.1, pbr_lighting.wesl: `getDistanceAttenuation`, `spot_light`;
/// render/light.rs: `extract_lights`, `prepare_lights`). Half angles in radians, lumens over the whole
/// sphere for a spotlight too; lux for a directional light.
pub(crate) fn bevy(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; intensity: "intensity" = 1e6, range: "range" = 20.0, inner: "inner_angle" = 0.0,
        outer: "outer_angle" = FRAC_PI_4, illuminance: "illuminance" = 10_000.0);
    let outer = if outer >= FRAC_PI_2 { FRAC_PI_2 - 1e-4 } else { outer };
    let attenuation = window(distance, range).powi(2) / distance.powi(2).max(1e-4) / (4.0 * PI);
    match kind {
        Kind::Directional => illuminance,
        Kind::Point => intensity * attenuation,
        Kind::Spot => intensity * attenuation * ramp(angle, inner, outer, 1e-4).powi(2),
    }
}

/// Babylon.js (npm `@babylonjs/core` 9.35.0, pbrDirectLightingFalloffFunctions.js,
/// Lights/spotLight.pure.js: `_computeAngleValues`, Lights/light.js: `_getPhotometricScale`). Full angles in
/// radians. `falloffType`: 0 and 1 physical, a spherical Gaussian without an edge; 2 of glTF; 3 standard,
/// the only one of StandardMaterial. `intensityMode` 1 is lumens over the whole sphere.
pub(crate) fn babylon(values: &[(&str, f64)], kind: Kind, angle: f64, distance: f64) -> f64 {
    light!(values; intensity: "intensity" = 1.0, mode: "intensityMode" = 0.0,
        falloff: "falloffType" = 0.0, range: "range" = f64::MAX, full: "angle" = f64::NAN,
        inner: "innerAngle" = 0.0, exponent: "exponent" = f64::NAN);
    let (cos, edge, square) = (angle.cos(), (full / 2.0).cos(), distance.powi(2).max(1e-7));
    let intensity = if mode == 1.0 { intensity / (4.0 * PI) } else { intensity };
    let (spot, attenuation) = match falloff {
        2.0 => (ramp(angle, inner / 2.0, full / 2.0, 1e-3).powi(2), window(distance, range).powi(2) / square),
        3.0 if cos.max(1e-7) < edge => (0.0, 1.0),
        3.0 => (cos.max(1e-7).powf(exponent), (1.0 - distance / range).max(0.0)),
        _ => ((100_f64.log2() / (1.0 - edge) * (cos - 1.0)).exp2(), 1.0 / square),
    };
    match kind {
        Kind::Directional => intensity,
        Kind::Point if falloff == 3.0 => intensity * (1.0 - distance / range).max(0.0),
        Kind::Point => intensity * attenuation,
        Kind::Spot => intensity * attenuation * spot,
    }
}
