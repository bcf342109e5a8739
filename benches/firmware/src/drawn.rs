//! What one pixel or LED of a row call costs: rows of a wall, the drawables for two dimensions, and a tree of LEDs.

use luminaire::{
    Fx16, Length, Rgb, Vec3,
    attenuation::NoAttenuation,
    display::{LedOrder, LedStrip, Pixel, Ramp, Rgb565, TemporalDither, clip},
    draw::{Gradient, Pool, Sprite},
    falloff::Soft,
    light::{QuickSpotLight, Row},
    number::Light16,
};

use crate::board::{begin, end, opaque, println};

const WIDTH: usize = 240;
const ROWS: i32 = 24;
/// The side of the sprite in pixels.
const SIDE: usize = 120;
const LEDS: usize = 500;
const STRIP: LedStrip = LedStrip::new(LedOrder::Grb).with_limit(4_000, 20, 1);
/// 64 pixels to the metre.
const PIXEL: Length = Length::from_bits(1 << (16 - 6));

static RAMPS: [Ramp<Rgb565>; 1] = [include!(concat!(env!("OUT_DIR"), "/ramp.rs"))];
static LINEAR: Gradient<Rgb565> = include!(concat!(env!("OUT_DIR"), "/linear.rs"));
static RADIAL: Gradient<Rgb565> = include!(concat!(env!("OUT_DIR"), "/radial.rs"));
const LIGHT: QuickSpotLight<Fx16, Soft> = include!(concat!(env!("OUT_DIR"), "/pool.rs"));
static NORMALS: [[i8; 3]; SIDE * SIDE] = include!(concat!(env!("OUT_DIR"), "/normals.rs"));
static LAMPS: [QuickSpotLight<Fx16, Soft, NoAttenuation>; 4] =
    include!(concat!(env!("OUT_DIR"), "/lamps.rs"));
static PLACES: [Vec3<Length>; LEDS] = include!(concat!(env!("OUT_DIR"), "/places.rs"));

/// Draws each of them between the markers, and prints two lines for each: `name checksum bits` and `name
/// number points`.
pub fn drawn() {
    rows("gradient", |y, pixels: &mut [_; WIDTH]| opaque(&LINEAR).row(10 * y, 0, pixels));
    rows("gradient-radial", |y, pixels: &mut [_; WIDTH]| opaque(&RADIAL).row(10 * y, 0, pixels));
    let pool = Pool::new(&RAMPS[0], PIXEL);
    rows("pool", |y, pixels: &mut [_; WIDTH]| opaque(&pool).row(&LIGHT, 10 * y, 0, pixels));
    let Ok(sprite) = Sprite::new(SIDE, &NORMALS, &RAMPS, PIXEL) else { return };
    let sprite = sprite.at(60, 0);
    report("sprite", SIDE * SIDE, || {
        let mut pixels = [Rgb565(0); SIDE];
        (0..SIDE as i32).fold(0, |sum, y| {
            opaque(&sprite).row(&[LIGHT], y, 60, &mut pixels);
            folded(sum, &pixels)
        })
    });
    // A row of a wall in the light alone.
    let wall =
        Row::along_x(Fx16::normal([0.0, 0.0, 1.0]), [Length::from_f32(1.9), Length::ZERO], |i: usize| {
            Length::from_bits((i as i32) << (16 - 6))
        });
    let mut arrived = [Light16::ZERO; WIDTH / 2];
    report("row", WIDTH / 2, || {
        wall.fill(opaque(&LIGHT), 60, &mut arrived);
        arrived.iter().fold(0, |sum: u32, light| sum.wrapping_mul(3) ^ light.to_bits())
    });
    report("row-every-4th", WIDTH / 2, || {
        wall.fill_interpolated::<_, 4>(opaque(&LIGHT), 60, &mut arrived);
        arrived.iter().fold(0, |sum: u32, light| sum.wrapping_mul(3) ^ light.to_bits())
    });
    leds();
}

/// Draws rows of pixels of a picture.
fn rows<P: Pixel + Default>(name: &str, draw: impl Fn(i32, &mut [P; WIDTH])) {
    report(name, WIDTH * ROWS as usize, || {
        let mut pixels = [P::default(); WIDTH];
        (0..ROWS).fold(0, |sum, y| {
            draw(y, &mut pixels);
            folded(sum, &pixels)
        })
    });
}

/// Two frames of a strip of LEDs: the first sets the phases of the dither.
fn leds() {
    let mut lit = [Rgb::default(); LEDS];
    let mut dithers = [Rgb::<TemporalDither<8>>::default(); LEDS];
    let mut bytes = [0; 3 * LEDS];
    report("leds", LEDS, || {
        for (lit, place) in lit.iter_mut().zip(&PLACES) {
            let add = |sum: Rgb<Light16>, light: &QuickSpotLight<Fx16, Soft, NoAttenuation>| {
                let arrived = light.irradiance_facing(*place);
                if arrived == Light16::ZERO { sum } else { sum + Rgb::lit(arrived, light.color()) }
            };
            *lit = clip(opaque(&LAMPS).iter().fold(Rgb::default(), add));
        }
        STRIP.write(&lit, &mut dithers, &mut bytes);
        bytes.iter().fold(0, |sum: u32, byte| sum.wrapping_mul(3) ^ u32::from(*byte))
    });
}

fn folded<P: Pixel>(sum: u32, pixels: &[P]) -> u32 {
    pixels.iter().fold(sum, |sum, pixel| sum.wrapping_mul(3) ^ pixel.to_bits())
}

#[inline(never)]
fn report(name: &str, points: usize, draw: impl FnOnce() -> u32) {
    begin();
    let sum = draw();
    end();
    println!("{name} {sum:08x} bits");
    println!("{name} {points} points");
}
