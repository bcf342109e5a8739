//! Block of pixels: the unit of lighting.

use crate::{
    buffer::LANES,
    light::{part::Part, reach::Reach},
};
use luminaire::{Scalar, Vec3};

/// Neighbouring pixels of a row, each quantity in its own array for vector instructions.
#[derive(Clone, Copy, Debug)]
pub struct Block<S: Scalar> {
    pub(crate) point: Vec3<[S::Length; LANES]>,
    /// Unit normals; zero where nothing was drawn, so that no light arrives there.
    pub(crate) normal: Vec3<[S; LANES]>,
    /// The numbers of the materials; 0 where nothing was drawn.
    pub(crate) material: [u32; LANES],
    /// Whether all pixels have the same material.
    pub(crate) is_uniform: bool,
    /// Bounds of the surface at the pixels that have the first pixel's material, and at all other
    /// pixels. At the outline of an object, the two parts separate the near surface from the far
    /// surface.
    pub(crate) parts: [Option<Part>; 2],
}

impl<S: Scalar> Block<S> {
    /// A block in which nothing was drawn.
    pub(crate) fn empty() -> Self {
        Self {
            point: Vec3::default().map(|()| [S::Length::default(); LANES]),
            normal: Vec3::default().map(|()| [S::ZERO; LANES]),
            material: [0; LANES],
            is_uniform: true,
            parts: [None; 2],
        }
    }

    /// Returns the number of the material if all pixels have the same material.
    #[inline(always)]
    pub(crate) fn only_material(&self) -> Option<u32> {
        self.is_uniform.then_some(self.material[0])
    }

    /// Returns bounds of the surface at all pixels of a material. The bounds may also enclose
    /// pixels of other materials.
    pub(crate) fn part(&self, number: u32) -> Option<Part> {
        self.parts[usize::from(number != self.material[0])]
    }

    /// Returns true only if no light arrives at any pixel, in every number format.
    pub(crate) fn is_missed(&self, reach: &Reach) -> bool {
        self.parts
            .iter()
            .flatten()
            .all(|part| reach.is_behind(&part.bounds, &part.normals) || reach.misses(&part.bounds))
    }

    /// The surface point at a pixel.
    #[inline(always)]
    pub(crate) fn point_at(&self, lane: usize) -> Vec3<S::Length> {
        Vec3::new(self.point.x[lane], self.point.y[lane], self.point.z[lane])
    }

    /// The surface normal at a pixel.
    #[inline(always)]
    pub(crate) fn normal_at(&self, lane: usize) -> Vec3<S> {
        Vec3::new(self.normal.x[lane], self.normal.y[lane], self.normal.z[lane])
    }
}
