//! Converts the pictures in `art`, and computes the tables.

#[path = "src/measures.rs"]
#[allow(dead_code, unreachable_pub, reason = "some are the program's part alone, and all are its interface")]
mod measures;

#[path = "convert.rs"]
mod convert;

use std::error::Error;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::{env, f64::consts::TAU};

use luminaire::{
    Fx16, PointLight, Rgb,
    codegen::as_source,
    display::{Pixel as _, Rgb555, clip, decode_srgb},
};

use convert::{Converted, Picture};
use measures::{AMBIENT, COLORS, INTENSITY, LIGHT_LEVELS, MATERIALS, SIDE, STEPS};

fn main() -> Result<(), Box<dyn Error>> {
    for file in ["art", "build.rs", "convert.rs", "src/measures.rs"] {
        println!("cargo::rerun-if-changed={file}");
    }
    let [color, normals, glow] = ["golem.png", "golem-normals.png", "golem-glow.png"].map(picture);
    let sprite = convert::convert([&color?, &normals?, &glow?], SIDE, MATERIALS)?;
    write("sprite.rs", &source(&sprite))?;
    let light = PointLight::new([0.0; 3])?.with_intensity(INTENSITY)?;
    write("light.rs", &as_source(&light.compile::<Fx16>()?).to_string())?;
    let sine = (0..256).map(|i| (f64::from(1 << 14) * (TAU * f64::from(i) / 256.0).sin()).round());
    write("sine.rs", &list(sine.map(|sine| sine as i16)))?;
    let lights: Vec<f32> = (0..LIGHT_LEVELS).map(light_of).collect();
    let levels = (0..STEPS).map(|step| level((step as f32 + 0.5) / 2_048.0, &lights));
    write("levels.rs", &list(levels.chain([0; STEPS])))?;
    write("pixels.rs", &list(pixels(&sprite, &lights)))?;
    write("lamps.rs", &list(COLORS.map(|[red, green, blue]| shown(Rgb::new(red, green, blue)))))
}

/// The light of a level: that of an sRGB channel of five bits.
fn light_of(level: usize) -> f32 {
    decode_srgb(Rgb555(level as u16).to_codes().blue)
}

/// The level of light, in eighths.
fn level(light: f32, lights: &[f32]) -> u8 {
    let below = lights.iter().take_while(|level| **level <= light).count().max(1) - 1;
    let (from, to) = (lights[below], lights.get(below + 1).copied().unwrap_or(f32::INFINITY));
    (8 * below) as u8 + (8.0 * (light - from) / (to - from)) as u8
}

/// The pixels of all materials under all levels of both lights, with blue in the upper bits.
fn pixels(sprite: &Converted, lights: &[f32]) -> Vec<u16> {
    let mut pixels = vec![0; MATERIALS * LIGHT_LEVELS * LIGHT_LEVELS];
    for ((material, first), second) in (0..sprite.materials.len())
        .flat_map(|m| (0..LIGHT_LEVELS).map(move |i| (m, i)))
        .flat_map(|i| (0..LIGHT_LEVELS).map(move |j| (i, j)))
    {
        let [color, glow]: [[f32; 3]; 2] = sprite.materials[material].map(|codes| codes.map(decode_srgb));
        let channel = |c: usize| {
            let arrived = AMBIENT[c] + lights[first] * COLORS[0][c] + lights[second] * COLORS[1][c];
            glow[c] + color[c] * arrived
        };
        pixels[(material * LIGHT_LEVELS + first) * LIGHT_LEVELS + second] =
            shown(Rgb::new(channel(0), channel(1), channel(2)));
    }
    pixels
}

/// The pixel of a linear colour, with blue in the upper bits.
fn shown(color: Rgb<f32>) -> u16 {
    let Rgb555(bits) = Rgb555::nearest(clip::<f32>(color));
    (bits & 31) << 10 | bits & 31 << 5 | bits >> 10
}

/// The constants of the sprite.
fn source(sprite: &Converted) -> String {
    let words: Vec<_> = sprite.words.iter().map(|word| format!("Word({word})")).collect();
    let spans: Vec<_> = sprite
        .spans
        .iter()
        .map(|[y, start, end]| format!("Span {{ y: {y}, start: {start}, end: {end} }}"))
        .collect();
    format!(
        "/// The opaque pixels.\npub static WORDS: [Word; {}] = [{}];\n/// Where they are.\npub static SPANS: [Span; {}] = [{}];",
        words.len(),
        words.join(", "),
        spans.len(),
        spans.join(", ")
    )
}

fn list<T: ToString>(items: impl IntoIterator<Item = T>) -> String {
    format!("[{}]", items.into_iter().map(|item| item.to_string()).collect::<Vec<_>>().join(", "))
}

/// Reads a PNG of [`SIDE`] x [`SIDE`] pixels.
fn picture(name: &str) -> Result<Picture, Box<dyn Error>> {
    let path = Path::new("art").join(name);
    let mut decoder = png::Decoder::new(BufReader::new(File::open(&path)?));
    decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::STRIP_16);
    let mut reader = decoder.read_info()?;
    let mut bytes = vec![0; reader.output_buffer_size().ok_or("too large")?];
    let info = reader.next_frame(&mut bytes)?;
    if [info.width, info.height] != [SIDE as u32; 2] {
        return Err(format!(
            "{}: {} x {} pixels: expected {SIDE} x {SIDE}",
            path.display(),
            info.width,
            info.height
        )
        .into());
    }
    let pixels = bytes.chunks(info.color_type.samples());
    pixels
        .map(|pixel| match *pixel {
            [grey] => Ok([grey, grey, grey, 255]),
            [grey, alpha] => Ok([grey, grey, grey, alpha]),
            [red, green, blue] => Ok([red, green, blue, 255]),
            [red, green, blue, alpha] => Ok([red, green, blue, alpha]),
            _ => Err("a pixel of more than four samples".into()),
        })
        .collect()
}

fn write(name: &str, text: &str) -> Result<(), Box<dyn Error>> {
    Ok(fs::write(PathBuf::from(env::var("OUT_DIR")?).join(name), text)?)
}
