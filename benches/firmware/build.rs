//! Places the programs in memory, and writes what the programs `drawn` and `pictures` draw as constants.

mod memory;
#[cfg(feature = "pictures")]
mod rendered;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use luminaire::{
    Angle, Cone, Fx16, HalfAngle, Rgb, SpotLight, Vec3,
    attenuation::NoAttenuation,
    codegen::{Source, as_source},
    display::{Ramp, Rgb565},
    draw::Gradient,
    falloff::Soft,
};

/// The side of the sprite in pixels.
const SIDE: i32 = 120;
const LEDS: usize = 500;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=memory.rs");
    println!("cargo::rerun-if-changed=rendered.rs");
    // The pictures do not fit into the flash of the smallest board.
    memory::place(cfg!(feature = "pictures").then_some("4M"))?;
    #[cfg(feature = "pictures")]
    rendered::write()?;
    let [night, dusk] = [Rgb::new(12, 18, 60), Rgb::new(190, 90, 80)];
    let ramp: Ramp<Rgb565> = Ramp::new(Rgb::new(0.01, 0.02, 0.05), Rgb::new(0.9, 0.7, 0.4))?;
    write("ramp", source(&ramp))?;
    let linear: Gradient<Rgb565> = Gradient::linear(&[night, dusk], [0.0, 0.0], [200.0, 230.0])?;
    write("linear", source(&linear))?;
    let radial: Gradient<Rgb565> = Gradient::radial(&[dusk, night], [120.0, 120.0], 110.0)?;
    write("radial", source(&radial))?;
    let cone = Cone::soft(Angle::degrees(40.0))?;
    let light = SpotLight::new([1.9, 1.9, 2.0], [0.0, 0.0, -1.0], cone)?.with_intensity(4.0)?;
    write("pool", source(&light.compile_quick::<Fx16>()?))?;
    write("normals", format!("{:?}", (0..SIDE * SIDE).map(normal).collect::<Vec<_>>()))?;
    let lamps: Result<Vec<_>, Box<dyn Error>> = (0..4).map(lamp).collect();
    write("lamps", list(lamps?))?;
    let places = (0..LEDS).map(|i| source(&place(i).map(luminaire::Length::from_f32)));
    write("places", list(places.collect()))
}

/// The normal of a pixel of a ball as three bytes; zero outside.
fn normal(i: i32) -> [i8; 3] {
    let [x, y] = [i % SIDE, i / SIDE].map(|place| f64::from(2 * place + 1 - SIDE) / f64::from(SIDE));
    let z = 1.0 - x * x - y * y;
    if z > 0.0 { [x, y, z.sqrt()].map(|part| (127.0 * part).round() as i8) } else { [0; 3] }
}

/// A spotlight beside a tree of LEDs.
fn lamp(i: usize) -> Result<String, Box<dyn Error>> {
    let [x, z] = [[3.0, 0.0], [0.0, 3.0], [-3.0, 0.0], [0.0, -3.0]][i];
    let color = [[1.0, 0.1, 0.0], [0.0, 0.3, 1.0], [1.0, 0.6, 0.1], [0.5, 0.0, 1.0]][i];
    let cone = Cone::from_outer(Soft, HalfAngle::degrees(9.0))?;
    let light = SpotLight::new([x, 1.0, z], [-x, 0.5 * i as f32 - 0.75, -z], cone)?;
    let light = light.with_attenuation(NoAttenuation).with_color(color.into())?;
    Ok(source(&light.compile_quick::<Fx16>()?))
}

/// The position of an LED: on a spiral of 20 turns around a cone.
fn place(i: usize) -> Vec3<f32> {
    let height = i as f32 / LEDS as f32;
    let (sine, cosine) = (20.0 * std::f32::consts::TAU * height).sin_cos();
    let radius = 0.6 * (1.0 - height);
    Vec3::new(radius * cosine, 2.0 * height, radius * sine)
}

fn source(value: &impl Source) -> String {
    as_source(value).to_string()
}

fn list(items: Vec<String>) -> String {
    format!("[{}]", items.join(","))
}

fn write(name: &str, text: String) -> Result<(), Box<dyn Error>> {
    Ok(fs::write(Path::new(&env::var("OUT_DIR")?).join(format!("{name}.rs")), text)?)
}
