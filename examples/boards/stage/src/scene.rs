//! Finds the visible point of each pixel: the nearest of wall, floor, ball and column.

use luminaire::{Fx16, Vec3, number::Length};

use super::ball::{self, Lines};
use super::camera::{DEPTH_BITS, Sight, steps};
use super::column::Side;
use super::measures::{EYE, WALL};
use super::site::{Material, Site, UP};

const TO_THE_FRONT: Vec3<Fx16> = Vec3::new(Fx16::ZERO, Fx16::ZERO, Fx16::ONE);

/// Finds the surface points that the pixels of a row show.
#[inline(never)]
pub(crate) fn look<const WIDTH: usize>(side: &Side, row: i32, sites: &mut [Site; WIDTH]) {
    paint_backdrop(row, sites);
    side.draw(row, sites);
    // Nothing is in front of the ball, so it is drawn last.
    let window = const { ball::window::<WIDTH>() };
    if !window.has(row) {
        return;
    }
    let mut lines = Lines::new::<WIDTH>(window.columns().start, row);
    for (column, site) in window.of(row, sites) {
        if let Some(depth) = lines.next_depth() {
            let point = Sight::<WIDTH>::through(column, row).point(depth);
            *site = Site { point, normal: ball::normal(point), material: Material::Ball };
        }
    }
}

/// Draws wall or floor. All points of a row have the same depth.
fn paint_backdrop<const WIDTH: usize>(row: i32, sites: &mut [Site; WIDTH]) {
    const TO_THE_WALL: i32 = steps(EYE[2] - WALL) >> (16 - DEPTH_BITS);
    let first = Sight::<WIDTH>::through(0, row);
    let to_the_floor = (steps(EYE[1]) << DEPTH_BITS).checked_div(-first.up).unwrap_or(TO_THE_WALL);
    let is_floor = first.height(TO_THE_WALL) < 0;
    let depth = if is_floor { to_the_floor } else { TO_THE_WALL };
    let Vec3 { y, z, .. } = first.point(depth);
    let row = Sight::<WIDTH>::row_at(depth).zip(sites);
    if !is_floor {
        for (x, site) in row {
            let point = Vec3::new(x, y, z);
            *site = Site { point, normal: TO_THE_FRONT, material: Material::Wall };
        }
        return;
    }
    for (x, site) in row {
        // Tiles of half a metre.
        let is_dark = (x.to_bits() ^ z.to_bits()) >> 15 & 1 == 1;
        let material = if is_dark { Material::DarkTile } else { Material::LightTile };
        *site = Site { point: Vec3::new(x, Length::ZERO, z), normal: UP, material };
    }
}
