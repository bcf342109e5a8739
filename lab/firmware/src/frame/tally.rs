//! Counts the pixels that the light reaches, and the others by the reason.

use core::fmt;

use luminaire::{
    Fx16, Scalar, Vec3,
    number::{Arithmetic, Light16, Offset},
};

use super::camera::steps;
use super::measures::LIGHT;
use super::paint::KEY;
use super::scene::Site;
use super::shadow::is_in_shadow;

/// Numbers of pixels by the first condition that keeps the light from them, in the order in which
/// the conditions are tested. `lit` counts the pixels that the light reaches.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Tally {
    facing_away: u32,
    outside: u32,
    in_shadow: u32,
    lit: u32,
}

impl Tally {
    /// Adds the pixels of a row.
    pub(super) fn add(&mut self, sites: &[Site]) {
        const PLACE: Vec3<i32> = Vec3::new(steps(LIGHT[0]), steps(LIGHT[1]), steps(LIGHT[2]));
        let light = PLACE.map(<Fx16 as Scalar>::Length::from_bits);
        for site in sites {
            let facing = Fx16::offset(light, site.point).facing(site.normal);
            let group = if <Fx16 as Arithmetic>::Offset::faces_away(facing) {
                &mut self.facing_away
            } else if KEY.irradiance(site.point, site.normal) == Light16::ZERO {
                &mut self.outside
            } else if is_in_shadow(site) {
                &mut self.in_shadow
            } else {
                &mut self.lit
            };
            *group += 1;
        }
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { facing_away, outside, in_shadow, lit } = self;
        write!(out, "{facing_away} facing away, {outside} outside the cone, {in_shadow} in shadow, {lit} lit")
    }
}
