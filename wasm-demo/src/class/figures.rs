//! The figures, in the order of the class.

mod angles;
mod cones;
mod distance;
mod highlight;
mod kinds;
mod numbers;

#[cfg(test)]
pub(crate) use numbers::code;

// What the figures are built of; each has these names from here.
use super::{
    figure::{Drawing, Figure, Graph, Parameter::*, Values, tidy},
    lit::{AXIS, Beam, beams, picture, sampled, single},
};
use crate::{quantity::*, refusal::Refusal};
use luminaire::{Angle, Cone, HalfAngle, PointLight, Rgb, SpotLight, falloff::Falloff};
use luminaire_oracle::DVec3;

pub(crate) static ALL: [Figure; 13] = [
    kinds::FIGURE,
    distance::ATTENUATION,
    distance::SPHERE,
    cones::POWER,
    cones::CONES,
    cones::DIRECT3D,
    angles::EDGES,
    angles::BEAM_FIELD,
    angles::BOTH,
    highlight::FIGURE,
    numbers::BITS_FIGURE,
    numbers::VERSINE,
    numbers::BANDS,
];
