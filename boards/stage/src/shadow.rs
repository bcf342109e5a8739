//! Tests whether an object stands between a point and the light.

use luminaire::Vec3;
use luminaire::number::{Length, Light16};

use super::camera::steps;
use super::measures::LIGHT;
use super::scene::{Material, Site};
use super::{ball, column};

/// Sets the light of sites in shadow to zero.
#[inline(never)]
pub(super) fn cast<const WIDTH: usize>(sites: &[Site; WIDTH], lights: &mut [Light16; WIDTH]) {
    for (column, light) in lights.iter_mut().enumerate() {
        if *light != Light16::ZERO && is_in_shadow(&sites[column]) {
            *light = Light16::ZERO;
        }
    }
}

/// Whether an object stands between a site and the light. An object is not tested for sites on its
/// own surface: where it would shadow itself, its surface faces away from the light.
#[inline(always)]
pub(super) fn is_in_shadow(site: &Site) -> bool {
    let way = Way::to_light(site.point);
    (site.material != Material::Ball && ball::is_between(&way))
        || (site.material != Material::Column && column::is_between(&way))
}

/// The offset from a point to the light, in steps of 2^-12, so that the sum of three squares fits
/// 32 bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    start: Vec3<i32>,
    /// The offset from the start to the light.
    pub(super) whole: Vec3<i32>,
}

impl Way {
    /// The offset from a point to the light.
    #[inline(always)]
    pub(super) fn to_light(point: Vec3<Length>) -> Self {
        const END: Vec3<i32> = Vec3::new(steps(LIGHT[0]), steps(LIGHT[1]), steps(LIGHT[2]));
        let start = point.map(Length::to_bits);
        Self { start, whole: END.zip(start, |end, start| (end - start) >> 4) }
    }

    /// The offset from its start to a position.
    #[inline(always)]
    pub(super) fn to(&self, place: Vec3<i32>) -> Vec3<i32> {
        place.zip(self.start, |place, start| (place - start) >> 4)
    }
}

/// How a line to the light passes through a round object, as inner products in steps of 2^-9, so
/// that their products fit 32 bits. This precision moves the outline of a shadow by some
/// millimetres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage {
    /// The inner product of the whole offset with itself: its squared length.
    pub(super) squared: i32,
    /// The inner product of the whole offset with the offset to the object's centre. The line is
    /// nearest to the centre at the fraction `nearest / squared` of its length.
    pub(super) nearest: i32,
    /// The line enters the object at the fraction `(nearest - sqrt(within)) / squared` of its
    /// length.
    pub(super) within: u32,
}

impl Passage {
    /// The passage of a line that starts outside the object, or `None` if it misses the object.
    /// `middle` is the offset from the line's start to the object's centre.
    #[inline(always)]
    pub(super) fn of(way: Vec3<i32>, middle: Vec3<i32>, radius: i32) -> Option<Self> {
        let nearest = dot(way, middle);
        let gap = dot(middle, middle) - radius * radius;
        if nearest <= 0 || gap <= 0 {
            return None;
        }
        let [squared, nearest, gap] = [dot(way, way), nearest, gap].map(|square| square >> 15);
        let within = u32::try_from(nearest * nearest - squared * gap).ok().filter(|within| *within > 0)?;
        Some(Self { squared, nearest, within })
    }
}

/// The inner product of two offsets, in steps of 2^-24.
#[inline(always)]
fn dot(a: Vec3<i32>, b: Vec3<i32>) -> i32 {
    a.x * b.x + a.y * b.y + a.z * b.z
}
