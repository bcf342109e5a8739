//! Lights of measured intensities.

use luminaire::light::Distribution;
use luminaire::{MeasuredLight, PointLight, SpotLight};

use crate::curve::Curve;
use crate::difference::Difference;
use crate::fit;
use crate::lamp::Lamp;
use crate::reading::Reading;
use crate::refusal::Refusal;
use crate::sphere::{Sphere, Table};

/// Returns the lights of a curve whose axis points down: one, and a second one that points up if there
/// is light more than 90 degrees off the axis, where no cone of one light reaches; or a point light, if the
/// intensity is the same in every direction.
///
/// Each spotlight has the cheapest cone within the tolerance in linear codes, at full scale on its axis.
/// `difference` is that of the curve from its source, relative to the largest intensity.
pub(crate) fn lamps(
    name: &str,
    curve: &Curve,
    difference: f64,
    tolerance: f64,
) -> Result<Vec<Lamp>, Refusal> {
    let (peak, _) = curve.peak();
    let least = curve.points().iter().map(|point| point.1).fold(peak, f64::min);
    let spread = (peak - least) / (2.0 * peak);
    if curve.points().last().is_some_and(|last| last.0 == 180.0) && 255.0 * spread <= tolerance {
        let globe = PointLight::new([0.0; 3])?.with_intensity(((peak + least) / 2.0) as f32)?;
        let mut lamp = Lamp::new(name, globe);
        lamp.difference.angle = (spread + difference).min(1.0) as f32;
        lamp.measured = Some(curve.clone());
        return Ok(vec![lamp]);
    }
    let (mut lamps, mut faint) = (Vec::new(), None);
    for (upward, name) in [(false, name.to_owned()), (true, format!("{name} (upward)"))] {
        let Some(half) = hemisphere(curve, upward) else { continue };
        let share = half.peak().0 / peak;
        // An instrument's noise is no light; the half with the peak is.
        if share < 1.0 && 255.0 * share <= tolerance / 2.0 {
            let (side, codes, lumens) = (if upward { "over" } else { "under" }, 255.0 * share, half.lumens());
            faint = Some(format!(
                "the light {side} 90 degrees off the axis is left out: at most {codes:.2} codes, {lumens:.1} lm"
            ));
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
    let first = lamps.first_mut().ok_or_else(|| Refusal::new("intensities", "0", "a light"))?;
    first.notes.extend(faint);
    Ok(lamps)
}

/// Sizes of tables that are tried, the last one whatever its difference.
const SIZES: [u32; 4] = [9, 17, 33, 65];

/// Returns the light of intensities that are not round, which points down: one light over the whole sphere.
pub(crate) fn lamp(name: &str, sphere: &Sphere, reading: Reading) -> Result<Lamp, Refusal> {
    let is_enough =
        |table: &Table| sphere.sampled(table).is_some_and(|difference| difference.found <= reading.fit);
    let table = match reading.size {
        // Too large a size is refused before its samples are taken.
        Some(size) => {
            // Another size is refused before its samples are taken.
            let is_size = (3..=257).contains(&size) && (size - 1).is_power_of_two();
            let expected = "a power of two and one, from 3 to 257";
            is_size.then(|| sphere.table(size)).ok_or_else(|| Refusal::new("size", size, expected))?
        }
        None => {
            let last = SIZES[SIZES.len() - 1];
            let found = SIZES.into_iter().map(|size| sphere.table(size)).find(is_enough);
            found.unwrap_or_else(|| sphere.table(last))
        }
    };
    let none = || Refusal::new("intensities", "not finite", "numbers");
    let difference = sphere.difference(&table).ok_or_else(none)?;
    let samples: &'static [u16] = table.samples.leak();
    let distribution = Distribution::new(samples, table.size, table.symmetry)?;
    let side = if table.is_turned { [0.0, 0.0, -1.0] } else { [1.0, 0.0, 0.0] };
    let light = MeasuredLight::new([0.0; 3], [0.0, -1.0, 0.0], side, distribution)?;
    let mut lamp = Lamp::new(name, light.with_intensity(sphere.peak() as f32)?);
    lamp.difference.angle = (difference.bound / 255.0).min(1.0) as f32;
    let [columns, rows] = distribution.shape();
    lamp.notes.push(format!(
        "the light is not round: a table of {columns} x {rows} samples over all directions differs from the file by {:.2} \
         of 255 codes in the mean square and at most {:.1} (found), {:.1} (bound)",
        difference.rms, difference.found, difference.bound
    ));
    Ok(lamp)
}

/// Returns the half of a curve up to 90 degrees off the axis, or off the opposite axis; `None` without light.
///
/// The horizon is the edge of both halves, and alone it is no half. Behind the last angle of a curve there
/// is no light, and none is assumed there.
fn hemisphere(curve: &Curve, upward: bool) -> Option<Curve> {
    let own = |(angle, candela): (f64, f64)| (if upward { 180.0 - angle } else { angle }, candela);
    let mut points: Vec<_> =
        curve.points().iter().map(|&point| own(point)).filter(|point| point.0 < 90.0).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points.dedup_by_key(|point| point.0);
    let &(first, candela) = points.first()?;
    if first > 0.0 && candela > 0.0 {
        points.insert(0, (first * (1.0 - 1e-6), 0.0));
    }
    if curve.points().last().is_some_and(|last| last.0 >= 90.0) {
        points.push((90.0, curve.at(90.0)));
    }
    Curve::new(points).filter(|half| half.peak().0 > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lights(points: &[(f64, f64)], tolerance: f64) -> Vec<Lamp> {
        lamps("a", &Curve::new(points.to_vec()).unwrap(), 0.0, tolerance).unwrap()
    }

    #[test]
    fn halves_have_their_own_points_alone() {
        for (points, lumens) in [
            (&[(0.0, 100.0), (90.0, 10.0)][..], vec![268.3]),
            (&[(0.0, 0.0), (90.0, 0.0), (180.0, 5.0)], vec![11.4]),
            // Between 120 and 180 degrees the file has no light.
            (&[(0.0, 100.0), (90.0, 100.0), (120.0, 100.0)], vec![628.3, 314.2]),
        ] {
            let found = lights(points, 1.0);
            let flux = found.iter().map(|lamp| lamp.measured.as_ref().unwrap().lumens());
            let flux: Vec<_> = flux.map(|lumens| (lumens * 10.0).round() / 10.0).collect();
            assert_eq!(flux, lumens, "{points:?}: {found:?}");
        }
    }

    #[test]
    fn faint_half_is_noted_up_to_half_a_code_and_a_light_beyond() {
        for (up, lights_expected) in [(1.0, 1), (1.001, 2)] {
            let found = lights(&[(0.0, 510.0), (60.0, 0.0), (120.0, 0.0), (180.0, up)], 1.0);
            let notes: Vec<_> = found.iter().flat_map(|lamp| &lamp.notes).collect();
            assert_eq!((found.len(), notes.len()), (lights_expected, 2 - lights_expected), "{notes:?}");
        }
    }

    #[test]
    fn globe_is_a_point_light_within_the_tolerance() {
        // Half of the spread of 2 of 255 codes is the tolerance.
        for (least, is_point) in [(255.0, true), (253.0, true), (252.9, false)] {
            let found = lights(&[(0.0, 255.0), (90.0, least), (180.0, 255.0)], 1.0);
            assert_eq!(matches!(found[0].light, luminaire::dynamic::AnyLight::Point(_)), is_point);
        }
        let [half] = &lights(&[(0.0, 100.0), (90.0, 100.0)], 1.0)[..] else { panic!("expected a light") };
        assert!(half.fits.last().is_some_and(|fit| fit.residual.bound < 0.1), "{half:?}");
    }
}
