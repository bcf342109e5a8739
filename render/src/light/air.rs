//! In-scattering between the eye and the surfaces: the visible beams in haze.

mod beam;
mod frame;
mod hazy;
mod open;
mod rays;
mod shafts;
mod tile;

use crate::buffer::{LANES, Radiance};
use luminaire::{Rgb, Scalar};

#[cfg(test)]
pub(crate) use self::beam::Seen;
pub(crate) use self::{
    beam::Beam,
    hazy::{Hazy, Way},
    rays::bundle,
    tile::{Scattered, TileAir},
};

/// Adds light from the air in front of the pixels of a block, rounded to the format.
#[inline(always)]
pub(crate) fn add<S: Scalar>(radiance: &mut Radiance<S>, light: &Rgb<[f32; LANES]>) {
    let Rgb { red, green, blue } = radiance;
    for (sums, light) in [(red, &light.red), (green, &light.green), (blue, &light.blue)] {
        for (sum, light) in sums.iter_mut().zip(S::lights_from_f32(light)) {
            *sum += light;
        }
    }
}
