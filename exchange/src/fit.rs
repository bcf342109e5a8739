//! From measured intensities to the cheapest cone.

use std::f64::consts::FRAC_PI_2;

use luminaire::Cone;
use luminaire::falloff::{AnyFalloff, Cubic, Falloff, Hard, Quadratic, Soft};

use crate::curve::{Curve, Definition};
use crate::refusal::Refusal;
use crate::residual::{Residual, difference, even};
use crate::search;
use crate::tabulate::Shape;
use crate::versine::{full, of_versine, versine};

/// A cone in place of measured intensities, and its difference from them.
#[derive(Clone, PartialEq, Debug)]
pub struct Fit {
    /// The falloff and its hotspot, such as `soft` or `cubic with a hotspot`.
    pub name: &'static str,
    /// The cone; the intensity on its axis is the largest one that was measured.
    pub cone: Cone<AnyFalloff>,
    /// The difference from the measured intensities.
    pub residual: Residual,
}

/// Returns the intensity of a cone at a half angle in degrees, relative to the intensity of its light,
/// in f64 and in [0, 1].
pub fn share(cone: &Cone<AnyFalloff>, half_degrees: f64) -> f64 {
    let [inner, outer, limit] = cone.versines().map(f64::from);
    let versine = versine(half_degrees.to_radians());
    if versine >= limit {
        return 0.0;
    }
    let t = if versine <= inner { 1.0 } else { (outer - versine) / (outer - inner) };
    cone.falloff().formula().exact(t).clamp(0.0, 1.0)
}

/// The polynomials, the cheapest first: the order of their counts of instructions in the records of
/// `luminaire pick`.
const NAMES: [&str; 8] = [
    "soft",
    "hard",
    "quadratic",
    "cubic",
    "soft with a hotspot",
    "hard with a hotspot",
    "quadratic with a hotspot",
    "cubic with a hotspot",
];

/// Outer and inner half angle in radians, and the slopes of the polynomial at the edge and at full
/// intensity.
type Parameters = [f64; 4];

/// Returns the cones of the polynomials, the cheapest first, up to the first one within the tolerance in
/// linear codes, and, if none is, the table of the curve as the last one.
///
/// The differences of a polynomial are searched at the measured angles and between them; the last number
/// is a bound for every angle, because a polynomial of this crate is monotone and the intensities are
/// lines.
///
/// # Errors
/// A curve without light up to 90 degrees off the axis.
pub fn fits(curve: &Curve, tolerance: f64) -> Result<Vec<Fit>, Refusal> {
    let (peak, _) = curve.peak();
    if peak <= 0.0 {
        return Err(Refusal::new("largest intensity", peak, "light up to 90 degrees off the axis"));
    }
    let grid = searched(curve, peak);
    let angle =
        |share| curve.angle(share, Definition::Ies).map_or(FRAC_PI_2, |full| (full / 2.0).to_radians());
    let (beam, field) = (angle(0.5), angle(0.1));
    let end = curve.end().to_radians();
    let mut found = Vec::new();
    for (kind, name) in NAMES.iter().enumerate() {
        let cost = |free: Parameters| {
            let parameters = constrained(kind, free);
            let [outer, inner, ..] = parameters;
            let Some(coefficients) = coefficients(parameters) else { return f64::INFINITY };
            if !(outer > 1e-6 && outer <= FRAC_PI_2 && (0.0..0.999 * outer).contains(&inner)) {
                return f64::INFINITY;
            }
            let (inner, outer) = (versine(inner), versine(outer));
            let difference = |&(v, share): &(f64, f64)| {
                let t = ((outer - v) / (outer - inner)).clamp(0.0, 1.0);
                let [a, b, c] = coefficients;
                (t * (a + t * (b + t * c)) - share).abs()
            };
            grid.iter().map(difference).fold(0.0, f64::max)
        };
        let starts =
            [field * 1.2, end, beam * 1.1].map(|outer| [outer.clamp(1e-5, FRAC_PI_2), beam / 2.0, 1.0, 1.0]);
        // A step of 0 keeps what the polynomial does not have.
        let [edge, full] = [[0.0; 2], [0.0; 2], [0.5, 0.0], [0.5; 2]][kind % 4];
        let steps =
            |start: Parameters| [start[0] / 4.0, if kind < 4 { 0.0 } else { start[1] / 2.0 }, edge, full];
        let searched = starts.map(|start| search::least(start, steps(start), cost));
        let Some((best, least)) = searched.into_iter().min_by(|a, b| a.1.total_cmp(&b.1)) else { continue };
        if least.is_finite() {
            // The kernel may reject what the search found in f64; the table remains.
            let Ok(cone) = cone(kind, constrained(kind, best)) else { continue };
            let residual = residual(curve, &cone);
            found.push(Fit { name, cone, residual });
            if residual.bound <= tolerance {
                return Ok(found);
            }
        }
    }
    found.push(table(curve)?);
    Ok(found)
}

/// Returns at most 1,024 versines at which the difference of a polynomial is searched, and the share of the
/// largest intensity there: those of the measured angles and the middles between them, or every so many.
fn searched(curve: &Curve, peak: f64) -> Vec<(f64, f64)> {
    let points = curve.points();
    let middles = points.windows(2).map(|pair| (pair[0].0 + pair[1].0) / 2.0);
    let all = points.iter().map(|point| point.0).chain(middles).filter(|&degrees| degrees <= 90.0);
    let every = (2 * points.len()).div_ceil(1_024);
    all.step_by(every).map(|degrees| (versine(degrees.to_radians()), curve.at(degrees) / peak)).collect()
}

/// Returns the parameters of a polynomial from those of the search.
fn constrained(kind: usize, [outer, inner, edge, full]: Parameters) -> Parameters {
    let inner = if kind < 4 { 0.0 } else { inner };
    match kind % 4 {
        0 => [outer, inner, 0.0, 2.0],
        1 => [outer, inner, 2.0, 0.0],
        2 => [outer, inner, edge, 2.0 - edge],
        _ => [outer, inner, edge, full],
    }
}

/// Returns the coefficients of the cubic with these slopes, or `None` if it is not monotone.
fn coefficients([.., edge, full]: Parameters) -> Option<[f64; 3]> {
    // A quadratic is the cubic without its last term.
    let is_quadratic = edge + full == 2.0 && (0.0..=2.0).contains(&edge);
    let is_monotone = is_quadratic || Cubic::with_slopes(edge as f32, full as f32).is_ok();
    is_monotone.then_some([edge, 3.0 - 2.0 * edge - full, edge + full - 2.0])
}

fn cone(kind: usize, [outer, inner, edge, slope]: Parameters) -> Result<Cone<AnyFalloff>, Refusal> {
    let falloff = match kind % 4 {
        0 => Soft.into(),
        1 => Hard.into(),
        2 => Quadratic::new(edge as f32)?.into(),
        _ => Cubic::with_slopes(edge as f32, slope as f32)?.into(),
    };
    let cone = Cone::from_outer(falloff, full(outer))?;
    Ok(if kind < 4 { cone } else { cone.with_inner(full(inner))? })
}

/// Returns the table of a curve up to 90 degrees off the axis.
fn table(curve: &Curve) -> Result<Fit, Refusal> {
    let (peak, _) = curve.peak();
    let end = curve.end().min(90.0);
    let breaks: Vec<_> =
        curve.points().iter().filter(|point| point.0 < end).map(|point| point.0.to_radians()).collect();
    // Rounding leads behind the end, where there is no light.
    let at = |angle: f64| curve.at(angle.to_degrees().min(end)) / peak;
    let (cone, bound) = Shape::new(0.0, end.to_radians(), &at, &breaks).cone()?;
    let found = residual(curve, &cone);
    Ok(Fit { name: "table", cone, residual: Residual { bound: (255.0 * bound).max(found.found), ..found } })
}

/// Returns the half angle in degrees at which a cone ends.
pub(crate) fn end(cone: &Cone<AnyFalloff>) -> f64 {
    of_versine(cone.versines()[2].into()).to_degrees()
}

/// Returns the difference between a cone with a monotone falloff and a curve.
pub(crate) fn residual(curve: &Curve, cone: &Cone<AnyFalloff>) -> Residual {
    let (peak, _) = curve.peak();
    let breaks = curve.points().iter().map(|point| point.0.min(90.0)).collect();
    let (last, end) = (curve.points().last().map_or(90.0, |last| last.0), end(cone));
    let breaks = [breaks, even(0.0, end)].concat();
    difference(
        &|degrees| curve.at(degrees) / peak,
        &|degrees| share(cone, degrees),
        breaks,
        [&[last], &[end]],
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The eight searches take as long for a million angles as for five hundred.
    #[test]
    fn search_is_bounded_however_many_angles_were_measured() {
        for (count, searched_at) in [(512, 1_023), (513, 513), (20_000, 1_000)] {
            let points = (0..count).map(|i| (90.0 * f64::from(i) / f64::from(count), 1.0));
            let curve = Curve::new(points.collect()).unwrap();
            assert_eq!(searched(&curve, 1.0).len(), searched_at, "{count} angles");
        }
    }
}
