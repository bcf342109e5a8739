//! From measured intensities to the cheapest cone.

use std::f64::consts::FRAC_PI_2;

use luminaire::Cone;
use luminaire::falloff::{AnyFalloff, Cubic, Falloff, Hard, Quadratic, Soft, SoftPair};

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

/// The falloffs, the cheapest first: the order of their counts of instructions in the records of `luminaire pick`,
/// in `fx16` on a Cortex-M0.
const NAMES: [&str; 10] = [
    "soft",
    "hard",
    "quadratic",
    "soft pair",
    "cubic",
    "soft with a hotspot",
    "hard with a hotspot",
    "quadratic with a hotspot",
    "soft pair with a hotspot",
    "cubic with a hotspot",
];

/// How many of them are without a hotspot.
const EDGES: usize = NAMES.len() / 2;
/// The soft pair among these.
const PAIR: usize = 3;

/// Outer and inner half angle in radians, and two numbers: the slopes of a polynomial at the edge and at full intensity,
/// or of a soft pair the share of the narrow falloff and the logarithm to base 2 of its ratio.
type Parameters = [f64; 4];

/// A falloff over `t`.
#[derive(Clone, Copy)]
enum Function {
    /// The coefficients of t, t^2 and t^3.
    Polynomial([f64; 3]),
    /// The share and the ratio of the narrow falloff of a soft pair.
    Pair([f64; 2]),
}

impl Function {
    /// Returns the function with these numbers; `None` if it is not monotone, or no model of the kernel.
    fn new(kind: usize, [.., first, second]: Parameters) -> Option<Self> {
        if kind % EDGES == PAIR {
            let is_pair = (0.0..=1.0).contains(&first) && (0.0..=10.0).contains(&second);
            return is_pair.then(|| Self::Pair([first, second.exp2()]));
        }
        let [edge, full] = [first, second];
        // A quadratic is the cubic without its last term.
        let is_quadratic = edge + full == 2.0 && (0.0..=2.0).contains(&edge);
        let is_monotone = is_quadratic || Cubic::with_slopes(edge as f32, full as f32).is_ok();
        is_monotone.then_some(Self::Polynomial([edge, 3.0 - 2.0 * edge - full, edge + full - 2.0]))
    }

    fn at(self, t: f64) -> f64 {
        match self {
            Self::Polynomial([a, b, c]) => t * (a + t * (b + t * c)),
            Self::Pair([share, ratio]) => {
                let narrow = (1.0 - ratio * (1.0 - t)).max(0.0);
                (1.0 - share) * t * t + share * narrow * narrow
            }
        }
    }
}

/// Returns the cones of the falloffs, the cheapest first, up to the first one within the tolerance in
/// linear codes, and, if none is, the table of the curve as the last one.
///
/// The differences of a falloff are searched at the measured angles and between them; the last number is a bound for
/// every angle, because each of these falloffs is monotone and the intensities are lines.
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
            let Some(function) = Function::new(kind, parameters) else { return f64::INFINITY };
            if !(outer > 1e-6 && outer <= FRAC_PI_2 && (0.0..0.999 * outer).contains(&inner)) {
                return f64::INFINITY;
            }
            let (inner, outer) = (versine(inner), versine(outer));
            let difference = |&(v, share): &(f64, f64)| {
                let t = ((outer - v) / (outer - inner)).clamp(0.0, 1.0);
                (function.at(t) - share).abs()
            };
            grid.iter().map(difference).fold(0.0, f64::max)
        };
        let [first, second] = if kind % EDGES == PAIR { [0.5, 2.0] } else { [1.0; 2] };
        let starts = [field * 1.2, end, beam * 1.1]
            .map(|outer| [outer.clamp(1e-5, FRAC_PI_2), beam / 2.0, first, second]);
        // A step of 0 keeps what the falloff does not have.
        let [first, second] = [[0.0; 2], [0.0; 2], [0.5, 0.0], [0.25, 1.0], [0.5; 2]][kind % EDGES];
        let steps = |start: Parameters| {
            [start[0] / 4.0, if kind < EDGES { 0.0 } else { start[1] / 2.0 }, first, second]
        };
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

/// Returns at most 1,024 versines at which the difference of a falloff is searched, and the share of the
/// largest intensity there: those of the measured angles and the middles between them, or every so many.
fn searched(curve: &Curve, peak: f64) -> Vec<(f64, f64)> {
    let points = curve.points();
    let middles = points.windows(2).map(|pair| (pair[0].0 + pair[1].0) / 2.0);
    let all = points.iter().map(|point| point.0).chain(middles).filter(|&degrees| degrees <= 90.0);
    let every = (2 * points.len()).div_ceil(1_024);
    all.step_by(every).map(|degrees| (versine(degrees.to_radians()), curve.at(degrees) / peak)).collect()
}

/// Returns the parameters of a falloff from those of the search.
fn constrained(kind: usize, [outer, inner, first, second]: Parameters) -> Parameters {
    let inner = if kind < EDGES { 0.0 } else { inner };
    match kind % EDGES {
        0 => [outer, inner, 0.0, 2.0],
        1 => [outer, inner, 2.0, 0.0],
        2 => [outer, inner, first, 2.0 - first],
        _ => [outer, inner, first, second],
    }
}

fn cone(kind: usize, [outer, inner, first, second]: Parameters) -> Result<Cone<AnyFalloff>, Refusal> {
    let falloff = match kind % EDGES {
        0 => Soft.into(),
        1 => Hard.into(),
        2 => Quadratic::new(first as f32)?.into(),
        PAIR => SoftPair::new(first as f32, second.exp2() as f32)?.into(),
        _ => Cubic::with_slopes(first as f32, second as f32)?.into(),
    };
    let cone = Cone::from_outer(falloff, full(outer))?;
    Ok(if kind < EDGES { cone } else { cone.with_inner(full(inner))? })
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

    /// The ten searches take as long for a million angles as for five hundred.
    #[test]
    fn search_is_bounded_however_many_angles_were_measured() {
        for (count, searched_at) in [(512, 1_023), (513, 513), (20_000, 1_000)] {
            let points = (0..count).map(|i| (90.0 * f64::from(i) / f64::from(count), 1.0));
            let curve = Curve::new(points.collect()).unwrap();
            assert_eq!(searched(&curve, 1.0).len(), searched_at, "{count} angles");
        }
    }
    /// Each falloff is found again from its own light, with a stated difference under that of all that are cheaper.
    #[test]
    fn each_falloff_is_found_from_its_own_light() {
        let pair = |share, ratio| SoftPair::new(share, ratio).unwrap().into();
        let cubic = Cubic::with_slopes(1.25, 3.5).unwrap().into();
        for (name, falloff, inner) in [
            ("soft", AnyFalloff::from(Soft), 0.0),
            ("soft pair", pair(0.375, 4.0), 0.0),
            ("soft pair", pair(0.47, 30.0), 0.0),
            ("soft pair", pair(0.9, 2.5), 0.0),
            ("soft pair with a hotspot", pair(0.6, 8.0), 12.0),
            ("cubic", cubic, 0.0),
        ] {
            let cone = Cone::from_outer(falloff, luminaire::Angle::degrees(60.0)).unwrap();
            let cone = cone.with_inner(luminaire::Angle::degrees(inner)).unwrap();
            let points = (0..=480).map(|i| f64::from(i) / 8.0).map(|angle| (angle, share(&cone, angle)));
            let found = fits(&Curve::new(points.collect()).unwrap(), 0.5).unwrap();
            let (last, others) = found.split_last().unwrap();
            assert_eq!(last.name, name, "{falloff:?}: {:?}", last.residual);
            assert!(last.residual.bound <= 0.5 && others.iter().all(|other| other.residual.bound > 0.5));
        }
    }
}
