//! The reference of a gobo in f64, as plain code, and the table of its error bounds.

use super::bounds::REFUSE;

/// The transmission at these distances from the left and the top edge, in sides: linear
/// interpolation between the centres of the texels, first along two rows and then between them.
pub fn transmission(side: usize, transmissions: &[u8], [column, row]: [f64; 2]) -> f64 {
    let last = (side - 1) as f64;
    let [x, y] = [column, row].map(|way| (way * side as f64 - 0.5).clamp(0.0, last));
    let [left, top] = [x, y].map(|way| way.floor() as usize);
    let [right, bottom] = [left, top].map(|index| (index + 1).min(side - 1));
    let at = |row: usize, column: usize| f64::from(transmissions[row * side + column]) / 255.0;
    let between = |from: f64, to: f64, way: f64| from + (to - from) * way;
    let along = |row| between(at(row, left), at(row, right), x - left as f64);
    between(along(top), along(bottom), y - top as f64)
}

/// The bounds in `f32`, `Fx32` and `Fx16`, in this order, of a gobo of random transmissions. Errors
/// are searched and compared as in [`bounds`](super::bounds), two-sided; `LUMINAIRE_FULL=1 cargo
/// test --test suite gobo:: -- --nocapture --test-threads 1` prints the measured ones.
pub struct Row {
    pub name: &'static str,
    /// Number of texels on a side.
    pub side: usize,
    /// The half angle of the cone, in degrees. `None`: the error from a position on the square, not
    /// from a point in space.
    pub half: Option<f32>,
    pub bounds: [f64; 3],
}

const fn row(name: &'static str, side: usize, half: Option<f32>, bounds: [f64; 3]) -> Row {
    Row { name, side, half, bounds }
}

#[rustfmt::skip]
pub const ROWS: [Row; 8] = [
    row("place, side 7",          7, None,       [2.4e-4, 2.4e-4, 2.6e-4]),
    row("place, side 64",        64, None,       [9.2e-8, 7.2e-10, 4.7e-5]),
    row("place, side 256",      256, None,       [9.2e-8, 7.2e-10, 4.7e-5]),
    row("0.1 degrees, side 64",  64, Some(0.1),  [1.9e-3, 9.7e-4, REFUSE]),
    row("1 degree, side 64",     64, Some(1.0),  [1.1e-3, 9.9e-4, 3.0e-2]),
    row("7.5 degrees, side 64",  64, Some(7.5),  [9.5e-4, 9.5e-4, 8.5e-3]),
    row("30 degrees, side 64",   64, Some(30.0), [9.6e-4, 9.7e-4, 8.4e-3]),
    row("80 degrees, side 64",   64, Some(80.0), [9.6e-4, 9.6e-4, 3.8e-2]),
];
