//! Lights as functions in `f32`: GLSL, WGSL and C.

mod expression;
mod formula;
mod light;
mod measured;
mod names;
mod scene;
mod syntax;

use luminaire::dynamic::AnyLight;

use self::names::Names;
pub(crate) use self::scene::scene;
pub(crate) use self::syntax::Syntax;
use crate::error::ExportError;
use crate::head::{guarded, head};

/// Returns the functions of a light.
pub(crate) fn export(light: &AnyLight, name: &str, syntax: Syntax) -> Result<String, ExportError> {
    let names = Names(name);
    let text = syntax.program(names, &light::program(names, light)?);
    let mut head = head(light, name);
    if syntax == Syntax::Glsl {
        head.push("GLSL ES 3.00, GLSL 1.30 and later, and without a table GLSL ES 1.00.".to_owned());
    }
    Ok(match syntax {
        Syntax::Glsl | Syntax::Wgsl => {
            let head: String = head.iter().map(|line| format!("// {line}\n")).collect();
            format!("{head}\n{text}")
        }
        Syntax::C => {
            let include =
                if text.contains("sqrtf") || text.contains("powf") { "#include <math.h>\n\n" } else { "" };
            guarded(name, "light", &head.join("\n * "), &format!("{include}{text}"))
        }
    })
}

/// Returns GLSL in which the numbers of a light are uniforms, so that it can move, zoom and change its
/// colour. Tables and the numbers of the attenuation stay constants.
pub(crate) fn with_uniforms(light: &AnyLight, name: &str) -> Result<String, ExportError> {
    let mut text = export(light, name, Syntax::Glsl)?;
    let mut declared = Vec::new();
    for line in text.clone().lines() {
        // `const highp vec3 luminaire_key_Axis = vec3(0.0, 0.0, 1.0); // unit vector along the beam`
        let Some((name_of, value)) =
            line.strip_prefix("const highp ").and_then(|rest| rest.split_once(" = "))
        else {
            continue;
        };
        let ((kind, own), Some((value, doc))) =
            (name_of.split_once(' ').unwrap_or_default(), value.split_once("; // "))
        else {
            continue;
        };
        let public = own.trim_start_matches("luminaire_").to_ascii_lowercase();
        text = text.replace(line, &format!("uniform highp {kind} {own}; // {doc}: {value}"));
        declared.push((own.to_owned(), public));
    }
    for (own, public) in declared {
        text = text.replace(&own, &public);
    }
    Ok(text)
}
