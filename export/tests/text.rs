//! JSON, constants of Rust, and what is refused.

mod support;

use fastrand::Rng;
use luminaire::attenuation::{FilamentRange, InverseSquare, SmoothRange};
use luminaire::codegen::as_source;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{Cubic, Falloff, Formula, Hard, Power, Smooth, Table};
use luminaire::light::{Distribution, Symmetry};
use luminaire::{Angle, Cone, DirectionalLight, Fx16, Fx32, MeasuredLight, PointLight, Rgb, SpotLight, Vec3};
use luminaire_export::rust::{constant, quick_constant};
use luminaire_export::{C_HEADERS, Language, check_text, export, json};
use luminaire_oracle::{DVec3, versine_between};
use serde_json::Value;

use support::compiler::compile_rust;
use support::{place, points_of_light, spots};

/// Returns a number. One with a fraction is that of `f32`.
fn number(value: &Value) -> f64 {
    match (value.as_i64(), value.as_f64()) {
        (Some(whole), _) => whole as f64,
        (None, Some(real)) => f64::from(real as f32),
        (None, None) => panic!("{value} is no number"),
    }
}

fn triple(value: &Value) -> DVec3 {
    DVec3::new(number(&value[0]), number(&value[1]), number(&value[2]))
}

/// Returns the falloff at `t`, from the documentation of the JSON alone.
fn falloff(falloff: &Value, t: f64) -> f64 {
    let u = 1.0 - t;
    let numbers =
        |member: &str| falloff[member].as_array().expect("a list").iter().map(number).collect::<Vec<_>>();
    match falloff["formula"].as_str().expect("a formula") {
        "step" => 1.0,
        "polynomial" => {
            let c = numbers("coefficients");
            t * (c[0] + t * (c[1] + t * c[2]))
        }
        "power" => t.powf(number(&falloff["exponent"])),
        "inverted-power" => {
            let (floor, exponent) = (number(&falloff["floor"]), number(&falloff["exponent"]));
            (1.0 - u.max(floor).powf(exponent)) / (1.0 - floor.powf(exponent))
        }
        "soft-pair" => {
            let [share, ratio] = numbers("parameters")[..] else { panic!("two numbers") };
            (1.0 - share) * t * t + share * (1.0 - ratio * u).max(0.0).powi(2)
        }
        "samples" => {
            let samples = numbers("parameters");
            let place = u * (samples.len() - 1) as f64;
            let i = (place as usize).min(samples.len() - 2);
            (samples[i] + (samples[i + 1] - samples[i]) * (place - i as f64)) / 65_535.0
        }
        "knots" => {
            let knots = numbers("parameters");
            let knot = knots.chunks(3).rfind(|knot| knot[0] <= u * 65_536.0).unwrap_or(&knots);
            let rise = knot[2] / 32_768.0 * (u * 65_536.0 - knot[0]);
            ((knot[1] + rise) / 65_535.0).clamp(0.0, 1.0)
        }
        formula => panic!("{formula} is not documented"),
    }
}

/// The laws that the documentation of the JSON has.
const LAWS: [&str; 5] = ["constant", "inverse-square", "polynomial", "decay", "smoothstep"];

/// Returns an axis of unit length in f32, as the exact model has it.
fn unit(axis: DVec3) -> DVec3 {
    let [x, y, z] = axis.to_array().map(|c| c as f32);
    let length = (x * x + y * y + z * z).sqrt();
    DVec3::from_array([x, y, z].map(|c| f64::from(c / length)))
}

/// Returns the irradiance, from the documentation of the JSON alone.
fn irradiance(light: &Value, point: DVec3, normal: DVec3) -> f64 {
    let offset = point - triple(&light["position"]);
    let (distance, cone) = (offset.length(), &light["cone"]);
    let versine = versine_between(offset, unit(triple(&light["axis"])));
    let [inner, outer] = ["inner_versine", "outer_versine"].map(|versine| number(&cone[versine]));
    let limit = cone.get("cutoff_versine").map_or(outer, number);
    let t = if versine <= inner { 1.0 } else { (outer - versine) / (outer - inner) };
    let share = if versine < limit { falloff(&cone["falloff"], t) } else { 0.0 };
    let attenuation = &light["attenuation"];
    let fraction = attenuation.get("range").map_or(0.0, |range| distance / number(range));
    let law = match attenuation["law"].as_str().expect("a law") {
        "constant" => 1.0,
        "inverse-square" => 1.0 / (distance * distance),
        "polynomial" => {
            let [a, b, c] = ["constant", "linear", "quadratic"].map(|name| number(&attenuation[name]));
            1.0 / (a + b * distance + c * distance * distance).max(1.0)
        }
        "decay" => distance.powf(-number(&attenuation["exponent"])).min(number(&attenuation["most"])),
        "smoothstep" => {
            let t = (1.0 - fraction).max(0.0);
            t * t * (3.0 - 2.0 * t)
        }
        law => panic!("{law} is not documented"),
    };
    let fourth = (1.0 - fraction.powi(4)).max(0.0);
    let window = match attenuation.get("window").map(|window| window.as_str().expect("a name")) {
        None => 1.0,
        Some("cut") => f64::from(fraction < 1.0),
        Some("gltf") => fourth,
        Some("square") => fourth * fourth,
        Some(window) => panic!("{window} is not documented"),
    };
    let cosine = (-offset.dot(normal) / distance).clamp(0.0, 1.0);
    number(&light["intensity"]) * law * window * share * cosine
}

/// The JSON alone is enough to evaluate a light: in f64 the result is that of the exact model. Of a
/// falloff that is a function, and of a law that the documentation has not, the JSON has the name.
#[test]
fn json_has_all_that_a_light_needs() {
    let (mut rng, mut worst, mut lit) = (Rng::with_seed(7), 0.0_f64, 0);
    for spot in spots::<f32>(&mut rng, 4) {
        if matches!(spot.cone().falloff().formula(), Formula::Function(..)) {
            continue;
        }
        let json = export(spot, "key", Language::Json).expect("a light");
        let document: Value = serde_json::from_str(&json).expect("JSON");
        let light = &document["lights"][0];
        if !LAWS.contains(&light["attenuation"]["law"].as_str().expect("a law")) {
            continue;
        }
        let any = AnyLight::from(spot);
        for _ in 0..200 {
            let (point, normal) = place(&mut rng, &any);
            let [exact, share] = support::exact(&spot, point, normal);
            let wide = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
            let found = irradiance(light, wide(point), wide(normal));
            if exact > 0.0 && exact.is_finite() {
                lit += 1;
                worst = worst.max((found - exact).abs() * share / exact);
            }
        }
    }
    println!("{lit} lit points: a falloff differs by {worst:.1e}");
    assert!(lit > 4_000, "{lit} lit points");
    assert!((1e-17..=1e-12).contains(&worst), "a falloff differs by {worst:e}");
}

#[allow(unreachable_pub, reason = "the constants are those of a library")]
#[path = "text/lights.rs"]
#[rustfmt::skip]
mod lights;

type Written = (String, [bool; 2]);

/// Returns lights as Rust, and whether the constants in the file are the compiled lights.
fn written() -> Result<Vec<Written>, Box<dyn std::error::Error>> {
    let angle = Angle::degrees(40.0);
    let (position, axis) = ([1.0, 2.0, 3.0], [0.0, -1.0, 0.5]);
    let cubic = SpotLight::new(position, axis, Cone::from_outer(Cubic::with_slopes(1.25, 3.5)?, angle)?)?
        .with_attenuation(FilamentRange::new(InverseSquare, Some(9.0))?);
    let point = PointLight::new(position)?.with_attenuation(SmoothRange::new(5.0)?);
    let sun = DirectionalLight::new(axis)?;
    let is =
        |text: String, source: String, same: bool| (text.clone(), [text.contains(source.trim_end()), same]);
    Ok(vec![
        is(
            export(cubic, "cubic", Language::RustFixed16)?,
            as_source(&cubic.compile::<Fx16>()?).to_string(),
            lights::cubic::LIGHT == cubic.compile::<Fx16>()?,
        ),
        is(
            export(point, "point", Language::RustFixed32)?,
            as_source(&point.compile::<Fx32>()?).to_string(),
            lights::point::LIGHT == point.compile::<Fx32>()?,
        ),
        is(
            export(sun, "sun", Language::RustFloat)?,
            as_source(&sun.compile::<f32>()).to_string(),
            lights::sun::LIGHT == sun.compile::<f32>(),
        ),
    ])
}

/// The file is compiled with this test; `LUMINAIRE_BLESS=1` writes it.
#[test]
fn rust_is_the_compiled_light_of_a_concrete_type() {
    let written = written().expect("lights");
    let text: String = written.iter().map(|(text, _)| text.as_str()).collect();
    if std::env::var_os("LUMINAIRE_BLESS").is_some() {
        std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/text/lights.rs"), &text).expect("a file");
    }
    let expected = include_str!("text/lights.rs");
    assert!(text == expected, "expected the text of tests/text/lights.rs: write it with LUMINAIRE_BLESS=1");
    for (text, checks) in &written {
        assert_eq!(checks, &[true; 2], "{text}");
    }
}

/// A constant of the quick evaluation is the compiled light, and an integer power is a type with its exponent.
#[test]
fn constants_are_those_of_concrete_types() -> Result<(), Box<dyn std::error::Error>> {
    let cone = Cone::from_outer(Power::<5>, Angle::degrees(40.0))?;
    let spot = SpotLight::new([1.0, 2.0, 3.0], [0.0, -1.0, 0.5], cone)?
        .with_attenuation(FilamentRange::new(InverseSquare, Some(9.0))?);
    let AnyLight::Spot(any) = spot.into() else { unreachable!("a spotlight") };
    let law = "Windowed<InverseSquare>";
    let quick = quick_constant::<Fx16>(&any)?;
    assert_eq!(quick.type_name, format!("QuickSpotLight<Fx16, Power<5>, {law}>"));
    assert_eq!(quick.value, as_source(&spot.compile_quick::<Fx16>()?).to_string());
    let fine = constant::<Fx32>(&any.into())?;
    assert_eq!(fine.type_name, format!("CompiledSpotLight<Fx32, Power<5>, {law}>"));
    assert_eq!(fine.value, as_source(&spot.compile::<Fx32>()?).to_string());
    Ok(())
}

#[allow(unreachable_pub, dead_code, reason = "the functions are those of build scripts")]
#[rustfmt::skip]
mod scripts {
    #[path = "cubic.rs"]
    pub(super) mod cubic;
    #[path = "point.rs"]
    pub(super) mod point;
    #[path = "sun.rs"]
    pub(super) mod sun;
}

/// The files are compiled with this test; `LUMINAIRE_BLESS=1` writes them.
#[test]
fn a_build_script_describes_the_light() -> Result<(), Box<dyn std::error::Error>> {
    let cone = Cone::from_outer(Cubic::with_slopes(1.25, 3.5)?, Angle::degrees(40.0))?;
    let cubic = SpotLight::new([1.0, 2.0, 3.0], [0.0, -1.0, 0.5], cone.with_inner(Angle::degrees(7.0))?)?
        .with_attenuation(FilamentRange::new(InverseSquare, Some(9.0))?)
        .with_color(Rgb::new(1.0, 0.5, 0.25))?
        .with_intensity(16.0)?;
    let point = PointLight::new([1.0, 2.0, 3.0])?.with_attenuation(SmoothRange::new(5.0)?);
    let sun = DirectionalLight::new([0.0, -1.0, 0.5])?.with_specular_color(Rgb::new(0.5, 0.5, 1.0))?;
    let lights: [(&str, AnyLight, &str); 3] = [
        ("cubic", cubic.into(), include_str!("scripts/cubic.rs")),
        ("point", point.into(), include_str!("scripts/point.rs")),
        ("sun", sun.into(), include_str!("scripts/sun.rs")),
    ];
    for (name, light, expected) in lights {
        let text = export(light, name, Language::RustBuild)?;
        if std::env::var_os("LUMINAIRE_BLESS").is_some() {
            std::fs::write(format!("{}/tests/scripts/{name}.rs", env!("CARGO_MANIFEST_DIR")), &text)?;
            continue;
        }
        assert!(
            text == expected,
            "expected the text of tests/scripts/{name}.rs: write it with LUMINAIRE_BLESS=1"
        );
    }
    let found = scripts::cubic::cubic()?;
    for (found, expected) in found.cone().versines().into_iter().zip(cubic.cone().versines()) {
        assert!((found / expected - 1.0).abs() < 1e-5, "{found} in place of {expected}");
    }
    // An axis is normalised again.
    let near = |one: Vec3<f32>, other: Vec3<f32>| {
        let off = one.zip(other, |one, other| one - other);
        assert!(off.dot(off) < 1e-12, "{one:?} in place of {other:?}");
    };
    near(found.axis(), cubic.axis());
    assert_eq!(found.with_cone(cubic.cone()).with_axis(cubic.axis())?, cubic.with_axis(cubic.axis())?);
    assert_eq!(scripts::point::point()?, point);
    let found = scripts::sun::sun()?;
    near(found.direction(), sun.direction());
    assert_eq!((found.color(), found.specular_color()), (sun.color(), sun.specular_color()));
    Ok(())
}

/// The build scripts of lights of each falloff and each attenuation compile.
#[test]
fn the_build_scripts_of_drawn_lights_compile() -> Result<(), Box<dyn std::error::Error>> {
    let mut rng = Rng::with_seed(12);
    let spots = spots::<Fx16>(&mut rng, 2).into_iter().map(AnyLight::from);
    let lights = spots.chain(points_of_light::<Fx16>(&mut rng).into_iter().map(AnyLight::from));
    let mut file = String::new();
    for (index, light) in lights.enumerate() {
        let text = export(light, &format!("light{index}"), Language::RustBuild)?;
        file += &format!("pub mod light{index} {{\n{text}}}\n");
    }
    compile_rust(&file, "lib", &tempfile::tempdir()?.path().join("scripts"))
}

/// A light that is not round is written as JSON, as constants of concrete types and as a build script, with the same bits,
/// and refused with what takes it by a language without its table.
#[test]
fn measured_lights_are_written_where_their_table_is() -> Result<(), Box<dyn std::error::Error>> {
    let samples: &[u16] = &[65_535, 3, 40_000, 0, 7, 9, 1, 40_000, 0, 7, 65_535, 3, 1, 3, 65_535];
    let distribution = Distribution::new(samples, 5, Symmetry::Bilateral)?;
    let light = MeasuredLight::new([1.0, 2.0, 3.0], [0.3, -1.0, 0.5], [0.9, 0.1, 0.1], distribution)?
        .with_color(Rgb::new(1.0, 0.5, 0.25))?
        .with_intensity(16.0)?
        .with_attenuation(FilamentRange::new(InverseSquare, Some(9.0))?);
    let text = export(light, "street", Language::Json)?;
    let read = json::read(&text)?;
    assert_eq!(read.lights[0].light, light.into());
    for (part, wrong, told) in [
        ("\"size\": 5", "\"size\": 6", "size of the distribution = 6: expected a power of two and one"),
        (
            "1, 3, 65535",
            "1, 4, 65535",
            "sample on the edge = 3: expected 4, the sample of the same direction",
        ),
        ("bilateral", "lateral", "symmetry = lateral: expected none, bilateral or quadrant"),
        ("\"side\": [", "\"side\": [0, 0, 0], \"near\": [", ""),
        ("40000", "-1", ""),
    ] {
        let refusal = json::read(&text.replacen(part, wrong, 1)).expect_err(wrong).to_string();
        assert!(refusal.contains(told), "{refusal}");
    }
    let fine = constant::<Fx32>(&light.into())?;
    assert_eq!(fine.type_name, "CompiledMeasuredLight<'static, Fx32, Windowed<InverseSquare>>");
    let close = |text: &str| text.split_whitespace().collect::<String>().replace(",]", "]");
    assert_eq!(close(&fine.value), close(&as_source(&light.compile::<Fx32>()?).to_string()));
    let script = export(light, "street", Language::RustBuild)?;
    let module = export(light, "street", Language::RustFixed16)?;
    let file = format!(
        "mod script {{\n{script}}}\n{}\nfn main() {{\n    let light = script::street().unwrap();\n    \
         assert_eq!(light.compile::<luminaire::Fx16>().unwrap(), street16::LIGHT);\n}}\n",
        module.replace("pub mod street", "pub mod street16")
    );
    let folder = tempfile::tempdir()?;
    let program = folder.path().join("street");
    compile_rust(&file, "bin", &program)?;
    assert!(std::process::Command::new(program).status()?.success(), "{file}");
    let refusal = export(light, "street", Language::RustProgram).expect_err("no table").to_string();
    assert!(refusal.starts_with("light = measured: expected a spotlight"), "{refusal}");
    // Samples that are missing are 0 in Rust; the lookup in C would read behind the table.
    let cut = Distribution::from_parts(&samples[..14], 5, Symmetry::Bilateral);
    let cut = MeasuredLight::new([0.0; 3], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], cut)?;
    let refusal = export(cut, "street", Language::CFixed).expect_err("too few samples").to_string();
    assert!(refusal.starts_with("number of samples = 14: expected 15"), "{refusal}");
    let fine = Distribution::new(&[9; 65 * 129], 129, Symmetry::Bilateral)?;
    let fine = MeasuredLight::new([0.0; 3], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], fine)?;
    let refusal = export(fine, "street", Language::Glsl).expect_err("too many samples").to_string();
    assert!(refusal.starts_with("number of samples = 8385: expected at most 4225"), "{refusal}");
    Ok(())
}

/// The programs of lights of each falloff and each attenuation compile, and one of two angles,
/// which it has, prints its pool.
#[test]
fn a_program_draws_the_light() -> Result<(), Box<dyn std::error::Error>> {
    let folder = tempfile::tempdir()?;
    let mut file = String::new();
    for (index, light) in spots::<Fx16>(&mut Rng::with_seed(13), 2).into_iter().enumerate() {
        file += &format!("pub mod light{index} {{\n{}}}\n", export(light, "key", Language::RustProgram)?);
    }
    compile_rust(&file, "lib", &folder.path().join("all"))?;
    let cone = Cone::from_beam_and_field(Angle::degrees(12.0), Angle::degrees(22.0))?;
    let light = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_intensity(130.57)?;
    let text = export(light, "key", Language::RustProgram)?;
    assert!(text.contains("from_beam_and_field(Angle::degrees(12.0), Angle::degrees(22.0))"), "{text}");
    let program = folder.path().join("key");
    compile_rust(&text, "bin", &program)?;
    let printed = String::from_utf8(std::process::Command::new(program).output()?.stdout)?;
    let rows: Vec<_> = printed.lines().map(str::as_bytes).collect();
    assert!(rows.len() == 21 && rows.iter().all(|row| row.len() == 41), "{printed}");
    // Full on the axis, nothing in the corners, and half of it where the beam angle ends.
    let half = (6.0_f64.to_radians().tan() / (cone.outer().to_degrees() / 2.0).to_radians().tan() as f64
        * 20.0) as usize;
    assert_eq!([rows[10][20], rows[0][0], rows[20][40]], *b"@  ", "{printed}");
    assert!(b"=+".contains(&rows[10][20 + half]), "{printed}");
    // An edge that its two angles do not determine, or that they cannot have, has its own.
    let smooth = light.with_cone(Cone::from_outer(Smooth, Angle::degrees(40.0))?);
    let text = export(smooth, "key", Language::RustProgram)?;
    assert!(text.contains("Cone::from_outer(Smooth, Angle::degrees(40.0))?;"), "{text}");
    let cone = Cone::from_outer(Hard, Angle::degrees(16.0))?.with_inner(Angle::degrees(9.0))?;
    let ended = light.with_cone(cone.with_cutoff(Angle::degrees(14.5))?);
    let text = export(ended, "key", Language::RustProgram)?;
    assert!(text.contains(".with_inner(Angle::degrees(9.0))?.with_cutoff(Angle::degrees(14.5))?;"), "{text}");
    let dark = export(light.with_intensity(0.0)?, "key", Language::RustProgram)?;
    assert!(dark.contains(".to_f32() / 1.0;"), "{dark}");
    Ok(())
}

/// With its uniforms as constants, and their own names, the shader is that of the constants.
#[test]
fn uniforms_are_the_constants_of_the_other_shader() {
    let angle = Angle::degrees(40.0);
    let cone = Cone::soft(angle).and_then(|cone| cone.with_cutoff(Angle::degrees(30.0))).expect("a cone");
    let light = SpotLight::new([0.5; 3], [0.0, -1.0, 0.25], cone).expect("a light");
    let [constant, mut uniform] = [Language::Glsl, Language::GlslUniforms]
        .map(|language| export(light, "key", language).expect("a shader"));
    assert!(
        uniform.contains("uniform highp vec3 key_position; // position: vec3(0.5, 0.5, 0.5)"),
        "{uniform}"
    );
    for name in ["Position", "Axis", "Outer", "Cutoff", "Slope", "Intensity"] {
        uniform =
            uniform.replace(&format!("key_{}", name.to_ascii_lowercase()), &format!("luminaire_key_{name}"));
    }
    let back = |line: &str| match line.strip_prefix("uniform ").and_then(|rest| rest.split_once("; // ")) {
        Some((name, rest)) => {
            let (doc, value) = rest.rsplit_once(": ").expect("a value");
            format!("const {name} = {value}; // {doc}")
        }
        None => line.to_owned(),
    };
    assert_eq!(uniform.lines().map(back).collect::<Vec<_>>(), constant.lines().collect::<Vec<_>>());
}

#[test]
fn what_cannot_be_exported_is_named() {
    let cone = Cone::soft(Angle::degrees(40.0)).expect("a cone");
    let light = SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone).expect("a light");
    let told = |light: AnyLight, name: &str, language| {
        export(light, name, language).expect_err("a refusal").to_string()
    };
    for (name, language, own) in [
        ("", Language::Glsl, "light"),
        ("Key", Language::Json, "key"),
        ("1st", Language::Wgsl, "light_1st"),
        ("a__b", Language::CFloat, "a_b"),
        ("a_", Language::CFixed, "a"),
        ("gl_light", Language::Glsl, "light_gl_light"),
        ("fn", Language::RustFloat, "fn_light"),
        ("main", Language::RustBuild, "main_light"),
        ("luminaire_is", Language::Glsl, "light_luminaire_is"),
        ("\u{e9} b", Language::CFixed, "b"),
    ] {
        let told = told(light.into(), name, language);
        assert!(told.starts_with(&format!("name = {name}: expected lower-case letters")), "{told}");
        assert!(told.ends_with(&format!("that {language} has taken; such as {own}")), "{told}");
        assert!(export(light, own, language).is_ok(), "{own}");
    }
    // Only names that the language itself has taken matter.
    for name in ["fn", "main", "std"] {
        assert!(export(light, name, Language::Glsl).is_ok() && export(light, name, Language::CFixed).is_ok());
    }
    assert!(export(light, "gl_light", Language::RustFloat).is_ok());
    let sun = DirectionalLight::new([0.0, -1.0, 0.0]).expect("a light");
    let refused = told(sun.into(), "sun", Language::RustProgram);
    assert_eq!(refused, "light = directional: expected a spotlight in rust-program; rust-build takes it");
    let narrow = light.with_cone(Cone::soft(Angle::degrees(0.5)).expect("a cone"));
    let refused = told(narrow.into(), "key", Language::CFixed);
    assert!(refused.starts_with("outer angle = ") && refused.contains("at least"), "{refused}");
    assert!(refused.ends_with(" in c-fx16; c-f32 takes it"), "{refused}");
    let refused = told(narrow.into(), "key", Language::RustBuild);
    assert!(refused.ends_with(" in rust-build; rust-fx32 takes it"), "{refused}");
    assert!(export(narrow, "key", Language::Glsl).is_ok());
    let long = light.with_cone(light.cone().with_falloff(Table::of(Box::leak(Box::new([1_u16; 1_025])))));
    let refused = told(long.into(), "key", Language::Wgsl);
    assert!(refused.starts_with("length of a table = 1025: expected at most 1024"), "{refused}");
    assert!(export(long, "key", Language::CFixed).is_ok());
}

#[test]
fn names_never_become_source_or_steer_a_terminal() {
    let light = PointLight::new([0.0; 3]).expect("a light");
    for hostile in ["a\nb", "a*/b", "a`b", "a\"b", "a\u{202e}b", "a\u{2066}b", "a\u{1b}[2Jb", "a\u{2028}b"] {
        for &language in Language::ALL {
            let told = export(light, hostile, language).expect_err("a refusal").to_string();
            assert!(
                !told.contains(|c: char| c.is_control() || "\u{202e}\u{2066}\u{2028}".contains(c)),
                "{told:?}"
            );
        }
        assert!(check_text("name", hostile).is_err(), "{hostile:?}");
    }
    assert!(check_text("name", "Fresnel 2 (left): Bühne, 36.5").is_ok());
}

#[test]
fn every_language_has_a_name() {
    for &language in Language::ALL {
        assert_eq!(language.to_string().parse(), Ok(language));
    }
    assert!(C_HEADERS.iter().all(|(_, text)| !text.contains('`')));
    let told = "pascal".parse::<Language>().expect_err("a refusal").to_string();
    assert!(told.starts_with("language = pascal: expected one of json, glsl, glsl-uniforms, wgsl"), "{told}");
    let axis = Vec3::new(0.0, -1.0, 0.0);
    let light =
        SpotLight::new([0.0; 3], axis, Cone::soft(Angle::degrees(40.0)).expect("a cone")).expect("a light");
    for &language in Language::ALL {
        let text = export(light, "key", language).expect("a light");
        assert!(text.contains("key") && text.ends_with('\n'), "{language}");
        // A shader is pasted into the string of a script, which a backtick would end.
        assert!(!text.contains('`'), "{text}");
    }
}
