//! Lights that are not round.

use fastrand::Rng;
use luminaire::attenuation::{AnyAttenuation, Attenuation};
use luminaire::light::{Distribution, Symmetry};
use luminaire::{MeasuredLight, Scalar};

use super::lights::{direction, intensity, position};

/// Returns lights of any size, symmetry and attenuation. A third of them ends within a right angle of its axis, and half of
/// them is so smooth that few points need the fine evaluation.
pub(crate) fn measured<S: Scalar>(
    rng: &mut Rng,
    count: usize,
) -> Vec<MeasuredLight<'static, AnyAttenuation>> {
    let light = |index: usize| {
        let symmetry = [Symmetry::None, Symmetry::Bilateral, Symmetry::Quadrant][index % 3];
        let size = [3, 5, 9, 17, 33, 65][rng.usize(..6)];
        let [columns, rows] = Distribution::from_parts(&[], size, symmetry).shape();
        let (is_smooth, ends) = (rng.bool(), rng.u8(..3) == 0);
        let off = |i: usize, count: usize| {
            let half = size as usize / 2;
            if count > half + 1 { i.abs_diff(half) } else { i }
        };
        let sample = |at: usize| {
            let far = off(at % columns, columns) + off(at / columns, rows);
            match () {
                () if ends && far >= size as usize / 3 => 0,
                () if is_smooth => (65_535 - 10 * far) as u16,
                // The ends of the range, too.
                () => [rng.u16(..), 65_535, 0][[0, 0, 0, 1, 2][rng.usize(..5)]],
            }
        };
        // The samples of one direction at the edges of the square may differ: the bits are the same.
        let samples = (0..columns * rows).map(sample).collect::<Vec<_>>().leak();
        let distribution = Distribution::from_parts(samples, size, symmetry);
        let attenuation = AnyAttenuation::anywhere(index, || 0.5).ok()?;
        let light =
            MeasuredLight::new(position::<S>(rng), direction(rng), direction(rng), distribution).ok()?;
        Some(light.with_intensity(intensity(rng)).ok()?.with_attenuation(attenuation))
    };
    (0..count).filter_map(light).collect()
}
