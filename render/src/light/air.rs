//! In-scattering between the eye and the surfaces: the visible beams in haze.

mod beam;
mod cell;
mod ends;
mod hazy;
mod rays;
mod shafts;
mod sums;
mod tile;

pub(crate) use self::{
    hazy::{Hazy, Way},
    rays::bundle,
    shafts::Shafts,
    tile::TileAir,
};
