//! Measured intensities over the angle off the axis, and what a data sheet says of them.

use std::f64::consts::PI;

/// Intensities over the angle off the axis, with lines between them.
#[derive(Clone, PartialEq, Debug)]
pub struct Curve {
    /// Half angles in degrees, ascending from 0 to at most 180, and intensities in candela.
    points: Vec<(f64, f64)>,
}

/// Which intensity the 50 % and the 10 % of beam and field angle are taken of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Definition {
    /// Of the largest intensity (ANSI/IES LM-63 and data sheets in America).
    Ies,
    /// Of the intensity on the axis (CIE 43).
    Cie,
}

impl Curve {
    /// Creates a curve of at least two points from half angles in degrees, strictly ascending, and
    /// intensities of at least 0; `None` for others. A first angle over 0 is the end of a line from the
    /// same intensity on the axis.
    pub fn new(mut points: Vec<(f64, f64)>) -> Option<Self> {
        let first = *points.first()?;
        if first.0 > 0.0 {
            points.insert(0, (0.0, first.1));
        }
        let ascending = points.windows(2).all(|pair| pair[0].0 < pair[1].0);
        let good = points
            .iter()
            .all(|&(angle, candela)| (0.0..=180.0).contains(&angle) && (0.0..=1e12).contains(&candela));
        (points.len() >= 2 && ascending && good).then_some(Self { points })
    }

    /// Returns the points: half angles in degrees, and intensities in candela.
    pub fn points(&self) -> &[(f64, f64)] {
        &self.points
    }

    /// Returns the intensity at a half angle in degrees; 0 behind the last point.
    pub fn at(&self, angle: f64) -> f64 {
        let next = self.points.partition_point(|point| point.0 < angle);
        match (next.checked_sub(1).map(|before| self.points[before]), self.points.get(next)) {
            // At its end a line has its value, and rounding leaves it neither there nor below 0.
            (Some(_), Some(&(b, to))) if angle >= b => to,
            (Some((a, from)), Some(&(b, to))) => from + (to - from) * ((angle - a) / (b - a)),
            (None, Some(&(_, first))) => first,
            (_, None) => 0.0,
        }
    }

    /// Returns the largest intensity and its half angle in degrees.
    pub fn peak(&self) -> (f64, f64) {
        let largest =
            |a: (f64, f64), &(angle, candela): &(f64, f64)| if candela > a.0 { (candela, angle) } else { a };
        self.points.iter().fold((0.0, 0.0), largest)
    }

    /// Returns the full angle in degrees of the last place at which the intensity is this share of the
    /// reference; `None` without light.
    pub fn angle(&self, share: f64, definition: Definition) -> Option<f64> {
        let reference = match definition {
            Definition::Ies => self.peak().0,
            Definition::Cie => self.points[0].1,
        };
        let level = share * reference;
        if reference <= 0.0 {
            return None;
        }
        let last = self.points.iter().rposition(|point| point.1 >= level)?;
        let (a, from) = self.points[last];
        let half = match self.points.get(last + 1) {
            Some(&(b, to)) => a + (b - a) * (from - level) / (from - to),
            None => a,
        };
        Some(2.0 * half)
    }

    /// Returns the luminous flux in lumens: the exact integral over the sphere.
    pub fn lumens(&self) -> f64 {
        let cell = |pair: &[(f64, f64)]| {
            let [(a, from), (b, to)] =
                [pair[0], pair[1]].map(|(degrees, candela)| (degrees.to_radians(), candela));
            let slope = (to - from) / (b - a);
            // The antiderivative of `(from + slope (x - a)) sin x`.
            let at = |x: f64| slope * x.sin() - (from + slope * (x - a)) * x.cos();
            at(b) - at(a)
        };
        2.0 * PI * self.points.windows(2).map(cell).sum::<f64>()
    }

    /// Returns the last half angle in degrees at which there is light.
    pub fn end(&self) -> f64 {
        let last = self.points.iter().rposition(|point| point.1 > 0.0).map_or(0, |last| last + 1);
        self.points[last.min(self.points.len() - 1)].0
    }
}
