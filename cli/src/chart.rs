//! `--svg`: measured and fitted intensities over the angle.

use std::fmt::Write;

use luminaire::dynamic::AnyLight;
use luminaire_exchange::{Definition, Lamp, share};

use crate::text::short;

/// The width of a panel and its height, without margins.
const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 240.0;
const MARGIN: f64 = 48.0;

/// Returns a panel for each spotlight, one below the other.
pub(crate) fn svg(lamps: &[&Lamp]) -> String {
    let spots: Vec<_> = lamps.iter().filter(|lamp| matches!(lamp.light, AnyLight::Spot(_))).collect();
    let (width, height) = (WIDTH + 2.0 * MARGIN, HEIGHT + 2.0 * MARGIN);
    let total = height * spots.len().max(1) as f64;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {total}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <rect width=\"{width}\" height=\"{total}\" fill=\"white\"/>\n"
    );
    for (row, lamp) in spots.iter().enumerate() {
        let _ = writeln!(out, "<g transform=\"translate({MARGIN} {})\">", height * row as f64 + MARGIN);
        panel(&mut out, lamp);
        out.push_str("</g>\n");
    }
    out.push_str("</svg>\n");
    out
}

fn panel(out: &mut String, lamp: &Lamp) {
    let AnyLight::Spot(spot) = &lamp.light else { return };
    let cone = spot.cone();
    // Up to a little more than the angle of 1 %, or to the end.
    let faint = lamp.curve().and_then(|curve| curve.angle(0.01, Definition::Ies));
    let end = (faint.unwrap_or(180.0) * 0.6).min(f64::from(cone.outer().to_degrees()) * 0.55).min(90.0);
    let at = |degrees: f64, share: f64| format!("{:.1},{:.1}", WIDTH * degrees / end, HEIGHT * (1.0 - share));
    for (share, angle, text) in [(0.5, cone.beam(), "50 %"), (0.1, cone.field(), "10 %")] {
        let (x, y) = (WIDTH * f64::from(angle.to_degrees()) / 2.0 / end, HEIGHT * (1.0 - share));
        let _ = writeln!(
            out,
            "<path d=\"M0,{y:.1}H{WIDTH}M{x:.1},0V{HEIGHT}\" stroke=\"#bbb\" fill=\"none\"/>\
             <text x=\"-8\" y=\"{:.1}\" text-anchor=\"end\">{text}</text>\
             <text x=\"{x:.1}\" y=\"-4\" text-anchor=\"middle\">{:.1}&#176;</text>",
            y + 4.0,
            angle.to_degrees() / 2.0
        );
    }
    let _ = writeln!(
        out,
        "<path d=\"M0,0V{HEIGHT}H{WIDTH}\" stroke=\"black\" fill=\"none\"/>\
         <text x=\"{WIDTH}\" y=\"{}\" text-anchor=\"end\">{} degrees off the axis</text>",
        HEIGHT + 18.0,
        short(end)
    );
    if let Some(curve) = &lamp.measured {
        let peak = curve.peak().0;
        let points = curve
            .points()
            .iter()
            .filter(|point| point.0 <= end)
            .map(|&(angle, candela)| at(angle, candela / peak));
        let points: Vec<_> = points.collect();
        let _ = writeln!(
            out,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"#c40\" stroke-width=\"4\" opacity=\"0.5\"/>",
            points.join(" ")
        );
    }
    let fitted: Vec<_> =
        (0..=280).map(|i| end * f64::from(i) / 280.0).map(|angle| at(angle, share(&cone, angle))).collect();
    let _ = writeln!(
        out,
        "<polyline points=\"{}\" fill=\"none\" stroke=\"#06c\" stroke-width=\"1.5\"/>",
        fitted.join(" ")
    );
    let fit = lamp.fits.last().map_or_else(String::new, |fit| {
        format!(": measured (red), {} (blue), within {:.2} of 255 codes", fit.name, fit.residual.bound)
    });
    let name = lamp.name.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let _ = writeln!(
        out,
        "<text x=\"0\" y=\"-24\" font-weight=\"bold\">{}{fit}</text>",
        luminaire_export::printable(&name)
    );
}
