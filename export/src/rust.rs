//! Lights as constants of Rust, of concrete types.

use luminaire::attenuation::{AnyAttenuation, Attenuation, WithAttenuation};
use luminaire::codegen::{ConeParts, Parts, as_source, name};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Falloff, WithFalloff, with_falloff};
use luminaire::light::{CompiledCone, CompiledPointLight, CompiledSpotLight};
use luminaire::{PointLight, Rgb, Scalar, SpotLight};

use crate::error::ExportError;
use crate::head::head;

/// Returns a module with the constant `LIGHT` in the format `S`.
pub(crate) fn export<S: Scalar>(light: &AnyLight, light_name: &str) -> Result<String, ExportError> {
    let format = match S::NAME {
        "fx16" => "Fx16",
        "fx32" => "Fx32",
        _ => "f32",
    };
    let (kind, value) = match light {
        AnyLight::Spot(spot) => attenuated::<S>(spot)?,
        AnyLight::Point(point) => around::<S>(point)?,
        AnyLight::Directional(directional) => (
            "CompiledDirectionalLight<FORMAT>".to_owned(),
            as_source(&directional.compile::<S>()).to_string(),
        ),
    };
    let head: String = head(light, light_name).iter().map(|line| format!("// {line}\n")).collect();
    let imports = "#[allow(unused_imports, reason = \"not every light names a type of each module\")]\n    \
                   use luminaire::{attenuation::*, falloff::*, light::*, *};";
    let kind = spelled(&kind.replace("FORMAT", format));
    let value = value.trim_end();
    Ok(format!(
        "{head}\npub mod {light_name} {{\n    {imports}\n\n    /// The compiled light.\n    \
         pub const LIGHT: {kind} = {value};\n}}\n"
    ))
}

/// Returns a type as it is written: those of the list have spaces around their brackets.
pub(crate) fn spelled(kind: &str) -> String {
    kind.replace(" <", "<").replace("< ", "<").replace(" >", ">")
}

/// Takes the source of a falloff.
struct FalloffSource;

impl WithFalloff<f32> for FalloffSource {
    type Output = String;

    fn falloff<P: Falloff>(self, falloff: P, _: P::Compiled<f32>) -> String {
        // The block around the value only imports names.
        let block = as_source(&falloff).to_string();
        let value = block.split_once(";\n").and_then(|(_, rest)| rest.trim_end().strip_suffix('}'));
        value.unwrap_or(&block).trim_end().to_owned()
    }
}

/// Returns the name of the type of a falloff, and its value.
pub(crate) fn falloff_source(falloff: AnyFalloff) -> (String, String) {
    (spelled(falloff.type_name()), with_falloff(falloff, falloff.compile::<f32>(), FalloffSource))
}

type Spot = SpotLight<AnyFalloff, AnyAttenuation>;

/// Returns the type and the value of a point light.
fn around<S: Scalar>(light: &PointLight<AnyAttenuation>) -> Result<(String, String), ExportError> {
    let parts = light.compile::<S>()?.parts();
    let colors = [light.color(), light.specular_color()].map(|color| color.map(S::from_f32));
    Ok(light.attenuation().with(Around { parts, colors }))
}

/// Writes a point light with its attenuation.
struct Around<S: Scalar> {
    parts: Parts<S, AnyAttenuation>,
    colors: [Rgb<S>; 2],
}

impl<S: Scalar> WithAttenuation for Around<S> {
    type Output = (String, String);

    fn attenuation<A: Attenuation>(self, law: A) -> (String, String) {
        let Self { parts, colors } = self;
        let light = CompiledPointLight::<S, A>::from_parts(
            parts.position,
            law.constants::<S>(),
            parts.intensity,
            parts.fine_below,
            colors,
        );
        (format!("CompiledPointLight<FORMAT, {}>", name::<A>()), as_source(&light).to_string())
    }
}

/// Returns the type and the value of a spotlight.
fn attenuated<S: Scalar>(light: &Spot) -> Result<(String, String), ExportError> {
    let compiled = light.compile::<S>()?;
    let Some(cone) = compiled.parts().cone else { unreachable!("a spotlight has a cone") };
    let colors = [light.color(), light.specular_color()].map(|color| color.map(S::from_f32));
    let shape = Shaped { light, parts: compiled.parts(), cone, colors };
    Ok(light.attenuation().with(shape))
}

/// Writes a spotlight with its attenuation.
struct Shaped<'a, S: Scalar> {
    light: &'a Spot,
    parts: Parts<S, AnyAttenuation>,
    cone: ConeParts<S>,
    colors: [Rgb<S>; 2],
}

impl<S: Scalar> WithAttenuation for Shaped<'_, S> {
    type Output = (String, String);

    fn attenuation<A: Attenuation>(self, law: A) -> (String, String) {
        let falloff = self.light.cone().falloff();
        let kind = format!("CompiledSpotLight<FORMAT, {}, {}>", falloff.type_name(), name::<A>());
        (kind, with_falloff(falloff, falloff.compile::<S>(), Attenuated { shape: self, law }))
    }
}

/// Writes a spotlight with its falloff.
struct Attenuated<'a, S: Scalar, A> {
    shape: Shaped<'a, S>,
    law: A,
}

impl<S: Scalar, A: Attenuation> WithFalloff<S> for Attenuated<'_, S, A> {
    type Output = String;

    fn falloff<P: Falloff>(self, falloff: P, curve: P::Compiled<S>) -> String {
        let Shaped { parts, cone, colors, .. } = self.shape;
        let light = CompiledSpotLight::<S, P, A>::from_parts(
            parts.position,
            cone.axis,
            CompiledCone::from_parts(cone.ramp, falloff, curve),
            cone.outside,
            self.law.constants::<S>(),
            parts.intensity,
            parts.fine_below,
            colors,
        );
        as_source(&light).to_string()
    }
}
