//! Lights as C in the integers of the 16-bit format.

mod formula;

use std::fmt::Write;

use luminaire::attenuation::AnyAttenuation;
use luminaire::codegen::Parts;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Cubic, Falloff, Formula};
use luminaire::{DirectionalLight, Fx16, Fx32, Length, Rgb, SpotLight};

use self::formula::{Precision, gain_of};
use crate::error::ExportError;
use crate::head::{guarded, head};
use crate::name::global;
use crate::trace::Trace;

/// The files of C that the source of lights in [`Language::CFixed`](crate::Language::CFixed) includes, and
/// `luminaire_display.h`: names and texts.
pub const C_HEADERS: [(&str, &str); 3] = [
    ("luminaire.h", include_str!("../c/src/luminaire.h")),
    ("luminaire_constant.h", include_str!("../c/src/luminaire_constant.h")),
    ("luminaire_display.h", include_str!("../c/src/luminaire_display.h")),
];
/// The functions of a cone.
const CONE: &str = include_str!("fixed/cone.h");
/// What replaces them for a point light.
const SPHERE: &str = include_str!("fixed/sphere.h");
/// The irradiance of a light.
const LIGHT: &str = include_str!("fixed/light.h");
/// What stands in the three files for the name of the light.
const NAME: &str = "NAME";
/// What stands in [`LIGHT`] for the coarse share of the light, window included.
const WINDOWED: &str = "WINDOWED";

const PRECISIONS: [Precision; 2] = [Precision("coarse"), Precision("fine")];

/// Returns the constants and functions of a light.
pub(crate) fn export(light: &AnyLight, name: &str) -> Result<String, ExportError> {
    let (parts, law, trace) = match light {
        AnyLight::Spot(spot) => {
            (spot.compile::<Fx16>()?.parts(), spot.attenuation(), Some(Trace::of(spot.cone().falloff())))
        }
        AnyLight::Point(point) => (point.compile::<Fx16>()?.parts(), point.attenuation(), None),
        AnyLight::Directional(sun) => return Ok(directional(light, sun, name)),
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
    if let AnyLight::Spot(spot) = light {
        text += &moving(spot, name, &parts).unwrap_or_default();
    }
    Ok(file(light, name, &text))
}

/// Returns the file of a light.
fn file(light: &AnyLight, name: &str, text: &str) -> String {
    let head = head(light, name).join("\n * ")
        + "\n * A point has steps of 2^-16; a normal, the falloff and the irradiance have steps of 2^-14.";
    guarded(name, &head, &format!("#include \"luminaire_constant.h\"\n\n{text}"))
}

/// Returns the file of a directional light.
fn directional(light: &AnyLight, sun: &DirectionalLight, name: &str) -> String {
    let (direction, intensity) = sun.compile::<Fx16>().parts();
    let (direction, color) = (list(direction.map(Fx32::to_bits)), steps(sun.color()));
    let (intensity, constant) = (gain_of(intensity), global(name, "light"));
    let text = format!(
        "/* The linear colour, in steps of 2^-14. */\nstatic const int16_t {}[3] = {color};\n\
         /* The light. */\nstatic const luminaire_directional {constant} = {{ {direction}, {intensity}, {color} }};\n\n\
         /* Returns the irradiance at a unit normal, before the colour, in steps of 2^-14. */\n\
         static inline uint32_t {}(const int16_t normal[3]) {{\n    \
         return luminaire_directional_irradiance(&{constant}, normal);\n}}\n",
        global(name, "color"),
        global(name, "irradiance"),
    );
    file(light, name, &text)
}

/// Returns a function that returns the light as a `luminaire_spot`, if its falloff and attenuation are those
/// of one.
fn moving(
    spot: &SpotLight<AnyFalloff, AnyAttenuation>,
    name: &str,
    parts: &Parts<Fx16, AnyAttenuation>,
) -> Option<String> {
    let falloff = spot.cone().falloff();
    let (AnyAttenuation::InverseSquare(_), Formula::Polynomial([a, b, c])) =
        (spot.attenuation(), falloff.formula())
    else {
        return None;
    };
    let (g, h) = Cubic::new(a, b, c).ok()?.compile::<Fx16>().weights();
    let of = |part| global(name, part);
    let three = |of: &str| format!("{{ {of}[0], {of}[1], {of}[2] }}");
    let ramp = parts.cone?.ramp.to_bits().map(|bits| format!("UINT32_C({bits})")).join(", ");
    Some(format!(
        "\n/* Returns the light as one that moves. */\n\
         static inline luminaire_spot {}(void) {{\n    luminaire_spot spot = {{\n        {}, {}, {{ {ramp} }},\n        \
         {}, {}, {}, {}, {}, {}\n    }};\n    return spot;\n}}\n",
        of("spot"),
        three(&of("position")),
        three(&of("axis")),
        g.to_bits(),
        h.to_bits(),
        gain_of(parts.intensity),
        of("fine_below"),
        three(&of("color")),
        of("outside"),
    ))
}

/// Returns the constants of a light that has a position.
fn constants(name: &str, color: Rgb<f32>, parts: &Parts<Fx16, AnyAttenuation>) -> String {
    let mut text = String::new();
    let mut define = |kind: &str, part: &str, value: String, doc: &str| {
        let (part, size) = part.split_at(part.find('[').unwrap_or(part.len()));
        let _ = writeln!(text, "/* {doc} */\nstatic const {kind} {}{size} = {value};", global(name, part));
    };
    let position = list(parts.position.map(Length::to_bits));
    define("int32_t", "position[3]", position, "The position, in steps of 2^-16.");
    define("int16_t", "color[3]", steps(color), "The linear colour, in steps of 2^-14.");
    define("luminaire_gain", "intensity", gain_of(parts.intensity), "The intensity.");
    let doc = "The points that need the fine evaluation: within an encoded distance.";
    define("uint32_t", "fine_below", format!("UINT32_C({:#x})", parts.fine_below), doc);
    if let Some(cone) = parts.cone {
        define("int32_t", "axis[3]", list(cone.axis.map(Fx32::to_bits)), "The axis, in steps of 2^-30.");
        let ramp = cone.ramp.to_bits().map(|bits| format!("UINT32_C({bits})")).join(", ");
        let doc = "The map from a versine to the falloff's argument.";
        define("luminaire_ramp", "ramp", format!("{{ {ramp} }}"), doc);
        let outside = format!("{}", cone.outside.to_bits().max(0));
        let doc = "The squared cosine of half the outer angle, less a margin.";
        define("int32_t", "outside", outside, doc);
    }
    text
}

/// Returns the initialiser of a colour in steps of 2^-14.
fn steps(color: Rgb<f32>) -> String {
    format!("{{ {} }}", <[_; 3]>::from(color.map(|c| Fx16::from_f32(c).to_bits().to_string())).join(", "))
}

/// Returns the initialiser of three numbers.
fn list(numbers: impl Into<[i32; 3]>) -> String {
    let numbers = numbers.into().map(|number| format!("INT32_C({number})"));
    format!("{{ {} }}", numbers.join(", "))
}
