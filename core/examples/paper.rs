//! A relief on electronic paper of four greys, in 16-bit integers: prints it as characters.
//!
//! The relief is a picture of normals under a raking light, which shows it best. A row of the paper is lit at once,
//! dithered, and packed in the bytes that its controller takes.

use luminaire::{
    Angle, Cone, Fx16, Length, Rgb, SpotLight, Vec3,
    display::{CompiledExposure, Exposure, Gray2, Layout, clip, pack},
    falloff::Soft,
    light::{QuickSpotLight, Row},
    number::Light16,
};

type Light = QuickSpotLight<Fx16, Soft>;

const COLUMNS: usize = 96;
const ROWS: i32 = 40;
/// The normal of the paper.
const FACING: Vec3<Fx16> = Fx16::normal([0.0, 0.0, 1.0]);
/// The bytes of a row: four pixels in each.
const BYTES: usize = COLUMNS / 4;

fn main() -> Result<(), luminaire::Error> {
    let (light, exposure) = (lamp()?, Exposure::stops(1)?.compile());
    for y in 0..ROWS {
        let greys = greys(&paper(&light, &exposure, y));
        println!("{}", String::from_utf8_lossy(&greys.map(|grey| b" -+#"[usize::from(grey)])));
    }
    Ok(())
}

/// A light to the left of the paper, just above it.
fn lamp() -> Result<Light, luminaire::Error> {
    let cone = Cone::soft(Angle::degrees(60.0))?;
    SpotLight::new([-0.5, 1.2, 1.2], [3.5, 0.0, -1.2], cone)?.with_intensity(9.0)?.compile_quick()
}

/// The bytes of a row of the paper, 16 pixels to the metre; y points down.
fn paper(light: &Light, exposure: &CompiledExposure<Fx16>, y: i32) -> [u8; BYTES] {
    let metres = |pixels: i32| Length::from_bits(pixels << (16 - 4)); // 16 fraction bits
    let row = Row::along_x(FACING, [metres(y), Length::ZERO], |x| metres(x as i32));
    let mut arrived = [Light16::ZERO; COLUMNS];
    let lit = row.reach(light, COLUMNS);
    row.fill_facing(light, |x| Fx16::normal_from_bytes(relief(x as i32, y)), lit.start, &mut arrived[lit]);

    let mut pixels = [Gray2::default(); COLUMNS];
    for ((x, pixel), arrived) in (0..).zip(&mut pixels).zip(arrived) {
        let color = clip(exposure.expose(Rgb::lit(arrived, light.color())));
        *pixel = Gray2::from_luminance_dithered(color.green, x, y as u32);
    }
    let mut bytes = [0; BYTES];
    pack(&pixels, Layout::MsbFirst, &mut bytes);
    bytes
}

/// The normal of a pixel of the relief: a plate with round studs, 16 columns and 10 rows apart.
fn relief(x: i32, y: i32) -> [i8; 3] {
    let (right, down) = (x.rem_euclid(16) - 8, 2 * (y.rem_euclid(10) - 5));
    let height = 49 - right * right - down * down;
    if height <= 0 {
        [0, 0, 127]
    } else {
        [right, down, height.isqrt()].map(|component| (16 * component) as i8)
    }
}

/// The greys of a row of bytes, as the paper shows them.
fn greys(bytes: &[u8; BYTES]) -> [u8; COLUMNS] {
    std::array::from_fn(|x| bytes[x / 4] >> (6 - 2 * (x % 4)) & 3)
}

#[test]
fn studs_are_bright_towards_the_light_and_dark_behind() {
    let (light, exposure) = (lamp().expect("a light"), Exposure::stops(1).expect("an exposure").compile());
    let greys = greys(&paper(&light, &exposure, 15));
    let sum =
        |columns: std::ops::Range<usize>| greys[columns].iter().map(|&grey| u32::from(grey)).sum::<u32>();
    assert!(sum(34..40) > sum(41..47) + 6, "{greys:?}");
}
