//! The light of all beams on the grids of a tile, and its interpolation to the pixels.

use super::cell::{COLUMNS, Cell, ROWS};
use crate::buffer::Radiance;
use luminaire::Rgb;

/// Values at the nodes of a cell: three rows of three.
pub(super) type Nodes = [[f32; 3]; 3];

/// Light of each channel at the nodes of a cell; `None` where no beam was added.
type Sum = Option<Rgb<Nodes>>;

/// The sums of the cells of each size. Beams that are interpolated on cells of the same size are
/// added at the nodes, so that each cell is interpolated once for all beams.
pub(super) struct Sums {
    /// Cells of 16, of 8 and of 4 pixels, row by row.
    coarse: [Sum; COLUMNS * ROWS / 256],
    medium: [Sum; COLUMNS * ROWS / 64],
    fine: [Sum; COLUMNS * ROWS / 16],
}

impl Sums {
    pub(super) const fn new() -> Self {
        Self {
            coarse: [None; COLUMNS * ROWS / 256],
            medium: [None; COLUMNS * ROWS / 64],
            fine: [None; COLUMNS * ROWS / 16],
        }
    }

    /// Adds a beam of this colour at the nodes of a cell.
    pub(super) fn add(&mut self, cell: &Cell, light: &Nodes, color: Rgb<f32>) {
        let side = cell.side();
        let number = cell.y / side * (COLUMNS / side) + cell.x / side;
        let cells: &mut [Sum] = match side {
            16 => &mut self.coarse,
            8 => &mut self.medium,
            _ => &mut self.fine,
        };
        let sum = cells[number].get_or_insert(Rgb::new([[0.0; 3]; 3], [[0.0; 3]; 3], [[0.0; 3]; 3]));
        for (sum, color) in
            [(&mut sum.red, color.red), (&mut sum.green, color.green), (&mut sum.blue, color.blue)]
        {
            for (sum, light) in sum.iter_mut().flatten().zip(light.iter().flatten()) {
                *sum += light * color;
            }
        }
    }

    /// Adds the interpolated light to the radiance of a tile's rows, whose blocks are `stride`
    /// apart.
    pub(super) fn spread(&self, rows: usize, radiance: &mut [Radiance], stride: usize) {
        spread::<16>(&self.coarse, rows, radiance, stride);
        spread::<8>(&self.medium, rows, radiance, stride);
        spread::<4>(&self.fine, rows, radiance, stride);
    }
}

/// Interpolates bilinearly between the nodes of cells with `SIDE` pixels per side.
fn spread<const SIDE: usize>(cells: &[Sum], rows: usize, radiance: &mut [Radiance], stride: usize) {
    let columns = COLUMNS / SIDE;
    for (number, sum) in cells.iter().enumerate() {
        let Some(sum) = sum else { continue };
        let (x, y) = (number % columns * SIDE, number / columns * SIDE);
        for row in y..rows.min(y + SIDE) {
            let block = &mut radiance[row * stride];
            add_row::<SIDE>(&sum.red, row - y, &mut block.red[x..x + SIDE]);
            add_row::<SIDE>(&sum.green, row - y, &mut block.green[x..x + SIDE]);
            add_row::<SIDE>(&sum.blue, row - y, &mut block.blue[x..x + SIDE]);
        }
    }
}

/// Adds a row of a cell to the light of its pixels.
#[inline(always)]
fn add_row<const SIDE: usize>(nodes: &Nodes, row: usize, light: &mut [f32]) {
    let half = SIDE / 2;
    let (above, share) = (row / half, (row % half) as f32 / half as f32);
    let [left, middle, right] = [0, 1, 2].map(|node| {
        let (upper, lower) = (nodes[above][node], nodes[above + 1][node]);
        upper + (lower - upper) * share
    });
    let (first, second) = light.split_at_mut(half);
    for (part, from, to) in [(first, left, middle), (second, middle, right)] {
        let step = (to - from) / half as f32;
        for (i, light) in part.iter_mut().enumerate() {
            *light += from + step * i as f32;
        }
    }
}
