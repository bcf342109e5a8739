//! The ratios of field versine to beam versine that a monotone cubic reaches, for each edge slope. All of
//! it is found by search, in f64.

use super::svg::{Drawing, Frame};
use support::cubics::{Cubic, ratios};

const MOST_SLOPE: f64 = 4.0;
const FRAME: Frame = Frame { x: [(60.0, 0.0), (690.0, MOST_SLOPE)], y: [(400.0, 1.0), (30.0, 5.6)] };
const BLACK: &str = "#000";

/// The diagram.
pub(crate) fn svg() -> String {
    let slopes = (0..=100).map(|i| f64::from(i) / 25.0);
    let ranges: Vec<_> = slopes.filter_map(|slope| Some((slope, ratios(slope, 2_000)?))).collect();
    let lower = ranges.iter().map(|&(slope, (least, _))| FRAME.place(slope, least));
    let upper = ranges.iter().rev().map(|&(slope, (_, most))| FRAME.place(slope, most));
    // A quadratic is the cubic whose slopes add up to 2.
    let quadratics = (0..=40).map(|i| f64::from(i) / 20.0);
    let quadratics =
        quadratics.map(|slope| FRAME.place(slope, Cubic::with_slopes(slope, 2.0 - slope).ratio()));
    let title = "Which ratio of field to beam versine each edge slope of a monotone cubic reaches";
    let mut drawing = Drawing::new(720.0, 460.0, title);
    for ratio in 1..=5 {
        let (from, to) = FRAME.level(ratio.into());
        drawing.line(from, to, r##"stroke="#ddd""##);
        drawing.text((from.0 - 8.0, from.1 + 4.0), "end", BLACK, &ratio.to_string());
    }
    for slope in 0..=4 {
        let (x, y) = FRAME.place(slope.into(), 1.0);
        drawing.text((x, y + 18.0), "middle", BLACK, &slope.to_string());
    }
    let around = lower.clone().chain(upper).chain(lower.take(1));
    drawing.path(around, r##"fill="#cfe3f7" stroke="#20639b" stroke-width="1.5""##);
    drawing.path(quadratics, r##"fill="none" stroke="#1b7f4d" stroke-width="2.5""##);
    for (slope, ratio, words) in [
        (0.0, 2.3346, "soft"),
        (2.0, 1.3416, "hard"),
        (1.0, 1.8, "linear"),
        (1.34, 4.587, "field 15°, beam 7°"),
    ] {
        let (x, y) = FRAME.place(slope, ratio);
        drawing.dot((x, y), "#b3261e");
        drawing.text((x + 8.0, y - 8.0), "start", BLACK, words);
    }
    drawing.text((375.0, 446.0), "middle", BLACK, "slope at the edge, over t");
    drawing.text((60.0, 32.0), "start", BLACK, "field versine / beam versine");
    drawing.text((517.0, 191.0), "start", BLACK, "blue: monotone cubics");
    drawing.text((517.0, 209.0), "start", BLACK, "green: quadratics");
    drawing.finish()
}
