//! IES LM-63 of 1986, 1991, 1995, 2002 and 2019.

use super::photometry::{Fields, POSITIVE, Photometry, Planes};
use crate::refusal::Refusal;

/// Returns the light of a file of type C.
///
/// The intensity is the product of value, multiplier, ballast factor and ballast-lamp factor. The
/// lumens of the lamps are none: in relative photometry the values are for rated lumens. In
/// LM-63-2019 the field of the ballast-lamp factor has the origin of the file (section 5.13).
///
/// # Errors
/// A file that is malformed, of another type, or of a light without rotational symmetry.
pub(crate) fn read(text: &str) -> Result<Photometry, Refusal> {
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
    let kind = fields.text("photometric type")?;
    if kind != "1" {
        let expected = "1 (type C); 2 is type B and 3 is type A: convert the file to type C";
        return Err(fields.refusal("photometric type", kind, expected));
    }
    fields.skip(4)?; // units, width, length, height
    factor *= fields.number("ballast factor", POSITIVE)?;
    let lamp = fields.number("ballast-lamp photometric factor", POSITIVE)?;
    if !text.starts_with("IES:LM-63-2019") {
        factor *= lamp;
    }
    fields.skip(1)?; // watts
    let vertical = fields.ascending("vertical angle", angles, -90.0..=180.0)?;
    let horizontal = fields.ascending("horizontal angle", planes, 0.0..=360.0)?;
    let symmetry = match (planes, horizontal[0], horizontal[planes - 1]) {
        (1, ..) => "rotational",
        (_, 0.0, 90.0) => "quadrant",
        (_, 0.0, 180.0) | (_, 90.0, 270.0) => "bilateral",
        _ => "none",
    };
    let candela = fields.candela(angles.saturating_mul(planes), factor)?;
    Planes { symmetry, horizontal, vertical, candela }.light(&names, notes)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = include_str!("../../tests/files/spot.ies");
    const POINTS: [(f64, f64); 5] = [(0.0, 2000.0), (2.5, 1900.0), (7.0, 500.0), (20.0, 5.0), (90.0, 0.0)];

    fn with(part: &str, other: &str) -> Result<Photometry, Refusal> {
        assert!(FILE.contains(part));
        read(&FILE.replace(part, other))
    }

    #[test]
    fn ies_of_each_version_gives_name_curve_and_notes() {
        let light = read(FILE).unwrap();
        assert_eq!((&*light.name, light.curve.points(), light.difference), ("Spot 12", &POINTS[..], 0.0));
        assert_eq!(light.notes, ["Relative photometry: the intensities are with 2 lamps of 1000 lm."]);
        assert_eq!(with("2 1000 2", "2 -1 2").unwrap().notes.len(), 0);
        let oldest = read(&format!("A spot\nof 1986\n{}", &FILE[FILE.find("TILT").unwrap()..])).unwrap();
        assert_eq!((&*oldest.name, oldest.curve.points()), ("A spot", &POINTS[..]));
        // The field of the ballast-lamp factor, 0.5, is no factor in this version.
        let newest = with("IESNA:LM-63-1995", "IES:LM-63-2019").unwrap();
        assert_eq!(newest.curve.peak(), (4000.0, 0.0));
        let tilted = with("TILT=NONE", "TILT=INCLUDE\n1\n2\n0 90\n.5 1").unwrap();
        assert_eq!(tilted.curve.peak(), (1000.0, 0.0));
        assert!(tilted.notes[0].starts_with("TILT=INCLUDE: the factor for the lamp's tilt at 0 is used"));
        assert!(with("=NONE", "=a.tlt").unwrap().notes[0].starts_with("TILT=a.tlt: the factors"));
        let up = with("0 2.5,7\n20 90", "90 92.5 97 110 180").unwrap();
        assert_eq!((up.curve.points()[0], up.curve.peak()), ((0.0, 0.0), (2000.0, 90.0)));
        let up = with("2.5,7\n20 90\n0\n4000 3800\n1000,10 0", "90 97 170 180 0 0 0 0 1 2").unwrap();
        assert_eq!(up.curve.points()[..2], [(0.0, 1.0), (10.0, 0.5)]);
    }

    #[test]
    fn ies_planes_give_their_mean_or_are_refused_by_plane_and_angle() {
        let plane = "4000 3800 1000 10 0";
        let three = FILE.replace("5 1 1 2", "5 3 1 2");
        let (head, _) = three.split_once("\n0\n").unwrap();
        for (horizontal, share) in [("0 30 90", 0.5), ("0 90 360", 0.5), ("0 90 240", 1.0 / 3.0)] {
            let light = read(&format!("{head} {horizontal} {plane} 4000 3790 1000 10 0 {plane}")).unwrap();
            let (mean, difference) = (1900.0 - share * 5.0, (1.0 - share) * 5.0 / 2000.0);
            assert!(
                (light.curve.at(2.5) - mean).abs() < 1e-9 && (light.difference - difference).abs() < 1e-12
            );
        }
        let refused = read(&format!("{head} 0 30 180 {plane} {plane} 4000 3800 1400 10 0")).unwrap_err();
        let plane =
            "plane 180 differs from the mean of the planes by 5.8 % of the peak at the vertical angle 7";
        assert_eq!((&*refused.value, refused.expected.ends_with(plane)), ("bilateral", true));
    }

    #[test]
    fn ies_that_is_malformed_is_refused_at_its_line() {
        for (part, other, expected) in [
            (
                "1 2\n",
                "3 2\n",
                "line 6: photometric type = 3: expected 1 (type C); 2 is type B and 3 is type A",
            ),
            ("2 5 1", "2 4e9 1", "line 6: number of vertical angles = 4e9: expected a number from 2 to"),
            ("2 5 1", "2 5.5 1", "line 6: number of vertical angles = 5.5: expected a whole number"),
            ("2 5 1", "2 4 1", "line 13: value = 10: expected the end of the file"),
            (".5,", "nan", "line 7: ballast factor = nan: expected a number"),
            ("7\n20", "7\n7", "line 10: vertical angle = 7: expected ascending"),
            ("0 2.5", "-90 2.5", "vertical angles = -90 to 90: expected 0 to 90"),
            ("0 2.5", "1 2.5", "vertical angles = 1 to 90: expected 0 to 90"),
            ("4000 3800\n1000,10", "0 0 0 0", "intensities = 0 cd at every angle: expected a light"),
            ("3800", "-1", "line 12: intensity = -1: expected a number from 0 to"),
            ("3800", "3e9", "line 12: intensity = 3e9: expected a number from 0 to 2000000000"),
            ("TILT=NONE", "", "TILT = no such line: expected TILT=NONE"),
        ] {
            let found = with(part, other).unwrap_err().to_string();
            assert!(found.starts_with(expected), "expected {expected}, found {found}");
        }
        let whole = FILE.trim_end();
        assert!((0..whole.len()).all(|end| read(&whole[..end]).is_err()));
    }
}
