//! Places the programs in memory, and writes the lights of the programs `still` and `frame`.

#[cfg(feature = "pick")]
mod answers;
#[path = "src/frame/measures.rs"]
#[allow(dead_code, reason = "the shapes are the program's part")]
mod measures;
mod memory;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use luminaire::{
    AmbientLight, Angle, Cone, Fx16, Material, Rgb, SpotLight, Vec3,
    codegen::{Source, as_source},
    falloff::Soft,
};

/// The linear colours of the wall, a light tile, a dark one, the ball and the column of the program
/// `frame`.
const MATERIALS: [[f32; 3]; 5] =
    [[0.5, 0.36, 0.4], [0.62, 0.55, 0.46], [0.3, 0.26, 0.23], [0.72, 0.1, 0.06], [0.66, 0.63, 0.56]];

type Outcome = Result<(), Box<dyn Error>>;

fn main() -> Outcome {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=memory.rs");
    println!("cargo::rerun-if-changed=src/frame/measures.rs");
    memory::place(None)?;
    #[cfg(feature = "pick")]
    picked()?;
    still()?;
    frame()
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

/// The spotlight of the program `still`, which hangs three metres above a floor and shines at a
/// slant.
fn still() -> Outcome {
    let cone = Cone::from_field(Soft, Angle::degrees(50.0))?;
    let key =
        SpotLight::new(Vec3::new(-1.0, 3.0, -0.5), Vec3::new(0.3, -1.0, 0.15), cone)?.with_intensity(10.0)?;
    write("key.rs", &key.compile::<Fx16>()?)
}

/// The spotlight of the program `frame`, the ambient light that each material reflects, and the
/// product of each material's colour and the spotlight's.
fn frame() -> Outcome {
    let cone = Cone::from_field(Soft, Angle::degrees(44.0))?;
    let [x, y, z] = measures::LIGHT;
    let axis = Vec3::new(0.125 - x, 0.375 - y, -0.375 - z);
    let key = SpotLight::new(Vec3::new(x, y, z), axis, cone)?.with_intensity(24.0)?;
    let color = Rgb::new(1.0, 0.8, 0.55);
    let ambient = AmbientLight::new(Rgb::new(0.03, 0.04, 0.075))?.compile::<Fx16>();
    let mut glow = MATERIALS.map(|_| Rgb::default());
    let mut tint = MATERIALS.map(|_| Rgb::default());
    for (index, [red, green, blue]) in MATERIALS.into_iter().enumerate() {
        let diffuse = Rgb::new(red, green, blue);
        glow[index] = Material::new(diffuse)?.compile::<Fx16>().glow(ambient);
        tint[index] = color.zip(diffuse, |a, b| Fx16::from_f32(a * b));
    }
    write("frame_key.rs", &key.compile::<Fx16>()?)?;
    write("frame_glow.rs", &glow)?;
    write("frame_tint.rs", &tint)
}

fn write(name: &str, value: &impl Source) -> Outcome {
    let file = Path::new(&env::var("OUT_DIR")?).join(name);
    Ok(fs::write(file, as_source(value).to_string())?)
}
