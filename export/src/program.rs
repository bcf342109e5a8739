//! Lights as programs of Rust that draw them.

use luminaire::attenuation::Attenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Falloff, Formula, Step};
use luminaire::projector::Projection;
use luminaire::{Angle, Cone, Fx16, Rgb, Vec3};

use crate::error::ExportError;
use crate::item::Item;
use crate::json::kind;
use crate::script::{attenuation, color, cone, degrees, own_head};

/// The largest distance of the screen on which the program draws the pool, in scene units.
const DISTANCE: f32 = 4.0;

/// Characters from the middle of the picture to its side.
const REACH: f32 = 20.0;

/// Returns a function that prints the pool of a spotlight as characters, evaluated in 16 bits.
pub(crate) fn export(light: &AnyLight, name: &str) -> Result<String, ExportError> {
    let AnyLight::Spot(spot) = light else {
        return Err(ExportError::new("light", kind(light), "a spotlight"));
    };
    spot.compile::<Fx16>()?;
    let law = spot.attenuation();
    let distance = law.range().map_or(DISTANCE, |range| DISTANCE.min(range / 2.0));
    let brightest = spot.intensity() * law.exact(distance.into()) as f32;
    // Of a dark light nothing is shown.
    let full = if brightest > 0.0 { brightest } else { 1.0 };
    let (position, axis) = (spot.position(), spot.axis());
    let half = (spot.cone().outer().to_degrees() / 2.0).min(60.0).to_radians();
    // Of any width: the directions alone are taken.
    let square = Projection::of(&spot.with_cone(Cone::from_outer(Step, Angle::degrees(90.0))?))?;
    let step = distance * half.tan() / REACH;
    let (right, down) = (square.right().map(|way| step * way), square.up().map(|way| -step * way));
    let middle = position.zip(axis, |position, axis| position + distance * axis);
    let law = attenuation(law).1.unwrap_or_default();
    let tint = if spot.color() == Rgb::new(1.0, 1.0, 1.0) { "" } else { &color("color", spot.color()) };
    Ok(format!(
        r#"{head}fn {name}() -> Result<(), Error> {{
{cone}    let light = SpotLight::new({position}, {axis}, cone)?
        {law}{tint}.with_intensity({intensity:?})?;
    let (lit, normal) = (light.compile::<Fx16>()?, Fx16::normal({normal}));
    // A screen across the axis, {distance:?} from the light: its middle, and a step to the right and down.
    let (middle, right, down) =
        ({middle}, {right}, {down});
    for row in -10..=10_i8 {{
        let line = (-20..=20_i8).map(|column| {{
            let (x, y) = (f32::from(column), f32::from(2 * row));
            let point = std::array::from_fn(|i| middle[i] + x * right[i] + y * down[i]);
            let shade = lit.irradiance(Fx16::point(point), normal).to_f32() / {full:?};
            char::from(b" .:-=+*#%@"[(9.0 * shade).round().min(9.0) as usize])
        }});
        println!("{{}}", line.collect::<String>());
    }}
    Ok(())
}}
"#,
        head = own_head(light, name),
        cone = if is_of_two_angles(&spot.cone()) {
            let [beam, field] = [spot.cone().beam(), spot.cone().field()].map(degrees);
            format!("    let cone = Cone::from_beam_and_field({beam}, {field})?;\n")
        } else {
            cone(&spot.cone()).1
        },
        position = short(position),
        axis = short(axis),
        normal = short(axis.map(|axis| -axis)),
        middle = short(middle),
        right = short(right),
        down = short(down),
        intensity = spot.intensity(),
    ))
}

/// Returns whether the beam and the field angle of a cone make it again.
fn is_of_two_angles(cone: &Cone<AnyFalloff>) -> bool {
    let Ok(fitted) = Cone::from_beam_and_field(cone.beam(), cone.field()) else { return false };
    let [own, other] = [cone.falloff(), fitted.falloff().into()];
    let near = |own: f32, other: f32| (own - other).abs() <= 1e-3 * other.abs().max(1.0);
    let [inner, outer, limit] = cone.versines();
    inner == 0.0
        && limit == outer
        && (outer / fitted.outer_versine() - 1.0).abs() <= 1e-3
        && matches!((own.formula(), other.formula()), (Formula::Polynomial(own), Formula::Polynomial(other))
            if own.into_iter().zip(other).all(|(own, other)| near(own, other)))
}

/// Returns a program of the lights: of one alone, its function is `main`.
pub(crate) fn joined(items: &[Item<'_>]) -> String {
    let texts: Vec<_> = items.iter().map(|item| &*item.text).collect();
    let mut text = texts.join("\n");
    if let [Item { name, .. }] = items {
        text = text.replacen(&format!("fn {name}()"), "fn main()", 1);
    } else {
        let call = |Item { name, .. }: &Item<'_>| format!("    println!(\"{name}\");\n    {name}()?;\n");
        let calls: String = items.iter().map(call).collect();
        text += &format!("\nfn main() -> Result<(), Error> {{\n{calls}    Ok(())\n}}\n");
    }
    let used = |word, import| if text.contains(word) { import } else { "" };
    format!(
        "{}{}use luminaire::{{Angle, Cone, Error, Fx16, {}SpotLight}};\n\n{text}",
        used(".with_attenuation(", "use luminaire::attenuation::*;\n"),
        used("Cone::from_outer(", "use luminaire::falloff::*;\n"),
        used("Rgb::new(", "Rgb, "),
    )
}

/// Returns a vector with four decimals.
fn short(vector: Vec3<f32>) -> String {
    format!("{:?}", <[f32; 3]>::from(vector.map(|number| (number * 1e4).round() / 1e4 + 0.0)))
}
