//! Two coloured spotlights on a wall, in 16-bit integers: prints the picture as characters.
//!
//! `scanline` is what a microcontroller would run, with lights that a build script compiles, as in
//! `examples/boards/template`.

use luminaire::{
    Angle, Cone, Fx16, Length, Rgb, SpotLight, Vec3,
    display::{Rgb565, clip},
    falloff::Soft,
    light::CompiledSpotLight,
};

type Light = CompiledSpotLight<Fx16, Soft>;

const COLUMNS: usize = 80;
const ROWS: i32 = 32;

fn main() -> Result<(), luminaire::Error> {
    let cone = Cone::soft(Angle::degrees(40.0))?;
    let warm = SpotLight::new([1.5, 1.0, 3.0], [-0.1, 0.0, -1.0], cone)?.with_intensity(9.0)?;
    let cool = SpotLight::new([3.5, 1.0, 3.0], [0.2, 0.0, -1.0], cone)?.with_intensity(9.0)?;
    let lights = [
        warm.with_color(Rgb::new(1.0, 0.6, 0.3))?.compile()?,
        cool.with_color(Rgb::new(0.3, 0.5, 1.0))?.compile()?,
    ];
    for row in 0..ROWS {
        let mut pixels = [[0; 2]; COLUMNS];
        scanline(&lights, row, &mut pixels);
        let pixels = pixels.map(|bytes| Rgb565(u16::from_be_bytes(bytes)));
        let characters = pixels.map(|pixel| b" .:-=+*#%@"[usize::from(pixel.to_codes().green) * 9 / 255]);
        println!("{}", String::from_utf8_lossy(&characters));
    }
    Ok(())
}

/// One row of a wall that faces the lights, 16 pixels to the metre, in the bytes that most displays take by SPI.
fn scanline(lights: &[Light], row: i32, pixels: &mut [[u8; 2]]) {
    const NORMAL: Vec3<Fx16> = Fx16::normal([0.0, 0.0, 1.0]);
    let metres = |pixels: i32| Length::from_bits(pixels << (16 - 4)); // 16 fraction bits
    for (column, pixel) in (0..).zip(pixels) {
        let point = Vec3::new(metres(column), metres(row), Length::ZERO);
        let mut sum = Rgb::default();
        for light in lights {
            sum += Rgb::lit(light.irradiance(point, NORMAL), light.color());
        }
        *pixel = Rgb565::from_linear(clip(sum)).to_be_bytes();
    }
}
