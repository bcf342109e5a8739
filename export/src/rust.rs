//! Lights as constants of Rust, of concrete types.

use std::fmt;
use std::marker::PhantomData;

use luminaire::Scalar;
use luminaire::attenuation::{AnyAttenuation, Attenuation, WithAttenuation};
use luminaire::codegen::{Parts, Source, as_source, name};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Falloff, WithFalloff, with_falloff};

use crate::error::ExportError;
use crate::head::head;

/// Returns a module with the constant `LIGHT` in the format `S`.
pub(crate) fn export<S: Scalar>(light: &AnyLight, light_name: &str) -> Result<String, ExportError> {
    let (kind, value) = match light {
        AnyLight::Spot(spot) => {
            placed(light, &spot.compile::<S>()?.parts(), spot.attenuation(), Some(spot.cone().falloff()))
        }
        AnyLight::Point(point) => placed(light, &point.compile::<S>()?.parts(), point.attenuation(), None),
        AnyLight::Directional(directional) => {
            (format!("CompiledDirectionalLight<{}>", name::<S>()), expression(&directional.compile::<S>()))
        }
    };
    let head: String = head(light, light_name).iter().map(|line| format!("// {line}\n")).collect();
    let imports = "#[allow(unused_imports, reason = \"not every light names a type of each module\")]\n    \
                   use luminaire::{attenuation::*, falloff::*, light::*, *};";
    let value = as_source(&Text(value)).to_string();
    let value = value.trim_end();
    Ok(format!(
        "{head}\npub mod {light_name} {{\n    {imports}\n\n    /// The compiled light.\n    \
         pub const LIGHT: {kind} = {value};\n}}\n"
    ))
}

/// Returns the type and the value of a spotlight or a point light.
///
/// Each part becomes text on its own. To write the light as one value of a concrete type needs code
/// for each pair of attenuation and falloff in each format (measured: 1.9 times the WebAssembly of
/// the demo's module `code`).
fn placed<S: Scalar>(
    light: &AnyLight,
    parts: &Parts<S, AnyAttenuation>,
    attenuation: AnyAttenuation,
    falloff: Option<AnyFalloff>,
) -> (String, String) {
    let format = name::<S>();
    let [law, constants] = attenuation.with(AttenuationSource(PhantomData::<S>));
    let mut arguments = vec![expression(&parts.position)];
    let (kind, function) = match parts.cone.zip(falloff) {
        Some((cone, falloff)) => {
            let [shape, falloff, curve] = falloff_source::<S>(falloff);
            let function = format!("CompiledCone::<{format}, _>::from_parts");
            let compiled = call(&function, &[expression(&cone.ramp), falloff, curve]);
            arguments.extend([expression(&cone.axis), compiled, expression(&cone.outside)]);
            (
                format!("CompiledSpotLight<{format}, {shape}, {law}>"),
                format!("CompiledSpotLight::<{format}, _, {law}>::from_parts"),
            )
        }
        None => (
            format!("CompiledPointLight<{format}, {law}>"),
            format!("CompiledPointLight::<{format}, {law}>::from_parts"),
        ),
    };
    let colors = [light.color(), light.specular_color()].map(|color| color.map(S::from_f32));
    let [intensity, fine_below] = [expression(&parts.intensity), expression(&parts.fine_below)];
    arguments.extend([constants, intensity, fine_below, expression(&colors)]);
    (kind, call(&function, &arguments))
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
pub(crate) fn falloff_source<S: Scalar>(falloff: AnyFalloff) -> [String; 3] {
    // The types of the list have spaces around their brackets.
    let kind = falloff.type_name().replace(" <", "<").replace("< ", "<").replace(" >", ">");
    let [value, curve] = with_falloff(falloff, falloff.compile::<S>(), FalloffSource);
    [kind, value, curve]
}
