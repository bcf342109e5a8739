//! What the tests in a browser expect of the page and of exported shaders: values that the host computes, as
//! JSON.

use anyhow::{Context, Result};
use fastrand::Rng;
use luminaire::Fx16;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::AnyFalloff;
use luminaire::projector::Fixture;
use luminaire_export::{C_HEADERS, Language, export};
use luminaire_museum::{ALL, Exhibit, Picture, Side};
use luminaire_render::{Format, Renderer, scenes::Example};
use naga::back::glsl;
use serde_json::{Map, Value, json};

use tools::demo::site::{self, Build};

#[allow(dead_code, reason = "the tests of the exporter use more of them")]
#[path = "../../../export/tests/support/lights.rs"]
pub(crate) mod lights;

use lights::Spot;

/// Pixels on a side of a picture of the museum.
const SIDE: u32 = 200;

/// Places for each light, and lights of each falloff.
const PLACES: usize = 1_024;
const VARIANTS: usize = 3;

/// The numbers that `highp` has in GLSL ES 3.00 are below 2^126.
const MOST: f32 = 8.507_059e37;

/// What the page shows: its views, the difference of two formats, the museum's errors, and code.
pub(crate) fn page(build: Build) -> Result<Value> {
    Ok(json!({
        "site": site::folder(build),
        "views": site::built_views(build).collect::<Vec<_>>(),
        "divided": divided()?,
        "museum": ALL.iter().map(exhibit).collect::<Result<Vec<_>>>()?,
        "code": code()?,
    }))
}

/// How much a scene in 16 bits differs from that in `f32`, in codes, where and in how many pixels.
fn divided() -> Result<Value> {
    let (one, other) = (picture::<Fx16>()?, picture::<f32>()?);
    let difference = |(one, other): (&[u8; 4], &[u8; 4])| {
        one.iter().zip(other).map(|(one, other)| one.abs_diff(*other)).max().unwrap_or_default()
    };
    let pixels = one.as_chunks::<4>().0.iter().zip(other.as_chunks::<4>().0).map(difference);
    let differences: Vec<u8> = pixels.collect();
    let largest = differences.iter().max().context("no pixels")?;
    Ok(json!({
        "largest": largest,
        "place": differences.iter().position(|difference| difference == largest),
        "differing": differences.iter().filter(|difference| **difference > 0).count(),
    }))
}

/// The scene's picture at second 0: RGBA, sRGB, eight bits.
fn picture<S: Format>() -> Result<Vec<u8>> {
    let scene = Example::ThreePoint;
    let setup = scene.setup().context("the scene has no setup")?;
    let (width, height) = scene.size();
    let fixtures: Vec<Fixture> = setup.fixtures_at(0.0).context("no fixtures")?;
    let mut renderer = Renderer::<S>::new(width, height).context("no renderer")?;
    renderer.set_display(setup.display);
    renderer.set_antialiased(true);
    renderer.draw_geometry(&setup.scene, &setup.camera);
    renderer.draw_shadows(&setup.scene, &fixtures).context("no shadows")?;
    renderer.draw_light(&fixtures).context("no light")?;
    Ok(renderer.encode().to_vec())
}

/// An exhibit of the museum, with its errors at the values that the tests choose.
fn exhibit(exhibit: &Exhibit) -> Result<Value> {
    let Exhibit { name, title, agrees_at, .. } = exhibit;
    let start = exhibit.control.start;
    let others: &[f32] = if *name == ALL[0].name { &[0.5, 2.0] } else { &[] };
    let mut at = Vec::new();
    for value in [start].iter().chain(agrees_at).chain(others) {
        let picture = Picture::of(&(exhibit.beam)(*value).context(*name)?, SIDE).context(*name)?;
        let sides = [Side::Faulty, Side::Ours].map(|side| {
            let errors = picture.errors(side);
            json!({ "largest": errors.largest, "undefined": errors.undefined })
        });
        at.push(json!({ "value": value, "sides": sides }));
    }
    Ok(json!({ "name": name, "title": title, "start": start, "agreesAt": agrees_at, "at": at }))
}

/// The code of lights of the still life and of the show, some of which the scene moves, and the number of
/// the sun of a third scene.
fn code() -> Result<Value> {
    let mut lights = Vec::new();
    for (scene, number) in [(Example::ThreePoint, 0), (Example::ThreePoint, 2), (Example::Show, 1)] {
        let fixtures = scene.setup().context("no scene")?.fixtures_at(0.0).context("no lights")?;
        let (light, name) = (*fixtures[number].light(), format!("light_{}", number + 1));
        let texts = Language::ALL
            .iter()
            .map(|&language| Ok((language.name().to_owned(), export(light, &name, language)?.into())));
        let texts = texts.collect::<Result<Map<String, Value>>>()?;
        lights.push(json!({ "scene": scene.name(), "light": number, "texts": texts }));
    }
    let setup = Example::Gallery.setup().context("no scene")?;
    let mut fixtures = setup.fixtures.iter();
    let sun = fixtures.position(|fixture| matches!(fixture.light(), AnyLight::Directional(_)));
    let sun = sun.context("no sun")?;
    let headers: Map<String, Value> =
        C_HEADERS.map(|(name, text)| (name.to_owned(), text.into())).into_iter().collect();
    Ok(json!({ "lights": lights, "headers": headers, "sun": sun }))
}

/// Spotlights of all falloffs and attenuations as shaders, with places and what the kernel computes there.
pub(crate) fn shaders() -> Result<Value> {
    let mut rng = Rng::with_seed(1976);
    let mut spots = lights::spots::<f32>(&mut rng, VARIANTS);
    spots.retain(|spot| <[f32; 3]>::from(spot.position()).iter().all(|c| c.abs() < MOST));
    let lights = spots.iter().map(|spot| light(&mut rng, spot).with_context(|| format!("{spot:?}")));
    Ok(json!({ "lights": lights.collect::<Result<Vec<_>>>()? }))
}

fn light(rng: &mut Rng, spot: &Spot) -> Result<Value> {
    let any = (*spot).into();
    let places: Vec<_> = (0..PLACES).map(|_| lights::place(rng, &any)).collect();
    let compiled = spot.compile::<f32>()?;
    let is_smooth = lights::is_smooth(spot);
    let expected = places.iter().map(|(point, normal)| {
        // At the light itself no direction is exact.
        let has_exact = is_smooth && spot.position() != (*point).into();
        let exact = has_exact.then(|| lights::exact(spot, *point, *normal)[1]);
        let irradiance = compiled.irradiance((*point).into(), (*normal).into());
        let falloff = compiled.falloff_at((*point).into());
        (!ends_near(spot, *point)).then(|| json!([irradiance.to_bits(), falloff.to_bits(), exact]))
    });
    let words = places.iter().flat_map(|(point, normal)| [*point, *normal]).flatten().map(f32::to_bits);
    Ok(json!({
        "name": format!("{spot:?}"),
        "texts": { "glsl": glsl(spot)?, "wgsl": translated(spot)? },
        "bits": words.collect::<Vec<_>>(),
        "expected": expected.collect::<Vec<_>>(),
        "isReal": matches!(
            spot.cone().falloff(),
            AnyFalloff::RealPower(_) | AnyFalloff::InvertedRealPower(_)
        ),
    }))
}

/// Whether a point is so close to the outer angle that a jump there may be on its other side.
fn ends_near(spot: &Spot, point: [f32; 3]) -> bool {
    let limit = f64::from(spot.cone().outer_versine());
    let room = 1e-5 * limit.sqrt() + 1e-4 * limit;
    (lights::versine(spot, point) - limit).abs() < room
}

/// A fragment shader that draws the irradiance and the falloff of the places.
fn glsl(spot: &Spot) -> Result<String> {
    let light = export(*spot, "light", Language::Glsl)?;
    Ok(format!(
        "#version 300 es\n{light}\nprecision highp float;\nprecision highp sampler2D;\n\
         uniform sampler2D places;\nout uvec4 words;\n\
         void main() {{\n    \
         vec3 point = texelFetch(places, ivec2(gl_FragCoord.x, 0), 0).xyz;\n    \
         vec3 normal = texelFetch(places, ivec2(gl_FragCoord.x, 1), 0).xyz;\n    \
         words = uvec4(floatBitsToUint(light_irradiance(point, normal)), \
         floatBitsToUint(light_falloff(point)), 0u, 0u);\n}}\n"
    ))
}

/// The same in WGSL, translated to GLSL.
fn translated(spot: &Spot) -> Result<String> {
    let light = export(*spot, "light", Language::Wgsl)?;
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
