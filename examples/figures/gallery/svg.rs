//! Drawings as SVG: lines, curves, text, and the frame of a diagram.

use std::fmt::Write;

/// A position in pixels, from the left and the top.
pub(crate) type Place = (f64, f64);

/// An SVG that is being written.
pub(crate) struct Drawing {
    svg: String,
}

impl Drawing {
    /// An empty drawing on white.
    pub(crate) fn new(width: f64, height: f64, title: &str) -> Self {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"
viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="13">
<title>{title}</title>
<rect width="{width}" height="{height}" fill="white"/>
"#
        );
        Self { svg }
    }

    /// Draws a straight line. `style` consists of SVG attributes.
    pub(crate) fn line(&mut self, (x1, y1): Place, (x2, y2): Place, style: &str) {
        let _ = writeln!(self.svg, r#"<line x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}" {style}/>"#);
    }

    /// Draws a path through points.
    pub(crate) fn path(&mut self, points: impl IntoIterator<Item = Place>, style: &str) {
        let mut path = String::new();
        for (x, y) in points {
            let _ = write!(path, "{}{x:.1},{y:.1}", if path.is_empty() { "M" } else { " L" });
        }
        let _ = writeln!(self.svg, r#"<path d="{path}" {style}/>"#);
    }

    /// Draws a dot of this colour.
    pub(crate) fn dot(&mut self, (x, y): Place, color: &str) {
        let _ = writeln!(self.svg, r#"<circle cx="{x:.1}" cy="{y:.1}" r="4" fill="{color}"/>"#);
    }

    /// Draws text whose start, middle or end, as `anchor` says, is at a position.
    pub(crate) fn text(&mut self, (x, y): Place, anchor: &str, color: &str, words: &str) {
        let _ = writeln!(
            self.svg,
            r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" fill="{color}">{words}</text>"#
        );
    }

    /// The finished SVG.
    pub(crate) fn finish(mut self) -> String {
        self.svg.push_str("</svg>\n");
        self.svg
    }
}

/// The frame of a diagram, which maps values to pixels.
pub(crate) struct Frame {
    /// Left and right border, in pixels and as values.
    pub(crate) x: [(f64, f64); 2],
    /// Lower and upper border, in pixels and as values.
    pub(crate) y: [(f64, f64); 2],
}

impl Frame {
    /// The position of a pair of values.
    pub(crate) fn place(&self, x: f64, y: f64) -> Place {
        let on = |[(from, low), (to, high)]: [(f64, f64); 2], value: f64| {
            from + (to - from) * (value - low) / (high - low)
        };
        (on(self.x, x), on(self.y, y))
    }

    /// The end points of a horizontal line from border to border.
    pub(crate) fn level(&self, y: f64) -> (Place, Place) {
        (self.place(self.x[0].1, y), self.place(self.x[1].1, y))
    }
}
