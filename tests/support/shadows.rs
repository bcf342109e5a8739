//! The reference of a look-up in a shadow map, in f64 and as plain code.

/// The visibility at a position, in sides, and a depth. The depth is compared with the four nearest
/// texels, and the four results are interpolated bilinearly. Outside the outermost texel centres
/// the nearest texels are used.
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
