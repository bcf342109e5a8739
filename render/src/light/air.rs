//! In-scattering between the eye and the surfaces: the visible beams in haze.

mod beam;
mod frame;
mod hazy;
mod open;
mod rays;
mod shafts;
mod tile;

#[cfg(test)]
pub(crate) use self::beam::Seen;
pub(crate) use self::{
    beam::Beam,
    hazy::{Hazy, Way},
    rays::bundle,
    tile::TileAir,
};
