//! Lights as build scripts of Rust.

use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::AnyFalloff;
use luminaire::{Angle, Cone, Fx16, Rgb};

use crate::error::ExportError;
use crate::head::head;
use crate::item::Item;
use crate::rust::{distribution, falloff_source, structure};
use crate::scene::Together;

/// The parts of a script that depend on the kind of a light.
struct Parts {
    /// The type of the light.
    kind: String,
    /// The line before the light; empty without a cone.
    cone: String,
    /// The calls that make the light, without its colour and intensity.
    calls: Vec<String>,
}

/// Returns a function of a build script that describes a light of which `Fx16` has a constant.
pub(crate) fn export(light: &AnyLight, name: &str) -> Result<String, ExportError> {
    light.compile::<Fx16>()?;
    let Parts { kind, cone, mut calls } = parts(light);
    calls.push(color("color", light.color()));
    if light.specular_color() != light.color() {
        calls.push(color("specular_color", light.specular_color()));
    }
    calls.push(format!(".with_intensity({:?})", light.intensity()));
    Ok(format!(
        r#"{head}//
// With this build.rs, and luminaire among the build-dependencies, the constant in the program is
// const {constant}: luminaire::light::{compiled} =
//     include!(concat!(env!("OUT_DIR"), "/{name}.rs"));
pub fn {name}() -> Result<{kind}, Error> {{
{cone}    {calls}
}}
"#,
        head = own_head(light, name),
        constant = name.to_ascii_uppercase(),
        compiled = compiled(&kind),
        calls = calls.join("\n        "),
    ))
}

/// Returns the comment of a light that people edit.
pub(crate) fn own_head(light: &AnyLight, name: &str) -> String {
    head(light, name).iter().map(|line| format!("// {}\n", line.replace(": do not edit", ""))).collect()
}

/// Returns a build script that writes a file for each light. No variable of its `main` hides a
/// function of a light.
pub(crate) fn joined(items: &[Item<'_>], together: Option<&Together<'_>>) -> String {
    let texts: Vec<_> = items.iter().map(|item| &*item.text).collect();
    let write = |Item { name, light, .. }: &Item<'_>| {
        let checked = if matches!(light, AnyLight::Directional(_)) { "" } else { "?" };
        format!(
            r#"    std::fs::write(
        std::path::Path::new(&std::env::var("OUT_DIR")?).join("{name}.rs"),
        luminaire::codegen::as_source(&{name}()?.compile::<Fx16>(){checked}).to_string(),
    )?;
"#
        )
    };
    let [structure, scene] = together.map(scene).unwrap_or_default();
    format!(
        r#"#[allow(unused_imports, reason = "not every light names a type of each module")]
use luminaire::{{attenuation::*, codegen::*, falloff::*, light::*, *}};

{functions}{structure}
fn main() -> Result<(), Box<dyn std::error::Error>> {{
{written}{scene}    Ok(())
}}
"#,
        functions = texts.join("\n"),
        written = items.iter().map(write).collect::<String>(),
    )
}

/// What stands in the text of a scene for its ambient light, which the build script computes.
const AMBIENT: &str = "AMBIENT";

/// Returns the text of a scene, whose lights are the files of the others, and the statement of `main` that writes it.
fn scene(together: &Together<'_>) -> [String; 2] {
    let members = together.items.iter().map(|item| {
        let value = format!("include!(concat!(env!(\"OUT_DIR\"), \"/{}.rs\"))", item.name);
        (item, compiled(&parts(&item.light).kind), value)
    });
    let text = structure::<Fx16>(together, &members.collect::<Vec<_>>(), AMBIENT);
    let name = &together.name;
    let constant = name.to_ascii_uppercase();
    let ambient = together.ambient.iter().map(|light| {
        let own = format!("AmbientLight::new({})?", rgb(light.color()));
        format!("{own}.with_intensity({:?})?", light.intensity())
    });
    let ambient = ambient.collect::<Vec<_>>().join(", ");
    let text = format!(
        "\n// The lights of the scene {name} together. With this build.rs, the program has them by\n\
         // mod {name} {{ include!(concat!(env!(\"OUT_DIR\"), \"/{name}.rs\")); }}\n\
         const {constant}: &str = r#\"{text}\"#;\n"
    );
    let written = format!(
        r#"    std::fs::write(
        std::path::Path::new(&std::env::var("OUT_DIR")?).join("{name}.rs"),
        {constant}.replace(
            "{AMBIENT}",
            &luminaire::codegen::as_source(
                &[{ambient}].iter().map(AmbientLight::compile::<Fx16>).fold(Rgb::default(), |sum, light| sum + light),
            )
            .to_string(),
        ),
    )?;
"#
    );
    [text, written]
}

/// Returns the type of a compiled light in `Fx16`, of that of a light.
fn compiled(kind: &str) -> String {
    match kind.split_once('<') {
        Some((kind, models)) => match models.strip_prefix("'static, ") {
            Some(models) => format!("Compiled{kind}<'static, Fx16, {models}"),
            None => format!("Compiled{kind}<Fx16, {models}"),
        },
        None => format!("Compiled{kind}<Fx16>"),
    }
}

fn parts(light: &AnyLight) -> Parts {
    match light {
        AnyLight::Spot(spot) => {
            let (falloff, cone) = cone(&spot.cone());
            let (law, call) = attenuation(spot.attenuation());
            let [position, axis] = [spot.position(), spot.axis()].map(<[f32; 3]>::from);
            let new = format!("SpotLight::new({position:?}, {axis:?}, cone)?");
            let calls = [new].into_iter().chain(call).collect();
            Parts { kind: format!("SpotLight<{falloff}, {law}>"), cone, calls }
        }
        AnyLight::Measured(light) => {
            let (law, call) = attenuation(light.attenuation());
            let [position, axis, side] =
                [light.position(), light.given_axis(), light.given_side()].map(<[f32; 3]>::from);
            let distribution = distribution(light.distribution());
            let new = format!("MeasuredLight::new({position:?}, {axis:?}, {side:?}, {distribution})?");
            let calls = [new].into_iter().chain(call).collect();
            Parts { kind: format!("MeasuredLight<'static, {law}>"), cone: String::new(), calls }
        }
        AnyLight::Point(point) => {
            let (law, call) = attenuation(point.attenuation());
            let position: [f32; 3] = point.position().into();
            let calls = [format!("PointLight::new({position:?})?")].into_iter().chain(call).collect();
            Parts { kind: format!("PointLight<{law}>"), cone: String::new(), calls }
        }
        AnyLight::Directional(sun) => {
            let direction: [f32; 3] = sun.direction().into();
            let calls = vec![format!("DirectionalLight::new({direction:?})?")];
            Parts { kind: "DirectionalLight".to_owned(), cone: String::new(), calls }
        }
    }
}

pub(crate) fn color(name: &str, color: Rgb<f32>) -> String {
    format!(".with_{name}({})?", rgb(color))
}

fn rgb(Rgb { red, green, blue }: Rgb<f32>) -> String {
    format!("Rgb::new({red:?}, {green:?}, {blue:?})")
}

/// Returns the type of the falloff, and the line that makes the cone.
pub(crate) fn cone(cone: &Cone<AnyFalloff>) -> (String, String) {
    let [kind, falloff, _] = falloff_source::<Fx16>(cone.falloff());
    let [inner, outer, limit] = cone.versines().map(|versine| degrees(Angle::from_versine(versine)));
    let hotspot = if cone.has_hotspot() { format!(".with_inner({inner})?") } else { String::new() };
    let cutoff = if cone.has_cutoff() { format!(".with_cutoff({limit})?") } else { String::new() };
    (kind, format!("    let cone = Cone::from_outer({falloff}, {outer})?{hotspot}{cutoff};\n"))
}

/// Returns an angle with six digits.
pub(crate) fn degrees(angle: Angle) -> String {
    let exact = angle.to_degrees();
    let short: f32 = format!("{exact:.5e}").parse().unwrap_or(exact);
    format!("Angle::degrees({short:?})")
}

/// Returns the type of an attenuation, and the call that gives it to a light; `None` for the inverse
/// square, which every light has at first.
pub(crate) fn attenuation(attenuation: AnyAttenuation) -> (String, Option<String>) {
    let row = attenuation.row();
    let numbers: Vec<_> = attenuation.numbers().map(|number| format!("{number:?}")).collect();
    let law = if numbers.is_empty() {
        row.law_type.to_owned()
    } else {
        format!("{}::new({})?", row.law_type, numbers.join(", "))
    };
    // A window without a range leaves the law as it is.
    let (kind, value) = match (row.window, attenuation.range()) {
        (Some(_), Some(range)) => {
            // A macro's type has spaces around its brackets.
            let kind = row.type_name.replace(' ', "");
            let constructor = kind.split('<').next().unwrap_or(&kind);
            let value = format!("{constructor}::new({law}, Some({range:?}))?");
            (kind, value)
        }
        _ => (row.law_type.to_owned(), law),
    };
    let call = (kind != "InverseSquare").then(|| format!(".with_attenuation({value})"));
    (kind, call)
}
