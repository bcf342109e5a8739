//! Lights as functions in `f32`: GLSL, WGSL and C.

mod expression;
mod formula;
mod light;
mod names;
mod syntax;

use luminaire::dynamic::AnyLight;

use self::names::Names;
pub(crate) use self::syntax::Syntax;
use crate::error::ExportError;
use crate::head::head;

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
            let guard = format!("{}_LIGHT_H", name.to_ascii_uppercase());
            let head = head.join("\n * ");
            let include =
                if text.contains("sqrtf") || text.contains("powf") { "#include <math.h>\n\n" } else { "" };
            format!("/* {head} */\n#ifndef {guard}\n#define {guard}\n\n{include}{text}\n#endif\n")
        }
    })
}
