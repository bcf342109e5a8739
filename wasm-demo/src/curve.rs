//! The angles over which the intensity of a light is drawn.

use crate::refusal::Refusal;
use luminaire::{Cone, falloff::AnyFalloff};

/// Largest number of samples of a curve: a few samples for each pixel of a wide screen.
const SAMPLES: usize = 10_000;

/// Returns angles off the axis in degrees, evenly spaced from `-reach` to `reach`.
pub(crate) fn angles(reach: f32, samples: usize) -> Result<Vec<f32>, Refusal> {
    if !(2..=SAMPLES).contains(&samples) {
        let range = [2.0, SAMPLES as f32];
        return Err(Refusal::outside("number of samples", samples as f32, range, "samples"));
    }
    let last = (samples - 1) as f32;
    Ok((0..samples).map(|i| reach * (2.0 * i as f32 / last - 1.0)).collect())
}

/// Returns the angle off the axis up to which the curve of a cone is drawn. The curve has a dark
/// margin at each side, so that the end of the light is visible.
pub(crate) fn reach(cone: &Cone<AnyFalloff>) -> f32 {
    (cone.outer().to_degrees() / 2.0 * 1.12).min(180.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_reject_too_few_and_too_many_samples() {
        for samples in [0, 1, SAMPLES + 1, usize::MAX] {
            let refusal = angles(1.0, samples).unwrap_err().to_string();
            assert!(refusal.starts_with("number of samples"), "{refusal}");
        }
        assert_eq!(angles(3.0, 3), Ok(vec![-3.0, 0.0, 3.0]));
    }
}
