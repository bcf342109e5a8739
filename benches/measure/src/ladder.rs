//! The two ends of the error of lit points, in linear codes and in steps of displays: the largest that a
//! search finds, and the derived bound.

use anyhow::{Error, Result};
use luminaire_pick::{Attenuation, Chip, Display, Edge, Light, Request};

use crate::record::Group;

/// Outer half angles in degrees.
pub(crate) const ANGLES: [&str; 7] = ["1", "3", "5", "15", "22", "45", "80"];

/// The lit points, by the names of their kernels.
pub(crate) const POINTS: [(&str, Edge, Attenuation); 4] = [
    ("lit", Edge::Soft, Attenuation::None),
    ("lit-hard", Edge::Hard, Attenuation::None),
    ("lit-inverse-square", Edge::Soft, Attenuation::InverseSquare),
    ("lit-hard-inverse-square", Edge::Hard, Attenuation::InverseSquare),
];

/// Returns the errors in a cone that ends at a half angle in degrees. An evaluation that does not hold the
/// cone has none.
pub(crate) fn at(degrees: &str) -> Result<Group> {
    let mut group = Group::default();
    for (kernel, edge, attenuation) in POINTS {
        let intensity = if attenuation == Attenuation::None { 1.0 } else { 16.0 };
        let outer = Some(2.0 * degrees.parse::<f32>()?);
        let light = Light { edge, outer, attenuation, intensity, near: 1.0, far: 7.0, ..Light::default() };
        let request = |display| Request::new(Chip::CortexM0, display);
        for (unit, request) in [
            ("codes", request(Display::Rgb888).codes(1.0)),
            ("rgb565", request(Display::Rgb565).steps(1.0)),
            ("rgb888", request(Display::Rgb888).steps(1.0)),
        ] {
            for surveyed in request.survey(&light).map_err(Error::new)?.evaluations {
                let name = format!("{kernel}.{}", surveyed.evaluation);
                let bound = surveyed.bound;
                group.add(&name, unit, digits(bound.found, f64::floor));
                group.add(&name, &format!("{unit}_bound"), digits(bound.value, f64::ceil));
            }
        }
    }
    Ok(group)
}

/// A number with three digits, rounded down or up.
fn digits(value: f64, round: fn(f64) -> f64) -> f64 {
    let unit = 10_f64.powf(value.log10().floor() - 2.0);
    let rounded = format!("{:.2e}", round(value / unit) * unit);
    rounded.parse().expect("a number")
}
