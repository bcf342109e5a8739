//! G-buffer: position, normal and material of each pixel.

use crate::{
    buffer::{LANES, filled},
    light::{
        block::Block,
        part::{Fan, Part},
    },
    raster::{Fragments, view::View},
    space::bounds::Bounds,
};
use alloc::{collections::TryReserveError, vec::Vec};
use luminaire::{Scalar, Vec3};

/// The blocks of a picture, row by row.
#[derive(Clone, Debug)]
pub(crate) struct GBuffer<S: Scalar> {
    pub(crate) blocks: Vec<Block<S>>,
    /// The bounding sphere of each block's points; `None` if nothing was drawn. They are apart from
    /// the blocks, because all of them are read together.
    pub(crate) bounds: Vec<Option<Bounds>>,
    /// Blocks per row.
    pub(crate) columns: usize,
}

impl<S: Scalar> GBuffer<S> {
    pub(crate) fn new(width: usize, height: usize) -> Result<Self, TryReserveError> {
        let columns = width.div_ceil(LANES);
        let count = columns * height;
        Ok(Self { blocks: filled(count, Block::empty())?, bounds: filled(count, None)?, columns })
    }

    /// Computes the position and the unit normal of each fragment.
    pub(crate) fn resolve(&mut self, fragments: &Fragments, view: &View) {
        let nearness = blocks(&fragments.nearness);
        let [nx, ny, nz] = fragments.normal.each_ref().map(|plane| blocks(plane));
        let material = blocks(&fragments.material);
        let lanes = nearness.zip(nx.zip(ny).zip(nz)).zip(material);
        let blocks = self.blocks.iter_mut().zip(&mut self.bounds);
        for (number, ((block, bounds), ((nearness, ((nx, ny), nz)), material))) in
            blocks.zip(lanes).enumerate()
        {
            let (row, column) = (number / self.columns, number % self.columns);
            let (first, step) = view.ray(row);
            let first = first + step * (column * LANES) as f32;
            let points = locate(nearness, view.eye(), first, step);
            let normals = unit(nearness, [nx, ny, nz]);
            block.point = points.map(|plane| plane.map(S::length));
            block.normal = normals.map(|plane| plane.map(S::from_f32));
            block.material = *material;
            // The fold has no early exit, so that compilers vectorise it.
            block.is_uniform =
                material.iter().fold(true, |is_uniform, number| is_uniform & (number == &material[0]));
            let last = first + step * (LANES - 1) as f32;
            let fan = Fan { eye: view.eye(), edges: [first, last] };
            let whole = Part::new(&fan, nearness, &normals);
            *bounds = whole.map(|part| part.bounds);
            block.parts = if block.is_uniform {
                [whole, None]
            } else {
                [true, false].map(|is_first| {
                    let is_in = |lane: usize| (material[lane] == material[0]) == is_first;
                    let nearness =
                        core::array::from_fn(|lane| if is_in(lane) { nearness[lane] } else { 0.0 });
                    Part::new(&fan, &nearness, &normals)
                })
            };
        }
    }
}

/// Returns the positions of the fragments; the eye's position where nothing was drawn.
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

/// Returns the unit normals of the fragments; zero where nothing was drawn.
fn unit(nearness: &[f32; LANES], [x, y, z]: [&[f32; LANES]; 3]) -> Vec3<[f32; LANES]> {
    let mut normals = Vec3::default().map(|()| [0.0; LANES]);
    for lane in 0..LANES {
        // The kernel's `Vec3::unit` contains the only square root in this function.
        let direction = Vec3::new(x[lane], y[lane], z[lane]).unit();
        let is_covered = nearness[lane] > 0.0;
        normals.x[lane] = if is_covered { direction.x } else { 0.0 };
        normals.y[lane] = if is_covered { direction.y } else { 0.0 };
        normals.z[lane] = if is_covered { direction.z } else { 0.0 };
    }
    normals
}

/// Iterates over the whole blocks of a plane of fragments.
fn blocks<T>(plane: &[T]) -> impl Iterator<Item = &[T; LANES]> {
    plane.chunks_exact(LANES).filter_map(<[T]>::first_chunk)
}
