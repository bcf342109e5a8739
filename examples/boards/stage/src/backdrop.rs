//! The wall and the floor, of which each row shows one line.

use core::array;
use core::ops::Range;

use luminaire::{
    Fx16, Vec3,
    light::{AlongX, Row},
    number::{Length, Light16},
};

use super::camera::{DEPTH_BITS, Sight, steps};
use super::measures::{EYE, WALL};
use super::site::{Material, Site, UP};

/// The materials of the floor.
pub(super) const TILES: [Material; 2] = [Material::LightTile, Material::DarkTile];

const TO_THE_FRONT: Vec3<Fx16> = Vec3::new(Fx16::ZERO, Fx16::ZERO, Fx16::ONE);

/// The wall or the floor behind a row of pixels: points of one height and one depth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Backdrop {
    pub(super) y: Length,
    pub(super) z: Length,
    pub(super) is_floor: bool,
    /// The x coordinate in the first column, and from column to column, with `DEPTH_BITS` more fraction bits
    /// than a length.
    first: i32,
    step: i32,
}

impl Backdrop {
    /// The backdrop of a row.
    pub(super) fn of<const WIDTH: usize>(row: i32) -> Self {
        const TO_THE_WALL: i32 = steps(EYE[2] - WALL) >> (16 - DEPTH_BITS);
        let sight = Sight::<WIDTH>::through(0, row);
        let to_the_floor = (steps(EYE[1]) << DEPTH_BITS).checked_div(-sight.up).unwrap_or(TO_THE_WALL);
        let is_floor = sight.height(TO_THE_WALL) < 0;
        let depth = if is_floor { to_the_floor } else { TO_THE_WALL };
        let Vec3 { y, z, .. } = sight.point(depth);
        let [first, step] = Sight::<WIDTH>::row_at(depth);
        Self { y: if is_floor { Length::ZERO } else { y }, z, is_floor, first, step }
    }

    /// The x coordinate in a column, with `DEPTH_BITS` more fraction bits than a length.
    #[inline(always)]
    fn place(&self, column: usize) -> i32 {
        self.first.wrapping_add(self.step.wrapping_mul(column as i32))
    }

    #[inline(always)]
    pub(super) fn x(&self, column: usize) -> Length {
        Length::from_bits(steps(EYE[0]) + (self.place(column) >> DEPTH_BITS))
    }

    #[inline(always)]
    pub(super) fn point(&self, column: usize) -> Vec3<Length> {
        Vec3::new(self.x(column), self.y, self.z)
    }

    /// Which of the [`TILES`] a column of the floor shows. They are half a metre wide.
    #[inline(always)]
    pub(super) fn tile(&self, column: usize) -> usize {
        const { assert!(steps(EYE[0]) == 0) };
        let across = self.place(column) >> (DEPTH_BITS + 15);
        ((across ^ self.z.to_bits() >> 15) & 1) as usize
    }

    /// The points of a row, with their normal.
    #[inline(always)]
    pub(super) fn points(&self) -> Row<Fx16, AlongX<Length, impl Fn(usize) -> Length>> {
        Row::along_x(self.normal(), [self.y, self.z], |column| self.x(column))
    }

    fn normal(&self) -> Vec3<Fx16> {
        if self.is_floor { UP } else { TO_THE_FRONT }
    }

    /// What a column shows, if nothing is in front of it.
    fn site(&self, column: usize) -> Site {
        Site { point: self.point(column), normal: self.normal() }
    }

    /// The materials of the tiles of a row; those of the wall are the same.
    pub(super) fn materials(&self) -> [Material; 2] {
        if self.is_floor { TILES } else { [Material::Wall; 2] }
    }
}

/// The materials of the objects of [`Seen`].
pub(super) const OBJECTS: [Material; 2] = [Material::Column, Material::Ball];

/// What the pixels of a row see: the backdrop, and columns that show an object.
#[derive(Clone, Debug)]
pub(super) struct Seen {
    pub(super) backdrop: Backdrop,
    /// The columns of the column and of the ball.
    pub(super) objects: [Range<usize>; 2],
    /// The columns of the backdrop in the shadow of each object.
    pub(super) shadows: [Range<usize>; 2],
    /// The columns outside which the light does not reach the backdrop.
    pub(super) reach: Range<usize>,
}

impl Seen {
    /// What the pixels see before the first row.
    pub(super) fn new<const WIDTH: usize>() -> Self {
        let nothing = || [0..0, 0..0];
        Self { backdrop: Backdrop::of::<WIDTH>(0), objects: nothing(), shadows: nothing(), reach: 0..0 }
    }

    /// The columns that show the backdrop, up to a width.
    pub(super) fn gaps(&self, width: usize) -> [Range<usize>; 3] {
        outside(0..width, &self.objects)
    }

    /// The columns of a gap that the light may reach.
    pub(super) fn lit(&self, gap: &Range<usize>) -> [Range<usize>; 3] {
        let [start, end] = [self.reach.start, self.reach.end].map(|at| at.clamp(gap.start, gap.end));
        outside(start..end, &self.shadows)
    }

    /// The object that a column shows: of two, the one that is drawn last.
    fn object(&self, column: usize) -> Option<usize> {
        self.objects.iter().rposition(|object| object.contains(&column))
    }

    /// The material that a column shows.
    #[cfg(test)]
    pub(super) fn material(&self, column: usize) -> Material {
        let backdrop = || self.backdrop.materials()[self.backdrop.tile(column)];
        self.object(column).map_or_else(backdrop, |object| OBJECTS[object])
    }

    /// What all pixels see, of which `sites` has those of objects.
    pub(super) fn sites<const WIDTH: usize>(&self, sites: &[Site; WIDTH]) -> [Site; WIDTH] {
        array::from_fn(|i| if self.object(i).is_some() { sites[i] } else { self.backdrop.site(i) })
    }

    /// The light of all pixels, of which `lights` has those that the light may reach.
    pub(super) fn lights<const WIDTH: usize>(&self, lights: &[Light16; WIDTH]) -> [Light16; WIDTH] {
        let gaps = self.gaps(WIDTH);
        let is_lit = |i| gaps.iter().flat_map(|gap| self.lit(gap)).any(|lit| lit.contains(&i));
        array::from_fn(|i| if self.object(i).is_some() || is_lit(i) { lights[i] } else { Light16::ZERO })
    }
}

/// The parts of a range before, between and behind two others.
fn outside(whole: Range<usize>, holes: &[Range<usize>; 2]) -> [Range<usize>; 3] {
    let [a, b] = [0, 1].map(|i| match &holes[i] {
        hole if hole.is_empty() => whole.end..whole.end,
        hole => hole.start.clamp(whole.start, whole.end)..hole.end.clamp(whole.start, whole.end),
    });
    let [first, last] = if a.start <= b.start { [a, b] } else { [b, a] };
    let between = first.end.min(last.start)..last.start;
    [whole.start..first.start, between, first.end.max(last.end)..whole.end]
}
