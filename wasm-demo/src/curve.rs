//! The intensity of a light over the angle off its axis, and curves to compare it with.

use crate::{
    design::{Design, Mark},
    format::Format,
    refusal::Refusal,
};
use luminaire::{
    Angle, Cone, HalfAngle,
    falloff::{AnyFalloff, Linear, Smooth},
};

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

/// Returns the intensity of another falloff with this full beam angle in degrees, at angles off the
/// axis: `power`, a power of the cosine; `smooth`, smoothstep over the cosine; `linear`, a linear
/// ramp over it. Empty if there is none that `f32` holds.
pub(crate) fn other(name: &str, beam: f32, angles: &[f32]) -> Result<Vec<f32>, Refusal> {
    let falloff = match name {
        "power" => return Ok(power(beam, angles)),
        "smooth" => AnyFalloff::from(Smooth),
        "linear" => Linear.into(),
        _ => return Err(Refusal::name("curve", name, "power, smooth or linear")),
    };
    let design = Design::of(Mark::Beam, beam);
    let cone = Cone::from_field(falloff, Angle::degrees(1.0))?;
    let curve = |cone| Format::F32.intensities(&cone, angles);
    Ok(design.cone(Some(falloff), cone).and_then(curve).unwrap_or_default())
}

/// Returns `cos(angle)^n`, which is 1/2 at half the beam angle.
fn power(beam: f32, angles: &[f32]) -> Vec<f32> {
    let logarithm =
        |degrees| (1.0 - f64::from(Angle::from(HalfAngle::degrees(degrees)).versine())).max(0.0).ln();
    let half = logarithm(beam / 2.0);
    if !(half < 0.0 && half.is_finite()) {
        return Vec::new();
    }
    angles.iter().map(|&angle| (-(logarithm(angle) / half) as f32).exp2()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_other_curve_has_the_same_beam_angle() {
        for beam in [0.5, 20.0, 80.0] {
            for name in ["power", "smooth", "linear"] {
                let curve = other(name, beam, &[0.0, -beam / 2.0, beam / 2.0, 180.0]).unwrap();
                for (found, expected) in curve.iter().zip([1.0, 0.5, 0.5, 0.0]) {
                    assert!((found - expected).abs() < 1e-3, "{name} of {beam}: {curve:?}");
                }
            }
        }
        for (name, beam) in [("power", 181.0), ("linear", 170.0), ("smooth", 1e-6), ("linear", f32::NAN)] {
            assert_eq!(other(name, beam, &[0.0]), Ok(Vec::new()), "{name} of {beam}");
        }
        assert!(other("cubic", 20.0, &[0.0]).is_err());
    }

    #[test]
    fn angles_reject_too_few_and_too_many_samples() {
        for samples in [0, 1, SAMPLES + 1, usize::MAX] {
            let refusal = angles(1.0, samples).unwrap_err().to_string();
            assert!(refusal.starts_with("number of samples"), "{refusal}");
        }
        assert_eq!(angles(3.0, 3), Ok(vec![-3.0, 0.0, 3.0]));
    }
}
