//! IES LM-63-2002.

use luminaire_export::json::kind;

use crate::curve::Curve;
use crate::lamp::Lamp;
use crate::refusal::Refusal;

/// The longest line in bytes that every version allows, without its end.
const WIDTH: usize = 132;
/// Printed steps in a degree. An `f32` still tells two angles apart whose difference is a step.
const STEPS: u32 = 10_000;

/// Returns a file of LM-63-2002 of a spotlight that shines down: type C, a plane, absolute
/// photometry. Its place, its colour and its law of the distance are not in it.
///
/// The angles are rounded to 0.0001 degrees; points that are nearer to each other move that far
/// apart. Intensities are rounded to the seventh digit of the peak, but between `1e-12` and 1 cd. A
/// curve that ends with light falls to 0 within 0.0001 degrees, at 90 degrees before them. A
/// character of the name that is not printable ASCII becomes `?`, and the name ends after 120
/// characters.
///
/// # Errors
/// A light of another kind, a dark light, or a cone within 32 of those steps of its axis.
pub fn ies(lamp: &Lamp) -> Result<String, Refusal> {
    let curve = lamp.curve().ok_or_else(|| {
        Refusal::new(
            "light",
            kind(&lamp.light),
            "a spotlight: ies has intensities over the angle off an axis",
        )
    })?;
    if curve.peak().0 <= 0.0 {
        return Err(Refusal::new("intensity", 0, "more than 0 in ies"));
    }
    let end = curve.end();
    if end * f64::from(STEPS) < 32.0 {
        return Err(Refusal::new("outer angle", (2.0 * end) as f32, "at least 0.0064 degrees in ies"));
    }
    Ok(text(&lamp.name, &curve))
}

fn text(name: &str, curve: &Curve) -> String {
    let mut points: Vec<(u32, f64)> = Vec::new();
    for &(angle, candela) in curve.points() {
        let least = points.last().map_or(0, |last| last.0 + 1);
        points.push((least.max((angle * f64::from(STEPS)).round() as u32), candela));
    }
    let half = if points.iter().all(|point| point.0 <= 90 * STEPS) { 90 } else { 180 };
    points.retain(|point| point.0 <= half * STEPS);
    // Light at the horizon itself would be light of the other half, too.
    if points.last().is_some_and(|&(end, light)| half == 90 && end == 90 * STEPS && light > 0.0) {
        let last = points.pop();
        points.extend(last.map(|(end, light)| (end - 1, light)));
        points.dedup_by_key(|point| point.0);
    }
    let (end, light) = points[points.len() - 1];
    if end < half * STEPS {
        points.extend((light > 0.0 && end + 1 < half * STEPS).then_some((end + 1, 0.0)));
        points.push((half * STEPS, 0.0));
    }

    let name: String = name.chars().take(120).map(|c| if matches!(c, ' '..='~') { c } else { '?' }).collect();
    let mut file = format!(
        "IESNA:LM-63-2002\r\n[TEST] luminaire\r\n[TESTLAB] none, computed\r\n[ISSUEDATE] none\r\n\
         [MANUFAC] none\r\n[LUMINAIRE] {name}\r\nTILT=NONE\r\n1 -1 1 {} 1 1 2 0 0 0\r\n1 1 0",
        points.len()
    );
    let digit = 10_f64.powf((6.0 - curve.peak().0.log10().floor()).clamp(0.0, 12.0));
    write(&mut file, points.iter().map(|point| f64::from(point.0) / f64::from(STEPS)));
    file += "\r\n0";
    write(&mut file, points.iter().map(|point| (point.1 * digit).round() / digit));
    file + "\r\n"
}

/// Writes numbers in lines, each after its separator.
fn write(file: &mut String, numbers: impl Iterator<Item = f64>) {
    let mut width = WIDTH;
    for number in numbers.map(|number| number.to_string()) {
        let fits = width + 1 + number.len() <= WIDTH;
        width = if fits { width + 1 } else { 0 } + number.len();
        *file += if fits { " " } else { "\r\n" };
        *file += &number;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read;
    use crate::reading::Reading;

    #[test]
    fn ies_that_was_written_gives_the_curve_again() {
        let narrow = vec![(0.0, 1.25e6), (1.0 / 3.0, 1e6), (0.333_334, 9e5), (2.345_67, 123.456_789)];
        let wide = (0..=300).map(|i| (f64::from(i) * 0.5, 1.0 / 3.0)).collect();
        for (points, end, digit, first) in
            [(narrow, 90.0, 1.0, "\n1250000 1"), (wide, 180.0, 1e-7, "\n0.3333333 0")]
        {
            let curve = Curve::new(points).unwrap();
            let file = text("Spöt\n12", &curve);
            assert!(file.lines().all(|line| line.len() <= 132) && file.contains(first));
            let light = read::ies::read(&file, Reading::default()).unwrap();
            assert_eq!((light.name.as_str(), light.notes.len()), ("Sp?t?12", 0));
            let (read, dark) = light.round().unwrap().0.points().split_at(curve.points().len());
            for (read, written) in read.iter().zip(curve.points()) {
                assert!((read.0 - written.0).abs() < 1.51e-4 && (read.1 - written.1).abs() < 0.51 * digit);
            }
            assert_eq!(dark, [(((curve.end() * 1e4).round() + 1.0) / 1e4, 0.0), (end, 0.0)]);
        }
    }
}
