//! Placing labels beside markers, over nothing else.

/// A part of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rectangle {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Rectangle {
    /// The area that two have in common.
    fn overlap(&self, other: &Self) -> f64 {
        let width = self.right.min(other.right) - self.left.max(other.left);
        let height = self.bottom.min(other.bottom) - self.top.max(other.top);
        width.max(0.0) * height.max(0.0)
    }

    fn area(&self) -> f64 {
        (self.right - self.left) * (self.bottom - self.top)
    }
}

/// What is taken of a panel.
#[derive(Debug)]
pub(super) struct Labels {
    frame: Rectangle,
    taken: Vec<Rectangle>,
}

/// How far from its marker a label may stand; from the second on a line leads to it.
const DISTANCES: [f64; 5] = [9.0, 22.0, 38.0, 56.0, 76.0];
/// The directions in which it may, the best first.
const DIRECTIONS: [(f64, f64); 8] =
    [(1.0, 0.0), (-1.0, 0.0), (0.7, -0.7), (0.7, 0.7), (-0.7, -0.7), (-0.7, 0.7), (0.0, -1.0), (0.0, 1.0)];
/// Half a marker.
const MARKER: f64 = 5.0;
/// Half a line's width.
const LINE: f64 = 3.0;

impl Labels {
    /// A panel with markers at these places.
    pub(super) fn new(frame: Rectangle, markers: &[(f64, f64)]) -> Self {
        let taken = markers.iter().map(|&(x, y)| Rectangle {
            left: x - MARKER,
            top: y - MARKER,
            right: x + MARKER,
            bottom: y + MARKER,
        });
        Self { frame, taken: taken.collect() }
    }

    /// Keeps labels off a line between two places, along an axis.
    pub(super) fn avoid(&mut self, (x1, y1): (f64, f64), (x2, y2): (f64, f64)) {
        let (left, top) = (x1.min(x2) - LINE, y1.min(y2) - LINE);
        self.taken.push(Rectangle { left, top, right: x1.max(x2) + LINE, bottom: y1.max(y2) + LINE });
    }

    /// Writes a label for the marker at a place, where it covers least.
    pub(super) fn place(&mut self, words: &str, (x, y): (f64, f64), size: u32) -> String {
        let (width, height) = (0.62 * f64::from(size) * words.chars().count() as f64, 1.2 * f64::from(size));
        let mut best: Option<(f64, Rectangle, f64)> = None;
        for distance in DISTANCES {
            for (right, down) in DIRECTIONS {
                let (anchor_x, anchor_y) = (x + right * distance, y + down * distance);
                let left = anchor_x + (right.signum() * f64::from(right != 0.0) - 1.0) / 2.0 * width;
                let top = anchor_y + (down - 1.0) / 2.0 * height;
                let label = Rectangle { left, top, right: left + width, bottom: top + height };
                let covered = self.covered(&label);
                if best.as_ref().is_none_or(|(least, ..)| covered < *least) {
                    best = Some((covered, label, distance));
                }
            }
        }
        let Some((_, label, distance)) = best else { return String::new() };
        self.taken.push(label);
        let mut svg = String::new();
        if distance > DISTANCES[0] {
            let (near_x, near_y) = (x.clamp(label.left, label.right), y.clamp(label.top, label.bottom));
            svg += &format!(
                "<line x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{near_x:.1}\" y2=\"{near_y:.1}\" stroke=\"#999\" \
                 stroke-width=\"0.8\"/>\n"
            );
        }
        svg + &format!(
            "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"{size}\" stroke=\"#fff\" stroke-width=\"3\" \
             paint-order=\"stroke\">{words}</text>\n",
            label.left,
            label.bottom - 0.25 * height
        )
    }

    /// How much of others a label covers, what is outside of the frame included.
    fn covered(&self, label: &Rectangle) -> f64 {
        let outside = label.area() - label.overlap(&self.frame);
        10.0 * outside + self.taken.iter().map(|taken| taken.overlap(label)).sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_a_crowd_cover_neither_markers_nor_one_another() {
        let frame = Rectangle { left: 0.0, top: 0.0, right: 400.0, bottom: 400.0 };
        let markers = [(200.0, 200.0), (206.0, 203.0), (198.0, 190.0), (395.0, 5.0)];
        let mut labels = Labels::new(frame, &markers);
        for marker in markers {
            labels.place("soft fx16", marker, 12);
        }
        for (index, label) in labels.taken.iter().enumerate().skip(markers.len()) {
            assert!((label.overlap(&frame) - label.area()).abs() < 1e-9, "{label:?} is outside");
            for other in &labels.taken[..index] {
                assert_eq!(label.overlap(other), 0.0, "{label:?} covers {other:?}");
            }
        }
    }
}
