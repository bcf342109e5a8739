//! Lights as programs of Rust that draw them.

use luminaire::attenuation::Attenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::Step;
use luminaire::projector::Projection;
use luminaire::{Angle, Cone, Fx16, Rgb, Vec3};

use crate::error::ExportError;
use crate::head::head;
use crate::script::{attenuation, color, degrees};

/// The largest distance of the screen on which the program draws the pool, in scene units.
const DISTANCE: f32 = 4.0;

/// Characters from the middle of the picture to its side.
const REACH: f32 = 20.0;

/// Returns a program that prints the pool of a spotlight as characters, evaluated in 16 bits. It makes
/// the cone from the beam and the field angle; an edge that these two do not determine is the fitted one.
pub(crate) fn export(light: &AnyLight, name: &str) -> Result<String, ExportError> {
    let AnyLight::Spot(spot) = light else {
        return Err(ExportError::new("light", name, "a spotlight".to_owned()));
    };
    let cone = Cone::from_beam_and_field(spot.cone().beam(), spot.cone().field())?;
    let fitted = spot.with_cone(cone);
    fitted.compile::<Fx16>()?;
    let law = spot.attenuation();
    let distance = law.range().map_or(DISTANCE, |range| DISTANCE.min(range / 2.0));
    let brightest = spot.intensity() * law.exact(distance.into()) as f32;
    // Of a dark light nothing is shown.
    let full = if brightest > 0.0 { brightest } else { 1.0 };
    let (position, axis) = (spot.position(), spot.axis());
    let half = (cone.outer().to_degrees() / 2.0).min(60.0).to_radians();
    // Of any width: the directions alone are taken.
    let square = Projection::of(&spot.with_cone(Cone::from_outer(Step, Angle::degrees(90.0))?))?;
    let step = distance * half.tan() / REACH;
    let (right, down) = (square.right().map(|way| step * way), square.up().map(|way| -step * way));
    let middle = position.zip(axis, |position, axis| position + distance * axis);
    let (law, imports) = match attenuation(law).1 {
        Some(call) => (call, "use luminaire::attenuation::*;\n"),
        None => (String::new(), ""),
    };
    let tint = if spot.color() == Rgb::new(1.0, 1.0, 1.0) { "" } else { &color("color", spot.color()) };
    let rgb = if tint.is_empty() { "" } else { "Rgb, " };
    let head: String =
        head(light, name).iter().map(|line| format!("// {}\n", line.replace(": do not edit", ""))).collect();
    Ok(format!(
        r#"{head}
{imports}use luminaire::{{Angle, Cone, Error, Fx16, {rgb}SpotLight}};

fn main() -> Result<(), Error> {{
    let cone = Cone::from_beam_and_field({beam}, {field})?;
    let light = SpotLight::new({position}, {axis}, cone)?
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
        beam = degrees(spot.cone().beam()),
        field = degrees(spot.cone().field()),
        position = short(position),
        axis = short(axis),
        normal = short(axis.map(|axis| -axis)),
        middle = short(middle),
        right = short(right),
        down = short(down),
        intensity = spot.intensity(),
    ))
}

/// Returns a vector with four decimals.
fn short(vector: Vec3<f32>) -> String {
    format!("{:?}", <[f32; 3]>::from(vector.map(|number| (number * 1e4).round() / 1e4 + 0.0)))
}
