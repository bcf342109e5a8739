//! What a shadow map says of a place, in f64 and as plainly as it can be said.

/// The part of the light that arrives at a place, in parts of a side, and at a depth: the four nearest
/// middles of texels are asked, and each answer counts by how near the place is. Outside the outermost
/// middles the nearest ones are asked.
pub fn visibility(side: usize, depths: &[f64], [column, row]: [f64; 2], depth: f64) -> f64 {
    let last = side as f64 - 1.0;
    let taps = |part: f64| {
        let way = part * side as f64 - 0.5;
        let before = way.floor();
        let after = way - before;
        [(before.clamp(0.0, last), 1.0 - after), ((before + 1.0).clamp(0.0, last), after)]
    };
    let mut sum = 0.0;
    for (row, down) in taps(row) {
        for (column, right) in taps(column) {
            if depth <= depths[row as usize * side + column as usize] {
                sum += down * right;
            }
        }
    }
    sum
}
