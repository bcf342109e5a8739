//! The air in front of a tile: few rays, interpolated where they suffice.

use super::{
    beam::Beam,
    cell::{COLUMNS, Cell, ROWS},
    ends::{Ends, Nearness, Plane},
    hazy::{BATCH, Hazy, Way},
    rays::{Fan, Light, NO_LIGHT, Queue},
    shafts::{Shafts, WIDTH},
    sums::{Nodes, Sums},
};
use crate::{
    buffer::{LANES, Radiance},
    raster::{Fragments, view::View},
};
use alloc::vec::Vec;
use core::ops::Range;
use luminaire::{Rgb, Scalar, haze::RayBundle};

/// Largest error of all beams together in a channel of a pixel, as tested at the nodes: half a
/// linear code.
const TOLERANCE: f32 = 0.5 / 255.0;

/// Largest accepted sum of the second differences along rows and columns, in tolerances.
///
/// At an edge between nodes, where the light jumps, linear interpolation errs by up to the second
/// difference; in a smooth cell by an eighth of it.
const BEND: f32 = 1.0;

/// Largest accepted error in the middle of the quarters of a cell, in tolerances. It is the check
/// against light whose second difference is small by chance, such as a bend beside an edge.
const OFF: f32 = 0.4;

/// The air in front of a tile.
pub(crate) struct TileAir<'a> {
    fan: Fan,
    /// The size of the part of the tile that is in the picture.
    columns: usize,
    rows: usize,
    nearness: Nearness,
    /// The bounds of all surfaces in the tile.
    ends: Ends,
    queue: Queue,
    sums: Sums,
    /// The light of the tile's rows, whose blocks are `stride` apart.
    radiance: &'a mut [Radiance],
    stride: usize,
    /// Number of evaluated rays.
    rays: usize,
}

/// A cell, and the light of a beam at its nodes.
#[derive(Clone, Copy)]
struct Found {
    cell: Cell,
    ends: Ends,
    /// The mean of the values at both ends.
    nodes: Nodes,
    /// The largest difference of the values at both ends.
    gap: f32,
}

impl<'a> TileAir<'a> {
    /// Returns the air in front of the rows `rows` of a column of blocks, of which `columns` pixels
    /// are in the picture. `radiance` begins with the block of the first row; the blocks of the next
    /// rows are `stride` apart.
    pub(crate) fn new(
        view: &View,
        fragments: &Fragments,
        (rows, column): (Range<usize>, usize),
        columns: usize,
        radiance: &'a mut [Radiance],
        stride: usize,
    ) -> Self {
        let mut nearness = [[0.0; COLUMNS]; ROWS];
        for (to, row) in nearness.iter_mut().zip(rows.clone()) {
            to.copy_from_slice(fragments.block(row, column));
        }
        Self {
            fan: Fan::new(view, rows.start, column * LANES),
            columns,
            rows: rows.len(),
            ends: Ends::of(&nearness, 0..columns, 0..rows.len()),
            nearness,
            queue: Queue::new(),
            sums: Sums::new(),
            radiance,
            stride,
            rays: 0,
        }
    }

    /// Adds the in-scattered light of a beam: by its shafts, if it has them, or else interpolated where
    /// that suffices. `share` is the beam's share of the error.
    pub(crate) fn add<S: Scalar>(
        &mut self,
        hazy: &Hazy,
        way: &Way<'_, S>,
        shafts: Option<&Shafts>,
        share: f32,
    ) {
        let Rgb { red, green, blue } = hazy.color;
        let tolerance = TOLERANCE * share / red.max(green).max(blue);
        let beam = Beam::new(hazy, way, &self.fan, tolerance);
        if let Some(shafts) = shafts {
            self.add_shafts(&beam, shafts);
            return;
        }
        let step = ROWS / 2;
        let cells = [0, COLUMNS / 2].map(|x| Cell { x, y: 0, step });
        self.refine(&beam, &cells, None, self.ends.is_flat.then_some(self.ends.far));
    }

    /// Adds the in-scattered light of a beam by its shafts, with a ray through every pixel.
    fn add_shafts<S: Scalar>(&mut self, beam: &Beam<'_, S>, shafts: &Shafts) {
        let (sheaf, sides) = (shafts.sheaf(&self.fan), beam.sides_of(&self.fan));
        // Pixels whose rays end at the light's body.
        let mut sampled = Vec::new();
        for y in 0..self.rows {
            for x in (0..self.columns).step_by(WIDTH) {
                if sides.is_beside((x, y), WIDTH - 1) {
                    continue;
                }
                let nearness = core::array::from_fn(|i| self.nearness[y][x + i]);
                let run = shafts.light(&sheaf, (x, y), &nearness);
                self.add_run((x, y), &run.light, beam.hazy.color);
                let inside = WIDTH.min(self.columns - x);
                self.rays += inside;
                sampled.extend((0..inside).filter(|&i| run.is_sampled[i]).map(|i| (x + i, y)));
            }
        }
        for pixels in sampled.chunks(BATCH) {
            pixels.iter().for_each(|&(x, y)| self.queue.push((x, y), self.nearness[y][x]));
            let light = self.evaluate(beam);
            self.rays -= pixels.len();
            for (&(x, y), light) in pixels.iter().zip(light) {
                self.add_run((x, y), &[light], beam.hazy.color);
            }
        }
    }

    /// Adds the light of neighbouring pixels in a row.
    #[inline(always)]
    fn add_run<const N: usize>(&mut self, (x, y): (usize, usize), lights: &[f32; N], color: Rgb<f32>) {
        let Rgb { red, green, blue } = &mut self.radiance[y * self.stride];
        for (channel, color) in [(red, color.red), (green, color.green), (blue, color.blue)] {
            for (sum, light) in channel[x..x + N].iter_mut().zip(lights) {
                *sum += light * color;
            }
        }
    }

    /// Adds the in-scattered light of a beam, with a ray through every pixel.
    pub(crate) fn add_each<S: Scalar>(&mut self, hazy: &Hazy, way: &Way<'_, S>) {
        let beam = Beam::new(hazy, way, &self.fan, 0.0);
        for y in (0..self.rows).step_by(4) {
            for x in (0..self.columns).step_by(4) {
                self.evaluate_pixels(&beam, &Cell { x, y, step: 2 });
            }
        }
    }

    /// Adds the interpolated light to the radiance. Returns the number of evaluated rays.
    pub(crate) fn finish(self) -> usize {
        self.sums.spread(self.rows, self.radiance, self.stride);
        self.rays
    }

    /// Adds a beam to two cells side by side, or to the quarters of a cell.
    ///
    /// `known` are the values at the nodes of that cell, and `plane` is the flat surface that all
    /// these cells show.
    fn refine<S: Scalar>(
        &mut self,
        beam: &Beam<'_, S>,
        cells: &[Cell],
        known: Option<&Nodes>,
        plane: Option<Plane>,
    ) {
        let is_empty =
            |cell: &Cell| cell.y >= self.rows || cell.x >= self.columns || beam.is_beside(&self.fan, cell);
        let mut inside = [None; 4];
        for (inside, cell) in inside.iter_mut().zip(cells) {
            *inside = Some(*cell).filter(|cell| !is_empty(cell));
        }
        if inside == [None; 4] {
            return;
        }
        if !(beam.hazy.is_smooth() && beam.way.is_clear() && self.is_fine_enough(beam, cells)) {
            inside.iter().flatten().for_each(|cell| self.split(beam, cell, None, plane));
            return;
        }
        let found = match plane {
            Some(plane) => self.on_plane(beam, cells, &inside, known, plane),
            None => self.between_ends(beam, &inside),
        };
        self.settle(beam, &found);
    }

    /// Evaluates the nodes of neighbouring cells that show one flat surface.
    fn on_plane<S: Scalar>(
        &mut self,
        beam: &Beam<'_, S>,
        cells: &[Cell],
        inside: &[Option<Cell>; 4],
        known: Option<&Nodes>,
        plane: Plane,
    ) -> [Option<Found>; 4] {
        let Cell { x, y, step } = cells[0];
        let known_at = |column: usize, row: usize| {
            known.filter(|_| column % 2 + row % 2 == 0).map(|known| known[row / 2][column / 2])
        };
        let nodes = (0..5 * (cells.len() + 1)).map(|i| (i % 5, i / 5));
        for (column, row) in nodes.clone().filter(|&(column, row)| known_at(column, row).is_none()) {
            let pixel = (x + column * step, y + row * step);
            self.queue.push(pixel, plane.at(pixel));
        }
        let mut light = self.evaluate(beam).into_iter();
        let mut grid = [[0.0; 5]; 5];
        for (column, row) in nodes {
            grid[row][column] = known_at(column, row).or_else(|| light.next()).unwrap_or_default();
        }
        inside.map(|cell| {
            let cell = cell?;
            let (column, row) = ((cell.x - x) / step, (cell.y - y) / step);
            let nodes = [0, 1, 2].map(|r| [0, 1, 2].map(|c| grid[row + r][column + c]));
            Some(Found { cell, ends: Ends::flat(plane), nodes, gap: 0.0 })
        })
    }

    /// Evaluates the nodes of cells between the bounds of their surfaces.
    fn between_ends<S: Scalar>(
        &mut self,
        beam: &Beam<'_, S>,
        cells: &[Option<Cell>; 4],
    ) -> [Option<Found>; 4] {
        let cells = cells.map(|cell| cell.map(|cell| (cell, self.ends_of(&cell))));
        for (cell, ends) in cells.iter().flatten() {
            self.queue.push_ends(ends, cell.nodes());
        }
        let mut light = self.evaluate(beam).into_iter();
        let mut nodes = || [[(); 3]; 3].map(|row| row.map(|()| light.next().unwrap_or_default()));
        cells.map(|cell| {
            let (cell, ends) = cell?;
            let (mut middle, mut gap) = (nodes(), 0.0_f32);
            if !ends.is_flat {
                let near = nodes();
                for (far, near) in middle.iter_mut().flatten().zip(near.iter().flatten()) {
                    gap = gap.max((*far - near).abs());
                    *far = 0.5 * (*far + near);
                }
            }
            Some(Found { cell, ends, nodes: middle, gap })
        })
    }

    /// Returns the light of the queued rays.
    fn evaluate<S: Scalar>(&mut self, beam: &Beam<'_, S>) -> Light {
        let mut light = NO_LIGHT;
        self.rays += self.queue.evaluate(&self.fan, beam.hazy, beam.way, &mut light);
        light
    }

    /// Interpolates cells from their nodes, or splits them.
    ///
    /// A cell is interpolated if its nodes bend little, and if a ray through the middle of each
    /// quarter shows that the interpolation is right there, too.
    fn settle<S: Scalar>(&mut self, beam: &Beam<'_, S>, found: &[Option<Found>; 4]) {
        let mut hopeful = [None; 4];
        for (found, hopeful) in found.iter().zip(&mut hopeful) {
            let Some(found) = found else { continue };
            let Found { cell, nodes, gap, ends } = found;
            let is_dark = nodes.iter().flatten().all(|&light| light == 0.0) && *gap == 0.0;
            if is_dark && !beam.hazy.may_be_seen(&self.bundle(cell)) {
                continue;
            }
            if !is_dark && bend(nodes) <= BEND * beam.tolerance && *gap <= beam.tolerance {
                *hopeful = Some(*found);
            } else {
                self.split(beam, cell, Some(nodes), ends.plane());
            }
        }
        for Found { cell, ends, .. } in hopeful.iter().flatten() {
            self.queue.push_ends(ends, cell.quarters().map(Cell::middle));
        }
        let mut light = self.evaluate(beam).into_iter();
        for found in hopeful.iter().flatten() {
            let mut middles = || [(); 4].map(|()| light.next().unwrap_or_default());
            let far = middles();
            let near = if found.ends.is_flat { far } else { middles() };
            let off = (0..4).map(|i| {
                let (row, column) = (i / 2, i % 2);
                let [above, below] =
                    [row, row + 1].map(|row| found.nodes[row][column] + found.nodes[row][column + 1]);
                let gap = (far[i] - near[i]).abs();
                (0.5 * (far[i] + near[i]) - 0.25 * (above + below)).abs().max(0.5 * gap)
            });
            if off.fold(0.0, f32::max) <= OFF * beam.tolerance {
                self.sums.add(&found.cell, &found.nodes, beam.hazy.color);
            } else {
                self.split(beam, &found.cell, Some(&found.nodes), found.ends.plane());
            }
        }
    }

    /// Adds a beam to the quarters of a cell; to the pixels if the cell is one of the smallest.
    fn split<S: Scalar>(
        &mut self,
        beam: &Beam<'_, S>,
        cell: &Cell,
        nodes: Option<&Nodes>,
        plane: Option<Plane>,
    ) {
        if cell.step == 2 {
            self.evaluate_pixels(beam, cell);
        } else {
            self.refine(beam, &cell.quarters(), nodes.filter(|_| plane.is_some()), plane);
        }
    }

    /// Adds a beam to the pixels of a cell, with a ray through every pixel.
    fn evaluate_pixels<S: Scalar>(&mut self, beam: &Beam<'_, S>, cell: &Cell) {
        let (columns, rows) = self.inside(cell);
        for y in rows.clone() {
            columns.clone().for_each(|x| self.queue.push((x, y), self.nearness[y][x]));
        }
        let light = self.evaluate(beam);
        let color = beam.hazy.color;
        for (y, row) in rows.zip(light.chunks(columns.len())) {
            let Rgb { red, green, blue } = &mut self.radiance[y * self.stride];
            for (x, light) in columns.clone().zip(row) {
                red[x] += light * color.red;
                green[x] += light * color.green;
                blue[x] += light * color.blue;
            }
        }
    }

    /// Returns the columns and the rows of a cell that are in the picture.
    fn inside(&self, cell: &Cell) -> (Range<usize>, Range<usize>) {
        let side = cell.side();
        (cell.x..(cell.x + side).min(self.columns), cell.y..(cell.y + side).min(self.rows))
    }

    fn ends_of(&self, cell: &Cell) -> Ends {
        let (columns, rows) = self.inside(cell);
        Ends::of(&self.nearness, columns, rows)
    }

    /// Returns the bundle of the rays through the pixels of a cell.
    fn bundle(&self, cell: &Cell) -> RayBundle {
        let (columns, rows) = self.inside(cell);
        let nearness = self.nearness[rows.clone()].iter().flat_map(|row| &row[columns.clone()]);
        let least = nearness.copied().fold(f32::INFINITY, f32::min);
        self.fan.bundle(columns, rows, least)
    }

    /// Returns whether the nodes of neighbouring cells can't miss the beam.
    fn is_fine_enough<S: Scalar>(&self, beam: &Beam<'_, S>, cells: &[Cell]) -> bool {
        let Cell { x, y, step } = cells[0];
        let (half_width, half_height) = ((2 * step) as f32, (cells.len() / 2 * step) as f32);
        let middle = self.fan.at(x as f32 + half_width, y as f32 + half_height);
        let around = self.fan.pitch() * glam::Vec2::new(half_width, half_height).length();
        beam.is_wide(middle, around, self.fan.pitch() * step as f32)
    }
}

/// Returns the largest second difference along the rows plus that along the columns.
fn bend(nodes: &Nodes) -> f32 {
    let bend = |[a, b, c]: [f32; 3]| (a - 2.0 * b + c).abs();
    let along = nodes.map(bend);
    let across = [0, 1, 2].map(|i| bend([nodes[0][i], nodes[1][i], nodes[2][i]]));
    let most = |[a, b, c]: [f32; 3]| a.max(b).max(c);
    most(along) + most(across)
}
