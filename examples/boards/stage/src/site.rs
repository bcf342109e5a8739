//! The surface point that a pixel shows.

use luminaire::{Fx16, Vec3, number::Length};

/// The material of a surface. Its number is the index of its colours in the tables.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum Material {
    #[default]
    Wall,
    LightTile,
    DarkTile,
    Ball,
    Column,
}

impl Material {
    /// Whether the surface is the wall or the floor.
    #[inline(always)]
    pub(crate) fn is_backdrop(self) -> bool {
        !matches!(self, Self::Ball | Self::Column)
    }
}

/// The surface point that a pixel shows.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Site {
    pub(crate) point: Vec3<Length>,
    pub(crate) normal: Vec3<Fx16>,
    pub(crate) material: Material,
}

pub(super) const UP: Vec3<Fx16> = Vec3::new(Fx16::ZERO, Fx16::ONE, Fx16::ZERO);
