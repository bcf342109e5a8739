//! The geometry of a picture, ready to be lit: position, normal and material of each pixel.

use crate::{bounds::Bounds, memory::filled, raster::Fragments, view::View};
use alloc::{collections::TryReserveError, vec::Vec};
use luminaire::{Offset, Ray, Scalar, Vec3};

/// How many pixels of a row make a block.
pub(crate) const LANES: usize = 32;

/// Some neighbouring pixels of a row, each quantity in an array of its own, as vector instructions want it.
#[derive(Clone, Copy, Debug)]
pub struct Block<S: Scalar> {
    pub(crate) point: Vec3<[S::Length; LANES]>,
    /// Of unit length; zero where nothing was drawn, so that no light arrives there.
    pub(crate) normal: Vec3<[S; LANES]>,
    /// The number of the material; 0 where nothing was drawn.
    pub(crate) material: [u32; LANES],
    /// What encloses the points; nothing if nothing was drawn.
    pub(crate) bounds: Option<Bounds>,
}

impl<S: Scalar> Block<S> {
    /// The number of the material, if all pixels have the same.
    #[inline(always)]
    pub(crate) fn only_material(&self) -> Option<u32> {
        let first = self.material[0];
        // Without a way out of the loop, as vector instructions want it.
        let is_only = self.material.iter().fold(true, |is_only, &number| is_only & (number == first));
        is_only.then_some(first)
    }

    /// The point of a pixel.
    #[inline(always)]
    pub(crate) fn point_at(&self, lane: usize) -> Vec3<S::Length> {
        Vec3::new(self.point.x[lane], self.point.y[lane], self.point.z[lane])
    }

    /// The normal of a pixel.
    #[inline(always)]
    pub(crate) fn normal_at(&self, lane: usize) -> Vec3<S> {
        Vec3::new(self.normal.x[lane], self.normal.y[lane], self.normal.z[lane])
    }
}

/// The blocks of a picture, row by row.
#[derive(Clone, Debug)]
pub(crate) struct GBuffer<S: Scalar> {
    pub(crate) blocks: Vec<Block<S>>,
    /// Blocks of a row.
    pub(crate) columns: usize,
}

impl<S: Scalar> GBuffer<S> {
    pub(crate) fn new(width: usize, height: usize) -> Result<Self, TryReserveError> {
        let columns = width.div_ceil(LANES);
        let empty = Block {
            point: Vec3::default().map(|()| [S::Length::default(); LANES]),
            normal: Vec3::default().map(|()| [S::ZERO; LANES]),
            material: [0; LANES],
            bounds: None,
        };
        Ok(Self { blocks: filled(columns * height, empty)?, columns })
    }

    /// Finds position and unit normal of each fragment.
    pub(crate) fn resolve(&mut self, fragments: &Fragments, view: &View) {
        let nearness = fragments.nearness.as_chunks::<LANES>().0.iter();
        let [nx, ny, nz] = fragments.normal.each_ref().map(|plane| plane.as_chunks::<LANES>().0.iter());
        let material = fragments.material.as_chunks::<LANES>().0.iter();
        let lanes = nearness.zip(nx.zip(ny).zip(nz)).zip(material);
        for (number, (block, ((nearness, ((nx, ny), nz)), material))) in
            self.blocks.iter_mut().zip(lanes).enumerate()
        {
            let (row, column) = (number / self.columns, number % self.columns);
            let (first, step) = view.ray(row);
            let first = first + step * (column * LANES) as f32;
            let points = locate(nearness, view.eye(), first, step);
            let normals = unit(nearness, [nx, ny, nz]);
            block.point = points.map(|plane| plane.map(S::length));
            block.normal = normals.map(|plane| plane.map(S::from_f32));
            block.material = *material;
            let last = first + step * (LANES - 1) as f32;
            block.bounds = depths(nearness).map(|(near, far)| {
                // The rays of a row lie in a plane, so that the points are within the corners of a trapezium.
                let corners = [first * near, first * far, last * near, last * far];
                Bounds::around(corners.map(|corner| view.eye() + corner))
            });
        }
    }
}

/// The least and the largest depth of the fragments, if there are any.
fn depths(nearness: &[f32; LANES]) -> Option<(f32, f32)> {
    let mut nearest = *nearness;
    let mut farthest = nearness.map(|nearness| if nearness > 0.0 { nearness } else { f32::INFINITY });
    // One half of the lanes against the other, as vector instructions want it.
    let mut half = LANES / 2;
    while half > 0 {
        for lane in 0..half {
            let (near, far) = (nearest[lane + half], farthest[lane + half]);
            nearest[lane] = if near > nearest[lane] { near } else { nearest[lane] };
            farthest[lane] = if far < farthest[lane] { far } else { farthest[lane] };
        }
        half /= 2;
    }
    (nearest[0] > 0.0).then(|| (1.0 / nearest[0], 1.0 / farthest[0]))
}

/// Where along their rays the fragments are; at the eye where there are none.
fn locate(
    nearness: &[f32; LANES],
    eye: glam::Vec3,
    first: glam::Vec3,
    step: glam::Vec3,
) -> Vec3<[f32; LANES]> {
    let mut points = Vec3::default().map(|()| [0.0; LANES]);
    let depths = nearness.map(|nearness| if nearness > 0.0 { 1.0 / nearness } else { 0.0 });
    for (lane, depth) in depths.into_iter().enumerate() {
        let point = eye + (first + step * lane as f32) * depth;
        points.x[lane] = point.x;
        points.y[lane] = point.y;
        points.z[lane] = point.z;
    }
    points
}

/// The normals of the fragments at unit length; zero where there are none.
fn unit(nearness: &[f32; LANES], [x, y, z]: [&[f32; LANES]; 3]) -> Vec3<[f32; LANES]> {
    let mut normals = Vec3::default().map(|()| [0.0; LANES]);
    for lane in 0..LANES {
        // The kernel's direction from the origin to a point: the one square root there is.
        let direction = f32::offset(Vec3::default(), Vec3::new(x[lane], y[lane], z[lane])).ray().direction();
        let is_covered = nearness[lane] > 0.0;
        normals.x[lane] = if is_covered { direction.x } else { 0.0 };
        normals.y[lane] = if is_covered { direction.y } else { 0.0 };
        normals.z[lane] = if is_covered { direction.z } else { 0.0 };
    }
    normals
}
