//! Conversion of goniometric data to knots, for set-up only.

use crate::{angle::Angle, number::Knot, trig};

/// Intensities that are evenly spaced in the angle, from the axis to an outer angle, with linear
/// interpolation.
pub(super) struct Measured<'m> {
    values: &'m [f32],
    /// The outer half angle in radians, and its versine.
    outer: f32,
    versine: f32,
}

/// The position of the outer angle. Positions are in units of 1/65,536 of the outer versine.
const EDGE: u32 = 65_536;

/// The smallest difference between table and data at which a further knot helps: half a step of the
/// 16-bit values.
const LEAST: f32 = 1.0 / 131_072.0;

impl<'m> Measured<'m> {
    /// Wraps at least two values in [0, 1], evenly spaced up to an outer angle in (0, 180] degrees.
    pub(super) fn new(values: &'m [f32], outer: Angle) -> Self {
        Self { values, outer: outer.to_radians() / 2.0, versine: outer.versine() }
    }

    /// Returns the used knots, at least one, and the largest difference between the knots' lines
    /// and the data.
    ///
    /// The function repeatedly splits the line with the largest difference, at the point of that
    /// difference, until no knots are left or no split helps (Ramer 1972; Douglas and Peucker
    /// 1973). Only the two halves of a split line are searched again: until the end, a knot holds what
    /// was found instead of its line.
    pub(super) fn resample<'k>(&self, knots: &'k mut [Knot]) -> (&'k [Knot], f32) {
        if let Some(first) = knots.first_mut() {
            *first = self.searched(0, EDGE);
        }
        let mut count = 1;
        let largest = loop {
            let lines = knots.get(..count).unwrap_or_default();
            let ends = lines.iter().skip(1).map(|next| next.start()).chain([EDGE]);
            let (mut largest, mut widest, mut split) = (0.0, LEAST, None);
            for (i, (line, end)) in lines.iter().zip(ends).enumerate() {
                let (_, place, difference) = line.to_bits();
                let difference = f32::from_bits(difference as u32);
                largest = f32::max(largest, difference);
                if difference > widest && end - line.start() > 1 {
                    (widest, split) = (difference, Some((i, place.into(), end)));
                }
            }
            let Some((i, place, end)) = split else { break largest };
            let Some([before, behind @ ..]) = knots.get_mut(i..=count) else { break largest };
            *before = self.searched(before.start(), place);
            // Moves the later knots up by one; the last slot was free.
            let mut moved = self.searched(place, end);
            behind.iter_mut().for_each(|knot| core::mem::swap(knot, &mut moved));
            count += 1;
        };
        let mut end = EDGE;
        for knot in knots.iter_mut().take(count).rev() {
            let place = knot.start();
            *knot = self.line(place, end);
            end = place;
        }
        (knots.get(..count).unwrap_or_default(), (largest + self.own_error()).min(1.0))
    }

    /// Returns a knot that holds, in place of the line to the next knot, the largest difference of this
    /// line and its position.
    fn searched(&self, place: u32, end: u32) -> Knot {
        let (difference, at) = self.farthest(self.line(place, end), end);
        Knot::from_bits(place as u16, at as u16, difference.to_bits() as i32)
    }

    /// Returns the line between the data at two positions.
    fn line(&self, place: u32, end: u32) -> Knot {
        let value = |place| (self.value(self.angle(place)) * 65_535.0 + 0.5) as u16;
        Knot::line([place, end], [place, end].map(value))
    }

    /// Returns the largest difference between a line and the data, and the position of that
    /// difference.
    ///
    /// A position at an end of the line is moved inside the line. The candidates are the measured
    /// angles, where the data bend. Between two measured angles, the angle at which the derivatives
    /// of data and line with respect to the versine are equal is also a candidate. At that angle
    /// `sin(angle)` has a single value.
    fn farthest(&self, line: Knot, end: u32) -> (f32, u32) {
        let (first, last) = (self.angle(line.start()), self.angle(end));
        let (mut largest, mut at) = (0.0, 0.0);
        let mut look = |angle: f32| {
            let u = self.u(angle);
            let difference = (self.value(angle) - line.intensity(u)).abs();
            if difference >= largest {
                (largest, at) = (difference, u);
            }
        };
        look(first);
        look(last);
        let step = self.outer / (self.values.len() - 1) as f32;
        for (i, pair) in self.values.windows(2).enumerate().skip((first / step) as usize) {
            let [from, to] = [i, i + 1].map(|i| (i as f32 * step).max(first).min(last));
            if from >= last {
                break;
            }
            look(to);
            let sine = (pair[1] - pair[0]) / step * self.versine / line.rise();
            if sine > 0.0 && sine < 1.0 {
                look(trig::asin(sine).max(from).min(to));
            }
        }
        let inside = ((at * EDGE as f32 + 0.5) as u32).min(end.saturating_sub(1)).max(line.start() + 1);
        (largest, inside)
    }

    /// Returns an upper bound of the conversion's rounding error in f32, which is largest where the
    /// data are steepest.
    fn own_error(&self) -> f32 {
        let steepest = self.values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f32::max);
        1e-6 + 1e-6 * steepest * (self.values.len() - 1) as f32
    }

    /// Returns the half angle of a position, in radians.
    fn angle(&self, place: u32) -> f32 {
        let u = place as f32 / EDGE as f32;
        if place == EDGE { self.outer } else { 2.0 * trig::asin(trig::sqrt(u * self.versine / 2.0)) }
    }

    /// Returns the versine of a half angle, divided by the outer versine.
    fn u(&self, angle: f32) -> f32 {
        let sine = trig::sin(angle / 2.0);
        2.0 * sine * sine / self.versine
    }

    /// Returns the data at a half angle.
    fn value(&self, angle: f32) -> f32 {
        let place = angle / self.outer * (self.values.len() - 1) as f32;
        let index = place as usize;
        let here = self.values.get(index).or(self.values.last()).copied().unwrap_or_default();
        let next = self.values.get(index + 1).copied().unwrap_or(here);
        here + (next - here) * (place - index as f32).min(1.0)
    }
}
