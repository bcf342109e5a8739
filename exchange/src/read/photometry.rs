//! What the photometric formats share: fields of a text with their lines, and planes that agree.

use std::fmt::Display;
use std::ops::RangeInclusive;

use crate::curve::Curve;
use crate::limits::within;
use crate::reading::Reading;
use crate::refusal::Refusal;
use crate::sphere::{Goniometer, Sphere};

/// A photometric file of a light.
#[derive(Debug)]
pub(crate) struct Photometry {
    pub(crate) name: String,
    pub(crate) shape: Shape,
    /// The correlated colour temperature, if the file has one.
    pub(crate) kelvin: Option<f64>,
    pub(crate) notes: Vec<String>,
}

/// The intensities of a file.
#[derive(Debug)]
pub(crate) enum Shape {
    /// A light that is round, or is taken as round: its curve, and the largest difference of a plane from it, relative to
    /// the peak; 0 with one plane.
    Round(Curve, f64),
    /// A light that is not, and why it is not round.
    Planes(Sphere, Refusal),
}

/// The difference of a plane from the mean, in linear codes, up to which a light is round.
const ROUND: f64 = 1.0;

type Range = RangeInclusive<f64>;
/// A factor of the intensities, or a luminous flux in lumens.
pub(crate) const POSITIVE: Range = 1e-9..=1e9;

/// The fields of a text, each a word or a line, in their order.
pub(crate) struct Fields<'a> {
    rest: Box<dyn Iterator<Item = (usize, &'a str)> + 'a>,
    /// The line of the last field.
    line: usize,
}

impl<'a> Fields<'a> {
    /// Creates fields with their lines, from 1.
    pub(crate) fn new(fields: impl Iterator<Item = (usize, &'a str)> + 'a) -> Self {
        Self { rest: Box::new(fields), line: 1 }
    }

    /// Returns the next field.
    pub(crate) fn text(&mut self, name: &str) -> Result<&'a str, Refusal> {
        let Some((line, field)) = self.rest.next() else {
            return Err(self.refusal(name, "the end of the file", "a value: the file is truncated"));
        };
        self.line = line;
        Ok(field)
    }

    /// Passes over fields that have no effect.
    pub(crate) fn skip(&mut self, count: usize) -> Result<(), Refusal> {
        (0..count).try_for_each(|_| self.text("line").map(drop))
    }

    /// Returns the next field as a number within a range, with a decimal point or a decimal comma.
    pub(crate) fn number(&mut self, name: &str, range: Range) -> Result<f64, Refusal> {
        let field = self.text(name)?;
        let number = field.replace(',', ".").parse().ok();
        let number = number.and_then(|number| within(number, *range.start(), *range.end()));
        let expected = format_args!("a number from {} to {}", range.start(), range.end());
        number.ok_or_else(|| self.refusal(name, field, expected))
    }

    /// Returns the next field as a count of at most a million, for which no memory is reserved.
    pub(crate) fn count(&mut self, name: &str, least: usize) -> Result<usize, Refusal> {
        let count = self.number(name, least as f64..=1e6)?;
        let whole = (count.fract() == 0.0).then_some(count as usize);
        whole.ok_or_else(|| self.refusal(name, count, "a whole number"))
    }

    /// Returns the next fields as ascending numbers within a range. A first or last one that was rounded is the
    /// right angle or the two that it means.
    pub(crate) fn ascending(&mut self, name: &str, count: usize, range: Range) -> Result<Vec<f64>, Refusal> {
        let mut angles: Vec<f64> = Vec::new();
        for _ in 0..count {
            let angle = self.number(name, range.clone())?;
            if let Some(last) = angles.last().filter(|&&last| angle <= last) {
                return Err(self.refusal(name, angle, format_args!("ascending angles, here over {last}")));
            }
            angles.push(angle);
        }
        let last = angles.len() - 1;
        for end in [0, last] {
            let limit = [-90.0, 90.0, 180.0].into_iter().find_map(|limit| within(angles[end], limit, limit));
            angles[end] = limit.unwrap_or(angles[end]);
        }
        Ok(angles)
    }

    /// Returns the intensities, at most 1e9 cd, and the word that follows them: the end of the file, or a
    /// comment that needs no reading.
    ///
    /// # Errors
    /// A number behind the last intensity: a declared count is too small.
    pub(crate) fn candela(
        &mut self,
        count: usize,
        factor: f64,
    ) -> Result<(Vec<f64>, Option<&'a str>), Refusal> {
        let value = |_| Ok(factor * self.number("intensity", 0.0..=1e9 / factor)?);
        let values = (0..count).map(value).collect::<Result<_, Refusal>>()?;
        let rest = self.rest.find(|(_, field)| !matches!(*field, "" | "\x1a"));
        if let Some((line, field)) = rest.filter(|(_, field)| field.replace(',', ".").parse::<f64>().is_ok())
        {
            self.line = line;
            return Err(self.refusal("value", field, "the end of the file: a declared count is too small"));
        }
        Ok((values, rest.map(|(_, field)| field)))
    }

    /// Returns a refusal at the line of the last field.
    pub(crate) fn refusal(&self, name: &str, value: impl Display, expected: impl Display) -> Refusal {
        Refusal::new(name, value, expected).at(format_args!("line {}", self.line))
    }
}

/// Intensities in candela in planes through the vertical axis, plane by plane: the symmetry that
/// the file states, and ascending angles in degrees, of the planes and from the direction down.
pub(crate) struct Planes<'a> {
    pub(crate) symmetry: &'static str,
    pub(crate) horizontal: Vec<f64>,
    pub(crate) vertical: Vec<f64>,
    pub(crate) candela: (Vec<f64>, Option<&'a str>),
}

impl Planes<'_> {
    /// Returns the light with the first name that is not empty and the mean of the planes as curve.
    /// For a light that shines up, half angles are from the vertical angle 180.
    ///
    /// A light with a plane that is farther off the mean than `reading` takes has all its planes.
    ///
    /// # Errors
    /// No light, no vertical angle at the axis, or planes that are no whole, half or quarter of a circle.
    pub(crate) fn light(
        &self,
        names: &[&str],
        mut notes: Vec<String>,
        reading: Reading,
    ) -> Result<Photometry, Refusal> {
        let (first, last) = (self.vertical[0], self.vertical[self.vertical.len() - 1]);
        let refusal = |expected| Refusal::new("vertical angles", format_args!("{first} to {last}"), expected);
        if first != 0.0 && (first, last) != (90.0, 180.0) {
            return Err(refusal("0 to 90, 0 to 180, or 90 to 180 (type C)"));
        }
        let (candela, rest) = &self.candela;
        notes.extend(rest.map(not_read));
        let mut mean = vec![0.0; self.vertical.len()];
        for (weight, plane) in weights(&self.horizontal).zip(candela.chunks(mean.len())) {
            mean.iter_mut().zip(plane).for_each(|(mean, candela)| *mean += weight * candela);
        }
        let mut points: Vec<_> = self.vertical.iter().copied().zip(mean).collect();
        // In reverse, because the last of equal ones counts.
        let peak = points.iter().rev().copied().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
        if peak.1 == 0.0 {
            return Err(Refusal::new("intensities", "0 cd at every angle", "a light"));
        }
        let size = points.len();
        let difference = |at: &usize| (candela[*at] - points[at % size].1).abs() / peak.1;
        let worst = (0..candela.len()).max_by(|a, b| difference(a).total_cmp(&difference(b))).unwrap_or(0);
        let difference = difference(&worst);
        if 255.0 * difference > ROUND {
            let (plane, angle) = (self.horizontal[worst / size] % 360.0, self.vertical[worst % size]);
            let differs = format!(
                "the horizontal plane {plane} differs from the mean of the planes by {} at the vertical angle {angle}",
                of_peak(difference)
            );
            if let Some(refusal) = refused(self.symmetry, difference, &differs, reading) {
                let Some(sphere) = Sphere::new(&self.horizontal, &self.vertical, candela) else {
                    return Err(refusal);
                };
                let shape = Shape::Planes(sphere, refusal);
                return Ok(Photometry { name: first_name(names), shape, kelvin: None, notes });
            }
            notes.push(format!("The light is taken as round: {differs}."));
        }
        if last == 180.0 && (first == 90.0 || peak.0 > 90.0) {
            notes.push("The light shines up: half angles are from the vertical angle 180.".to_owned());
            points = points.into_iter().rev().map(|(angle, candela)| (180.0 - angle, candela)).collect();
            points.dedup_by_key(|point| point.0);
        }
        let curve = Curve::new(points).ok_or_else(|| refusal("ascending angles"))?;
        let shape = Shape::Round(curve, difference);
        Ok(Photometry { name: first_name(names), shape, kelvin: None, notes })
    }
}

/// Intensities in candela at horizontal and vertical angles, in degrees from -90 to 90, about a horizontal or a vertical
/// pole: the types B and A. `candela` has all vertical angles of a horizontal one, one after the other.
pub(crate) struct Across<'a> {
    pub(crate) goniometer: Goniometer,
    pub(crate) horizontal: Vec<f64>,
    pub(crate) vertical: Vec<f64>,
    pub(crate) candela: (Vec<f64>, Option<&'a str>),
}

impl Across<'_> {
    /// Returns the light with the first name that is not empty: with its intensities in all directions, or with their mean
    /// about the axis as curve if none is farther off the mean than `reading` takes.
    ///
    /// # Errors
    /// No light, or angles of which the first one is over 0.
    pub(crate) fn light(
        &self,
        names: &[&str],
        mut notes: Vec<String>,
        reading: Reading,
    ) -> Result<Photometry, Refusal> {
        for (name, angles) in [("horizontal angles", &self.horizontal), ("vertical angles", &self.vertical)] {
            let (first, last) = (angles[0], angles[angles.len() - 1]);
            if angles.len() < 2 || first > 0.0 {
                let found = format_args!("{first} to {last}");
                return Err(Refusal::new(
                    name,
                    found,
                    "-90 to 90, or 0 to 90 of a light that is the same on both sides",
                ));
            }
        }
        let (candela, rest) = &self.candela;
        notes.extend(rest.map(not_read));
        let sphere = Sphere::across(self.goniometer, [&self.horizontal, &self.vertical], candela);
        let sphere = sphere.ok_or_else(|| Refusal::new("intensities", "0 cd at every angle", "a light"))?;
        let (points, [difference, angle, about]) = sphere.mean();
        let peak = points.iter().fold(0.0, |peak: f64, point| peak.max(point.1));
        let difference = difference / peak;
        if 255.0 * difference > ROUND {
            let differs = format!(
                "the direction {angle} degrees off the axis, {about} about it, differs from the mean about the axis by {}",
                of_peak(difference)
            );
            let symmetry = if self.horizontal[0] < 0.0 { "none" } else { "bilateral" };
            if let Some(refusal) = refused(symmetry, difference, &differs, reading) {
                let shape = Shape::Planes(sphere, refusal);
                return Ok(Photometry { name: first_name(names), shape, kelvin: None, notes });
            }
            notes.push(format!("The light is taken as round: {differs}."));
        }
        let none = || Refusal::new("intensities", "not finite", "numbers");
        let shape = Shape::Round(Curve::new(points).ok_or_else(none)?, difference);
        Ok(Photometry { name: first_name(names), shape, kelvin: None, notes })
    }
}

/// Returns a difference relative to the peak in words.
fn of_peak(difference: f64) -> String {
    format!("{:.1} of 255 codes ({:.1} % of the peak)", 255.0 * difference, 100.0 * difference)
}

/// Returns the refusal of a light that differs by more than is taken as round.
fn refused(symmetry: &str, difference: f64, differs: &str, reading: Reading) -> Option<Refusal> {
    let expected = format_args!("a light with rotational symmetry; in this one {differs}{}", reading.remedy);
    let is_refused = !reading.is_round && 255.0 * difference > reading.fit;
    is_refused.then(|| Refusal::new("symmetry", symmetry, expected))
}

/// Returns a note of a word behind the last intensity.
fn not_read(word: &str) -> String {
    format!("What follows the last intensity is not read: {word:.40}")
}

impl Photometry {
    /// Returns the curve of a light that is round, and the largest difference of a plane from it.
    ///
    /// # Errors
    /// A light that is not round.
    pub(crate) fn round(&self) -> Result<(&Curve, f64), Refusal> {
        match &self.shape {
            Shape::Round(curve, difference) => Ok((curve, *difference)),
            Shape::Planes(_, refusal) => Err(refusal.clone()),
        }
    }
}

/// Returns the first name that is not empty.
fn first_name(names: &[&str]) -> String {
    (*names.iter().find(|name| !name.is_empty()).unwrap_or(&"")).to_owned()
}

/// Returns the share of each plane in the mean: half the angle to its neighbours, so that planes 0
/// and 360 share one. A circle without a plane 360 closes from its last plane to its first.
fn weights(planes: &[f64]) -> impl Iterator<Item = f64> {
    let turn = planes[planes.len() - 1] - planes[0];
    let gap = if turn > 180.0 || planes.len() == 1 { 360.0 - turn } else { 0.0 };
    let gaps = move || planes.windows(2).map(|pair| pair[1] - pair[0]);
    let before = std::iter::once(gap).chain(gaps());
    let after = gaps().chain(std::iter::once(gap));
    before.zip(after).map(move |(before, after)| (before + after) / (2.0 * (turn + gap)))
}
