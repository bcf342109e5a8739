//! The two lights and their ways.

use luminaire::{Fx16, Length, Vec3, light::CompiledPointLight};

use crate::measures::{PIXEL_BITS, SIDE};

/// The lights, in the middle of the sprite: [`Lights::at`] moves them.
const LIGHT: CompiledPointLight<Fx16> = include!(concat!(env!("OUT_DIR"), "/light.rs"));

/// A sine in steps of 2^-14, by 256ths of a turn.
static SINE: [i16; 256] = include!(concat!(env!("OUT_DIR"), "/sine.rs"));

/// The two lights of a picture.
#[derive(Clone, Copy, Debug)]
pub struct Lights(pub [CompiledPointLight<Fx16>; 2], pub [Vec3<Length>; 2]);

impl Lights {
    /// Returns the lights at a time, in refreshes of the display: the first is on its way round every 4.3 seconds, the
    /// second, the other way, every 5.7.
    pub fn at(time: u32) -> Self {
        let (first, second) = (time.wrapping_mul(256), time.wrapping_mul(192));
        let positions = [
            Vec3::new(
                wave(first.wrapping_add(0x4000), 290_000),
                wave(first, 230_000),
                height(first.wrapping_mul(2)),
            ),
            Vec3::new(
                wave(0x9000_u32.wrapping_sub(second), 320_000),
                wave(0x5000_u32.wrapping_sub(second), 190_000),
                height(second.wrapping_mul(3)),
            ),
        ];
        Self(positions.map(|position| LIGHT.moved_to(position)), positions)
    }

    /// Returns the pixels at which the lights are, from the upper left corner of the sprite.
    pub fn pixels(&self) -> [[i32; 2]; 2] {
        self.1.map(|Vec3 { x, y, .. }| {
            [x, y].map(|c| (c.to_bits() + PIXEL_BITS * SIDE as i32 / 2) / PIXEL_BITS)
        })
    }
}

/// Returns the place of a column or a row of pixels: the middle of the sprite is the origin.
#[inline(always)]
pub fn place(pixel: i32) -> Length {
    Length::from_bits((2 * pixel - (SIDE as i32 - 1)) * (PIXEL_BITS / 2))
}

/// Returns a sine by 65,536ths of a turn, interpolated linearly, with this amplitude.
fn wave(turn: u32, amplitude: i32) -> Length {
    let sine = |turn: u32| i32::from(SINE[(turn >> 8 & 0xff) as usize]);
    let (from, to) = (sine(turn), sine(turn.wrapping_add(0x100)));
    let between = from + (((to - from) * (turn & 0xff) as i32) >> 8);
    Length::from_bits(((amplitude >> 4) * between) >> 10)
}

/// Returns the distance from the plane of the sprite: 2.75 to 4.25 units.
fn height(turn: u32) -> Length {
    Length::from_bits(229_376 + wave(turn, 49_152).to_bits())
}
