//! Lights that are used together: in one file, in one program, from two files.

#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
mod compiler;

use std::collections::HashSet;
use std::fs;
use std::process::Command;

use luminaire::dynamic::AnyLight;
use luminaire::{Angle, Cone, DirectionalLight, PointLight, SpotLight, falloff::Hard};
use luminaire_export::{Language, export, export_all, identifier, names};

use compiler::{compile, compile_rust, is_missing, write_headers};

fn spot(degrees: f32) -> AnyLight {
    let cone = Cone::from_outer(Hard, Angle::degrees(degrees)).expect("a cone");
    SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone).expect("a light").into()
}

/// Each name is one that `export` accepts, no two are equal, and thousands of equal ones take no
/// time.
#[test]
fn names_of_lights_are_identifiers_of_their_language_and_differ() {
    let texts =
        ["Key 1", "key-1", "", "main", "Static", "gl_a", "luminaire", "1", "B\u{fc}hne", "key_1_2", "std"];
    let found = names(texts, Language::RustBuild);
    let expected = [
        "key_1",
        "key_1_2",
        "light",
        "main_light",
        "static_light",
        "gl_a",
        "light_luminaire",
        "light_1",
        "b_hne",
        "key_1_2_2",
        "std_light",
    ];
    assert_eq!(found, expected);
    assert_eq!(identifier("main", Language::Glsl), "main");
    for &language in Language::ALL {
        let names = names(texts, language);
        let lights = names.iter().map(|name| (name.as_str(), spot(30.0)));
        let (text, refused) = export_all(lights, language);
        assert!(refused.is_empty() && !text.is_empty(), "{language}: {refused:?}");
        assert_eq!(names.iter().collect::<HashSet<_>>().len(), texts.len(), "{names:?}");
    }
    let many = names(std::iter::repeat_n("Spot", 50_000), Language::Glsl);
    assert_eq!((many[0].as_str(), many[49_999].as_str()), ("spot", "spot_50000"));
}

/// Two headers of two lights: by two names both count, by one name the compiler says so, and a
/// header twice counts once.
#[test]
fn headers_of_two_lights_count_both_or_are_an_error() {
    let folder = tempfile::tempdir().expect("a folder");
    write_headers(folder.path());
    let write = |file: &str, text: &str| fs::write(folder.path().join(file), text).expect("a file");
    for language in [Language::CFixed, Language::CFloat] {
        for (file, light, name) in
            [("key.h", spot(30.0), "key"), ("rim.h", spot(20.0), "rim"), ("other.h", spot(20.0), "key")]
        {
            write(file, &export(light, name, language).expect("a light"));
        }
        write(
            "both.c",
            "#include \"key.h\"\n#include \"rim.h\"\n#include \"key.h\"\nint main(void) { return !(key_irradiance && rim_irradiance); }\n",
        );
        write("clash.c", "#include \"key.h\"\n#include \"other.h\"\nint main(void) { return 0; }\n");
        write("other.c", "#define KEY_LIGHT_H\n#include \"key.h\"\nint main(void) { return 0; }\n");
        for (compiler, flags) in [("gcc", "-std=c99 -Wno-address"), ("g++", "-std=c++11 -Wno-address")] {
            if compile(compiler, flags, &folder.path().join("both.c"), &folder.path().join("both")).is_none()
            {
                continue;
            }
            for (file, told) in [("clash.c", "two lights have the name key"), ("other.c", "KEY_LIGHT_H")] {
                let mut refused = Command::new(compiler);
                let refused =
                    refused.args(["-x", if compiler == "gcc" { "c" } else { "c++" }, "-fsyntax-only"]);
                let Ok(refused) = refused.arg(folder.path().join(file)).output() else {
                    return is_missing(compiler).unwrap_or_default();
                };
                let errors = String::from_utf8_lossy(&refused.stderr).into_owned();
                assert!(!refused.status.success() && errors.contains(told), "{language}: {file}: {errors}");
            }
        }
    }
}

/// Several lights are one build script and one program. Their names are those that the text itself
/// uses.
#[test]
fn several_lights_are_one_program_of_rust() -> Result<(), Box<dyn std::error::Error>> {
    let folder = tempfile::tempdir()?;
    let lamp = PointLight::new([1.0, 2.0, 3.0])?.into();
    let sun = DirectionalLight::new([0.0, -1.0, 0.5])?.into();
    let lights = [("as_source", spot(30.0)), ("out", lamp), ("file", sun), ("light", spot(20.0))];
    let (script, refused) = export_all(lights, Language::RustBuild);
    assert!(refused.is_empty(), "{refused:?}");
    let program = folder.path().join("script");
    compile_rust(&script, "bin", &program)?;
    assert!(Command::new(&program).env("OUT_DIR", folder.path()).status()?.success());
    let mut text = String::new();
    for (name, kind) in [
        ("as_source", "CompiledSpotLight<Fx16, Hard>"),
        ("out", "CompiledPointLight<Fx16>"),
        ("file", "CompiledDirectionalLight<Fx16>"),
        ("light", "CompiledSpotLight<Fx16, Hard>"),
    ] {
        let file = folder.path().join(name).with_extension("rs");
        text += &format!("pub const _: {kind} = include!({file:?});\n");
    }
    let imports = "use luminaire::{Fx16, falloff::Hard, light::*};";
    compile_rust(&format!("{imports}\n{text}"), "lib", &folder.path().join("constants"))?;

    let lights = [("key", spot(30.0)), ("lamp", lamp), ("light", spot(20.0))];
    let (text, refused) = export_all(lights, Language::RustProgram);
    let [(1, error)] = &refused[..] else { panic!("{refused:?}") };
    assert!(error.to_string().starts_with("light = point: expected a spotlight in rust-program"), "{error}");
    let program = folder.path().join("program");
    compile_rust(&text, "bin", &program)?;
    let printed = String::from_utf8(Command::new(program).output()?.stdout)?;
    let heads: Vec<_> = printed.lines().step_by(22).collect();
    assert_eq!((heads, printed.lines().count()), (vec!["key", "light"], 44), "{printed}");
    Ok(())
}
