//! What a pixel sees: the nearest of wall, floor, ball and column.

use luminaire::{Fx16, Vec3, source::I16F16};

use super::camera::{DEPTH_BITS, Sight, steps};
use super::column::Meeting;
use super::measures::{COLUMN_HEIGHT, EYE, WALL};
use super::{WIDTH, ball, column};

/// What something is made of, which is also where its colours stand in the tables.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum Material {
    #[default]
    Wall,
    LightTile,
    DarkTile,
    Ball,
    Column,
}

/// What a pixel sees.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Site {
    pub(crate) point: Vec3<I16F16>,
    pub(crate) normal: Vec3<Fx16>,
    pub(crate) material: Material,
}

const UP: Vec3<Fx16> = Vec3::new(Fx16::ZERO, Fx16::ONE, Fx16::ZERO);
const TO_THE_FRONT: Vec3<Fx16> = Vec3::new(Fx16::ZERO, Fx16::ZERO, Fx16::ONE);

/// What the pixels of a row see.
#[inline(never)]
pub(crate) fn look(row: usize, sites: &mut [Site; WIDTH]) {
    let first = Sight::through(0, row);
    let backdrop = Backdrop::of(first);
    let (ball_is_near, column_is_near) = (ball::WINDOW.has_row(first), column::WINDOW.has_row(first));
    for (column, site) in sites.iter_mut().enumerate() {
        let sight = Sight::through(column, row);
        *site = backdrop.site(sight);
        if column_is_near && column::WINDOW.has_column(sight) {
            match column::meet(sight) {
                Some(Meeting::Side(depth)) => {
                    let point = sight.point(depth);
                    *site = Site { point, normal: column::normal(point), material: Material::Column };
                }
                Some(Meeting::Top(depth)) => {
                    let mut point = sight.point(depth);
                    point.y = I16F16::from_bits(steps(COLUMN_HEIGHT));
                    *site = Site { point, normal: UP, material: Material::Column };
                }
                None => {}
            }
        }
        // The ball stands before everything.
        if ball_is_near
            && ball::WINDOW.has_column(sight)
            && let Some(depth) = ball::depth(sight)
        {
            let point = sight.point(depth);
            *site = Site { point, normal: ball::normal(point), material: Material::Ball };
        }
    }
}

/// What a row sees where nothing stands: floor and wall are at one depth all along it.
#[derive(Clone, Copy, Debug)]
struct Backdrop {
    depth: i32,
    is_floor: bool,
}

impl Backdrop {
    fn of(sight: Sight) -> Self {
        const TO_THE_WALL: i32 = steps(EYE[2] - WALL) >> (16 - DEPTH_BITS);
        let is_floor = sight.height(TO_THE_WALL) < 0;
        let to_the_floor = (steps(EYE[1]) << DEPTH_BITS).checked_div(-sight.up).unwrap_or(TO_THE_WALL);
        Self { depth: if is_floor { to_the_floor } else { TO_THE_WALL }, is_floor }
    }

    #[inline(always)]
    fn site(self, sight: Sight) -> Site {
        let mut point = sight.point(self.depth);
        if !self.is_floor {
            return Site { point, normal: TO_THE_FRONT, material: Material::Wall };
        }
        point.y = I16F16::ZERO;
        // Tiles of half a metre.
        let is_dark = (point.x.to_bits() ^ point.z.to_bits()) >> 15 & 1 == 1;
        let material = if is_dark { Material::DarkTile } else { Material::LightTile };
        Site { point, normal: UP, material }
    }
}
