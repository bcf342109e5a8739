//! The page that tells what is read, and the one JSON format with its schema.

use std::fs;

use boon::{Compiler, Schemas};
use fastrand::Rng;
use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Knot, Table};
use luminaire::{Angle, Cone, DirectionalLight, PointLight, SpotLight};
use luminaire_exchange::System;
use luminaire_export::json::{NamedLight, read, write};
use serde_json::Value;

const PAGE: &str = include_str!("../../docs/LIGHTS.md");

#[test]
fn page_lists_every_system() {
    for system in System::ALL {
        let row = format!("| `{system}` | {} | {} |", system.extensions().join(", "), system.what())
            .replace("|  |", "| |");
        assert!(PAGE.contains(&row), "expected {row}");
    }
}

const SCHEMA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/lights.schema.json");

/// With `LUMINAIRE_BLESS`, adds to the schema the models of a document that it has no name of.
fn bless(document: &str) {
    if std::env::var_os("LUMINAIRE_BLESS").is_none() {
        return;
    }
    let document: Value = serde_json::from_str(document).expect("JSON");
    let mut schema = fs::read_to_string(SCHEMA).expect("a schema");
    for light in document["lights"].as_array().expect("lights") {
        for (model, first) in
            [(&light["cone"]["falloff"]["name"], "soft"), (&light["attenuation"]["law"], "constant")]
        {
            let (name, list) = (model.to_string(), format!("\"enum\": [\"{first}\""));
            let names = schema.split_once(&list).and_then(|(_, rest)| rest.split(']').next());
            if model.is_string() && name != format!("{first:?}") && !names.expect("a list").contains(&name) {
                schema = schema.replace(&list, &format!("{list}, {name}"));
            }
        }
    }
    fs::write(SCHEMA, schema).expect("written");
}

/// Every falloff and every attenuation is read with the bits that were written, in documents of the schema;
/// so is what the page writes by hand. `LUMINAIRE_BLESS=1` adds a new model to the schema.
#[test]
fn document_is_read_back_and_keeps_to_the_schema() {
    let mut rng = Rng::with_seed(3);
    let mut lights: Vec<AnyLight> =
        vec![DirectionalLight::new([0.0, -1.0, 0.25]).expect("a direction").into()];
    const KNOTS: &[Knot; 2] =
        &[Knot::from_bits(0, 65_535, -2_000_000_001), Knot::from_bits(30_000, 40_000, -9)];
    for index in 0..40 {
        let falloff = AnyFalloff::drawn(index, || rng.f32()).unwrap_or(Table::of_knots(KNOTS).into());
        let Ok(cone) = Cone::from_outer(falloff, Angle::degrees(1.0 + 178.0 * rng.f32())) else { continue };
        let cone =
            cone.with_inner(Angle::degrees(0.9 * cone.outer().to_degrees() * rng.f32())).unwrap_or(cone);
        let cone = cone.with_cutoff(Angle::degrees(0.9 * cone.outer().to_degrees())).unwrap_or(cone);
        let Ok(attenuation) = AnyAttenuation::drawn(index, || rng.f32()) else { continue };
        // A window without a range is no window.
        if attenuation.range().is_none() {
            continue;
        }
        let [x, y, z] = [0; 3].map(|_| 4.0 * rng.f32() - 1.5);
        let spot =
            SpotLight::new([x, y, z], [z, x, y], cone).expect("a light").with_intensity(9.0 * rng.f32());
        lights.push(spot.expect("an intensity").with_attenuation(attenuation).into());
        lights.push(PointLight::new([x, y, z]).expect("a light").with_attenuation(attenuation).into());
    }
    assert!(lights.len() > 50, "{} lights", lights.len());
    let named = |light: &AnyLight| NamedLight {
        name: "a \"name\"".into(),
        light: *light,
        surfaces: Some([1.0, 7.5]),
        about: None,
    };
    let lights: Vec<_> = lights.iter().map(named).collect();
    let text = write(&lights).expect("a document");
    bless(&text);
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    let schema = compiler.compile(SCHEMA, &mut schemas).expect("a schema");
    let check = |text: &str| {
        let value = serde_json::from_str(text).expect("JSON");
        schemas.validate(&value, schema).map_err(|error| error.to_string())
    };
    check(&text).expect("a document of the schema");
    let back = read(&text).expect("lights");
    assert!(back.len() == lights.len() && back.iter().zip(&lights).all(|(back, light)| back == light));

    // What a reader skips may be any JSON. More than 10,000 lights are not read.
    let many = |count: usize| {
        let light = r#"{"kind":"point","about":{"a":[[{}]]}},"#.repeat(count - 1);
        read(&format!(
            r#"{{"format":"luminaire-lights-1","refused":[1],"lights":[{light}{{"kind":"point"}}]}}"#
        ))
    };
    assert!(many(10_000).is_ok_and(|lights| lights.len() == 10_000 && lights[0].about.is_none()));
    assert!(many(10_001).is_err());

    let by_hand =
        PAGE.split("```json\n").nth(1).and_then(|rest| rest.split("```").next()).expect("an example");
    check(by_hand).expect("a document of the schema");
    assert_eq!(read(by_hand).expect("lights").len(), 3);
    for (wrong, told) in [
        (by_hand.replace("lights-1", "light-1"), "format = luminaire-light-1: expected luminaire-lights-1"),
        (by_hand.replace("beam_degrees", "beam"), "JSON = unknown field `beam`"),
        (
            by_hand.replace("\"square\"", "\"round\""),
            "lights[1]: window = round: expected cut or gltf or square",
        ),
        (by_hand.replace("\"outer_degrees\": 40", "\"outer_degrees\": 400"), "lights[2]: outer angle = 400"),
        (by_hand.replace("\"inverse-square\"", &format!("\"{:1000}\"", "")), "JSON = more than 1,000 bytes"),
        (
            by_hand.replace("\"outer_degrees\": 40", "\"outer_degrees\": 40, \"outer_versine\": 0.5"),
            "lights[2]: outer_degrees = 40: expected 120",
        ),
    ] {
        let refused = read(&wrong).expect_err(told).to_string();
        assert!(refused.starts_with(told), "{refused}: expected {told}");
        assert!(
            check(&wrong).is_err() || wrong.contains("versine") || wrong.len() > by_hand.len() + 900,
            "the schema accepts {told}"
        );
    }
}
