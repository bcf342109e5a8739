//! Shaders of `luminaire-export`, drawn by WebGL.

use std::fmt;

use anyhow::{Context, Result, ensure};
use browser::{Browser, Chromium, Page};
use fastrand::Rng;
use luminaire::falloff::AnyFalloff;
use luminaire_export::{Language, export};
use naga::back::glsl;

#[allow(dead_code, reason = "the tests of the exporter use more of them")]
#[path = "../../../export/tests/support/lights.rs"]
mod lights;

use lights::Spot;

/// The languages of the shaders.
pub const LANGUAGES: [Language; 2] = [Language::Glsl, Language::Wgsl];

const DRAW: &str = include_str!("shaders.js");

/// Places for each light.
const PLACES: usize = 1_024;

/// Lights of each falloff.
const VARIANTS: usize = 3;

/// The largest differences over all places, searched.
#[derive(Clone, Copy, Default, Debug)]
pub struct Differences {
    places: usize,
    lit: usize,
    /// Of the falloff from the kernel in `f32`, in linear codes; of real powers apart.
    falloff: f64,
    real_power: f64,
    /// Of the irradiance from the kernel, in units in the last place, where the falloff is at least
    /// a linear code; without real powers.
    ulp: u32,
    /// Of the falloff from f64, in linear codes, for falloffs without a jump in cones over 6
    /// degrees.
    exact: f64,
}

impl fmt::Display for Differences {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { places, lit, falloff, real_power, ulp, exact } = self;
        write!(
            out,
            "{places} places, {lit} lit; a falloff differs from the kernel by at most {falloff:.1e} linear \
             codes, one with a real power by {real_power:.1e}, from f64 by {exact:.1e}; an irradiance by {ulp} ULP"
        )
    }
}

/// Compares the shaders of all falloffs and attenuations with the kernel. `language` is GLSL, or
/// WGSL, which is translated to GLSL.
pub fn differences(chromium: &mut Chromium, language: Language) -> Result<Differences> {
    let mut page = chromium.open("about:blank", "")?;
    let mut rng = Rng::with_seed(1976);
    let mut differences = Differences::default();
    for spot in lights::spots::<f32>(&mut rng, VARIANTS) {
        compare(&mut page, &mut rng, &spot, language, &mut differences)
            .with_context(|| format!("{language}: {spot:?}"))?;
    }
    Ok(differences)
}

/// Checks that the differences are within their bounds, and not by far.
pub fn check(differences: &Differences) -> Result<()> {
    let Differences { places, lit, falloff, real_power, ulp, exact } = *differences;
    ensure!(lit > places / 3, "only {lit} of {places} places are lit");
    // Of Chromium's software renderer. A GPU may round less or more; where the least is not 0, the
    // kernel itself differs by that much.
    for (name, found, least, most) in [
        ("a falloff from the kernel", falloff, 0.0, 1e-4),
        ("a real power from the kernel", real_power, 1e-6, 0.02),
        ("a falloff from f64", exact, 1e-5, 0.02),
        ("an irradiance in ULP", ulp.into(), 0.0, 1_000.0),
    ] {
        ensure!(
            (least..=most).contains(&found),
            "{name} differs by {found:e}, expected {least:e} to {most:e}"
        );
    }
    Ok(())
}

fn compare(
    page: &mut Page,
    rng: &mut Rng,
    spot: &Spot,
    language: Language,
    worst: &mut Differences,
) -> Result<()> {
    let any = (*spot).into();
    let places: Vec<_> = (0..PLACES).map(|_| lights::place(rng, &any)).collect();
    let bits: Vec<u32> =
        places.iter().flat_map(|(point, normal)| [*point, *normal]).flatten().map(f32::to_bits).collect();
    let source = serde_json::to_string(&shader(spot, language)?)?;
    let found = page.ask(&format!("{DRAW}({source}, {bits:?})"))?;
    let found: Vec<u32> = serde_json::from_value(found).context("no list of numbers")?;
    ensure!(found.len() == 2 * PLACES, "{} numbers for {PLACES} places", found.len());
    let light = spot.compile::<f32>()?;
    let is_real =
        matches!(spot.cone().falloff(), AnyFalloff::RealPower(_) | AnyFalloff::InvertedRealPower(_));
    for ((point, normal), found) in places.into_iter().zip(found.chunks_exact(2)) {
        let [irradiance, falloff] = [found[0], found[1]].map(f32::from_bits);
        let expected = light.falloff_at(point.into());
        let differs = 255.0 * f64::from(falloff - expected).abs();
        worst.places += 1;
        let at = || format!("falloff {falloff}, expected {expected} at {point:?}");
        ensure!(differs.is_finite() && irradiance.is_finite(), at());
        // At the edge itself a rounding decides.
        if ends_near(spot, point) {
            continue;
        }
        let kind = if is_real { &mut worst.real_power } else { &mut worst.falloff };
        *kind = kind.max(differs);
        if lights::is_smooth(spot) {
            let [_, exact] = lights::exact(spot, point, normal);
            worst.exact = worst.exact.max(255.0 * (f64::from(falloff) - exact).abs());
        }
        let arrives = light.irradiance(point.into(), normal.into());
        worst.lit += usize::from(arrives > 0.0);
        if !is_real && expected > 1.0 / 255.0 && arrives > f32::MIN_POSITIVE {
            worst.ulp = worst.ulp.max(irradiance.to_bits().abs_diff(arrives.to_bits()));
        }
    }
    Ok(())
}

/// Returns whether a point is so close to the outer angle that a jump there may be on its other
/// side.
fn ends_near(spot: &Spot, point: [f32; 3]) -> bool {
    let limit = f64::from(spot.cone().outer_versine());
    let room = 1e-5 * limit.sqrt() + 1e-4 * limit;
    (lights::versine(spot, point) - limit).abs() < room
}

/// Returns a fragment shader that draws the irradiance and the falloff of the places.
fn shader(spot: &Spot, language: Language) -> Result<String> {
    let light = export(*spot, "light", language)?;
    if language == Language::Glsl {
        return Ok(format!(
            "#version 300 es\n{light}\nprecision highp float;\nprecision highp sampler2D;\n\
             uniform sampler2D places;\nout uvec4 words;\n\
             void main() {{\n    \
             vec3 point = texelFetch(places, ivec2(gl_FragCoord.x, 0), 0).xyz;\n    \
             vec3 normal = texelFetch(places, ivec2(gl_FragCoord.x, 1), 0).xyz;\n    \
             words = uvec4(floatBitsToUint(light_irradiance(point, normal)), \
             floatBitsToUint(light_falloff(point)), 0u, 0u);\n}}\n"
        ));
    }
    let text = format!(
        "{light}\n@group(0) @binding(0) var places: texture_2d<f32>;\n\
         @fragment fn main(@builtin(position) at: vec4<f32>) -> @location(0) vec4<u32> {{\n    \
         let point = textureLoad(places, vec2<i32>(i32(at.x), 0), 0).xyz;\n    \
         let normal = textureLoad(places, vec2<i32>(i32(at.x), 1), 0).xyz;\n    \
         return vec4<u32>(bitcast<u32>(light_irradiance(point, normal)), \
         bitcast<u32>(light_falloff(point)), 0u, 0u);\n}}\n"
    );
    let module =
        naga::front::wgsl::parse_str(&text).map_err(|error| anyhow::anyhow!(error.emit_to_string(&text)))?;
    let (flags, capabilities) = (naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty());
    let info = naga::valid::Validator::new(flags, capabilities).validate(&module);
    let info = info.map_err(|error| anyhow::anyhow!(error.emit_to_string(&text)))?;
    let version = glsl::Version::Embedded { version: 300, is_webgl: true };
    let options = glsl::Options { version, ..glsl::Options::default() };
    let pipeline = glsl::PipelineOptions {
        shader_stage: naga::ShaderStage::Fragment,
        entry_point: "main".to_owned(),
        multiview: None,
    };
    let mut out = String::new();
    let policies = naga::proc::BoundsCheckPolicies::default();
    glsl::Writer::new(&mut out, &module, &info, &options, &pipeline, policies)?.write()?;
    Ok(out)
}
