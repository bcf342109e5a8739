//! Functions of the angle as tables of knots.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Mutex;

use luminaire::Cone;
use luminaire::falloff::{AnyFalloff, Knot, Step, Table};

use crate::refusal::Refusal;
use crate::residual::{difference, even};
use crate::versine::{full, of_versine, versine};

/// A falloff that is defined by a function of the angle, between an inner and an outer half angle.
pub(crate) struct Shape<'a> {
    /// Half angles in radians: full intensity up to the first, no light from the second on.
    inner: f64,
    outer: f64,
    /// Their versines.
    span: [f64; 2],
    /// The intensity at a half angle in radians, in [0, 1].
    at: &'a dyn Fn(f64) -> f64,
    /// The places between which the function is monotone, ascending.
    breaks: Vec<f64>,
}

/// A cone with a table, and an upper bound of its difference from the function.
type Tabulated = (Cone<AnyFalloff>, f64);

/// The tables of the lights of one file. Equal functions share one.
#[derive(Clone, Default, Debug)]
pub(crate) struct Tables(Rc<RefCell<HashMap<[u64; 5], Tabulated>>>);

impl Tables {
    /// Returns the cone of a function that falls from 1 to 0 between two half angles in radians, and the
    /// difference of its table. The angles and the parameters tell the functions of a file apart.
    ///
    /// # Errors
    /// More than 256 tables, each of which takes a millisecond.
    pub(crate) fn cone(
        &self,
        inner: f64,
        outer: f64,
        [a, b, c]: [f64; 3],
        falloff: &dyn Fn(f64) -> f64,
    ) -> Result<Tabulated, Refusal> {
        // In f32, nothing may be left for a falloff.
        if full(inner) >= full(outer) {
            return Ok((Cone::from_outer(AnyFalloff::from(Step), full(outer))?, 0.0));
        }
        let key = [inner, outer, a, b, c].map(f64::to_bits);
        let mut known = self.0.borrow_mut();
        if let Some(found) = known.get(&key) {
            return Ok(*found);
        }
        if known.len() >= 256 {
            let expected = "at most 256 different ones over the angle in a file: read it in parts";
            return Err(Refusal::new("falloffs", "more", expected));
        }
        let found = Shape::new(inner, outer, falloff, &[]).cone()?;
        known.insert(key, found);
        Ok(found)
    }
}

/// Returns knots that live as long as the program, as those of every table that is chosen at run time. Equal
/// ones are kept once.
fn kept(knots: Vec<Knot>) -> &'static [Knot] {
    static KEPT: Mutex<Vec<&[Knot]>> = Mutex::new(Vec::new());
    let bits = |knots: &[Knot]| knots.iter().map(|knot| knot.to_bits()).collect::<Vec<_>>();
    let mut kept = KEPT.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let own = bits(&knots);
    match kept.binary_search_by_key(&own, |knots| bits(knots)) {
        Ok(found) => kept[found],
        Err(place) => {
            kept.insert(place, knots.leak());
            kept[place]
        }
    }
}

/// The most knots of a table.
const MOST: usize = 256;
/// The most breaks of a line at which its largest difference is searched. The bound has them all.
const SEARCHED: usize = 1_024;
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

impl<'a> Shape<'a> {
    /// Creates a shape from half angles in radians; the function is monotone between two of the last ones.
    pub(crate) fn new(inner: f64, outer: f64, at: &'a dyn Fn(f64) -> f64, breaks: &[f64]) -> Self {
        let span = [inner, outer].map(versine);
        let place = |&angle: &f64| (versine(angle) - span[0]) / (span[1] - span[0]) * f64::from(EDGE);
        Self { inner, outer, span, at, breaks: breaks.iter().map(place).collect() }
    }

    /// Returns a cone with a table of at most 256 knots, and an upper bound of the difference between
    /// table and function, relative to full intensity.
    ///
    /// A line is split at its largest difference (Ramer 1972) until none differs by more than a
    /// twentieth of a code. The bound needs no derivative: the function is monotone between two breaks,
    /// so within a cell neither it nor the line leaves the values at its ends.
    pub(crate) fn cone(&self) -> Result<Tabulated, Refusal> {
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
            let breaks = self.samples(place, end, usize::MAX);
            difference(&|at| self.value(at), &self.chord(place, end), breaks, Default::default()).bound
                / 255.0
        };
        let bound = lines.iter().map(bound).fold(0.0, f64::max);
        let knots: Vec<_> = lines.iter().map(|line| self.knot(line.place, line.end)).collect();
        let cone = Cone::from_outer(AnyFalloff::from(Table::from_knots(kept(knots))?), full(self.outer))?;
        // The rounding of the angles, of the knots' values and of their slopes.
        let rounded = bound + 2.0 / 65_535.0;
        Ok((if self.inner > 0.0 { cone.with_inner(full(self.inner))? } else { cone }, rounded))
    }

    /// Returns the half angle in radians at a place between the versines of both angles.
    fn angle(&self, place: f64) -> f64 {
        let [inner, outer] = self.span;
        of_versine(inner + (outer - inner) * place / f64::from(EDGE)).min(self.outer)
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
        for at in self.samples(place, end, SEARCHED) {
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

    /// Returns evenly spaced places, and of the breaks between them at most so many.
    fn samples(&self, place: u32, end: u32, most: usize) -> Vec<f64> {
        let (from, to) = (f64::from(place), f64::from(end));
        let [first, last] = [from, to.next_up()].map(|at| self.breaks.partition_point(|own| *own < at));
        let breaks = &self.breaks[first..last];
        even(from, to).into_iter().chain(breaks.iter().copied().step_by(breaks.len() / most + 1)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Equal functions share a table, equal tables share their knots, and a file has 256 of them.
    #[test]
    fn tables_are_shared_and_counted() {
        let falls = |angle: f64| 1.0 - angle;
        let (tables, other) = (Tables::default(), Tables::default());
        let knots = |cone: &Cone<AnyFalloff>| match cone.falloff() {
            AnyFalloff::Table(table) => table.knots().as_ptr(),
            _ => panic!("expected a table"),
        };
        let first = tables.cone(0.0, 1.0, [0.0; 3], &falls).unwrap().0;
        for again in [&tables, &other] {
            assert_eq!(knots(&again.cone(0.0, 1.0, [0.0; 3], &falls).unwrap().0), knots(&first));
        }
        assert_eq!(tables.0.borrow().len(), 1);
        // A step from full intensity takes one line, and thus no time.
        let step = |_: f64| 1.0;
        let of = |number: u32| tables.cone(0.0, 1.0, [number.into(), 0.0, 0.0], &step);
        assert!((1..256).all(|number| of(number).is_ok()));
        assert!(of(256).is_err_and(|refusal| refusal.parameter == "falloffs") && of(255).is_ok());
    }
}
