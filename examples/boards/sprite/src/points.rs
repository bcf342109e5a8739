//! Light point by point.

use luminaire::{Fx16, Length, Vec3, number::Light16};

use crate::{
    measures::{SIDE, STEPS},
    scene::{Lights, place},
    sprite::Sprite,
};

/// Draws the sprite: each opaque pixel by the kernel's irradiance of each light at its point. Transparent pixels keep
/// their values.
#[inline(never)]
pub fn draw(sprite: &Sprite<'_>, lights: &Lights, pixels: &mut [u16; SIDE * SIDE]) {
    let mut words = sprite.words.iter();
    for span in sprite.spans {
        let (y, start, end) = (i32::from(span.y), usize::from(span.start), usize::from(span.end));
        let row = pixels.get_mut(SIDE * y as usize..).unwrap_or_default();
        let to = row.get_mut(start..end).unwrap_or_default();
        for ((x, to), word) in (start as i32..).zip(to).zip(&mut words) {
            let point = Vec3::new(place(x), place(y), Length::ZERO);
            let normal = Fx16::normal_from_unit_bytes(word.normal());
            *to = sprite.shown.pixel(*word, [0, 1].map(|i| steps(lights.0[i].irradiance(point, normal))));
        }
    }
}

/// Returns light in steps of 1/2,048, at most the last.
#[inline(always)]
fn steps(light: Light16) -> u32 {
    (light.to_bits() >> 3).min(STEPS as u32 - 1)
}
