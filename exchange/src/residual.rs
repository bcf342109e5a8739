//! The difference between two intensities over the angle, and a bound of it.

/// The largest difference between two intensities over the angle, in linear codes: 1/255 of the largest
/// measured intensity, which is full scale.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Residual {
    /// The largest difference that was found.
    pub found: f64,
    /// An upper bound of the difference at every angle.
    pub bound: f64,
    /// The half angle in degrees of the difference that was found.
    pub degrees: f64,
    /// The measured intensity there, as a share of the largest.
    pub measured: f64,
    /// The intensity of the cone there, as a share of the largest.
    pub fitted: f64,
}

/// Returns 65 evenly spaced places.
pub(crate) fn even(from: f64, to: f64) -> Vec<f64> {
    (0..=64).map(|i| from + (to - from) * f64::from(i) / 64.0).collect()
}

/// The part of an angle within which two ends of lights are one: the rounding of a cone's angle to `f32`.
const SAME: f64 = 5e-7;

/// Returns the difference between two functions, such as of the half angle in degrees, from the first of
/// the breaks to the last one. Both are monotone between two neighbours, but for steps, which are given for
/// each of them.
///
/// Where both have a step, within half a millionth of the place, the values before and behind it count: a
/// cone has no light at its end itself, where measured intensities have their last one.
pub(crate) fn difference(
    measured: &dyn Fn(f64) -> f64,
    fitted: &dyn Fn(f64) -> f64,
    mut breaks: Vec<f64>,
    [own, other]: [&[f64]; 2],
) -> Residual {
    let tagged = |steps: &[f64], whose: u8| steps.iter().map(move |&step| (step, whose)).collect::<Vec<_>>();
    let mut steps = [tagged(own, 1), tagged(other, 2)].concat();
    steps.sort_by(|a, b| a.0.total_cmp(&b.0));
    // The cells around steps: their ends, and whose steps are between them.
    let mut around: Vec<(f64, f64, u8)> = Vec::new();
    for (step, whose) in steps {
        let (from, to) = (step * (1.0 - SAME), step * (1.0 + SAME));
        match around.last_mut().filter(|last| from <= last.1) {
            Some(last) => (last.1, last.2) = (to, last.2 | whose),
            None => around.push((from, to, whose)),
        }
    }
    let within =
        |at: f64| around[..around.partition_point(|cell| cell.0 < at)].last().filter(|cell| at < cell.1);
    breaks.retain(|&at| within(at).is_none());
    breaks.extend(around.iter().flat_map(|cell| [cell.0, cell.1]));
    breaks.sort_by(f64::total_cmp);
    let mut worst = Residual::default();
    let mut look = |degrees: f64| {
        let (measured, fitted) = (measured(degrees), fitted(degrees));
        let found = 255.0 * (measured - fitted).abs();
        if found > worst.found {
            worst = Residual { found, degrees, measured, fitted, ..worst };
        }
        (measured, fitted, worst.found)
    };
    let mut cells: Vec<_> = breaks.windows(2).map(|pair| (pair[0], pair[1])).collect();
    let mut bound = 0.0_f64;
    // In a cell neither function leaves the values at its ends. Where one is NaN, as for the angles of a cone
    // that is refused later, a cell is not divided.
    while let Some((a, b)) = cells.pop() {
        let ((m, f, _), (n, g, found)) = (look(a), look(b));
        if let Some(&(.., whose)) = within((a + b) / 2.0) {
            // Of one step, the other function has all its values on both sides of it.
            let both = if whose == 3 { 0.0 } else { (m - n).abs().min((f - g).abs()) };
            bound = bound.max(255.0 * ((m - f).abs().max((n - g).abs()) + both));
            continue;
        }
        let largest = 255.0 * (m.max(n) - f.min(g)).max(f.max(g) - m.min(n));
        if largest > found + 0.05 && b - a >= 1e-7 {
            let middle = (a + b) / 2.0;
            cells.extend([(a, middle), (middle, b)]);
        } else {
            bound = bound.max(largest);
        }
    }
    worst.bound = bound.max(worst.found);
    worst
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between two breaks alone, the difference is found inside, and the bound is over it by no more than
    /// what ends the search.
    #[test]
    fn difference_is_bounded_and_found_between_two_breaks() {
        let most = 255.0 / 4.0;
        let found = difference(&|x| x / 10.0, &|x| (x / 10.0).powi(2), vec![10.0, 0.0], [&[]; 2]);
        assert!(
            (most - 0.06..=most).contains(&found.found) && (found.degrees - 5.0).abs() < 0.2,
            "{found:?}"
        );
        assert!((most..=found.found + 0.05).contains(&found.bound), "{found:?}");
        let jump = difference(&|x| x / 10.0, &|x| if x < 3.0 { 0.0 } else { 1.0 }, vec![0.0, 10.0], [&[]; 2]);
        assert!((178.4..=178.5 + 1e-6).contains(&jump.found) && jump.bound >= 178.5, "{jump:?}");
    }
}
