//! Writes a light as source of another language.
//!
//! Most renderers on microcontrollers are written in C or C++, and most renderers on the web in
//! GLSL or WGSL. This crate writes a light that [`luminaire`] describes in these languages, as JSON
//! and as a constant of Rust:
//!
//! ```
//! use luminaire::{Angle, Cone, SpotLight, falloff::Soft};
//! use luminaire_export::{Language, export};
//!
//! let cone = Cone::from_field(Soft, Angle::degrees(36.0))?;
//! let key = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_intensity(16.0)?;
//! let shader = export(key, "key", Language::Glsl)?;
//! assert!(shader.contains("float key_irradiance(highp vec3 point, highp vec3 normal) {"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | language | functions and constants of a light named `key` | same bits as the kernel |
//! |---|---|---|
//! | [`Language::Glsl`], [`Language::Wgsl`] | `key_irradiance(point, normal)`, `key_falloff(point)`, `key_color` | no: a GPU rounds as it likes |
//! | [`Language::GlslUniforms`] | the same, and uniforms such as `key_position`, whose values are in comments | no |
//! | [`Language::CFloat`] | the same, over arrays of three `float` | yes in `f32`, without contraction (`-ffp-contract=off`), except real powers and decays |
//! | [`Language::CFixed`] | the same, over arrays of integers | yes in `Fx16` |
//! | [`Language::RustBuild`] | `key()`, the light, and a `main` that writes `key.rs` | it describes the light: angles have six digits |
//! | [`Language::RustProgram`] | a `main` that prints the pool of `key` | it describes the spotlight: angles have six digits |
//! | [`Language::RustFloat`], [`Language::RustFixed32`], [`Language::RustFixed16`] | `key::LIGHT` | it is the kernel |
//! | [`Language::Json`] | the parameters | no code |
//!
//! Spotlights have all falloffs and attenuations of the kernel. Point lights and directional lights
//! have an irradiance and no falloff; that of a directional light takes the normal alone.
//! A measured light has an irradiance, and its table over all directions is an array; [`Language::RustProgram`] does not
//! have it.
//!
//! # Scenes
//!
//! [`export_scene`] adds what lights a point by all lights of a source with their colours, and by ambient light. Of a
//! scene `room` with a light `key` it is:
//!
//! | language | a point | a row of pixels | lights that move |
//! |---|---|---|---|
//! | [`Language::Glsl`], [`Language::GlslUniforms`], [`Language::Wgsl`] | `room_light(point, normal)` | | uniforms such as `key_position` |
//! | [`Language::CFloat`] | `room_light(light, point, normal)` | `room_row_add(lights, first, step, normal, count)` | |
//! | [`Language::CFixed`] | `room_light(&scene, point, normal)` | `room_row_add(lights, row, &scene, count)` | the members of a `room_scene`, such as `scene.key`; `room_start` has them as described |
//! | Rust | `scene.light(point, normal)` | `scene.row(&row, pixels, show)` | the fields of a `room::Scene`, such as `scene.key`; `room::SCENE` has them as described |
//!
//! In [`Language::CFixed`] `room_light_facing(&scene, point)`, and in Rust `scene.light_facing(point)`, is the light of a small
//! body without a normal, such as an LED: that of a surface that faces each light.
//!
//! A light that cannot reach a point is skipped before its root, and one that cannot reach a part of a row is skipped
//! there, which changes no bit. In `Fx16` all spotlights of a polynomial with the inverse square have one type, that of
//! a [`Cubic`](luminaire::falloff::Cubic): so C and Rust have the same bits, and one copy of its code; the light of
//! others than cubics may differ by a step where the fine evaluation is used.
//!
//! # The formulas
//!
//! The formula of a falloff is recorded from the kernel's own code, so no formula is written twice.
//! The angle off axis enters as the squared difference of two unit vectors, which is twice the
//! versine `1 - cos`. The difference keeps the leading bits of the versine of a narrow beam, which
//! `1 - dot(a, b)` would lose.
//!
//! # C
//!
//! The folder `c` of this crate is a library for C and C++ without Rust, and [`C_HEADERS`] are its
//! files. The source of [`Language::CFixed`] includes `luminaire_constant.h`, and that
//! `luminaire.h`. This has `luminaire_directional`, and `luminaire_spot`, a spotlight that is set up and
//! moves at run time. Its results have the bits of [`CompiledSpotLight`](luminaire::light::CompiledSpotLight) in [`Fx16`]
//! with a [`Cubic`](luminaire::falloff::Cubic) and the inverse square, and its set-up those of
//! [`IntegerCone`](luminaire::light::IntegerCone). For words that no set-up made, such as those of
//! a damaged file, the results are defined, and have these bits after `luminaire_spot_restore`. A
//! spotlight of a cubic falloff with the inverse square that is exported has a function `key_spot`,
//! which returns it as one that moves. Two headers of different lights of one name are an error of
//! the compiler, and a header that is included twice counts once.
//!
//! # JSON
//!
//! [`json`] writes and reads one format, `luminaire-lights-1`, for any number of lights:
//!
//! | member | meaning |
//! |---|---|
//! | `format` | `luminaire-lights-1` |
//! | `lights` | an array of lights, each with the members below |
//! | `name`, `kind` | any text; `spot` (the default), `measured`, `point`, `directional` or `ambient` |
//! | `position`, `axis` | three numbers; the axis points along the light and has any length |
//! | `color`, `specular_color` | linear red, green and blue, each up to 1; white, and the colour, by default |
//! | `intensity` | 1 is full scale on the axis at distance 1 |
//! | `about` | anything: what `luminaire import` knows of the light, of which it reads again `difference`, `full_scale`, `kelvin`, `is_assumed` and `notes` |
//! | `near`, `far` | the distances of the nearest and of the farthest surface, for `luminaire pick`; both or neither |
//! | `cone.beam_degrees`, `field_degrees`, `outer_degrees`, `inner_degrees`, `cutoff_degrees` | full angles: 50 % and 10 % of the intensity, the end of the falloff, full intensity, the end of the light before that of its falloff |
//! | `cone.inner_versine`, `outer_versine`, `cutoff_versine` | `1 - cos` of half of three of these angles, which are exact: with them the angles are for readers |
//! | `cone.falloff` | `name` and `parameters`, those of `luminaire export --falloff`; and for readers its [`formula`](luminaire::falloff::Formula) at `t = (outer - v) / (outer - inner)` with the versine `v`: `coefficients`, or `exponent` and `floor` |
//! | `side` | of a measured light three numbers, at least 6 degrees off the axis: of photometry the plane C0; 1, 0, 0 by default |
//! | `distribution.size`, `symmetry`, `samples` | of a measured light: 3, 5, 9, 17, 33, 65 (the default), 129 or 257; `none` (the default), `bilateral` or `quadrant`; and the intensities as [`Distribution`](luminaire::light::Distribution) has them, of which 65,535 is 1 |
//! | `attenuation.law` | `constant`, `inverse-square` (the default), `polynomial` with `constant`, `linear` and `quadratic`, `decay` with `exponent` and its cap `most`, or `smoothstep` to `range` |
//! | `attenuation.window`, `range` | `cut`, `gltf` or `square`, at the range; absent without a range |
//!
//! Ambient light has a name, a colour and an intensity alone, of which 1 lights a white surface to full scale.
//!
//! A spotlight that is written by hand needs a cone alone: one of beam, field and outer angle, or beam
//! and field angle without a falloff. A hotspot beside them leaves the beam and the field angle. A
//! light that was written is read with the same bits.
//!
//! [`falloff`](luminaire::falloff) and [`attenuation`](luminaire::attenuation) have the formulas. The
//! parameters of `table` are evenly spaced over `u = 1 - t`, and 65,535 is 1. Those of `knots` are three
//! numbers for each line, `place, value, slope`: it starts at `u = place / 65536` and rises by
//! `slope / 32768` per unit of `place`.
#![forbid(unsafe_code)]

mod error;
mod fixed;
mod head;
mod item;
pub mod json;
mod language;
mod name;
mod patch;
mod program;
pub mod rust;
mod scene;
mod script;
mod shader;
mod trace;
pub mod words;

use luminaire::dynamic::AnyLight;
use luminaire::{Fx16, Fx32};

pub use crate::error::{ExportError, printable};
pub use crate::fixed::C_HEADERS;
use crate::item::Item;
pub use crate::language::Language;
pub use crate::name::{check_text, identifier, names};
pub use crate::patch::export_patch;
pub use crate::scene::Scene;
use crate::scene::Together;
use crate::shader::Syntax;

/// Returns a light as source of a language.
///
/// `name` begins the names of the functions and constants for users, and `luminaire_` and `name` those
/// of all others. Lights of different names can be in one file, also with lights of `luminaire.h`.
///
/// # Errors
/// A light that the number format of the language cannot hold, with the error of its `compile`, and
/// with a language that takes the light if there is one. A name that is not its own [`identifier`]
/// in the language. A table with more than 1,024 entries in a language with `float`. Another light than a
/// spotlight in [`Language::RustProgram`].
pub fn export(light: impl Into<AnyLight>, name: &str, language: Language) -> Result<String, ExportError> {
    let (text, refused) = export_all([(name, light.into())], language);
    refused.into_iter().next().map_or(Ok(text), |(_, error)| Err(error))
}

/// Returns lights as one source of a language, and why the others are not in it, with their numbers
/// from 0.
///
/// The names differ, as [`names`] makes them. The lights of [`Language::RustBuild`] and of
/// [`Language::RustProgram`] have one `main`, which writes or prints each of them. Without any
/// light the text is empty.
pub fn export_all<'a>(
    lights: impl IntoIterator<Item = (&'a str, AnyLight)>,
    language: Language,
) -> (String, Vec<(usize, ExportError)>) {
    let (items, refused) = items(lights, language);
    (joined(&items, None, language), refused)
}

/// Returns lights as one source as [`export_all`] does, with one function that lights a point by all of them and by
/// ambient light, and one for a row of points in C and Rust: [`room_light`](self#scenes) of a scene `room`. Without any
/// light it returns the ambient light.
///
/// # Errors
/// A name of the scene that is no [`identifier`], or a language that has none: [`Language::has_scenes`].
pub fn export_scene<'a>(
    scene: &Scene<'a>,
    lights: impl IntoIterator<Item = (&'a str, AnyLight)>,
    language: Language,
) -> Result<(String, Vec<(usize, ExportError)>), ExportError> {
    let (items, refused) = items(lights, language);
    let together = Together::new(scene, &items, language)?;
    let (text, own) = (joined(&items, Some(&together), language), scene_text(&together, language)?);
    Ok((if text.is_empty() || own.is_empty() { text + &own } else { text + "\n" + &own }, refused))
}

/// Returns lights with their texts, and why the others have none, with their numbers from 0.
fn items<'a>(
    lights: impl IntoIterator<Item = (&'a str, AnyLight)>,
    language: Language,
) -> (Vec<Item<'a>>, Vec<(usize, ExportError)>) {
    let (mut items, mut refused) = (Vec::new(), Vec::new());
    for (number, (name, light)) in lights.into_iter().enumerate() {
        match item(light, name, language) {
            Ok(item) => items.push(item),
            Err(error) => refused.push((number, error)),
        }
    }
    (items, refused)
}

/// Returns the texts of lights as one.
fn joined(items: &[Item<'_>], together: Option<&Together<'_>>, language: Language) -> String {
    match language {
        _ if items.is_empty() && together.is_none() => String::new(),
        // Lights have no number that JSON has not.
        Language::Json => {
            let lights = items.iter().map(Item::named).collect();
            json::write(&json::Lights { lights, ambient: Vec::new() }).unwrap_or_default()
        }
        Language::RustBuild => script::joined(items, together),
        Language::RustProgram => program::joined(items),
        Language::Glsl
        | Language::GlslUniforms
        | Language::Wgsl
        | Language::CFloat
        | Language::CFixed
        | Language::RustFloat
        | Language::RustFixed32
        | Language::RustFixed16 => items.iter().map(|item| &*item.text).collect::<Vec<_>>().join("\n"),
    }
}

/// The light with its text, which is checked.
fn item(light: AnyLight, name: &str, language: Language) -> Result<Item<'_>, ExportError> {
    name::check_identifier(name, language)?;
    let text = text(&light, name, language).map_err(|error| {
        let other = language.wider().iter().find(|other| text(&light, name, **other).is_ok());
        let remedy = other.map_or_else(String::new, |other| format!("; {other} takes it"));
        ExportError { expected: format!("{} in {language}{remedy}", error.expected), ..error }
    })?;
    Ok(Item { name, light, text })
}

fn text(light: &AnyLight, name: &str, language: Language) -> Result<String, ExportError> {
    match language {
        Language::Json => Ok(String::new()), // a document has all lights
        Language::Glsl => shader::export(light, name, Syntax::Glsl),
        Language::GlslUniforms => shader::with_uniforms(light, name),
        Language::Wgsl => shader::export(light, name, Syntax::Wgsl),
        Language::CFloat => shader::export(light, name, Syntax::C),
        Language::CFixed => fixed::export(light, name),
        Language::RustBuild => script::export(light, name),
        Language::RustProgram => program::export(light, name),
        Language::RustFloat => rust::export::<f32>(light, name),
        Language::RustFixed32 => rust::export::<Fx32>(light, name),
        Language::RustFixed16 => rust::export::<Fx16>(light, name),
    }
}

/// Returns the function of a scene and what it needs beside the texts of the lights. A build script has its scene among
/// these.
fn scene_text(together: &Together<'_>, language: Language) -> Result<String, ExportError> {
    Ok(match language {
        Language::Glsl => shader::scene(together, Syntax::Glsl, false),
        Language::GlslUniforms => shader::scene(together, Syntax::Glsl, true),
        Language::Wgsl => shader::scene(together, Syntax::Wgsl, false),
        Language::CFloat => shader::scene(together, Syntax::C, false),
        Language::CFixed => fixed::scene(together)?,
        Language::RustFloat => rust::scene::<f32>(together)?,
        Language::RustFixed32 => rust::scene::<Fx32>(together)?,
        Language::RustFixed16 => rust::scene::<Fx16>(together)?,
        Language::RustBuild | Language::Json | Language::RustProgram => String::new(),
    })
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
