//! Lights as constants of Rust, of concrete types.

use std::fmt;
use std::marker::PhantomData;
use std::ops::Add;

use luminaire::attenuation::{AnyAttenuation, Attenuation, WithAttenuation};
use luminaire::codegen::{Parts, Source, as_source, name};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Cubic, Falloff, Formula, WithFalloff, with_falloff};
use luminaire::light::Distribution;
use luminaire::number::Quick;
use luminaire::{Fx16, MeasuredLight, Scalar, SpotLight};

use crate::error::ExportError;
use crate::head::head;
use crate::item::Item;
use crate::scene::Together;

/// A compiled light as a constant of Rust.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Constant {
    /// The type, whose names are those of the modules `attenuation`, `falloff` and `light` of the kernel and of its
    /// root.
    pub type_name: String,
    /// The value: a block that imports the names it uses.
    pub value: String,
}

/// Returns the light compiled for the format `S`, of concrete types.
///
/// # Errors
/// A light that the format cannot hold.
pub fn constant<S: Scalar>(light: &AnyLight) -> Result<Constant, ExportError> {
    Ok(match light {
        AnyLight::Spot(spot) => {
            let (attenuation, falloff) = (spot.attenuation(), spot.cone().falloff());
            placed("CompiledSpotLight", light, &spot.compile::<S>()?.parts(), attenuation, Some(falloff))
        }
        AnyLight::Measured(light) => measured::<S>(light)?,
        AnyLight::Point(point) => {
            placed("CompiledPointLight", light, &point.compile::<S>()?.parts(), point.attenuation(), None)
        }
        AnyLight::Directional(directional) => Constant {
            type_name: format!("CompiledDirectionalLight<{}>", name::<S>()),
            value: as_source(&directional.compile::<S>()).to_string(),
        },
    })
}

/// Returns the spotlight compiled for the quick evaluation of the format `S`, of concrete types.
///
/// # Errors
/// A light that the evaluation cannot hold.
pub fn quick_constant<S: Quick>(
    spot: &SpotLight<AnyFalloff, AnyAttenuation>,
) -> Result<Constant, ExportError> {
    let parts = spot.compile_quick::<S>()?.parts();
    let falloff = Some(spot.cone().falloff());
    Ok(placed("QuickSpotLight", &AnyLight::Spot(*spot), &parts, spot.attenuation(), falloff))
}

/// Returns a module with the constant `LIGHT` in the format `S`.
pub(crate) fn export<S: Scalar>(light: &AnyLight, light_name: &str) -> Result<String, ExportError> {
    let Constant { type_name, value } = constant::<S>(light)?;
    let head: String = head(light, light_name).iter().map(|line| format!("// {line}\n")).collect();
    let imports = "#[allow(unused_imports, reason = \"not every light names a type of each module\")]\n    \
                   use luminaire::{attenuation::*, falloff::*, light::*, *};";
    let value = value.trim_end();
    Ok(format!(
        "{head}\npub mod {light_name} {{\n    {imports}\n\n    /// The compiled light.\n    \
         pub const LIGHT: {type_name} = {value};\n}}\n"
    ))
}

/// Returns a module with the lights of a scene in the format `S`, in one structure.
pub(crate) fn scene<S: Scalar>(together: &Together<'_>) -> Result<String, ExportError>
where
    S::Irradiance: Add<Output = S::Irradiance> + Source,
{
    let mut members = Vec::new();
    for item in together.items {
        let (own, shared) = (constant::<S>(&item.light)?, shared::<S>(&item.light)?);
        let is_own = own.type_name == shared.type_name;
        let value =
            if is_own { format!("super::{}::LIGHT", item.name) } else { shared.value.trim_end().to_owned() };
        members.push((item, shared.type_name, value));
    }
    let ambient = as_source(&together.ambient::<S>()).to_string();
    let text = indented(&structure::<S>(together, &members, &ambient));
    Ok(format!("/// The lights of the scene {0} together.\npub mod {0} {{\n{text}}}\n", together.name))
}

/// Returns the light as [`constant`] does, but in `Fx16` a spotlight of a polynomial with the inverse square as one of
/// a [`Cubic`]: of such lights all are of one type.
///
/// The code of each type is its own. The bits are those of `luminaire_spot` in C.
fn shared<S: Scalar>(light: &AnyLight) -> Result<Constant, ExportError> {
    // With three soft and two fitted spotlights, a point light, a directional one and ambient light, rows of RGB565 take
    // 7.6 kB of a Cortex-M0 and 1,334 instructions a pixel by one type, 10.8 kB and 1,306 by two, and 27 kB and 2,268 as an
    // array of lights of any kind (measured once, with `opt-level = "s"`).
    if let (AnyLight::Spot(spot), true) = (light, S::NAME == Fx16::NAME)
        && let (AnyAttenuation::InverseSquare(_), Formula::Polynomial([a, b, c])) =
            (spot.attenuation(), spot.cone().falloff().formula())
        && let Ok(cubic) = Cubic::new(a, b, c)
    {
        let parts = spot.compile::<S>()?.parts();
        return Ok(placed("CompiledSpotLight", light, &parts, spot.attenuation(), Some(cubic.into())));
    }
    constant::<S>(light)
}

/// Returns the structure of a scene and its functions, with the type and the value of each light.
pub(crate) fn structure<S: Scalar>(
    together: &Together<'_>,
    members: &[(&Item<'_>, String, String)],
    sum: &str,
) -> String {
    let (format, ambient) = (name::<S>(), &together.ambient_name);
    let (mut fields, mut values, mut points, mut bodies, mut rows) = Default::default();
    let add = |text: &mut String, line: String| *text += &line;
    for (Item { name, light, .. }, type_name, value) in members {
        let place = if matches!(light, AnyLight::Directional(_)) { "normal" } else { "point, normal" };
        add(&mut fields, format!("    /// The light `{name}`.\n    pub {name}: {type_name},\n"));
        add(&mut values, format!("    {name}: {},\n", value.replace('\n', "\n    ")));
        add(
            &mut points,
            format!("        sum += Rgb::lit(self.{name}.irradiance({place}), self.{name}.color());\n"),
        );
        let place = if matches!(light, AnyLight::Directional(_)) { "" } else { "point" };
        add(
            &mut bodies,
            format!(
                "        sum += Rgb::lit(self.{name}.irradiance_facing({place}), self.{name}.color());\n"
            ),
        );
        add(&mut rows, format!("                block.add(&self.{name});\n"));
    }
    let (sum, point) =
        (sum.trim_end().replace('\n', "\n    "), if points.contains("(point") { "point" } else { "_point" });
    let mutable = if points.is_empty() { "" } else { "mut " };
    let normal = if points.is_empty() { "_normal" } else { "normal" };
    format!(
        r#"#[allow(unused_imports, reason = "not every scene names a type of each module")]
use luminaire::{{attenuation::*, falloff::*, light::*, *}};

/// The lights, which change by their methods: `scene.{example} = scene.{example}.dimmed(part)`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Scene {{
{fields}    /// Light that is the same at every point and normal.
    pub {ambient}: Rgb<<{format} as Scalar>::Irradiance>,
}}

/// The lights as they were described.
pub const SCENE: Scene = Scene {{
{values}    {ambient}: {sum},
}};

#[allow(dead_code, reason = "a program may light points or rows alone")]
impl Scene {{
    /// Returns the light at a point with a unit normal: that of all lights, with their colours.
    pub fn light(
        &self,
        {point}: Vec3<<{format} as Scalar>::Length>,
        {normal}: Vec3<{format}>,
    ) -> Rgb<<{format} as Scalar>::Irradiance> {{
        let {mutable}sum = self.{ambient};
{points}        sum
    }}

    /// Returns the light at a point of a surface that faces each light: what a small body without a normal receives,
    /// such as an LED.
    pub fn light_facing(&self, {point}: Vec3<<{format} as Scalar>::Length>) -> Rgb<<{format} as Scalar>::Irradiance> {{
        let {mutable}sum = self.{ambient};
{bodies}        sum
    }}

    /// Calls `show` for each pixel of a row that receives light, with the pixel, its index and the sum of the lights.
    pub fn row<F: Points<{format}>, T>(
        &self,
        row: &Row<{format}, F>,
        pixels: &mut [T],
        show: impl FnMut(&mut T, usize, Rgb<<{format} as Scalar>::Irradiance>),
    ) {{
        row.light_by(
            pixels,
            |block| {{
                block.add_ambient(self.{ambient});
{rows}            }},
            show,
        );
    }}
}}
"#,
        example = members.first().map_or("key", |(item, ..)| item.name),
    )
}

/// Returns lines with four spaces before each that is not empty.
fn indented(text: &str) -> String {
    let line = |line: &str| if line.is_empty() { "\n".to_owned() } else { format!("    {line}\n") };
    text.lines().map(line).collect()
}

/// Returns a spotlight or a point light of a kind.
///
/// Each part becomes text on its own. To write the light as one value of a concrete type needs code
/// for each pair of attenuation and falloff in each format (measured: 1.9 times the WebAssembly of
/// the demo's module `code`).
fn placed<S: Scalar>(
    kind: &str,
    light: &AnyLight,
    parts: &Parts<S, AnyAttenuation>,
    attenuation: AnyAttenuation,
    falloff: Option<AnyFalloff>,
) -> Constant {
    let format = name::<S>();
    let [law, constants] = attenuation.with(AttenuationSource(PhantomData::<S>));
    let mut arguments = vec![expression(&parts.position)];
    let (type_name, function) = match parts.cone.zip(falloff) {
        Some((cone, falloff)) => {
            let [shape, falloff, curve] = falloff_source::<S>(falloff);
            let function = format!("CompiledCone::<{format}, _>::from_parts");
            let compiled = call(&function, &[expression(&cone.ramp), falloff, curve]);
            arguments.extend([expression(&cone.axis), compiled, expression(&cone.outside)]);
            (format!("{kind}<{format}, {shape}, {law}>"), format!("{kind}::<{format}, _, {law}>::from_parts"))
        }
        None => (format!("{kind}<{format}, {law}>"), format!("{kind}::<{format}, {law}>::from_parts")),
    };
    arguments.extend([constants, expression(&parts.intensity)]);
    // The quick evaluation has no points that are fine.
    if kind != "QuickSpotLight" {
        arguments.push(expression(&parts.fine_below));
    }
    let colors = [light.color(), light.specular_color()].map(|color| color.map(S::from_f32));
    arguments.push(expression(&colors));
    Constant { type_name, value: as_source(&Text(call(&function, &arguments))).to_string() }
}

/// Returns a measured light, of a concrete attenuation.
fn measured<S: Scalar>(light: &MeasuredLight<'static, AnyAttenuation>) -> Result<Constant, ExportError> {
    let (compiled, format) = (light.compile::<S>()?, name::<S>());
    let [law, constants] = light.attenuation().with(AttenuationSource(PhantomData::<S>));
    let parts = compiled.parts();
    let colors = [compiled.color(), compiled.specular_color()];
    let arguments = [
        expression(&parts.position),
        expression(&compiled.frame()),
        distribution(light.distribution()),
        expression(&compiled.outside()),
        constants,
        expression(&parts.intensity),
        expression(&parts.fine_below),
        expression(&colors),
    ];
    let function = format!("CompiledMeasuredLight::<{format}, {law}>::from_parts");
    let value = as_source(&Text(call(&function, &arguments))).to_string();
    Ok(Constant { type_name: format!("CompiledMeasuredLight<'static, {format}, {law}>"), value })
}

/// Returns a distribution as an expression, with the samples on one line.
pub(crate) fn distribution(distribution: Distribution<'_>) -> String {
    fmt::from_fn(|out| distribution.write(out)).to_string().replace('\n', "")
}

/// Returns a call of a function, with one argument per line.
fn call(function: &str, arguments: &[String]) -> String {
    format!("{function}(\n    {},\n)", arguments.join(",\n").replace('\n', "\n    "))
}

/// Returns a value as an expression, without the block that imports the names.
fn expression(value: &dyn Source) -> String {
    format!("{:#?}", fmt::from_fn(|out| value.write(out)))
}

/// An expression that is text already.
struct Text(String);

impl Source for Text {
    fn write(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}

/// Writes the type and the constants of an attenuation in the format `S`.
struct AttenuationSource<S>(PhantomData<S>);

impl<S: Scalar> WithAttenuation for AttenuationSource<S> {
    type Output = [String; 2];

    fn attenuation<A: Attenuation>(self, law: A) -> [String; 2] {
        [name::<A>().to_string(), expression(&law.constants::<S>())]
    }
}

/// Writes a falloff, and its coefficients in a format.
struct FalloffSource;

impl<S: Scalar> WithFalloff<S> for FalloffSource {
    type Output = [String; 2];

    fn falloff<P: Falloff>(self, falloff: P, curve: P::Compiled<S>) -> [String; 2] {
        [expression(&falloff), expression(&curve)]
    }
}

/// Returns the name of the type of a falloff, its value, and its coefficients in the format `S`.
///
/// An integer power is of the type that has its exponent, for which the compiler unrolls the loop over its digits.
pub(crate) fn falloff_source<S: Scalar>(falloff: AnyFalloff) -> [String; 3] {
    let unrolled = |kind: &str, exponent: u32| {
        let value = format!("{kind}::<{exponent}>");
        [format!("{kind}<{exponent}>"), value.clone(), value]
    };
    if let AnyFalloff::Power(power) = falloff {
        return unrolled("Power", power.exponent());
    }
    if let AnyFalloff::InvertedPower(power) = falloff {
        return unrolled("InvertedPower", power.exponent());
    }
    // The types of the list have spaces around their brackets.
    let kind = falloff.type_name().replace(" <", "<").replace("< ", "<").replace(" >", ">");
    let [value, curve] = with_falloff(falloff, falloff.compile::<S>(), FalloffSource);
    [kind, value, curve]
}
