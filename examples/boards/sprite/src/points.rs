//! Light point by point.

use luminaire::{
    Fx16, Length, Vec3,
    light::{CompiledPointLight, Row},
    number::Light16,
};

use crate::{
    measures::{SIDE, STEPS},
    scene::{Lights, place},
    sprite::Sprite,
    word::Word,
};

/// Draws the sprite: each opaque pixel by the kernel's irradiance of each light at its point. Transparent pixels keep
/// their values.
#[inline(never)]
pub fn draw(sprite: &Sprite<'_>, lights: &Lights, pixels: &mut [u16; SIDE * SIDE]) {
    let mut words = sprite.words;
    let [mut first, mut second] = [[Light16::ZERO; SIDE]; 2];
    for span in sprite.spans {
        let (y, start, end) = (usize::from(span.y), usize::from(span.start), usize::from(span.end));
        let (Some((now, rest)), Some(to)) = (
            words.split_at_checked(end.saturating_sub(start)),
            pixels.get_mut(SIDE * y + start..SIDE * y + end),
        ) else {
            break;
        };
        words = rest;
        // The lights one after the other: both at once have more numbers than the processor has registers.
        for (light, arrived) in lights.0.iter().zip([&mut first, &mut second]) {
            fill(light, [start, y], now, arrived);
        }
        for (((to, word), first), second) in to.iter_mut().zip(now).zip(&first).zip(&second) {
            *to = sprite.shown.pixel(*word, [steps(*first), steps(*second)]);
        }
    }
}

/// Sets the irradiances of neighbouring pixels of a row.
#[inline(never)]
fn fill(light: &CompiledPointLight<Fx16>, [x, y]: [usize; 2], words: &[Word], arrived: &mut [Light16; SIDE]) {
    let row = Row::along_x(Vec3::default(), [place(y as i32), Length::ZERO], |i| place((x + i) as i32));
    let arrived = arrived.get_mut(..words.len()).unwrap_or_default();
    row.fill_facing(light, |i| words.get(i).map_or(Vec3::default(), |word| normal(*word)), 0, arrived);
}

/// Returns the normal of a pixel: its bytes in units of 1/127, of length 1 within the converter's choice of bytes.
#[inline(always)]
fn normal(word: Word) -> Vec3<Fx16> {
    Vec3::from(word.normal()).map(|c| Fx16::from_bits(129 * i16::from(c)))
}

/// Returns light in steps of 1/2,048, at most the last.
#[inline(always)]
fn steps(light: Light16) -> u32 {
    (light.to_bits() >> 3).min(STEPS as u32 - 1)
}
