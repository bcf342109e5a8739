//! A search for the parameters with the least difference.

/// Returns parameters at which a function is small, and its value there.
///
/// A pattern search (Hooke and Jeeves 1961) from one start: a step in every combination of directions,
/// as the largest of many differences has edges along which no single parameter leads down; without
/// progress the steps are halved. A step of 0 keeps its parameter. The result is a local minimum.
pub(crate) fn least<const N: usize>(
    start: [f64; N],
    mut steps: [f64; N],
    cost: impl Fn([f64; N]) -> f64,
) -> ([f64; N], f64) {
    let (mut best, mut least) = (start, cost(start));
    // 2^-22 of the first step is a millionth of an angle.
    for _ in 0..22 {
        // A valley that is longer than a dozen steps is walked with the next ones.
        for _ in 0..12 {
            let before = best;
            // Each digit in base 3 is a direction: none, up or down.
            for code in 1..3_usize.pow(N as u32) {
                let digits: [usize; N] = std::array::from_fn(|i| code / 3_usize.pow(i as u32) % 3);
                if digits.iter().zip(steps).any(|(&digit, step)| digit > 0 && step == 0.0) {
                    continue;
                }
                let moved = std::array::from_fn(|i| before[i] + [0.0, 1.0, -1.0][digits[i]] * steps[i]);
                let value = cost(moved);
                if value < least {
                    (best, least) = (moved, value);
                }
            }
            if best == before {
                break;
            }
        }
        steps = steps.map(|step| step / 2.0);
    }
    (best, least)
}
