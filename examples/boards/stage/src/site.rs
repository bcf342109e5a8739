//! The surface point that a pixel shows.

use luminaire::{Fx16, Vec3, number::Length};

/// The material of a surface. Its number is the index of its colours in the tables.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Material {
    Wall,
    LightTile,
    DarkTile,
    Ball,
    Column,
}

/// The surface point that a pixel shows.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Site {
    pub(crate) point: Vec3<Length>,
    pub(crate) normal: Vec3<Fx16>,
}

pub(super) const UP: Vec3<Fx16> = Vec3::new(Fx16::ZERO, Fx16::ONE, Fx16::ZERO);
