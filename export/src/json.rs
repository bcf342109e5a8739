//! Lights as JSON: the one format that every command reads and writes.

use std::fmt;

use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Falloff, Formula, Soft};
use luminaire::light::{Distribution, Symmetry};
use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, MeasuredLight, PointLight, Rgb, SpotLight, Vec3,
};
use serde::de::{Deserializer, Error as _, IgnoredAny, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, value::RawValue};

use crate::error::{ExportError, printable_json};
use crate::words;

/// The format of the documents.
const FORMAT: &str = "luminaire-lights-1";

/// A light of a document.
#[derive(Clone, PartialEq, Debug)]
pub struct NamedLight {
    /// The name: any text.
    pub name: String,
    /// The light.
    pub light: AnyLight,
    /// The distances of the nearest and of the farthest surface, where they are known.
    pub surfaces: Option<[f32; 2]>,
    /// What is known of the light beside it: any JSON. [`read`] skips it.
    pub about: Option<Value>,
}

/// Ambient light of a document.
#[derive(Clone, PartialEq, Debug)]
pub struct NamedAmbient {
    /// The name: any text.
    pub name: String,
    /// The light.
    pub light: AmbientLight,
}

/// The lights of a document.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Lights {
    /// Those that shine from a position or a direction.
    pub lights: Vec<NamedLight>,
    /// Those that are the same from everywhere.
    pub ambient: Vec<NamedAmbient>,
}

/// Declares an object of the format by its members, none of which has to be there.
macro_rules! object {
    ($(#[$doc:meta])* $name:ident { $($(#[$note:meta])* $member:ident: $type:ty,)+ }) => {
        $(#[$doc])*
        #[derive(Debug, Default, Serialize, Deserialize)]
        #[serde(default, deny_unknown_fields)]
        struct $name {
            $($(#[$note])* #[serde(skip_serializing_if = "Option::is_none")] $member: Option<$type>,)+
        }
    };
}

/// Reads any JSON in no memory.
fn skipped<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Value>, D::Error> {
    IgnoredAny::deserialize(from).map(|_| None)
}

/// Reads at most 10,000 lights, and no further.
fn few<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Vec<Light>>, D::Error> {
    struct Few;
    impl<'de> Visitor<'de> for Few {
        type Value = Vec<Light>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a list of at most 10,000 lights")
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<Light>, A::Error> {
            let mut found = Vec::new();
            while let Some(light) = list.next_element()? {
                if found.len() == 10_000 {
                    return Err(A::Error::invalid_length(10_001, &self));
                }
                found.push(light);
            }
            Ok(found)
        }
    }
    from.deserialize_seq(Few).map(Some)
}

/// Reads an object that is a few members long: not a tree of any size.
fn short<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Map<String, Value>>, D::Error> {
    let text = <&RawValue>::deserialize(from)?.get();
    if text.len() > 1_000 {
        return Err(D::Error::custom("more than 1,000 bytes: expected a law and its numbers"));
    }
    serde_json::from_str(text).map(Some).map_err(D::Error::custom)
}

object! {
    Document {
        format: String,
        #[serde(deserialize_with = "few")]
        lights: Vec<Light>,
        /// What could not be written, for people: any JSON.
        #[serde(deserialize_with = "skipped")]
        refused: Value,
    }
}

object! {
    /// A light as JSON has it: the crate's documentation lists the members.
    Light {
        name: String,
        kind: String,
        position: [f32; 3],
        /// The axis of a spotlight or of a measured light, or the direction of a directional light.
        axis: [f32; 3],
        color: [f32; 3],
        specular_color: [f32; 3],
        intensity: f32,
        /// The direction of the side of a measured light: the plane C0 of photometry.
        side: [f32; 3],
        cone: Shape,
        distribution: Samples,
        #[serde(deserialize_with = "short")]
        attenuation: Map<String, Value>,
        near: f32,
        far: f32,
        #[serde(deserialize_with = "skipped")]
        about: Value,
    }
}

object! {
    /// A distribution of intensity over all directions: a table on an unfolded octahedron.
    Samples {
        size: u32,
        symmetry: String,
        samples: Vec<u16>,
    }
}

object! {
    Shape {
        beam_degrees: f32,
        field_degrees: f32,
        outer_degrees: f32,
        inner_degrees: f32,
        cutoff_degrees: f32,
        inner_versine: f32,
        outer_versine: f32,
        cutoff_versine: f32,
        falloff: Profile,
    }
}

object! {
    /// A falloff: its name and the parameters of its constructor, and for readers its formula.
    Profile {
        name: String,
        parameters: Vec<f64>,
        formula: String,
        coefficients: [f32; 3],
        exponent: f32,
        floor: f32,
    }
}

/// Returns the number with the digits that an `f32` needs.
fn shortest(value: f32) -> f64 {
    format!("{value:?}").parse().unwrap_or(value.into())
}

/// Returns lights as a document.
///
/// # Errors
/// A number that JSON does not have; no light of this crate has one.
pub fn write(lights: &Lights) -> Result<String, ExportError> {
    write_with(lights, None)
}

/// Returns lights as a document, with what was refused.
///
/// # Errors
/// As those of [`write()`].
pub fn write_with(lights: &Lights, refused: Option<Value>) -> Result<String, ExportError> {
    let Lights { lights, ambient } = lights;
    let all = lights.iter().map(described).chain(ambient.iter().map(surrounding)).collect();
    let document = Document { format: Some(FORMAT.to_owned()), lights: Some(all), refused };
    let json = serde_json::to_string_pretty(&document);
    json.map(|text| printable_json(&in_lines(&text)))
        .map_err(|error| ExportError::new("lights", FORMAT, error.to_string()))
}

/// Returns JSON with each list of numbers or of texts on one line: a table has hundreds of them.
fn in_lines(pretty: &str) -> String {
    let (mut text, mut joins) = (String::new(), false);
    let mut lines = pretty.lines().peekable();
    while let Some(line) = lines.next() {
        let (own, next) = (line.trim_start(), lines.peek().map_or("", |next| next.trim_start()));
        text += if joins { own } else { line };
        let opens = line.ends_with('[') && !next.ends_with(['{', '[']);
        joins = opens || joins && !own.starts_with(']');
        text.push_str(if !joins {
            "\n"
        } else if opens || next.starts_with(']') {
            ""
        } else {
            " "
        });
    }
    text
}

fn triple(color: Rgb<f32>) -> [f32; 3] {
    [color.red, color.green, color.blue]
}

fn surrounding(NamedAmbient { name, light }: &NamedAmbient) -> Light {
    Light {
        name: Some(name.clone()),
        kind: Some(AMBIENT.to_owned()),
        color: Some(triple(light.color())),
        intensity: Some(light.intensity()),
        ..Light::default()
    }
}

fn described(NamedLight { name, light, surfaces, about }: &NamedLight) -> Light {
    let mut described = Light {
        name: Some(name.clone()),
        kind: Some(kind(light).to_owned()),
        color: Some(triple(light.color())),
        specular_color: Some(triple(light.specular_color())),
        intensity: Some(light.intensity()),
        near: surfaces.map(|[near, _]| near),
        far: surfaces.map(|[_, far]| far),
        about: about.clone(),
        ..Light::default()
    };
    match light {
        AnyLight::Spot(spot) => {
            described.position = Some(spot.position().into());
            described.axis = Some(spot.given_axis().into());
            described.cone = Some(shape(&spot.cone()));
            described.attenuation = Some(law(&spot.attenuation()));
        }
        AnyLight::Point(point) => {
            described.position = Some(point.position().into());
            described.attenuation = Some(law(&point.attenuation()));
        }
        AnyLight::Measured(light) => {
            let distribution = light.distribution();
            described.position = Some(light.position().into());
            described.axis = Some(light.given_axis().into());
            described.side = Some(light.given_side().into());
            described.distribution = Some(Samples {
                size: Some(distribution.size()),
                symmetry: Some(symmetry(distribution.symmetry()).to_owned()),
                samples: Some(distribution.samples().to_vec()),
            });
            described.attenuation = Some(law(&light.attenuation()));
        }
        AnyLight::Directional(directional) => described.axis = Some(directional.given_direction().into()),
    }
    described
}

/// Returns an attenuation as JSON has it: `law`, its numbers by name, and `window` and `range`.
fn law(attenuation: &AnyAttenuation) -> Map<String, Value> {
    let row = attenuation.row();
    let mut members = vec![("law", row.law.into())];
    let numbers = row.numbers.iter().zip(attenuation.numbers());
    members.extend(numbers.map(|(number, value)| (number.name, shortest(value).into())));
    if let (Some(window), Some(range)) = (row.window, attenuation.range()) {
        members.extend([("window", window.into()), ("range", shortest(range).into())]);
    }
    members.into_iter().map(|(name, value): (&str, Value)| (name.to_owned(), value)).collect()
}

/// The kind of ambient light.
pub const AMBIENT: &str = "ambient";

/// The symmetries of distributions.
const SYMMETRIES: [Symmetry; 3] = [Symmetry::None, Symmetry::Bilateral, Symmetry::Quadrant];

/// Returns the name of a symmetry: `none`, `bilateral` or `quadrant`.
pub fn symmetry(symmetry: Symmetry) -> &'static str {
    match symmetry {
        Symmetry::None => "none",
        Symmetry::Bilateral => "bilateral",
        Symmetry::Quadrant => "quadrant",
    }
}

/// Returns the kind of a light: `spot`, `measured`, `point` or `directional`.
pub fn kind(light: &AnyLight) -> &'static str {
    match light {
        AnyLight::Spot(_) => "spot",
        AnyLight::Measured(_) => "measured",
        AnyLight::Point(_) => "point",
        AnyLight::Directional(_) => "directional",
    }
}

fn shape(cone: &Cone<AnyFalloff>) -> Shape {
    let [inner_versine, outer_versine, limit] = cone.versines();
    let [beam_degrees, field_degrees, outer_degrees, inner_degrees, cutoff] = degrees(cone).map(Some);
    Shape {
        beam_degrees,
        field_degrees,
        outer_degrees,
        inner_degrees,
        cutoff_degrees: cutoff.filter(|_| cone.has_cutoff()),
        inner_versine: Some(inner_versine),
        outer_versine: Some(outer_versine),
        cutoff_versine: cone.has_cutoff().then_some(limit),
        falloff: Some(profile(cone.falloff())),
    }
}

/// Returns beam, field, outer and inner angle and cutoff.
fn degrees(cone: &Cone<AnyFalloff>) -> [f32; 5] {
    let outer = Angle::from_versine(cone.versines()[1]);
    [cone.beam(), cone.field(), outer, cone.inner(), cone.outer()].map(Angle::to_degrees)
}

fn profile(falloff: AnyFalloff) -> Profile {
    let (name, parameters) = words::described(&falloff);
    // Those of a table are whole numbers, of which f32 has not all.
    let number = |number: f64| if number.fract() == 0.0 { number } else { shortest(number as f32) };
    let parameters: Vec<_> = parameters.into_iter().map(number).collect();
    let parameters = Some(parameters).filter(|parameters| !parameters.is_empty());
    let mut profile = Profile { name: Some(name.to_owned()), parameters, ..Profile::default() };
    let formula = falloff.formula();
    match formula {
        Formula::Polynomial(coefficients) => profile.coefficients = Some(coefficients),
        Formula::Power(exponent) => profile.exponent = Some(exponent),
        Formula::InvertedPower(exponent, floor) => {
            (profile.exponent, profile.floor) = (Some(exponent), Some(floor));
        }
        // The name and the parameters tell the others.
        _ => {}
    }
    profile.formula = Some(formula.name().to_owned());
    profile
}

/// Returns the lights of a document, each of the two lists in its order.
///
/// A cone is read from its versines, which are exact, and without them from its angles. Angles beside
/// versines must agree with these. A table and a distribution live as long as the program.
///
/// # Errors
/// Text that is not a document of this format, with its line, or a value that the constructors of
/// [`luminaire`] reject, with the number of its light.
pub fn read(text: &str) -> Result<Lights, ExportError> {
    let document: Document = serde_json::from_str(text)
        .map_err(|error| ExportError::new("JSON", error, format!("a document of {FORMAT}")))?;
    if document.format.as_deref() != Some(FORMAT) {
        return Err(ExportError::new("format", document.format.as_deref().unwrap_or("none"), FORMAT));
    }
    let lights = document.lights.ok_or_else(|| ExportError::new("lights", "none", "a list of lights"))?;
    let mut read = Lights::default();
    for (number, light) in lights.iter().enumerate() {
        let added = if light.kind.as_deref() == Some(AMBIENT) {
            ambient(light).map(|own| read.ambient.push(own))
        } else {
            named(light).map(|own| read.lights.push(own))
        };
        added.map_err(|error| ExportError {
            parameter: format!("lights[{number}]: {}", error.parameter),
            ..error
        })?;
    }
    Ok(read)
}

fn ambient(described: &Light) -> Result<NamedAmbient, ExportError> {
    let [red, green, blue] = described.color.unwrap_or([1.0; 3]);
    let light = AmbientLight::new(Rgb::new(red, green, blue))?;
    let light = light.with_intensity(described.intensity.unwrap_or(1.0))?;
    Ok(NamedAmbient { name: described.name.clone().unwrap_or_else(|| "ambient".to_owned()), light })
}

fn named(described: &Light) -> Result<NamedLight, ExportError> {
    let surfaces = match (described.near, described.far) {
        (None, None) => None,
        (Some(near), Some(far)) => Some([near, far]),
        (one, _) => {
            let missing = if one.is_some() { "far" } else { "near" };
            return Err(ExportError::new(missing, "none", "both near and far, or neither"));
        }
    };
    let color = |[red, green, blue]: [f32; 3]| Rgb::new(red, green, blue);
    let position: Vec3<f32> = described.position.unwrap_or_default().into();
    let axis: Vec3<f32> = described.axis.unwrap_or([0.0, -1.0, 0.0]).into();
    let specular = described.specular_color.or(described.color);
    let [color, specular] = [described.color, specular].map(|own| color(own.unwrap_or([1.0; 3])));
    let intensity = described.intensity.unwrap_or(1.0);
    let attenuation = described
        .attenuation
        .as_ref()
        .map_or_else(|| words::attenuation("inverse-square", &[], "cut", None), attenuation);
    let light: AnyLight = match described.kind.as_deref().unwrap_or("spot") {
        "spot" => {
            let none = || ExportError::new("cone", "none", "the cone of a spotlight");
            let shape = described.cone.as_ref().ok_or_else(none)?;
            SpotLight::new(position, axis, cone(shape)?)?.with_attenuation(attenuation?).into()
        }
        "measured" => {
            let none = || ExportError::new("distribution", "none", "the distribution of a measured light");
            let samples = described.distribution.as_ref().ok_or_else(none)?;
            let side = described.side.unwrap_or([1.0, 0.0, 0.0]);
            MeasuredLight::new(position, axis, side, distribution(samples)?)?
                .with_attenuation(attenuation?)
                .into()
        }
        "point" => PointLight::new(position)?.with_attenuation(attenuation?).into(),
        "directional" => DirectionalLight::new(axis)?.into(),
        kind => return Err(ExportError::new("kind", kind, "spot, measured, point, directional or ambient")),
    };
    let light = light.with_color(color)?.with_specular_color(specular)?.with_intensity(intensity)?;
    let name = described.name.clone().unwrap_or_else(|| "light".to_owned());
    Ok(NamedLight { name, light, surfaces, about: None })
}

fn distribution(described: &Samples) -> Result<Distribution<'static>, ExportError> {
    let name = described.symmetry.as_deref().unwrap_or("none");
    let symmetry = SYMMETRIES.into_iter().find(|own| symmetry(*own) == name);
    let symmetry =
        symmetry.ok_or_else(|| ExportError::new("symmetry", name, "none, bilateral or quadrant"))?;
    let (samples, size) = (described.samples.as_deref().unwrap_or(&[]), described.size.unwrap_or(65));
    Distribution::new(samples, size, symmetry)?;
    Ok(Distribution::new(samples.to_vec().leak(), size, symmetry)?)
}

fn cone(shape: &Shape) -> Result<Cone<AnyFalloff>, ExportError> {
    let falloff = shape.falloff.as_ref().map(|profile| {
        words::falloff(
            profile.name.as_deref().unwrap_or("none"),
            profile.parameters.as_deref().unwrap_or(&[]),
        )
    });
    let falloff = falloff.transpose()?;
    let any = falloff.unwrap_or(Soft.into());
    if let Some(outer) = shape.outer_versine {
        let [inner, limit] = [shape.inner_versine.unwrap_or_default(), shape.cutoff_versine.unwrap_or(outer)];
        let cone = Cone::from_versines(any, [inner, outer, limit])?;
        let told = [
            ("beam_degrees", shape.beam_degrees),
            ("field_degrees", shape.field_degrees),
            ("outer_degrees", shape.outer_degrees),
            ("inner_degrees", shape.inner_degrees),
            ("cutoff_degrees", shape.cutoff_degrees),
        ];
        for ((name, told), own) in told.into_iter().zip(degrees(&cone)) {
            if let Some(told) = told.filter(|told| (told - own).abs() > 1e-3 * own.abs().max(0.01)) {
                let expected = format!("{own}, as the versines say; remove the versines to give angles");
                return Err(ExportError::new(name, told, expected));
            }
        }
        return Ok(cone);
    }
    let [beam, field, outer] =
        [shape.beam_degrees, shape.field_degrees, shape.outer_degrees].map(|a| a.map(Angle::degrees));
    from_angles(falloff, [beam, field, outer], shape.inner_degrees, shape.cutoff_degrees)
}

/// Returns the cone of one of beam, field and outer angle, or of beam and field angle together, which
/// determine the falloff: beside [`Soft`] that of [`Cone::soft_from_beam_and_field`], and else that of
/// [`Cone::from_beam_and_field`]. With a hotspot and a cutoff in degrees. Angles are full angles.
///
/// With a hotspot the falloff begins at the inner angle, and the light still has half of its
/// intensity at the beam angle and a tenth at the field angle.
///
/// # Errors
/// Other combinations of angles, a falloff but `Soft` beside both beam and field angle, or an angle that the cone
/// does not accept.
pub fn from_angles(
    falloff: Option<AnyFalloff>,
    angles: [Option<Angle>; 3],
    inner: Option<f32>,
    cutoff: Option<f32>,
) -> Result<Cone<AnyFalloff>, ExportError> {
    let mut cone = match (angles, inner) {
        ([beam, field, None], Some(inner)) if inner > 0.0 => {
            from_hotspot(falloff, [beam, field], inner).ok_or_else(|| {
                // Angles that no cone has are the first fault.
                without_hotspot(falloff, angles).err().unwrap_or_else(|| {
                    let expected = "less: a falloff that begins there cannot reach the beam or field angle";
                    ExportError::new("inner angle", inner, expected)
                })
            })?
        }
        (_, Some(inner)) => without_hotspot(falloff, angles)?.with_inner(Angle::degrees(inner))?,
        (_, None) => without_hotspot(falloff, angles)?,
    };
    if let Some(cutoff) = cutoff {
        cone = cone.with_cutoff(Angle::degrees(cutoff))?;
    }
    Ok(cone)
}

/// Returns the cone whose falloff begins at an inner angle: that of the angles whose versines are
/// smaller by that of the inner angle, moved outward.
fn from_hotspot(
    falloff: Option<AnyFalloff>,
    angles: [Option<Angle>; 2],
    inner: f32,
) -> Option<Cone<AnyFalloff>> {
    let inner = Angle::degrees(inner).versine();
    let [beam, field] =
        angles.map(|own| own.map(|own| Angle::from_versine((own.versine() - inner).max(0.0))));
    let cone = without_hotspot(falloff, [beam, field, None]).ok()?;
    let outer = inner + cone.outer_versine();
    // The last digits of a right angle.
    let outer = if outer < 1.0 + 1e-6 { outer.min(1.0) } else { outer };
    Cone::from_versines(cone.falloff(), [inner, outer, outer]).ok()
}

fn without_hotspot(
    falloff: Option<AnyFalloff>,
    angles: [Option<Angle>; 3],
) -> Result<Cone<AnyFalloff>, ExportError> {
    let any = falloff.unwrap_or(Soft.into());
    Ok(match angles {
        [None, None, None] => {
            return Err(ExportError::new("cone", "no angle", "a beam, a field or an outer angle"));
        }
        [Some(beam), None, None] => Cone::from_beam(any, beam)?,
        [None, Some(field), None] => Cone::from_field(any, field)?,
        [None, None, Some(outer)] => Cone::from_outer(any, outer)?,
        [Some(beam), Some(field), None] => {
            let cone = match falloff {
                None => Cone::from_beam_and_field(beam, field).map(any_falloff),
                Some(AnyFalloff::Soft(_)) => Cone::soft_from_beam_and_field(beam, field).map(any_falloff),
                Some(_) => {
                    let expected =
                        "soft or no falloff beside both a beam and a field angle, which determine it";
                    return Err(ExportError::new("falloff", "given", expected));
                }
            };
            cone.map_err(|error| {
                let ExportError { parameter, value, expected } = error.into();
                let remedy = "or one of the two alone; the beam angle (50 %) is below the field angle (10 %)";
                ExportError { parameter, value, expected: format!("{expected}, {remedy}") }
            })?
        }
        [.., Some(outer)] => {
            let expected = "no beam or field angle beside it";
            return Err(ExportError::new("outer angle", outer.to_degrees(), expected));
        }
    })
}

fn any_falloff(cone: Cone<impl Falloff + Into<AnyFalloff>>) -> Cone<AnyFalloff> {
    cone.with_falloff(cone.falloff().into())
}

fn attenuation(described: &Map<String, Value>) -> Result<AnyAttenuation, ExportError> {
    let text = |name: &str, default: &str| match described.get(name) {
        None => Ok(default.to_owned()),
        Some(Value::String(text)) => Ok(text.clone()),
        Some(other) => Err(ExportError::new(name, other, "a text")),
    };
    let number = |name: &str| {
        let number = described.get(name).map(|value| {
            value
                .as_f64()
                .ok_or_else(|| ExportError::new(name, value, "a number"))
                .map(|number| number as f32)
        });
        number.transpose()
    };
    let (law, window) = (text("law", "inverse-square")?, text("window", "cut")?);
    let own = words::law_numbers(&law).unwrap_or_default();
    if let Some(other) = described.keys().find(|&name| {
        !["law", "window", "range"].contains(&&**name) && own.iter().all(|own| own.name != name)
    }) {
        let names: Vec<_> =
            ["law", "window", "range"].into_iter().chain(own.iter().map(|own| own.name)).collect();
        return Err(ExportError::new("attenuation", other, format!("one of {} of {law}", names.join(", "))));
    }
    let numbers = own.iter().map(|own| match number(own.name)?.or(own.default) {
        Some(number) => Ok(number),
        None => Err(ExportError::new(own.name, "none", format!("a number of the law {law}"))),
    });
    let numbers: Vec<_> = numbers.collect::<Result<_, _>>()?;
    words::attenuation(&law, &numbers, &window, number("range")?)
}
