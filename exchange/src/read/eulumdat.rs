//! EULUMDAT (Stockmar 1990): a value per line.

use super::photometry::{Fields, POSITIVE, Photometry, Planes};
use crate::reading::Reading;
use crate::refusal::Refusal;

/// Symmetries by their indicator, and their first and last plane with values in quarters of a turn.
const SYMMETRIES: [(&str, usize, usize); 5] = [
    ("none", 0, 4),
    ("rotational", 0, 0),
    ("bilateral about C0-C180", 0, 2),
    ("bilateral about C90-C270", 3, 5),
    ("quadrant", 0, 1),
];

/// Returns the light of a file.
///
/// The intensity is the product of value, conversion factor and luminous flux over 1000 lm. The
/// flux is that of all lamps of the first set, or with a negative number of lamps that of the
/// luminaire: absolute photometry (DIAL 2009). The number of lamps is no factor.
///
/// # Errors
/// A file that is malformed.
pub(crate) fn read(text: &str, reading: Reading) -> Result<Photometry, Refusal> {
    let mut notes = Vec::new();
    let mut lines = Fields::new((1..).zip(text.lines().map(str::trim)));
    let company = lines.text("company")?;
    lines.skip(1)?; // type
    let symmetry = lines.count("symmetry indicator", 0)?;
    let Some(&(symmetry, from, to)) = SYMMETRIES.get(symmetry) else {
        return Err(lines.refusal("symmetry indicator", symmetry, "0, 1, 2, 3 or 4"));
    };
    let planes = lines.count("number of C planes", 1)?;
    if planes * from % 4 != 0 || planes * to % 4 != 0 {
        return Err(lines.refusal(
            "number of C planes",
            planes,
            format_args!("a multiple of 4 if {symmetry}"),
        ));
    }
    lines.skip(1)?; // distance of the planes
    let angles = lines.count("number of intensities in a C plane", 2)?;
    lines.skip(2)?; // distance of the angles, report
    let names = [lines.text("luminaire name")?, lines.text("luminaire number")?, company];
    lines.skip(13)?; // file, date, nine sizes, downward share, light output ratio
    let mut factor = lines.number("conversion factor", POSITIVE)?;
    lines.skip(1)?; // tilt
    let sets = lines.count("number of lamp sets", 1)?;
    let lamps = lines.number("number of lamps", -1e9..=1e9)?;
    lines.skip(1)?; // type of lamps
    let flux = lines.number("luminous flux", POSITIVE)?;
    factor *= flux / 1000.0;
    if lamps >= 0.0 {
        notes.push(format!("Relative photometry: the intensities are with lamps of {flux} lm."));
    }
    if sets > 1 {
        notes.push(format!("The intensities are those with the first of {sets} sets of lamps."));
    }
    let color = lines.text("colour temperature")?;
    let kelvin = kelvin(color);
    let is_bare = color.trim_end_matches(['K', ' ']).parse() == Ok(kelvin.unwrap_or_default());
    if !is_bare && !color.is_empty() {
        let taken = kelvin.map_or("no temperature".to_owned(), |kelvin| format!("{kelvin} K"));
        notes.push(format!("The colour temperature `{color:.40}` is taken as {taken}."));
    }
    lines.skip(2 + 6 * (sets - 1) + 10)?; // colour rendition and power, the other sets, ratios of rooms
    let all = lines.ascending("C plane", planes, 0.0..=360.0)?;
    let vertical = lines.ascending("angle", angles, -90.0..=180.0)?;

    // Bilateral about C90-C270 begins at C270 and goes on behind C360.
    let count = planes.min(planes * (to - from) / 4 + 1);
    let again = all.iter().map(|angle| angle + 360.0);
    let horizontal: Vec<_> = all[planes * from / 4..].iter().copied().chain(again).take(count).collect();
    let candela = lines.candela(angles.saturating_mul(count), factor)?;
    let light = Planes { symmetry, horizontal, vertical, candela }.light(&names, notes, reading)?;
    Ok(Photometry { kelvin, ..light })
}

/// Returns the correlated colour temperature of a text such as `3000`, `3000 K` or `warm 2700K`, or of a lamp's
/// colour code: its last two digits are hundreds of kelvin, so that `830` is 3000 K.
fn kelvin(text: &str) -> Option<f64> {
    let number = |digits: &str| digits.parse::<u32>().ok();
    let number =
        text.split(|c: char| !c.is_ascii_digit()).filter_map(number).find(|number| *number >= 100)?;
    Some(f64::from(if number < 1_000 { number % 100 * 100 } else { number }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Photometry, Refusal> {
        super::read(text, Reading::default())
    }

    const FILE: &str = include_str!("../../tests/files/spot.ldt");
    const PLANE: &str = "4000\n3800\n1000\n10\n0\n";

    /// The text of a real file's line, and what it means.
    #[test]
    fn eulumdat_temperatures_are_numbers_or_codes() {
        for (text, kelvin, is_noted) in [
            ("3000", Some(3000.0), false),
            ("4000 K", Some(4000.0), false),
            ("830", Some(3000.0), true),
            ("tw / 2700-6500K", Some(2700.0), true),
            ("warm white", None, true),
            ("", None, false),
        ] {
            let file = FILE.replacen("\n3000\n", &format!("\n{text}\n"), 1);
            let found = read(&file).unwrap();
            assert_eq!(
                (found.kelvin, found.notes.iter().any(|note| note.contains("colour"))),
                (kelvin, is_noted)
            );
        }
    }

    #[test]
    fn eulumdat_planes_that_differ_are_refused_by_plane_and_angle() {
        let (head, other) = (FILE.strip_suffix(PLANE).unwrap(), PLANE.replace("1000", "1200"));
        for (symmetry, planes, expected) in [
            (0, [PLANE, &other, PLANE, PLANE].concat(), ["none", "plane 90", "3.8 %"]),
            (2, [PLANE, PLANE, &other].concat(), ["bilateral about C0-C180", "plane 180", "3.8 %"]),
            (3, [PLANE, PLANE, &other].concat(), ["bilateral about C90-C270", "plane 90", "3.8 %"]),
            (4, [PLANE, &other].concat(), ["quadrant", "plane 90", "2.5 %"]),
        ] {
            let file = head.replacen("1\n1\n4\n", &format!("1\n{symmetry}\n4\n"), 1) + &planes;
            let found = read(&file).unwrap().round().unwrap_err().to_string();
            assert!(expected.iter().all(|part| found.contains(part)), "expected {expected:?}, found {found}");
            let dos = file.replace("1200", "1000").replace('\n', "\r\n") + "\x1a";
            let [found, expected] = [&dos, FILE].map(|text| read(text).unwrap());
            assert_eq!(found.round().unwrap().0, expected.round().unwrap().0);
        }
    }
}
