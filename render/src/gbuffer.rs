//! The geometry of a picture, ready to be lit: position, normal and material of each pixel.

use crate::{bounds::Bounds, memory::filled, raster::Fragments, view::View};
use alloc::{collections::TryReserveError, vec::Vec};
use luminaire::{Offset, Ray, Scalar, Vec3};

/// How many pixels of a row make a block.
pub(crate) const LANES: usize = 32;

/// Some neighbouring pixels of a row, each quantity in an array of its own, as vector instructions want it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block<S: Scalar> {
    pub(crate) point: Vec3<[S::Length; LANES]>,
    /// Of unit length; zero where nothing was drawn, so that no light arrives there.
    pub(crate) normal: Vec3<[S; LANES]>,
    /// Zero where nothing was drawn, else one more than the number of the object.
    pub(crate) material: [u32; LANES],
    /// What encloses the points; nothing if nothing was drawn.
    pub(crate) bounds: Option<Bounds>,
}

/// The blocks of a picture, row by row.
#[derive(Clone, Debug)]
pub(crate) struct GBuffer<S: Scalar> {
    pub(crate) blocks: Vec<Block<S>>,
    columns: usize,
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
        let [nx, ny, nz] = &fragments.normal;
        let lanes = fragments
            .nearness
            .chunks_exact(LANES)
            .zip(fragments.material.chunks_exact(LANES))
            .zip(nx.chunks_exact(LANES).zip(ny.chunks_exact(LANES)).zip(nz.chunks_exact(LANES)));
        for (number, (block, ((nearness, material), ((nx, ny), nz)))) in
            self.blocks.iter_mut().zip(lanes).enumerate()
        {
            let (row, column) = (number / self.columns, number % self.columns);
            let (first, step) = view.ray(row);
            let first = first + step * (column * LANES) as f32;
            let mut points = [[0.0; LANES]; 3];
            for lane in 0..LANES {
                let covered = nearness[lane] > 0.0;
                let depth = if covered { 1.0 / nearness[lane] } else { 0.0 };
                let point = view.eye() + (first + step * lane as f32) * depth;
                let normal = if covered { Vec3::new(nx[lane], ny[lane], nz[lane]) } else { Vec3::default() };
                let normal = f32::offset(Vec3::default(), normal).ray().direction();
                [points[0][lane], points[1][lane], points[2][lane]] = point.to_array();
                block.point.x[lane] = S::length(point.x);
                block.point.y[lane] = S::length(point.y);
                block.point.z[lane] = S::length(point.z);
                block.normal.x[lane] = S::from_f32(normal.x);
                block.normal.y[lane] = S::from_f32(normal.y);
                block.normal.z[lane] = S::from_f32(normal.z);
                block.material[lane] = if covered { material[lane] + 1 } else { 0 };
            }
            block.bounds = Bounds::around(&points, nearness);
        }
    }
}
