//! Counts the pixels that the light reaches, and the others by the reason.

use core::slice;

use luminaire::{
    Fx16, Scalar, Vec3,
    number::{Light16, Offset, Types},
};

use super::camera::steps;
use super::measures::LIGHT;
use super::paint::{self, Key};
use super::site::Site;

/// Numbers of pixels by the first condition that keeps the light from them, in the order in which
/// the conditions are tested. `lit` counts the pixels that the light reaches.
#[derive(Clone, Copy, Default, Debug)]
pub struct Tally {
    facing_away: u32,
    outside: u32,
    in_shadow: u32,
    lit: u32,
}

impl Tally {
    /// The number of pixels that face away, that are outside the cone, in shadow, and lit.
    pub fn counts(&self) -> [u32; 4] {
        [self.facing_away, self.outside, self.in_shadow, self.lit]
    }

    /// Adds the pixels of a row, with the light that arrives there.
    pub(super) fn add(&mut self, key: &Key, sites: &[Site], lights: &[Light16]) {
        const PLACE: Vec3<i32> = Vec3::new(steps(LIGHT[0]), steps(LIGHT[1]), steps(LIGHT[2]));
        let place = PLACE.map(<Fx16 as Scalar>::Length::from_bits);
        for (site, light) in sites.iter().zip(lights) {
            let facing = <Fx16 as Types>::Offset::between(place, site.point).facing(site.normal);
            let group = if <Fx16 as Types>::Offset::faces_away(facing) {
                &mut self.facing_away
            } else if !is_reached(key, site) {
                &mut self.outside
            } else if *light == Light16::ZERO {
                &mut self.in_shadow
            } else {
                &mut self.lit
            };
            *group += 1;
        }
    }
}

/// Whether the light of the spotlight arrives, if nothing is in the way.
fn is_reached(key: &Key, site: &Site) -> bool {
    let mut light = [Light16::MAX];
    paint::objects(key, slice::from_ref(site), &mut light);
    light != [Light16::ZERO]
}
