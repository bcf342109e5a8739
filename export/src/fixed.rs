//! Lights as C in the integers of the 16-bit format.

mod formula;
mod scene;

use std::fmt::Write;

use luminaire::attenuation::AnyAttenuation;
use luminaire::codegen::Parts;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Cubic, Falloff, Formula};
use luminaire::light::{Distribution, Symmetry};
use luminaire::number::Weight16;
use luminaire::{Fx16, Fx32, Length, Rgb, SpotLight, Vec3};

use self::formula::{Precision, gain_of};
pub(crate) use self::scene::scene;
use crate::error::ExportError;
use crate::head::{guarded, head};
use crate::name::global;
use crate::trace::Trace;

/// The files of C that the source of lights in [`Language::CFixed`](crate::Language::CFixed) includes,
/// `luminaire_display.h` and `luminaire_dmx.h`: names and texts.
pub const C_HEADERS: [(&str, &str); 4] = [
    ("luminaire.h", include_str!("../c/src/luminaire.h")),
    ("luminaire_constant.h", include_str!("../c/src/luminaire_constant.h")),
    ("luminaire_display.h", include_str!("../c/src/luminaire_display.h")),
    ("luminaire_dmx.h", include_str!("../c/src/luminaire_dmx.h")),
];
/// The functions of a cone.
const CONE: &str = include_str!("fixed/cone.h");
/// What replaces them for a point light.
const SPHERE: &str = include_str!("fixed/sphere.h");
/// What replaces them for a light that is not round.
const MEASURED: &str = include_str!("fixed/measured.h");
/// The irradiance of a light.
const LIGHT: &str = include_str!("fixed/light.h");
/// What stands in the four files for the name of the light.
const NAME: &str = "NAME";
/// What stands in [`LIGHT`] for the coarse share of the light, window included.
const WINDOWED: &str = "WINDOWED";

const PRECISIONS: [Precision; 2] = [Precision("coarse"), Precision("fine")];

/// A compiled light.
enum Compiled {
    Placed(Placed),
    /// The initialiser of a `luminaire_directional`.
    Directional(String),
}

/// The constants of a light with a position, and the weights of its falloff if it is that of a `luminaire_spot`.
struct Placed {
    parts: Parts<Fx16, AnyAttenuation>,
    law: AnyAttenuation,
    weights: Option<[i32; 2]>,
    /// What a light that is not round has beside these.
    measured: Option<Measured>,
}

/// The side, the front and the axis of a light that is not round, its distribution, and its bound for points outside.
struct Measured {
    frame: [Vec3<Fx32>; 3],
    distribution: Distribution<'static>,
    outside: Fx16,
}

impl Compiled {
    fn new(light: &AnyLight) -> Result<Self, ExportError> {
        Ok(match light {
            AnyLight::Spot(spot) => Self::Placed(Placed {
                parts: spot.compile::<Fx16>()?.parts(),
                law: spot.attenuation(),
                weights: weights(spot),
                measured: None,
            }),
            AnyLight::Point(point) => Self::Placed(Placed {
                parts: point.compile::<Fx16>()?.parts(),
                law: point.attenuation(),
                weights: None,
                measured: None,
            }),
            AnyLight::Measured(light) => {
                let (own, distribution) = (light.compile::<Fx16>()?, light.distribution());
                let [columns, rows] = distribution.shape();
                let count = distribution.samples().len();
                if count != columns * rows {
                    // The lookup in C tests no bounds.
                    return Err(ExportError::new("number of samples", count, (columns * rows).to_string()));
                }
                let measured = Measured { frame: own.frame(), distribution, outside: own.outside() };
                let (parts, law) = (own.parts(), light.attenuation());
                Self::Placed(Placed { parts, law, weights: None, measured: Some(measured) })
            }
            AnyLight::Directional(sun) => {
                let (direction, intensity) = sun.compile::<Fx16>().parts();
                let (direction, color) = (list(direction.map(Fx32::to_bits)), steps(sun.color()));
                Self::Directional(format!("{{ {direction}, {}, {color} }}", gain_of(intensity)))
            }
        })
    }
}

impl Placed {
    /// Returns the structure of the light.
    fn structure(&self) -> &'static str {
        if self.measured.is_some() { "luminaire_measured" } else { "luminaire_spot" }
    }

    /// Returns the member of that structure that is a `luminaire_spot`, with its point; nothing if it is one itself.
    fn member(&self) -> &'static str {
        if self.measured.is_some() { ".spot" } else { "" }
    }

    /// Returns the initialiser of the structure.
    fn initialiser(&self, color: Rgb<f32>) -> String {
        let spot = self.spot(color);
        let Some(Measured { frame: [side, front, _], .. }) = self.measured else { return spot };
        let [side, front] = [side, front].map(|axis| list(axis.map(Fx32::to_bits)));
        format!("{{\n    {},\n    {side}, {front}\n}}", spot.replace('\n', "\n    "))
    }

    /// Returns the initialiser of a `luminaire_spot`.
    fn spot(&self, color: Rgb<f32>) -> String {
        let Self { parts, weights, .. } = self;
        let (axis, ramp, outside) = match (parts.cone, &self.measured) {
            (Some(cone), _) => (cone.axis, cone.ramp.to_bits(), cone.outside.to_bits().max(0)),
            (None, Some(own)) => (own.frame[2], [0; 9], own.outside.to_bits().max(0)),
            (None, None) => (Vec3::default(), [0; 9], 0),
        };
        let ramp = ramp.map(|bits| format!("UINT32_C({bits})")).join(", ");
        let [g, h] = weights.unwrap_or_default();
        format!(
            "{{\n    {}, {},\n    {{ {ramp} }},\n    {g}, {h}, {}, UINT32_C({:#x}), {}, {outside}\n}}",
            list(parts.position.map(Length::to_bits)),
            list(axis.map(Fx32::to_bits)),
            gain_of(parts.intensity),
            parts.fine_below,
            steps(color)
        )
    }
}

/// Returns the weights of a cubic, if the falloff and the attenuation of a spotlight are those of a `luminaire_spot`.
fn weights(spot: &SpotLight<AnyFalloff, AnyAttenuation>) -> Option<[i32; 2]> {
    let (AnyAttenuation::InverseSquare(_), Formula::Polynomial([a, b, c])) =
        (spot.attenuation(), spot.cone().falloff().formula())
    else {
        return None;
    };
    let (g, h) = Cubic::new(a, b, c).ok()?.compile::<Fx16>().weights();
    Some([g, h].map(Weight16::to_bits))
}

/// Returns the constants and functions of a light.
pub(crate) fn export(light: &AnyLight, name: &str) -> Result<String, ExportError> {
    let color = format!(
        "/* The linear colour, in steps of 2^-14. */\nstatic const int16_t {}[3] = {};\n",
        global(name, "color"),
        steps(light.color()),
    );
    let placed = match Compiled::new(light)? {
        Compiled::Placed(placed) => placed,
        Compiled::Directional(own) => return Ok(file(light, name, &(color + &directional(name, &own)))),
    };
    let mut text = format!(
        "{color}/* The light: its position and axis, the map from a versine to the falloff's argument, its edge if it is that of\n \
         * a light that moves, its intensity, the encoded distance within which points need the fine evaluation, its colour,\n \
         * and the squared cosine of half the outer angle, less a margin. */\n\
         static const {} {} = {};\n",
        placed.structure(),
        global(name, "light"),
        placed.initialiser(light.color()),
    );
    let member = placed.member();
    let Placed { parts, law, weights, measured } = placed;
    let trace = if let AnyLight::Spot(spot) = light { Some(Trace::of(spot.cone().falloff())) } else { None };
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
    let windowed = if has_window { "luminaire_NAME_CoarseWindowed(spot, &coarse, share)" } else { "share" };
    let near = LIGHT.replace(WINDOWED, windowed);
    text.push('\n');
    match (&trace, parts.cone, measured) {
        (Some(trace), Some(_), _) => {
            let table = formula::table(name, trace);
            if !table.is_empty() {
                let _ = writeln!(text, "{table}");
            }
            for precision in PRECISIONS {
                let _ = writeln!(text, "{}", formula::curve(name, trace, precision));
            }
            text += &CONE.replace(NAME, name);
        }
        (.., Some(Measured { distribution, .. })) => {
            let _ = writeln!(text, "{}", table_of(name, distribution));
            text += &MEASURED.replace(NAME, name);
        }
        _ => text += &SPHERE.replace(NAME, name),
    }
    text += &functions;
    // The one use of the light itself.
    let near = near.replace("&luminaire_NAME_Light", &format!("&luminaire_NAME_Light{member}"));
    let _ = write!(text, "\n{}", near.replace(NAME, name));
    if weights.is_some() {
        let _ = write!(
            text,
            "\n/* Returns the light as one that moves. */\n\
             static inline luminaire_spot {}(void) {{\n    return {};\n}}\n",
            global(name, "spot"),
            global(name, "light"),
        );
    }
    Ok(file(light, name, &text))
}

/// Returns the definitions of a distribution and its samples.
fn table_of(name: &str, distribution: Distribution<'_>) -> String {
    let samples = distribution.samples().iter().map(u16::to_string).collect();
    let folds = match distribution.symmetry() {
        Symmetry::None => 0,
        Symmetry::Bilateral => 1,
        Symmetry::Quadrant => 2,
    };
    format!(
        "{}\n/* The intensity over all directions. */\n\
         static const luminaire_distribution {} = {{ {}, {}, {folds} }};\n",
        formula::samples(name, "uint16_t", samples),
        global(name, "distribution"),
        global(name, "table"),
        (distribution.size() / 2).trailing_zeros(),
    )
}

/// Returns the file of a light.
fn file(light: &AnyLight, name: &str, text: &str) -> String {
    let head = head(light, name).join("\n * ")
        + "\n * A point has steps of 2^-16; a normal, the falloff and the irradiance have steps of 2^-14.";
    guarded(name, "light", &head, &format!("#include \"luminaire_constant.h\"\n\n{text}"))
}

/// Returns the constant and the function of a directional light.
fn directional(name: &str, initialiser: &str) -> String {
    let constant = global(name, "light");
    format!(
        "/* The light. */\nstatic const luminaire_directional {constant} = {initialiser};\n\n\
         /* Returns the irradiance at a unit normal, before the colour, in steps of 2^-14. */\n\
         static inline uint32_t {}(const int16_t normal[3]) {{\n    \
         return luminaire_directional_irradiance(&{constant}, normal);\n}}\n",
        global(name, "irradiance"),
    )
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
