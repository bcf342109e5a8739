//! Tiles: rectangles of blocks that are re-lit or kept as a whole. Regions: squares of tiles.

use crate::{buffer::filled, space::bounds::Bounds, stripes::Stripes};
use alloc::{collections::TryReserveError, vec::Vec};
use core::ops::Range;
use luminaire::haze::RayBundle;

/// Rows per tile. A tile is one block wide.
const ROWS: usize = Stripes::ROWS;

/// Tiles along a side of a region.
const SIDE: usize = 4;

/// The tiles of a picture, row by row.
#[derive(Clone, Debug)]
pub(crate) struct Tiles {
    columns: usize,
    rows: usize,
    pub(crate) tiles: Vec<Tile>,
    /// Bounding sphere of the surface points of each region; `None` if nothing was drawn in the
    /// region. If a light misses a region, the tiles of the region are not tested.
    pub(crate) regions: Vec<Option<Bounds>>,
}

/// A rectangle of blocks.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Tile {
    /// Bounding sphere of the tile's surface points; `None` if nothing was drawn.
    pub(crate) bounds: Option<Bounds>,
    /// The bundle of view rays through the tile's pixels; `None` until the bundle is needed.
    pub(crate) sight: Option<RayBundle>,
    /// Whether the last lighting pass re-lit the tile.
    pub(crate) is_relit: bool,
    /// Time that the last lighting pass took for the tile, if the renderer has a clock; 0 else.
    pub(crate) time: f64,
    /// Whether the encoded pixels are up to date.
    pub(crate) is_encoded: bool,
}

impl Tiles {
    /// Returns the tiles of a picture. `columns` counts blocks and `rows` counts pixels.
    pub(crate) fn new(columns: usize, rows: usize) -> Result<Self, TryReserveError> {
        let lines = rows.div_ceil(ROWS);
        let regions = columns.div_ceil(SIDE) * lines.div_ceil(SIDE);
        Ok(Self {
            columns,
            rows,
            tiles: filled(columns * lines, Tile::default())?,
            regions: filled(regions, None)?,
        })
    }

    /// Returns the index of the region that contains a tile.
    pub(crate) fn region(&self, tile: usize) -> usize {
        let (line, column) = (tile / self.columns, tile % self.columns);
        line / SIDE * self.columns.div_ceil(SIDE) + column / SIDE
    }

    /// Returns the indices of a region's tiles.
    fn of_region(&self, region: usize) -> impl Iterator<Item = usize> + Clone + use<> {
        let (columns, across) = (self.columns, self.columns.div_ceil(SIDE));
        let from = |place: usize, end: usize| place * SIDE..((place + 1) * SIDE).min(end);
        let lines = from(region / across, self.rows.div_ceil(ROWS));
        let row = from(region % across, columns);
        lines.flat_map(move |line| row.clone().map(move |column| line * columns + column))
    }

    /// Returns the indices of a tile's blocks, from top to bottom.
    pub(crate) fn blocks(&self, tile: usize) -> impl Iterator<Item = usize> + Clone + use<> {
        let (columns, (rows, column)) = (self.columns, self.place(tile));
        rows.map(move |row| row * columns + column)
    }

    /// Returns the rows of pixels of a tile, and the column of its blocks.
    pub(crate) fn place(&self, tile: usize) -> (Range<usize>, usize) {
        let first = tile / self.columns * ROWS;
        (first..(first + ROWS).min(self.rows), tile % self.columns)
    }

    /// Returns the index of the tile that contains a block.
    pub(crate) fn of_block(&self, block: usize) -> usize {
        block / self.columns / ROWS * self.columns + block % self.columns
    }

    /// Computes the bounding spheres of all tiles and regions from those of all blocks.
    pub(crate) fn enclose(&mut self, blocks: &[Option<Bounds>]) {
        for number in 0..self.tiles.len() {
            let spheres = self.blocks(number).filter_map(|block| blocks[block]);
            self.tiles[number].bounds = Bounds::enclosing(spheres);
        }
        for number in 0..self.regions.len() {
            let spheres = self.of_region(number).filter_map(|tile| self.tiles[tile].bounds);
            self.regions[number] = Bounds::enclosing(spheres);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The picture's width is not a multiple of a region's width, and the same holds for the
    /// heights.
    #[test]
    fn each_tile_is_in_one_region_and_names_it() {
        let tiles = Tiles::new(9, 5 * ROWS + 1).unwrap();
        assert_eq!((tiles.tiles.len(), tiles.regions.len()), (54, 6));
        let mut regions = [None; 54];
        for region in 0..6 {
            tiles.of_region(region).for_each(|tile| assert_eq!(regions[tile].replace(region), None));
        }
        assert!(regions.into_iter().enumerate().all(|(tile, region)| region == Some(tiles.region(tile))));
        assert_eq!([0, 3, 4, 8, 35, 36, 53].map(|tile| tiles.region(tile)), [0, 0, 1, 2, 2, 3, 5]);
    }
}
