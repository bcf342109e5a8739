//! Lights as C in the integers of the 16-bit format.

mod formula;

use std::fmt::Write;

use luminaire::attenuation::AnyAttenuation;
use luminaire::codegen::{Parts, Tables};
use luminaire::dynamic::AnyLight;
use luminaire::{Fx16, Rgb};

use self::formula::{Precision, gain_of};
use crate::error::ExportError;
use crate::head::head;
use crate::name::global;
use crate::trace::Trace;

/// The shared functions, without the tables.
const HEADER: &str = include_str!("../c/luminaire.h");
/// The line of the header that the tables replace.
const TABLES: &str = "/* TABLES */\n";
/// What the header ends with: lights that move, and many points.
const FRAGMENTS: [&str; 2] = [include_str!("../c/spot.h"), include_str!("../c/rows.h")];
/// The functions of a cone.
const CONE: &str = include_str!("../c/cone.h");
/// What replaces them for a point light.
const SPHERE: &str = include_str!("../c/sphere.h");
/// The irradiance of a light.
const LIGHT: &str = include_str!("../c/light.h");
/// What stands in the three files for the name of the light.
const NAME: &str = "NAME";
/// What stands in [`LIGHT`] for the coarse share of the light, window included.
const WINDOWED: &str = "WINDOWED";

const PRECISIONS: [Precision; 2] = [Precision("coarse"), Precision("fine")];

/// Returns the file `luminaire.h`, which the source of each light in
/// [`Language::CFixed`](crate::Language::CFixed) includes.
///
/// Its tables are those of the kernel.
pub fn c_header() -> String {
    let Tables { inverse_square_roots, logarithms, powers, .. } = Tables::KERNEL;
    let rows =
        |values: Vec<String>| values.chunks(8).map(|row| row.join(", ")).collect::<Vec<_>>().join(",\n    ");
    let roots = rows(inverse_square_roots.iter().map(u16::to_string).collect());
    let pair =
        |(reciprocal, logarithm): &(u32, u32)| format!("{{ UINT32_C({reciprocal}), UINT32_C({logarithm}) }}");
    let logarithms = logarithms.iter().map(pair).collect::<Vec<_>>().join(",\n    ");
    let powers = rows(powers.iter().map(|power| format!("UINT32_C({power})")).collect());
    let tables = format!(
        "/* 2^31 / sqrt(n) at multiples of 2^25, lowered to the middle between chord and curve. */\n\
         static const uint16_t luminaire_inverse_square_roots[129] LUMINAIRE_TABLE = {{\n    {roots}\n}};\n\n\
         /* 1 / c with 31 fraction bits and log2 c with 32, for the middles of 64 parts of [1, 2). */\n\
         static const uint32_t luminaire_logarithms[64][2] LUMINAIRE_TABLE = {{\n    {logarithms}\n}};\n\n\
         /* 2^-c with 32 fraction bits, for the middles of 64 parts of [0, 1). */\n\
         static const uint32_t luminaire_powers[64] LUMINAIRE_TABLE = {{\n    {powers}\n}};\n"
    );
    let (shared, end) = HEADER.rsplit_once("#endif").unwrap_or((HEADER, ""));
    format!("{}{}#endif{end}", shared.replace(TABLES, &tables), FRAGMENTS.concat())
}

/// Returns the constants and functions of a light.
pub(crate) fn export(light: &AnyLight, name: &str) -> Result<String, ExportError> {
    let (parts, law, trace) = match light {
        AnyLight::Spot(spot) => {
            (spot.compile::<Fx16>()?.parts(), spot.attenuation(), Some(Trace::of(spot.cone().falloff())))
        }
        AnyLight::Point(point) => (point.compile::<Fx16>()?.parts(), point.attenuation(), None),
        _ => {
            let expected = "a spotlight or a point light: export a directional light to c-f32";
            return Err(ExportError::new("light", "directional", expected));
        }
    };
    let mut text = constants(name, light.color(), &parts);
    let [windows, whole] = Trace::of_attenuation(law);
    let (mut constants, mut functions) = (Vec::new(), String::new());
    for precision in PRECISIONS {
        functions += "\n";
        functions += &formula::attenuation(name, "attenuated", &whole, precision, &mut constants);
    }
    let has_window = windows.operations.len() > 1;
    if has_window {
        functions += "\n";
        functions += &formula::attenuation(name, "windowed", &windows, Precision("coarse"), &mut constants);
    }
    for constant in constants {
        let _ = writeln!(text, "{constant}");
    }
    let windowed = if has_window { "luminaire_NAME_CoarseWindowed(&coarse, share)" } else { "share" };
    let near = LIGHT.replace(WINDOWED, windowed);
    text.push('\n');
    match (&trace, parts.cone) {
        (Some(trace), Some(_)) => {
            let table = formula::table(name, trace);
            if !table.is_empty() {
                let _ = writeln!(text, "{table}");
            }
            for precision in PRECISIONS {
                let _ = writeln!(text, "{}", formula::curve(name, trace, precision));
            }
            text += &CONE.replace(NAME, name);
        }
        _ => text += &SPHERE.replace(NAME, name),
    }
    text += &functions;
    let _ = write!(text, "\n{}", near.replace(NAME, name));
    let head = head(light, name).join("\n * ");
    let guard = format!("{}_LIGHT_H", name.to_ascii_uppercase());
    Ok(format!(
        "/* {head}\n * A point has steps of 2^-16; a normal, the falloff and the irradiance have steps of 2^-14. */\n\
         #ifndef {guard}\n#define {guard}\n\n#include \"luminaire.h\"\n\n{text}\n#endif\n"
    ))
}

/// Returns the constants of a light that has a position.
fn constants(name: &str, color: Rgb<f32>, parts: &Parts<Fx16, AnyAttenuation>) -> String {
    let mut text = String::new();
    let mut define = |kind: &str, part: &str, value: String, doc: &str| {
        let (part, size) = part.split_at(part.find('[').unwrap_or(part.len()));
        let _ = writeln!(text, "/* {doc} */\nstatic const {kind} {}{size} = {value};", global(name, part));
    };
    let list = |values: Vec<String>| format!("{{ {} }}", values.join(", "));
    let position: [_; 3] = parts.position.into();
    let position = position.iter().map(|c| format!("INT32_C({})", c.to_bits())).collect();
    define("int32_t", "position[3]", list(position), "The position, in steps of 2^-16.");
    let color = [color.red, color.green, color.blue].map(|c| Fx16::from_f32(c).to_bits().to_string());
    define("int16_t", "color[3]", list(color.to_vec()), "The linear colour, in steps of 2^-14.");
    define("luminaire_gain", "intensity", gain_of(parts.intensity), "The intensity.");
    let doc = "The points that need the fine evaluation: within an encoded distance.";
    define("uint32_t", "fine_below", format!("UINT32_C({:#x})", parts.fine_below), doc);
    if let Some(cone) = parts.cone {
        let axis: [_; 3] = cone.axis.into();
        let axis = axis.iter().map(|c| format!("INT32_C({})", c.to_bits())).collect();
        define("int32_t", "axis[3]", list(axis), "The axis, in steps of 2^-30.");
        let ramp = cone.ramp.to_bits().iter().map(|bits| format!("UINT32_C({bits})")).collect();
        define("luminaire_ramp", "ramp", list(ramp), "The map from a versine to the falloff's argument.");
        let outside = format!("{}", cone.outside.to_bits().max(0));
        let doc = "The squared cosine of half the outer angle, less a margin.";
        define("uint32_t", "outside", outside, doc);
    }
    text
}
