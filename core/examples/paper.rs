//! A relief on electronic paper of four greys, in 16-bit integers: prints it as characters.
//!
//! The relief is a normal map under a raking light, which shows it best. A row of the paper is lit at once, dithered,
//! and packed in the bytes that its controller takes.

use luminaire::{
    Angle, Cone, Fx16, Length, Rgb, SpotLight, Vec3,
    display::{CompiledExposure, Exposure, Gray2, Layout, clip, pack},
    draw::normals_from_directx,
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
/// Columns and rows of a tile of the relief.
const TILE: [usize; 2] = [16, 10];
/// The normals of a tile, which the compiler makes from the bytes of its image.
const RELIEF: [[i8; 3]; TILE[0] * TILE[1]] = normals_from_directx(&stud());

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
    row.fill_facing(light, |x| Fx16::normal_from_bytes(relief(x, y as usize)), lit.start, &mut arrived[lit]);

    let mut pixels = [Gray2::default(); COLUMNS];
    for ((x, pixel), arrived) in (0..).zip(&mut pixels).zip(arrived) {
        let color = clip(exposure.expose(Rgb::lit(arrived, light.color())));
        *pixel = Gray2::from_luminance_dithered(color.green, x, y as u32);
    }
    let mut bytes = [0; BYTES];
    pack(&pixels, Layout::MsbFirst, &mut bytes);
    bytes
}

/// The normal of a pixel of the relief.
fn relief(x: usize, y: usize) -> [i8; 3] {
    RELIEF[y % TILE[1] * TILE[0] + x % TILE[0]]
}

/// A tile of the normal map, a round stud on a plate, in the bytes of an image: red to the right, green down and blue
/// to the viewer, as Direct3D has them, each with 128 for 0. Another program has the bytes of a file here.
const fn stud() -> [[u8; 3]; TILE[0] * TILE[1]] {
    let mut map = [[128, 128, 255]; TILE[0] * TILE[1]];
    let mut i = 0;
    while i < map.len() {
        let (right, down) = ((i % TILE[0]) as i32 - 8, 2 * ((i / TILE[0]) as i32 - 5));
        let height = 49 - right * right - down * down;
        if height > 0 {
            map[i] = [byte(right), byte(down), byte(height.isqrt())];
        }
        i += 1;
    }
    map
}

/// The byte of a component between -7 and 7.
const fn byte(component: i32) -> u8 {
    (128 + 16 * component) as u8
}

/// The greys of a row of bytes, as the paper shows them.
fn greys(bytes: &[u8; BYTES]) -> [u8; COLUMNS] {
    std::array::from_fn(|x| bytes[x / 4] >> (6 - 2 * (x % 4)) & 3)
}

#[test]
fn studs_are_bright_towards_the_light_and_dark_behind() {
    let (light, exposure) = (lamp().expect("a light"), Exposure::stops(1).expect("an exposure").compile());
    let sum = |y: i32, columns: std::ops::Range<usize>| -> u32 {
        greys(&paper(&light, &exposure, y))[columns].iter().map(|&grey| u32::from(grey)).sum()
    };
    let [left, right] = [34..40, 41..47].map(|columns| sum(15, columns));
    assert!(left > right + 6, "{left} left of a stud's middle, {right} right of it");
    // The middle of the light is at row 19.
    let [above, below] = [33, 37].map(|y| sum(y, 32..48));
    assert!(above > below, "{above} above the middle of the last studs, {below} below it");
}
