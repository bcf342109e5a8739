//! Integrals of a beam's light over the directions of its lines.

use super::pattern::{Pattern, STEPS, split};
use crate::{
    light::air::{frame::Frame, hazy::Hazy},
    space::vector,
};
use alloc::{vec, vec::Vec};
use luminaire::projector::{Gobo, Projection};

/// Places for lines, at equal distances in a [`bent`] `across`.
const PLACES: usize = 32_768;

/// How much denser lines are at the edge of the cone. Their lengths fall to 0 there with the root of the
/// distance from it, and with them the distances between what their steps show of the gobo.
const BENT: f32 = 0.125;

/// Smallest and largest number of intervals before any is divided. Between these limits each
/// transmission of the gobo has an interval, so that no stripe is between two lines.
const INTERVALS: [usize; 2] = [32, 512];

/// Largest difference, where an interval is not divided further, between the integral of a line and
/// the mean of the lines to its sides, relative to the integral without the gobo if that is under 1.
const TOLERANCE: f32 = 1.5e-3;

/// Smallest integral without a gobo that counts: at the edge of a soft beam there is no light.
const LEAST: f32 = 0.02;

/// Largest `across` of a line: a line at 1 touches the cone in a point.
const LAST: f32 = 0.999_99;

/// The largest number below 1 that stays below 2 if 1 is added.
const ALMOST: f32 = 1.0 - 1.2e-7;

/// The integrals over a line, from the edge of the cone to each step, in units of `along`.
type Line = [f32; STEPS + 1];

/// A line, and its whole integral without the gobo.
type Measured = (Line, f32);

/// All lines of a beam, in the order of `across`.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    lines: Vec<Line>,
    /// The intervals between the lines.
    intervals: Vec<Interval>,
    /// The number of the interval at each place.
    numbers: Vec<u16>,
}

/// An interval between two lines: its first place, and the reciprocal of its number of places.
#[derive(Clone, Copy, Debug)]
struct Interval {
    first: f32,
    reciprocal: f32,
}

impl Lines {
    pub(super) fn new(hazy: &Hazy, frame: &Frame, gobo: &(Gobo<'static>, Projection)) -> Self {
        let pattern = Pattern::new(gobo);
        let mut line = |place: usize| {
            integrals(hazy, frame, &pattern, across(place as f32 * (2.0 / PLACES as f32) - 1.0))
        };
        let [least, most] = INTERVALS;
        let width = PLACES / gobo.0.side().next_power_of_two().clamp(least, most);
        let mut found =
            Self { lines: vec![line(0).0], intervals: Vec::new(), numbers: Vec::with_capacity(PLACES) };
        for first in (0..PLACES).step_by(width) {
            let (last, _) = line(first + width);
            found.divide(&mut line, first, width, &last);
            found.lines.push(last);
        }
        found
    }

    /// Divides the interval between the last line and a line that is `width` places after it, until
    /// the lines are near enough. Adds all but the line after it.
    fn divide(&mut self, line: &mut impl FnMut(usize) -> Measured, first: usize, width: usize, last: &Line) {
        let half = width / 2;
        let (middle, open) = line(first + half);
        let off = self.lines.last().map_or(0.0, |first| bend(first, &middle, last));
        if off <= TOLERANCE * open.clamp(LEAST, 1.0) || half == 1 {
            self.enter(first, half);
            self.lines.push(middle);
            self.enter(first + half, half);
        } else {
            self.divide(line, first, half, &middle);
            self.lines.push(middle);
            self.divide(line, first + half, half, last);
        }
    }

    /// Adds an interval.
    fn enter(&mut self, first: usize, width: usize) {
        self.numbers.resize(first + width, self.intervals.len() as u16);
        self.intervals.push(Interval { first: first as f32, reciprocal: 1.0 / width as f32 });
    }

    /// Returns the integrals up to points of lines, in units of `along`. Points outside the cone
    /// count as those at its edge.
    #[inline(always)]
    pub(super) fn integrals<const N: usize>(
        &self,
        across: &[f32; N],
        along: &[f32; N],
        light: &mut [f32; N],
    ) {
        let (mut places, mut numbers) = ([0.0; N], [0_i32; N]);
        let (mut steps, mut rests) = ([0_i32; N], [0.0; N]);
        for i in 0..N {
            places[i] = scaled(bent(across[i]), PLACES);
            (numbers[i], _) = split(places[i]);
            (steps[i], rests[i]) = split(scaled(along[i], STEPS));
        }
        for i in 0..N {
            let number = usize::from(self.numbers[numbers[i] as usize % PLACES]);
            let step = steps[i] as usize % STEPS;
            let (Some(interval), Some([left, right])) =
                (self.intervals.get(number), self.lines.get(number..number + 2))
            else {
                continue;
            };
            let [left, right] =
                [left, right].map(|line| line[step] + (line[step + 1] - line[step]) * rests[i]);
            light[i] = left + (right - left) * ((places[i] - interval.first) * interval.reciprocal);
        }
    }
}

/// Returns an `across` on the scale of the places: its slope is infinite at both edges of the cone.
#[inline(always)]
fn bent(across: f32) -> f32 {
    let square = 1.0 - across * across;
    let more = BENT * (1.0 - vector::sqrt(if square > 0.0 { square } else { 0.0 }));
    (across + if across < 0.0 { -more } else { more }) / (1.0 + BENT)
}

/// Returns the `across` of a place, the inverse of [`bent`].
fn across(bent: f32) -> f32 {
    let more = (1.0 + BENT) * bent.abs() - BENT;
    let whole = 1.0 + BENT * BENT;
    ((more + BENT * vector::sqrt(whole - more * more)) / whole).copysign(bent)
}

/// Scales a coordinate from -1 to 1 to a number of parts. The last coordinate is just below the
/// number of parts.
#[inline(always)]
fn scaled(coordinate: f32, parts: usize) -> f32 {
    let coordinate = if coordinate > -1.0 { coordinate } else { -1.0 };
    let coordinate = if coordinate < ALMOST { coordinate } else { ALMOST };
    (coordinate + 1.0) * (0.5 * parts as f32)
}

/// Returns the largest difference between a line and the mean of two others.
fn bend(left: &Line, middle: &Line, right: &Line) -> f32 {
    let mut most = 0.0_f32;
    for i in 0..=STEPS {
        let off = (middle[i] - 0.5 * (left[i] + right[i])).abs();
        most = if off > most { off } else { most };
    }
    most
}

/// Integrates the light over a line.
fn integrals(hazy: &Hazy, frame: &Frame, pattern: &Pattern, across: f32) -> Measured {
    let Frame { axis: [ahead, aside], versine, sine, .. } = *frame;
    let [eye, toward, beside] = frame.directions();
    let off = across.clamp(-LAST, LAST) * sine;
    let sin = off / aside;
    let cos = vector::sqrt(1.0 - sin * sin);
    let side = toward * cos + beside * sin;
    let radius = vector::sqrt(1.0 - off * off);
    // The direction of the line that is nearest to the axis, and the direction in which the line
    // goes on from there.
    let nearest = (eye * ahead + side * (aside * cos)) / radius;
    let onward = (side * ahead - eye * (aside * cos)) / radius;
    let least = off * off / (1.0 + radius);
    let edge = vector::sqrt((versine - least) / ((1.0 - versine) + radius));
    // The light of a direction is that of the one as far on the other side of the nearest.
    let (mut shares, mut versines, mut lights) = ([0.0; STEPS / 2], [0.0; STEPS / 2], [0.0; STEPS / 2]);
    for i in 0..STEPS / 2 {
        let v = edge * ((i as i32 as f32 + 0.5) * (2.0 / STEPS as f32));
        shares[i] = 1.0 / (1.0 + v * v);
        versines[i] = least + 2.0 * radius * (v * v) * shares[i];
    }
    hazy.intensities(&versines, &mut lights);
    let (mut found, mut open) = ([0.0; STEPS], 0.0);
    for i in 0..STEPS / 2 {
        let light = 2.0 * shares[i] * lights[i];
        found[STEPS / 2 + i] = light;
        found[STEPS / 2 - 1 - i] = light;
        open += light;
    }
    let open = open * (4.0 / STEPS as f32);
    pattern.filter(nearest, onward, edge, &mut found);
    let (mut line, mut sum) = ([0.0; STEPS + 1], 0.0);
    for (to, light) in line[1..].iter_mut().zip(found) {
        sum += light;
        *to = sum * (2.0 / STEPS as f32);
    }
    (line, open)
}
