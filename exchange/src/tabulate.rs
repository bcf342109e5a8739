//! Functions of the angle as tables of knots.

use luminaire::Cone;
use luminaire::falloff::{Knot, Table};

use crate::refusal::Refusal;
use crate::residual::{difference, even};
use crate::versine::{full, of_versine, versine};

/// A falloff that is defined by a function of the angle, between an inner and an outer half angle.
pub(crate) struct Shape<'a> {
    /// Half angles in radians: full intensity up to the first, no light from the second on.
    pub(crate) inner: f64,
    pub(crate) outer: f64,
    /// The intensity at a half angle in radians, in [0, 1].
    pub(crate) at: &'a dyn Fn(f64) -> f64,
    /// The half angles in radians between which the function is monotone.
    pub(crate) breaks: &'a [f64],
}

/// The most knots of a table.
const MOST: usize = 256;
/// The largest difference at which no knot is added: a twentieth of a linear code.
const ENOUGH: f64 = 0.05 / 255.0;
/// The last place, in units of 1/65,536 of the span of versines.
const EDGE: u32 = 65_536;

/// A line of a table, with the largest difference that was found and its place.
struct Line {
    place: u32,
    end: u32,
    found: f64,
    at: u32,
}

impl Shape<'_> {
    /// Returns a cone with a table of at most 256 knots, and an upper bound of the difference between
    /// table and function, relative to full intensity.
    ///
    /// A line is split at its largest difference (Ramer 1972) until none differs by more than a
    /// twentieth of a code. The bound needs no derivative: the function is monotone between two breaks,
    /// so within a cell neither it nor the line leaves the values at its ends.
    ///
    /// The knots live as long as the program, as those of every table that is chosen at run time.
    pub(crate) fn cone(&self) -> Result<(Cone<Table<'static>>, f64), Refusal> {
        let mut lines = vec![self.line(0, EDGE)];
        while lines.len() < MOST {
            let splits = |line: &&Line| line.found > ENOUGH && line.end - line.place > 1;
            let worst = lines.iter().filter(splits).max_by(|a, b| a.found.total_cmp(&b.found));
            let Some(&Line { place, end, at, .. }) = worst else { break };
            let index = lines.partition_point(|line| line.place < place);
            lines[index] = self.line(place, at);
            lines.insert(index + 1, self.line(at, end));
        }
        let bound = |&Line { place, end, .. }: &Line| {
            difference(&|at| self.value(at), self.samples(place, end), &self.chord(place, end)).bound / 255.0
        };
        let bound = lines.iter().map(bound).fold(0.0, f64::max);
        let knots: Vec<_> = lines.iter().map(|line| self.knot(line.place, line.end)).collect();
        let table = Table::from_knots(Vec::leak(knots))?;
        let cone = Cone::from_outer(table, full(self.outer))?;
        // The rounding of the angles, of the knots' values and of their slopes.
        let rounded = bound + 2.0 / 65_535.0;
        Ok((if self.inner > 0.0 { cone.with_inner(full(self.inner))? } else { cone }, rounded))
    }

    /// Returns the half angle in radians at a place between the versines of both angles.
    fn angle(&self, place: f64) -> f64 {
        let [inner, outer] = [self.inner, self.outer].map(versine);
        of_versine(inner + (outer - inner) * place / f64::from(EDGE))
    }

    fn place(&self, angle: f64) -> f64 {
        let [inner, outer] = [self.inner, self.outer].map(versine);
        (versine(angle) - inner) / (outer - inner) * f64::from(EDGE)
    }

    fn value(&self, place: f64) -> f64 {
        (self.at)(self.angle(place)).clamp(0.0, 1.0)
    }

    fn knot(&self, place: u32, end: u32) -> Knot {
        let value = |place: u32| (self.value(place.into()) * 65_535.0).round() as u16;
        Knot::line([place, end], [value(place), value(end)])
    }

    /// Returns the chord between two places, with its largest difference from the function.
    fn line(&self, place: u32, end: u32) -> Line {
        let mut line = Line { place, end, found: 0.0, at: place + (end - place) / 2 };
        let chord = self.chord(place, end);
        for at in self.samples(place, end) {
            let difference = (self.value(at) - chord(at)).abs();
            if difference > line.found {
                (line.found, line.at) = (difference, at.round() as u32);
            }
        }
        line.at = line.at.clamp(place + 1, (end - 1).max(place + 1));
        line
    }

    fn chord(&self, place: u32, end: u32) -> impl Fn(f64) -> f64 {
        let (place, end) = (f64::from(place), f64::from(end));
        let (from, to) = (self.value(place), self.value(end));
        move |at| from + (to - from) * (at - place) / (end - place)
    }

    /// Returns evenly spaced places, and the breaks.
    fn samples(&self, place: u32, end: u32) -> Vec<f64> {
        let (from, to) = (f64::from(place), f64::from(end));
        let breaks = self.breaks.iter().map(|&angle| self.place(angle)).filter(|at| (from..=to).contains(at));
        even(from, to).into_iter().chain(breaks).collect()
    }
}
