//! A beam as seen from the eye.

use super::{hazy::Hazy, open::Open, shafts::Shafts};
use glam::Vec3;

/// A beam as seen from the eye.
#[derive(Clone, Debug)]
pub(crate) struct Beam {
    /// The normals of the planes through the eye that touch the beam; zero if there are none.
    pub(super) sides: [Vec3; 2],
    pub(crate) seen: Seen,
}

/// How the in-scattering of a beam is computed.
#[derive(Clone, Debug)]
pub(crate) enum Seen {
    /// By a formula.
    Open(Open),
    /// By integrals along lines.
    Shafts(Shafts),
    /// With a ray of the kernel through every pixel.
    Rays,
}

impl Beam {
    /// Prepares a beam; its gobo counts only if the beam `is_patterned`.
    pub(crate) fn new(hazy: &Hazy, eye: Vec3, is_patterned: bool, is_shadowed: bool) -> Self {
        let seen = match (is_patterned, is_shadowed) {
            (false, false) => Open::new(hazy, eye).map(Seen::Open),
            (true, false) => Shafts::new(hazy, eye).map(Seen::Shafts),
            // A shadow depends on the distance from the light.
            (_, true) => None,
        };
        Self { sides: hazy.beam.sides(eye.into()).map(Vec3::from), seen: seen.unwrap_or(Seen::Rays) }
    }
}
