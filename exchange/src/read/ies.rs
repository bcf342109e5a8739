//! IES LM-63 of 1986, 1991, 1995, 2002 and 2019.

use super::photometry::{Across, Fields, POSITIVE, Photometry, Planes};
use crate::reading::Reading;
use crate::refusal::Refusal;
use crate::sphere::Goniometer;

/// Returns the light of a file, of type C, B or A.
///
/// The intensity is the product of value, multiplier, ballast factor and ballast-lamp factor. The
/// lumens of the lamps are none: in relative photometry the values are for rated lumens. In
/// LM-63-2019 the field of the ballast-lamp factor has the origin of the file (section 5.13).
///
/// # Errors
/// A file that is malformed.
pub(crate) fn read(text: &str, reading: Reading) -> Result<Photometry, Refusal> {
    let tilt = text.lines().enumerate().find_map(|(above, line)| {
        let (label, tilt) = line.split_once('=')?;
        label.trim().eq_ignore_ascii_case("TILT").then_some((above, tilt.trim()))
    });
    let Some((above, tilt)) = tilt else {
        return Err(Refusal::new("TILT", "no such line", "TILT=NONE, TILT=INCLUDE or TILT=<file>"));
    };
    let labels = || text.lines().take(above).map(str::trim);
    let keyword = |keyword| labels().find_map(|label| label.strip_prefix(keyword)).unwrap_or("").trim();
    // A file of 1986 begins with lines of free text.
    let free = labels().find(|label| !label.starts_with('[') && !label.starts_with("IES")).unwrap_or("");
    let names = [keyword("[LUMCAT]"), keyword("[LUMINAIRE]"), keyword("[MANUFAC]"), free];
    let separates = |c: char| c == ',' || c.is_whitespace();
    let lines = (1..).zip(text.lines()).skip(above + 1);
    let words = lines.flat_map(|(line, text)| text.split(separates).map(move |word| (line, word)));
    let mut fields = Fields::new(words.filter(|(_, word)| !word.is_empty()));
    let (mut notes, mut factor) = (Vec::new(), 1.0);
    match tilt {
        none if none.eq_ignore_ascii_case("NONE") => {}
        include if include.eq_ignore_ascii_case("INCLUDE") => {
            fields.skip(1)?; // geometry of the lamp
            let pairs = fields.count("number of tilt angles", 1)?;
            fields.number("first tilt angle", 0.0..=0.0)?;
            fields.skip(pairs - 1)?;
            factor = fields.number("first tilt factor", POSITIVE)?;
            fields.skip(pairs - 1)?;
            notes.push(format!("TILT=INCLUDE: the factor for the lamp's tilt at 0 is used, {factor}."));
        }
        file => notes.push(format!("TILT={file}: the factors in that file are ignored.")),
    }
    let lamps = fields.number("number of lamps", -1e9..=1e9)?;
    let lumens = fields.number("lumens per lamp", -1e9..=1e9)?;
    if lumens >= 0.0 {
        notes.push(format!("Relative photometry: the intensities are with {lamps} lamps of {lumens} lm."));
    }
    factor *= fields.number("multiplier", POSITIVE)?;
    let angles = fields.count("number of vertical angles", 2)?;
    let planes = fields.count("number of horizontal angles", 1)?;
    let kind = fields.number("photometric type", 1.0..=3.0)?;
    let goniometer = match kind {
        1.0 => Goniometer::C,
        2.0 => Goniometer::B,
        3.0 => Goniometer::A,
        _ => return Err(fields.refusal("photometric type", kind, "1 (type C), 2 (type B) or 3 (type A)")),
    };
    fields.skip(4)?; // units, width, length, height
    factor *= fields.number("ballast factor", POSITIVE)?;
    let lamp = fields.number("ballast-lamp photometric factor", POSITIVE)?;
    // The first line has the number and the year of the standard, with whatever between and around them.
    let head = text.lines().find(|line| !line.trim().is_empty()).unwrap_or("");
    let digits: Vec<_> = head.split(|c: char| !c.is_ascii_digit()).filter(|run| !run.is_empty()).collect();
    if !(head.to_ascii_uppercase().contains("IES") && digits.windows(2).any(|pair| pair == ["63", "2019"])) {
        factor *= lamp;
    }
    let has_watts =
        |label: &str| ["w/sr", "steradian"].iter().any(|unit| label.to_lowercase().contains(unit));
    if let Some(label) = labels().find(|label| has_watts(label)) {
        notes.push(format!(
            "The intensities are watts, not lumens, per steradian, if this holds: {label:.100}"
        ));
    }
    fields.skip(1)?; // watts
    if goniometer != Goniometer::C {
        let vertical = fields.ascending("vertical angle", angles, -90.0..=90.0)?;
        let horizontal = fields.ascending("horizontal angle", planes, -90.0..=90.0)?;
        let candela = fields.candela(angles.saturating_mul(planes), factor)?;
        return Across { goniometer, horizontal, vertical, candela }.light(&names, notes, reading);
    }
    let vertical = fields.ascending("vertical angle", angles, -90.0..=180.0)?;
    let horizontal = fields.ascending("horizontal angle", planes, 0.0..=360.0)?;
    let symmetry = match (planes, horizontal[0], horizontal[planes - 1]) {
        (1, ..) => "rotational",
        (_, 0.0, 90.0) => "quadrant",
        (_, 0.0, 180.0) | (_, 90.0, 270.0) => "bilateral",
        _ => "none",
    };
    let candela = fields.candela(angles.saturating_mul(planes), factor)?;
    Planes { symmetry, horizontal, vertical, candela }.light(&names, notes, reading)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Curve;

    /// Returns the curve of a round light, the difference of its planes, and the notes.
    fn round(text: &str, reading: Reading) -> Result<(Curve, f64, Vec<String>), Refusal> {
        let photometry = super::read(text, reading)?;
        let (curve, difference) = photometry.round()?;
        Ok((curve.clone(), difference, photometry.notes))
    }

    fn read(text: &str) -> Result<(Curve, f64, Vec<String>), Refusal> {
        round(text, Reading::default())
    }

    const FILE: &str = include_str!("../../tests/files/spot.ies");

    #[test]
    fn ies_planes_give_their_mean_or_are_refused_by_plane_and_angle() {
        let plane = "4000 3800 1000 10 0";
        let three = FILE.replace("5 1 1 2", "5 3 1 2");
        let (head, _) = three.split_once("\n0\n").unwrap();
        for (horizontal, share) in [("0 30 90", 0.5), ("0 90 360", 0.5), ("0 90 240", 1.0 / 3.0)] {
            let (curve, off, _) =
                read(&format!("{head} {horizontal} {plane} 4000 3790 1000 10 0 {plane}")).unwrap();
            let (mean, difference) = (1900.0 - share * 5.0, (1.0 - share) * 5.0 / 2000.0);
            assert!((curve.at(2.5) - mean).abs() < 1e-9 && (off - difference).abs() < 1e-12);
        }
        // The mean of two planes is half of the difference off each: 1/255 of the peak is the limit.
        let two = |candela: f64, fit, is_round| {
            let planes = format!("2550 0 0 0 0 2550 {candela} 0 0 0");
            let file = format!("{} 0 180 {planes}", head.replace("5 3 1 2", "5 2 1 2"));
            round(&file, Reading { fit, is_round, ..Reading::default() })
        };
        let is_refused =
            |read: Result<_, Refusal>| read.is_err_and(|refusal| refusal.parameter == "symmetry");
        assert!(two(19.99, 0.0, false).is_ok() && is_refused(two(20.01, 1.0, false)));
        // A larger fit takes the mean of planes that differ by more, and `round` that of any; both say by how much.
        assert!(two(199.9, 10.0, false).is_ok() && is_refused(two(200.1, 10.0, false)));
        for light in [two(199.9, 10.0, false), two(199.9, 1.0, true)] {
            let (_, difference, notes) = light.unwrap();
            let told = "plane 180 differs from the mean of the planes by 10.0 of 255 codes (3.9 % of the peak) at the";
            assert!(notes.last().is_some_and(|note| note.contains(told)), "{notes:?}");
            assert!((255.0 * difference - 9.995).abs() < 1e-9, "{difference}");
        }
        let refused = read(&format!("{head} 0 30 180 {plane} {plane} 4000 3800 1400 10 0")).unwrap_err();
        let plane = "plane 180 differs from the mean of the planes by 14.9 of 255 codes (5.8 % of the peak) at the vertical angle 7";
        assert_eq!((&*refused.value, refused.expected.ends_with(plane)), ("bilateral", true));
    }
}
