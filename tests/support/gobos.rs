//! The reference of a gobo in f64, as plain code.

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
