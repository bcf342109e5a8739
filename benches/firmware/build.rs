//! Places the programs in memory, and writes the lights of the programs `still`, `picked` and
//! `exported`.

#[cfg(feature = "pick")]
mod answers;
mod memory;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use luminaire::{
    Angle, Cone, Fx16, SpotLight, Vec3,
    codegen::{Source, as_source},
    falloff::Soft,
};

type Outcome = Result<(), Box<dyn Error>>;

fn main() -> Outcome {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=memory.rs");
    memory::place(None)?;
    #[cfg(feature = "pick")]
    picked()?;
    let key = key()?;
    #[cfg(feature = "export")]
    exported(key)?;
    write("key.rs", &key.compile::<Fx16>()?)
}

/// The lights of the program `picked`: calls of its macro `run`.
#[cfg(feature = "pick")]
fn picked() -> Outcome {
    println!("cargo::rerun-if-changed=answers.rs");
    let mut text = String::from("{\n");
    for (number, answer) in answers::all()?.iter().enumerate() {
        let luminaire_pick::Light { position, axis, near, far, .. } = answer.light;
        let format = match answer.evaluation.name().split('-').next() {
            Some("fx16") => "luminaire::Fx16",
            Some("fx32") => "luminaire::Fx32",
            _ => "f32",
        };
        let tangent = (answer.outer / 2.0).to_radians().tan();
        text += &format!(
            "{{\n{}\nrun!({number}, {format}, LIGHT, Domain {{ position: {position:?}, axis: {axis:?}, \
             tangent: {tangent:?}, near: {near:?}, far: {far:?} }});\n}}\n",
            answer.code
        );
    }
    let file = Path::new(&env::var("OUT_DIR")?).join("picked.rs");
    Ok(fs::write(file, text + "}\n")?)
}

/// The spotlight of the programs `still` and `exported`, which hangs three metres above a floor and
/// shines at a slant.
fn key() -> Result<SpotLight<Soft>, luminaire::Error> {
    let cone = Cone::from_field(Soft, Angle::degrees(50.0))?;
    SpotLight::new(Vec3::new(-1.0, 3.0, -0.5), Vec3::new(0.3, -1.0, 0.15), cone)?.with_intensity(10.0)
}

/// Compiles the spotlight of the program `exported` as C.
#[cfg(feature = "export")]
fn exported(key: SpotLight<Soft>) -> Outcome {
    let folder = env::var("OUT_DIR")?;
    let folder = Path::new(&folder);
    let header = luminaire_export::export(key, "key", luminaire_export::Language::CFixed)?;
    let source = folder.join("exported.c");
    fs::write(folder.join("luminaire_fx16.h"), luminaire_export::c_header())?;
    fs::write(
        &source,
        header
            + "uint32_t exported(const int32_t p[3], const int16_t n[3]);\n\
               uint32_t exported(const int32_t p[3], const int16_t n[3]) { return key_irradiance(p, n); }\n",
    )?;
    let mut build = cc::Build::new();
    build
        .file(source)
        .std("c99")
        .flag("-ffreestanding")
        .flag("-Wno-unused-function")
        .flag("-Wno-unused-const-variable");
    build.try_compile("exported")?;
    Ok(())
}

fn write(name: &str, value: &impl Source) -> Outcome {
    let file = Path::new(&env::var("OUT_DIR")?).join(name);
    Ok(fs::write(file, as_source(value).to_string())?)
}
