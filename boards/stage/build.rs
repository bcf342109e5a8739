//! Compiles the light of the stage, the ambient light that each material reflects, and the product
//! of each material's colour and the light's.

#[path = "src/measures.rs"]
#[allow(dead_code, reason = "the shapes are the program's part")]
mod measures;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use luminaire::{
    AmbientLight, Angle, Cone, Fx16, Material, Rgb, SpotLight,
    codegen::{Source, as_source},
    falloff::Soft,
};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=src/measures.rs");
    let cone = Cone::from_field(Soft, Angle::degrees(measures::FIELD))?;
    let key = SpotLight::new(measures::LIGHT, measures::AXIS, cone)?.with_intensity(measures::INTENSITY)?;
    let color = Rgb::from(measures::COLOR);
    let ambient = AmbientLight::new(measures::AMBIENT.into())?.compile::<Fx16>();
    let mut glow = measures::MATERIALS.map(|_| Rgb::default());
    let mut tint = measures::MATERIALS.map(|_| Rgb::default());
    for (index, diffuse) in measures::MATERIALS.map(Rgb::from).into_iter().enumerate() {
        glow[index] = Material::new(diffuse)?.compile::<Fx16>().glow(ambient);
        tint[index] = color.zip(diffuse, |a, b| Fx16::from_f32(a * b));
    }
    write("key.rs", &key.compile_quick::<Fx16>()?)?;
    write("glow.rs", &glow)?;
    write("tint.rs", &tint)
}

fn write(name: &str, value: &impl Source) -> Result<(), Box<dyn Error>> {
    let file = Path::new(&env::var("OUT_DIR")?).join(name);
    Ok(fs::write(file, as_source(value).to_string())?)
}
