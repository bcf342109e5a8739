//! Places labels beside markers, where they cover as little as possible.

use std::error::Error;

use plotters::prelude::*;

use super::{Area, FONT, Pixel};

/// A part of the picture: left, top, right and bottom.
type Rectangle = [i32; 4];

/// The frame of a panel, and the parts of it that are taken.
#[derive(Debug)]
pub(super) struct Labels {
    frame: Rectangle,
    taken: Vec<Rectangle>,
}

/// Distances from its marker at which a label may stand, in pixels. From the second on, a line
/// connects label and marker.
const DISTANCES: [f64; 5] = [9.0, 22.0, 38.0, 56.0, 76.0];
/// Directions from its marker in which a label may stand, the best first.
const DIRECTIONS: [(f64, f64); 8] =
    [(1.0, 0.0), (-1.0, 0.0), (0.7, -0.7), (0.7, 0.7), (-0.7, -0.7), (-0.7, 0.7), (0.0, -1.0), (0.0, 1.0)];
/// Half the width of a marker, in pixels.
const MARKER: i32 = 5;
/// Half the width of a line, in pixels.
const LINE: i32 = 3;

/// The area that two rectangles have in common.
fn overlap(one: Rectangle, other: Rectangle) -> i32 {
    let width = one[2].min(other[2]) - one[0].max(other[0]);
    let height = one[3].min(other[3]) - one[1].max(other[1]);
    width.max(0) * height.max(0)
}

impl Labels {
    /// A panel with markers at these positions.
    pub(super) fn new(frame: Rectangle, markers: &[Pixel]) -> Self {
        let around = |&(x, y): &Pixel| [x - MARKER, y - MARKER, x + MARKER, y + MARKER];
        Self { frame, taken: markers.iter().map(around).collect() }
    }

    /// Keeps labels off a horizontal or vertical line between two positions.
    pub(super) fn avoid(&mut self, (x1, y1): Pixel, (x2, y2): Pixel) {
        self.taken.push([x1.min(x2) - LINE, y1.min(y2) - LINE, x1.max(x2) + LINE, y1.max(y2) + LINE]);
    }

    /// Draws the label of a marker at the position where the label covers least.
    pub(super) fn place(
        &mut self,
        root: &Area<'_>,
        words: &str,
        (x, y): Pixel,
        size: i32,
    ) -> Result<(), Box<dyn Error>> {
        let (label, is_near) = self.find(words, (x, y), size);
        let [left, top, right, bottom] = label;
        if !is_near {
            let near = (x.clamp(left, right), y.clamp(top, bottom));
            root.draw(&PathElement::new([(x, y), near], RGBColor(153, 153, 153)))?;
        }
        root.draw(&plotters::element::Rectangle::new(
            [(left, top), (right, bottom)],
            WHITE.mix(0.7).filled(),
        ))?;
        root.draw_text(words, &(FONT, size).into_text_style(root), (left, top))?;
        self.taken.push(label);
        Ok(())
    }

    /// The rectangle where a label covers least, and whether it is directly beside its marker.
    fn find(&self, words: &str, (x, y): Pixel, size: i32) -> (Rectangle, bool) {
        let (width, height) = (0.58 * f64::from(size) * words.chars().count() as f64, 1.2 * f64::from(size));
        let places = DISTANCES.iter().flat_map(|distance| DIRECTIONS.map(|direction| (distance, direction)));
        let labels = places.map(|(distance, (right, down))| {
            let across = right.signum() * f64::from(right != 0.0) - 1.0;
            let left = x + (right * distance + across / 2.0 * width) as i32;
            let top = y + (down * distance + (down - 1.0) / 2.0 * height) as i32;
            ([left, top, left + width as i32, top + height as i32], *distance == DISTANCES[0])
        });
        labels.min_by_key(|(label, _)| self.covered(*label)).unwrap_or_default()
    }

    /// The area that a label covers of taken parts, plus 10 times its area outside the frame.
    fn covered(&self, label: Rectangle) -> i32 {
        let outside = overlap(label, label) - overlap(label, self.frame);
        10 * outside + self.taken.iter().map(|taken| overlap(*taken, label)).sum::<i32>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_a_crowd_cover_neither_markers_nor_one_another() {
        let markers = [(200, 200), (206, 203), (198, 190), (395, 5)];
        let mut labels = Labels::new([0, 0, 400, 400], &markers);
        for marker in markers {
            let (label, _) = labels.find("soft fx16", marker, 12);
            assert_eq!(labels.covered(label), 0);
            labels.taken.push(label);
        }
    }
}
