//! The markers of the formats: told apart by shape, and by colours that the colour-blind tell apart
//! too.

use std::fmt::Write;

/// Each format with its colour, of M. Okabe and K. Ito, *Color Universal Design*, 2008.
pub(super) const ALL: [(&str, &str); 7] = [
    ("fx16", "#d55e00"),
    ("fx32", "#0072b2"),
    ("f32", "#009e73"),
    ("f32-cosine", "#e69f00"),
    ("f32-fast", "#56b4e9"),
    ("f64", "#cc79a7"),
    ("rival", "#000000"),
];

/// A marker of a radius at a place.
pub(super) fn draw(format: &str, (x, y): (f64, f64), radius: f64) -> String {
    let colour = ALL.iter().find(|(name, _)| *name == format).map_or("#000000", |(_, colour)| colour);
    let outline = match format {
        "fx16" => {
            return format!(
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{colour}\" stroke=\"#fff\"/>"
            );
        }
        "fx32" => polygon((x, y), 1.2 * radius, 4, 45.0),
        "f32" => polygon((x, y), 1.25 * radius, 3, -90.0),
        "f32-cosine" => polygon((x, y), 1.25 * radius, 4, 0.0),
        "f32-fast" => polygon((x, y), 1.25 * radius, 3, 90.0),
        "f64" => polygon((x, y), 1.15 * radius, 6, 0.0),
        _ => {
            let arm = 0.8 * radius;
            let (left, top, across) = (x - arm, y - arm, 2.0 * arm);
            return format!(
                "<path d=\"M{left:.1} {top:.1}l{across:.1} {across:.1}m0 -{across:.1}l-{across:.1} {across:.1}\" \
                 stroke=\"{colour}\" stroke-width=\"2.2\" fill=\"none\"/>"
            );
        }
    };
    format!("<path d=\"{outline}\" fill=\"{colour}\" stroke=\"#fff\"/>")
}

/// A regular polygon with a corner in a direction in degrees, clockwise from the right.
fn polygon((x, y): (f64, f64), radius: f64, corners: u32, direction: f64) -> String {
    let mut path = String::new();
    for corner in 0..corners {
        let angle = (direction + 360.0 * f64::from(corner) / f64::from(corners)).to_radians();
        let letter = if corner == 0 { 'M' } else { 'L' };
        let (sine, cosine) = angle.sin_cos();
        // Writing to a text cannot fail.
        let _ = write!(path, "{letter}{:.1} {:.1}", x + radius * cosine, y + radius * sine);
    }
    path + "Z"
}
