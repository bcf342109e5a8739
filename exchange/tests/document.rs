//! The page that tells what is read, and the one JSON format with its schema.

use std::fs;
use std::sync::LazyLock;

use boon::{Compiler, Schemas};
use fastrand::Rng;
use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Knot, Table};
use luminaire::light::{Distribution, Symmetry};
use luminaire::models::Number;
use luminaire::{AmbientLight, Angle, Cone, DirectionalLight, MeasuredLight, PointLight, SpotLight};
use luminaire_exchange::{Lamp, Reading, Sheet, System, Use, numbers};
use luminaire_export::json::{Lights, NamedAmbient, NamedLight, read, write};
use luminaire_export::{ExportError, words};

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

/// The schema's text, which is read before a test writes it.
static TEXT: LazyLock<String> = LazyLock::new(|| fs::read_to_string(SCHEMA).expect("a schema"));

/// Returns the schema's text with the lists of models as the kernel has them: the names of falloffs and of laws, and
/// the numbers of the laws.
fn with_all_models(schema: &str) -> String {
    let replaced = |text: &str, before: &str, after: &str, list: String| {
        let (head, rest) = text.split_once(before).expect("the head of a list");
        let (_, tail) = rest.split_once(after).expect("the end of a list");
        format!("{head}{before}{list}{after}{tail}")
    };
    let quoted = |names: &mut dyn Iterator<Item = &str>| {
        names.map(|name| format!("{name:?}")).collect::<Vec<_>>().join(", ")
    };
    let laws = words::law_names();
    let falloffs = quoted(&mut words::falloff_names());
    let schema = replaced(schema, "\"name\": { \"enum\": [", "] }", falloffs);
    let schema = replaced(&schema, "\"law\": { \"enum\": [", "] }", quoted(&mut laws.iter().copied()));
    let mut numbers = Vec::new();
    for number in laws.iter().filter_map(|law| words::law_numbers(law)).flatten() {
        if !numbers.contains(&number.name) {
            numbers.push(number.name);
        }
    }
    let member = |name: &&str| format!("        {name:?}: {{ \"type\": \"number\" }},\n");
    let numbers: String = numbers.iter().map(member).collect();
    let law =
        schema.lines().find(|line| line.trim_start().starts_with("\"law\"")).expect("a line").to_owned()
            + "\n";
    replaced(&schema, &law, "        \"window\"", numbers)
}

/// The schema has the falloffs and the laws of the kernel. With `LUMINAIRE_BLESS=1` it is written so.
#[test]
fn schema_has_every_model() {
    let all = with_all_models(&TEXT);
    if std::env::var_os("LUMINAIRE_BLESS").is_some() {
        fs::write(SCHEMA, all).expect("written");
    } else {
        assert_eq!(*TEXT, all);
    }
}

/// Every falloff and every attenuation is read with the bits that were written, in documents of the schema;
/// so is what the page writes by hand.
#[test]
fn document_is_read_back_and_keeps_to_the_schema() {
    let mut rng = Rng::with_seed(3);
    let mut lights: Vec<AnyLight> =
        vec![DirectionalLight::new([0.0, -1.0, 0.25]).expect("a direction").into()];
    const KNOTS: &[Knot; 2] =
        &[Knot::from_bits(0, 65_535, -2_000_000_001), Knot::from_bits(30_000, 40_000, -9)];
    let values = |rng: &mut Rng, numbers: &mut dyn Iterator<Item = &'static Number>| -> Vec<f32> {
        numbers.map(|number| number.anywhere(rng.f32())).collect()
    };
    for index in 0..80 {
        let row = &AnyFalloff::LIST[index % AnyFalloff::LIST.len()];
        let falloff =
            row.of(&values(&mut rng, &mut row.numbers.iter())).unwrap_or(Table::of_knots(KNOTS).into());
        let Ok(cone) = Cone::from_outer(falloff, Angle::degrees(1.0 + 178.0 * rng.f32())) else { continue };
        let cone =
            cone.with_inner(Angle::degrees(0.9 * cone.outer().to_degrees() * rng.f32())).unwrap_or(cone);
        let cone = cone.with_cutoff(Angle::degrees(0.9 * cone.outer().to_degrees())).unwrap_or(cone);
        let row = &AnyAttenuation::LIST[index % AnyAttenuation::LIST.len()];
        let between = 0.001 + 40.0 * rng.f32();
        let range = rng.choice([0.001, 1e9, between]);
        let Ok(attenuation) = row.of(&values(&mut rng, &mut row.beside_range()), range) else { continue };
        let [x, y, z] = [0; 3].map(|_| 4.0 * rng.f32() - 1.5);
        let usual = 9.0 * rng.f32();
        let intensity = rng.choice([0.0, 1e-9, 1e9, usual]).expect("four");
        let spot = SpotLight::new([x, y, z], [z, x, y], cone).expect("a light").with_intensity(intensity);
        lights.push(spot.expect("an intensity").with_attenuation(attenuation).into());
        lights.push(PointLight::new([x, y, z]).expect("a light").with_attenuation(attenuation).into());
    }
    const SAMPLES: &[u16] = &[65_535, 3, 40_000, 0, 7, 9, 1, 40_000, 0, 7, 65_535, 3, 1, 3, 65_535];
    let distribution = Distribution::from_parts(SAMPLES, 5, Symmetry::Bilateral);
    let street = MeasuredLight::new([1.0, 2.0, 3.0], [0.3, -1.0, 0.5], [0.9, 0.1, 0.1], distribution);
    lights.push(street.expect("a light").into());
    assert!(lights.len() > 100, "{} lights", lights.len());
    let named = |light: &AnyLight| NamedLight {
        name: "a \"name\"".into(),
        light: *light,
        surfaces: Some([1.0, 7.5]),
        about: None,
    };
    let sky = AmbientLight::new([0.5, 1.0, 0.1].into()).and_then(|sky| sky.with_intensity(0.1));
    let ambient = NamedAmbient { name: "sky".into(), light: sky.expect("a light") };
    let lights = Lights { lights: lights.iter().map(named).collect(), ambient: vec![ambient] };
    let text = write(&lights).expect("a document");
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    let own = serde_json::from_str(&with_all_models(&TEXT)).expect("JSON");
    compiler.add_resource("lights.schema.json", own).expect("a schema");
    let schema = compiler.compile("lights.schema.json", &mut schemas).expect("a schema");
    let check = |text: &str| {
        let value = serde_json::from_str(text).expect("JSON");
        schemas.validate(&value, schema).map_err(|error| error.to_string())
    };
    check(&text).expect("a document of the schema");
    let back = read(&text).expect("lights");
    assert_eq!(back, lights);

    // What a reader skips may be any JSON. More than 10,000 lights are not read.
    let many = |count: usize| {
        let light = r#"{"kind":"point","about":{"a":[[{}]]}},"#.repeat(count - 1);
        read(&format!(
            r#"{{"format":"luminaire-lights-1","refused":[1],"lights":[{light}{{"kind":"point"}}]}}"#
        ))
    };
    assert!(
        many(10_000).is_ok_and(|lights| lights.lights.len() == 10_000 && lights.lights[0].about.is_none())
    );
    assert!(many(10_001).is_err());

    let by_hand =
        PAGE.split("```json\n").nth(1).and_then(|rest| rest.split("```").next()).expect("an example");
    check(by_hand).expect("a document of the schema");
    let own = read(by_hand).expect("lights");
    assert_eq!((own.lights.len(), own.ambient.len()), (4, 1));
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

fn again(text: &str) -> Vec<Lamp> {
    luminaire_exchange::read("a.json", text.as_bytes(), None, Reading::default()).expect("a document").lamps
}

/// A document of one light.
fn written(light: &NamedLight) -> Result<String, ExportError> {
    write(&Lights { lights: vec![light.clone()], ambient: Vec::new() })
}

/// What is known of a light beside it comes back, but for its measured intensities and what follows from them.
#[test]
fn what_is_known_of_a_light_is_read_back() {
    let sheet = Sheet { lumens: Some(870.0), beam: Some(20.0), kelvin: Some(2_950.5), ..Sheet::default() };
    let scale = |full_scale| Use { throw: 4.0, full_scale, is_photometric: true };
    let lamp = sheet.lamp().expect("a lamp");
    assert!(lamp.is_assumed && lamp.kelvin.is_some() && !lamp.notes.is_empty());
    let godot =
        numbers(System::Godot, "spot_angle=20 spot_attenuation=1.3".split(' ')).expect("a light").lamps;
    let ldt = include_bytes!("files/spot.ldt");
    let measured = luminaire_exchange::read("a.ldt", ldt, None, Reading::default()).expect("a file").lamps;
    for lamp in [&[lamp][..], &godot, &measured].concat() {
        for full_scale in [1.0, 1.0 / 3.0, 123_456.789_012_345] {
            let named = lamp.named(scale(full_scale)).expect("a light");
            let back = again(&written(&named).expect("a document")).remove(0);
            let expected =
                Lamp { light: named.light, full_scale, measured: None, fits: Vec::new(), ..lamp.clone() };
            assert_eq!(back, expected);
            assert!((back.own_intensity() * full_scale / lamp.own_intensity() - 1.0).abs() < 1e-6);
            let (text, other) = (written(&named), written(&back.named(scale(1.0)).expect("a light")));
            assert_eq!(text.is_ok_and(|text| text == other.expect("a document")), lamp.measured.is_none());
        }
    }
}

/// Another program may write anything there, and a colour that was changed by hand is that of the light.
#[test]
fn what_is_known_of_a_light_may_be_anything() {
    let light = |about: &str| {
        let text = format!(
            r#"{{"format":"luminaire-lights-1","lights":[{{"kind":"point","color":[1,0.5,0.25],"about":{about}}}]}}"#
        );
        again(&text).remove(0)
    };
    let plain = light("null");
    for about in ["5", "[{}]", r#"{"from":[[]]}"#, r#"{"kelvin":"warm"}"#, r#"{"full_scale":-1}"#] {
        assert_eq!(light(about), plain, "{about}");
    }
    for about in [r#"{"kelvin":3000}"#, r#"{"kelvin":-3}"#] {
        let found = light(about);
        assert_eq!((found.kelvin, found.notes.len()), (None, 1), "{about}: {found:?}");
    }
}
