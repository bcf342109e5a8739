//! The markers of the formats, which differ in shape and in colours that colour-blind readers can
//! distinguish.

use std::error::Error;

use plotters::prelude::*;

use super::{Area, Pixel};

/// Each format with its colour, of M. Okabe and K. Ito, *Color Universal Design*, 2008.
pub(super) const ALL: [(&str, RGBColor); 5] = [
    ("fx16", RGBColor(0xd5, 0x5e, 0x00)),
    ("fx32", RGBColor(0x00, 0x72, 0xb2)),
    ("f32", RGBColor(0x00, 0x9e, 0x73)),
    ("f64", RGBColor(0xcc, 0x79, 0xa7)),
    ("rival", BLACK),
];

/// The end of the name of a format's quick evaluation, whose marker is hollow.
const QUICK: &str = "-quick";

/// Draws the marker of a format, larger if it is in front.
pub(super) fn draw(
    root: &Area<'_>,
    format: &str,
    place: Pixel,
    in_front: bool,
) -> Result<(), Box<dyn Error>> {
    let (format, is_hollow) = format.strip_suffix(QUICK).map_or((format, false), |standard| (standard, true));
    let color = ALL.iter().find(|(name, _)| *name == format).map_or(BLACK, |(_, color)| *color);
    let (radius, style) = if in_front { (6.0, color.mix(1.0)) } else { (4.0, color.mix(0.5)) };
    match format {
        "fx16" if is_hollow => root.draw(&Circle::new(place, radius as i32, style.stroke_width(2)))?,
        "fx32" if is_hollow => root.draw(&outline(place, 1.2 * radius, 4, 45.0, style))?,
        "f32" if is_hollow => root.draw(&outline(place, 1.25 * radius, 3, -90.0, style))?,
        "fx16" => root.draw(&Circle::new(place, radius as i32, style.filled()))?,
        "fx32" => root.draw(&polygon(place, 1.2 * radius, 4, 45.0, style))?,
        "f32" => root.draw(&polygon(place, 1.25 * radius, 3, -90.0, style))?,
        "f64" => root.draw(&polygon(place, 1.15 * radius, 6, 0.0, style))?,
        _ => root.draw(&Cross::new(place, (0.8 * radius) as i32, style.stroke_width(2)))?,
    }
    Ok(())
}

/// A regular polygon, filled.
fn polygon(place: Pixel, radius: f64, count: u32, direction: f64, color: RGBAColor) -> Polygon<Pixel> {
    Polygon::new(corners(place, radius, count, direction), color.filled())
}

/// The outline of a regular polygon.
fn outline(place: Pixel, radius: f64, count: u32, direction: f64, color: RGBAColor) -> PathElement<Pixel> {
    let corners = corners(place, radius, count, direction);
    PathElement::new([&corners[..], &corners[..1]].concat(), color.stroke_width(2))
}

/// The corners of a regular polygon. `direction` is that of the first, in degrees clockwise from the
/// right.
fn corners((x, y): Pixel, radius: f64, count: u32, direction: f64) -> Vec<Pixel> {
    let corner = |corner: u32| {
        let angle = (direction + 360.0 * f64::from(corner) / f64::from(count)).to_radians();
        let (sine, cosine) = angle.sin_cos();
        (x + (radius * cosine).round() as i32, y + (radius * sine).round() as i32)
    };
    (0..count).map(corner).collect()
}
