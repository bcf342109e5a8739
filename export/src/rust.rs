//! Lights as constants of Rust, of concrete types.

#[allow(clippy::wildcard_imports, reason = "the types of the list")]
use luminaire::attenuation::*;
use luminaire::codegen::{Named, Source, SourceScalar, as_source};
use luminaire::dynamic::AnyLight;
#[allow(clippy::wildcard_imports, reason = "the types of the list")]
use luminaire::falloff::*;
use luminaire::light::{CompiledCone, CompiledPointLight, CompiledSpotLight};
use luminaire::{PointLight, Scalar, SpotLight};

use crate::error::ExportError;
use crate::head;

/// Returns a module with the constant `LIGHT` in the format `S`.
pub(crate) fn export<S: SourceScalar>(light: &AnyLight, name: &str) -> Result<String, ExportError> {
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
    let head: String = head(light, name).iter().map(|line| format!("// {line}\n")).collect();
    let imports = "#[allow(unused_imports, reason = \"not every light names a type of each module\")]\n    \
                   use luminaire::{attenuation::*, falloff::*, light::*, *};";
    let kind = spelled(&kind.replace("FORMAT", format));
    let value = value.trim_end();
    Ok(format!(
        "{head}\npub mod {name} {{\n    {imports}\n\n    /// The compiled light.\n    \
         pub const LIGHT: {kind} = {value};\n}}\n"
    ))
}

/// Returns a type as it is written: those of the list have spaces around their brackets.
pub(crate) fn spelled(kind: &str) -> String {
    kind.replace(" <", "<").replace("< ", "<").replace(" >", ">")
}

macro_rules! with_attenuation {
    ([$any:expr, $inner:ident, $name:ident, $answer:expr]
     $($(#[$doc:meta])* $variant:ident($type:ty) = any $draw:expr
       $(, $(#[$its_doc:meta])* $constant:ty = $its_name:literal, $value:expr)*;)*) => {
        match $any {
            // Without a range, these are the plain laws.
            AnyAttenuation::Constant(cut) if cut.range().is_none() => {
                let ($inner, $name) = (cut.attenuation(), "NoAttenuation");
                $answer
            }
            AnyAttenuation::InverseSquare(cut) if cut.range().is_none() => {
                let ($inner, $name) = (cut.attenuation(), "InverseSquare");
                $answer
            }
            AnyAttenuation::Polynomial(cut) if cut.range().is_none() => {
                let ($inner, $name) = (cut.attenuation(), "Polynomial");
                $answer
            }
            $(AnyAttenuation::$variant($inner) => {
                let $name = stringify!($type);
                $answer
            })*
            _ => unreachable!("the list has every attenuation"),
        }
    };
}

macro_rules! with_falloff {
    ([$any:expr, $inner:ident, $name:ident, $answer:expr]
     $($(#[$doc:meta])* $variant:ident($type:ty) = $text:literal, $sample:expr, $truth:expr
       $(, any $draw:expr)? $(, constant $constant:ty = $its_name:literal, $value:expr, $its_truth:expr)?;)*) => {
        match $any {
            $(AnyFalloff::$variant($inner) => {
                let $name = stringify!($type);
                $answer
            })*
            _ => unreachable!("the list has every falloff"),
        }
    };
}

/// Returns the name of the type of an attenuation.
pub(crate) fn attenuation_type(attenuation: AnyAttenuation) -> String {
    spelled(luminaire::attenuations! { with_attenuation; [attenuation, _law, name, name] })
}

/// Returns the name of the type of a falloff, and its value.
pub(crate) fn falloff_source(falloff: AnyFalloff) -> (String, String) {
    luminaire::falloffs! { with_falloff; [falloff, inner, name, {
        // The block around the value only imports names.
        let block = as_source(&inner).to_string();
        let value = block.split_once(";\n").and_then(|(_, rest)| rest.trim_end().strip_suffix('}'));
        (spelled(name), value.unwrap_or(&block).trim_end().to_owned())
    }] }
}

type Spot = SpotLight<AnyFalloff, AnyAttenuation>;

/// Returns the type and the value of a point light.
fn around<S: SourceScalar>(light: &PointLight<AnyAttenuation>) -> Result<(String, String), ExportError> {
    let parts = light.compile::<S>()?.parts();
    let colors = [light.color(), light.specular_color()].map(|color| color.map(S::from_f32));
    Ok(luminaire::attenuations! { with_attenuation; [light.attenuation(), law, law_name, {
        let light = plain::<S, _>(law, |constants| CompiledPointLight::from_parts(
            parts.position, constants, parts.intensity, parts.fine_below, colors,
        ));
        (format!("CompiledPointLight<FORMAT, {law_name}>"), as_source(&light).to_string())
    }] })
}

/// Compiles an attenuation, and fixes its type.
fn plain<S: Scalar, A: Attenuation>(
    attenuation: A,
    light: impl FnOnce(A::Constants<S>) -> CompiledPointLight<S, A>,
) -> CompiledPointLight<S, A> {
    light(attenuation.constants::<S>())
}

/// Returns the type and the value of a spotlight.
fn attenuated<S: SourceScalar>(light: &Spot) -> Result<(String, String), ExportError> {
    luminaire::attenuations! { with_attenuation; [light.attenuation(), law, law_name, {
        shaped::<S, _>(light, law, law_name)
    }] }
}

fn shaped<S: SourceScalar, A: Attenuation + Named>(
    light: &Spot,
    law: A,
    law_name: &str,
) -> Result<(String, String), ExportError>
where
    A::Constants<S>: Source,
{
    let parts = light.compile::<S>()?.parts();
    let Some(cone) = parts.cone else { unreachable!("a spotlight has a cone") };
    let colors = [light.color(), light.specular_color()].map(|color| color.map(S::from_f32));
    Ok(luminaire::falloffs! { with_falloff; [light.cone().falloff(), falloff, falloff_name, {
        let cone_of = CompiledCone::from_parts(cone.ramp, falloff, falloff.compile::<S>());
        let light = CompiledSpotLight::<S, _, A>::from_parts(
            parts.position, cone.axis, cone_of, cone.outside, law.constants::<S>(), parts.intensity,
            parts.fine_below, colors,
        );
        (format!("CompiledSpotLight<FORMAT, {falloff_name}, {law_name}>"), as_source(&light).to_string())
    }] })
}
