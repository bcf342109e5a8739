//! Lights of measured intensities.

use luminaire::SpotLight;
use luminaire::import::Difference;

use crate::curve::Curve;
use crate::fit;
use crate::lamp::Lamp;
use crate::refusal::Refusal;

/// Returns the lights of a curve whose axis points down: one, and a second one that points up if there
/// is light more than 90 degrees off the axis, where no cone of one light reaches.
///
/// Each has the cheapest cone within the tolerance in linear codes, at full scale on its axis.
/// `difference` is that of the curve from its source, relative to the largest intensity.
pub(crate) fn lamps(
    name: &str,
    curve: &Curve,
    difference: f64,
    tolerance: f64,
) -> Result<Vec<Lamp>, Refusal> {
    let mut lamps = Vec::new();
    let (peak, _) = curve.peak();
    for (upward, name) in [(false, name.to_owned()), (true, format!("{name} (upward)"))] {
        let Some(half) = hemisphere(curve, upward) else { continue };
        let share = half.peak().0 / peak;
        // An instrument's noise is no light; the half with the peak is.
        if share < 1.0 && 255.0 * share <= tolerance / 2.0 {
            continue;
        }
        let fits = fit::fits(&half, tolerance)?;
        let Some(chosen) = fits.last() else { continue };
        let axis = [0.0, if upward { 1.0 } else { -1.0 }, 0.0];
        let light = SpotLight::new([0.0; 3], axis, chosen.cone)?.with_intensity(half.peak().0 as f32)?;
        let angle = chosen.residual.bound / 255.0 + difference;
        let mut lamp = Lamp::new(name, light);
        lamp.difference = Difference { angle: angle.min(1.0) as f32, ..Difference::default() };
        lamp.measured = Some(half);
        lamp.fits = fits;
        lamps.push(lamp);
    }
    if lamps.is_empty() { Err(Refusal::new("intensities", "0", "a light")) } else { Ok(lamps) }
}

/// Returns the half of a curve up to 90 degrees off the axis, or off the opposite axis.
fn hemisphere(curve: &Curve, upward: bool) -> Option<Curve> {
    let own = |(angle, candela): (f64, f64)| (if upward { 180.0 - angle } else { angle }, candela);
    let mut points: Vec<_> =
        curve.points().iter().map(|&point| own(point)).filter(|point| point.0 < 90.0).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let reaches = curve.points().last().is_some_and(|last| last.0 >= 90.0);
    if reaches {
        points.push((90.0, curve.at(90.0)));
    }
    Curve::new(points).filter(|half| half.peak().0 > 0.0)
}
