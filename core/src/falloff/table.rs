//! Measured falloffs.

mod measured;

use self::measured::Measured;
use core::fmt::{self, Formatter};

use super::{CompiledFalloff, Falloff, Formula};
use crate::{
    angle::{Angle, IntoAngle},
    error::{Error, Expected, Parameter},
    model::{Model, Number},
    models::SAMPLES,
    number::{Fraction, Knot, Scalar},
    source::Source,
    trig,
};

/// A table of measured intensities with linear interpolation over the **versine** of the angle off
/// axis.
///
/// A table spans the falloff from the axis (or the inner angle) to the edge and needs no
/// trigonometry per point. The samples are either evenly spaced over the versine or [`Knot`]s:
///
/// - evenly spaced, sample `i` of `n` at `u = i / (n - 1)`: two multiplies, one of which finds the
///   position in the table;
/// - knots, closer together where the curve bends: `log2 n` comparisons and one multiply.
///
/// [`Table::from_angles`] converts goniometric data, which are evenly spaced in the angle, to
/// knots.
///
/// 65,535 is full intensity in every number format. A table need not start at full intensity, end
/// at 0 or be monotone. From the outer angle on the intensity is 0. Beam and field angle are the
/// largest angles at which the intensity reaches 50 % and 10 % of *full* intensity.
///
/// ```
/// use luminaire::{Angle, Cone, falloff::{Knot, Table}};
/// // Every ten degrees off axis, up to 40: the intensities as the data sheet has them.
/// let mut knots = [Knot::default(); 32];
/// let (table, difference) = Table::from_angles(&[1.0, 0.93, 0.61, 0.18, 0.0], Angle::degrees(80.0), &mut knots)?;
/// assert!(difference < 0.5 / 255.0);
/// let cone = Cone::from_outer(table, Angle::degrees(80.0))?;
/// assert!((cone.beam().to_degrees() - 45.0).abs() < 1.0);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Table<'a> {
    samples: Samples<'a>,
}

#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Samples<'a> {
    Even(&'a [u16]),
    Knots(&'a [Knot]),
}

/// The sample value of full intensity.
const FULL: f32 = 65_535.0;

impl<'a> Table<'a> {
    /// Creates a table of evenly spaced samples over the versine.
    ///
    /// # Errors
    /// Fewer than 2 samples, or more than 65,536.
    pub fn new(samples: &'a [u16]) -> Result<Self, Error> {
        check_count(samples.len(), 2)?;
        Ok(Self { samples: Samples::Even(samples) })
    }

    /// Creates a table of 2 to 65,536 evenly spaced samples that are known at compile time.
    pub const fn of<const N: usize>(samples: &'a [u16; N]) -> Self {
        const { assert!(N >= 2 && N <= 65_536, "a table has 2 to 65,536 samples") };
        Self { samples: Samples::Even(samples) }
    }

    /// Creates a table of 1 to 65,536 knots that are known at compile time. If the positions of the
    /// knots are not ascending, the intensity is unspecified, but still in [0, 1].
    pub const fn of_knots<const N: usize>(knots: &'a [Knot; N]) -> Self {
        const { assert!(N >= 1 && N <= 65_536, "a table has 1 to 65,536 knots") };
        Self { samples: Samples::Knots(knots) }
    }

    /// Creates a table of knots. If the positions of the knots are not ascending, the intensity is
    /// unspecified, but still in [0, 1].
    ///
    /// # Errors
    /// No knot, or more than 65,536.
    pub fn from_knots(knots: &'a [Knot]) -> Result<Self, Error> {
        check_count(knots.len(), 1)?;
        Ok(Self { samples: Samples::Knots(knots) })
    }

    /// Creates a table from intensities that are evenly spaced in the angle, from the axis to the
    /// outer angle.
    ///
    /// Between these angles the intensities are interpolated linearly; 1 is full intensity. Use the
    /// table in a cone with this outer angle and without a hotspot. The function adds knots only
    /// while they reduce the difference between table and data, and places each knot where the
    /// difference is largest.
    ///
    /// The function also returns an upper bound of the difference between table and data, in units
    /// of full intensity. The bound does not include the rounding errors of a number format.
    /// Positions of knots are multiples of 2^-16 of the outer versine. For an outer angle of 180
    /// degrees, 2^-16 is a third of a degree next to the axis.
    ///
    /// # Errors
    /// Fewer than 2 measured values, no knot, more than 65,536 of either, a measured value outside
    /// [0, 1], or an outer angle outside (0, 180] degrees.
    pub fn from_angles(
        measured: &[f32],
        outer: impl IntoAngle,
        knots: &'a mut [Knot],
    ) -> Result<(Self, f32), Error> {
        check_count(measured.len(), 2)?;
        check_count(knots.len(), 1)?;
        let outer = outer.into_angle();
        if !(outer > Angle::degrees(0.0) && outer <= Angle::degrees(180.0)) {
            let accepted = Expected::AngleUpTo(180.0);
            return Err(Error { parameter: Parameter::OuterAngle, value: outer.to_degrees(), accepted });
        }
        if let Some(&value) = measured.iter().find(|value| !(0.0..=1.0).contains(*value)) {
            return Err(Error { parameter: Parameter::Sample, value, accepted: Expected::Between(0.0, 1.0) });
        }
        let (knots, difference) = Measured::new(measured, outer).resample(knots);
        Ok((Self { samples: Samples::Knots(knots) }, difference))
    }

    /// Returns the evenly spaced samples, from the axis to the edge; empty for a table of knots.
    pub fn samples(self) -> &'a [u16] {
        match self.samples {
            Samples::Even(samples) => samples,
            Samples::Knots(_) => &[],
        }
    }

    /// Returns the knots, from the axis to the edge; empty for a table of evenly spaced samples.
    pub fn knots(self) -> &'a [Knot] {
        match self.samples {
            Samples::Even(_) => &[],
            Samples::Knots(knots) => knots,
        }
    }

    /// Returns the segments from the axis to the edge.
    fn segments(self) -> impl DoubleEndedIterator<Item = Segment> {
        (0..self.samples().len().saturating_sub(1) + self.knots().len()).filter_map(move |i| self.segment(i))
    }

    fn segment(self, i: usize) -> Option<Segment> {
        match self.samples {
            Samples::Even(samples) => {
                let [start, end] = [i, i + 1].map(|i| i as f32 / (samples.len() - 1) as f32);
                let (from, to) = (f32::from(*samples.get(i)?) / FULL, f32::from(*samples.get(i + 1)?) / FULL);
                Some(Segment { start, end, from, to })
            }
            Samples::Knots(knots) => {
                let (knot, end) = (knots.get(i)?, knots.get(i + 1).map_or(1.0, |next| next.versine()));
                let start = knot.versine();
                Some(Segment { start, end, from: knot.intensity(start), to: knot.intensity(end) })
            }
        }
    }

    /// Returns the largest `u` with this intensity.
    ///
    /// The result is 1 if the table ends above this intensity, and 0 if the whole table is below
    /// this intensity.
    fn versine_of(self, intensity: f32) -> f32 {
        for Segment { start, end, from, to } in self.segments().rev() {
            if to >= intensity {
                return end;
            }
            if from >= intensity {
                return start + (end - start) * (from - intensity) / (from - to);
            }
        }
        0.0
    }
}

/// A straight line between two values of `u`, given by the intensities at both ends.
struct Segment {
    start: f32,
    end: f32,
    from: f32,
    to: f32,
}

fn check_count(count: usize, least: u16) -> Result<(), Error> {
    if (least.into()..=65_536).contains(&count) {
        Ok(())
    } else {
        let accepted = Expected::WholeBetween(least.into(), 65_536);
        Err(Error { parameter: Parameter::SampleCount, value: count as f32, accepted })
    }
}

/// A table has samples and no numbers.
impl Model for Table<'static> {
    #[cfg(feature = "arithmetic")]
    const TYPE: &'static str = "Table";
    const NUMBERS: &'static [Number] = &[];

    fn of(_: &[f32]) -> Result<Self, Error> {
        Ok(Self::of(&SAMPLES))
    }

    #[cfg(feature = "arithmetic")]
    fn number(&self, _: usize) -> Option<f32> {
        None
    }
}

impl Source for Table<'_> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        if self.knots().is_empty() {
            return write!(out, "Table::of(&{:?})", self.samples());
        }
        // The reference to a call's result is `'static` only inside a `const` block.
        out.write_str("Table::of_knots(const { &[")?;
        for (place, value, slope) in self.knots().iter().map(|knot| knot.to_bits()) {
            write!(out, "Knot::from_bits({place}, {value}, {slope}), ")?;
        }
        out.write_str("] })")
    }
}

impl Falloff for Table<'_> {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        match self.samples {
            Samples::Even(samples) => Formula::Samples(samples),
            Samples::Knots(knots) => Formula::Knots(knots),
        }
    }

    fn beam_versine(self) -> f32 {
        self.versine_of(0.5)
    }

    fn field_versine(self) -> f32 {
        self.versine_of(0.1)
    }

    /// Returns the largest derivative of the segments, and at least the steepness of a step.
    ///
    /// The derivative of each segment is evaluated at the segment's outer end.
    fn steepness(self, hotspot: f32) -> f32 {
        let span = 1.0 - hotspot;
        self.segments().fold(1.0, |largest, Segment { start, end, from, to }| {
            let versine = hotspot + end * span;
            let slope = 2.0 * ((to - from) / (end - start)).abs() * trig::sqrt(versine) / span;
            if slope > largest { slope } else { largest }
        })
    }

    fn integral(self, u: f32) -> f32 {
        self.segments().fold(0.0, |sum, Segment { start, end, from, to }| {
            let part = ((u - start) / (end - start)).clamp(0.0, 1.0);
            sum + (end - start) * part * (from + (to - from) * part / 2.0)
        })
    }
}

impl<S: Scalar> CompiledFalloff<S> for Table<'_> {
    #[inline(always)] // `table.f32` on Cortex-M0: +78 instructions without.
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        // A table may end above zero, but the intensity at the edge is 0.
        if t.step() > F::Value::default() {
            match self.samples {
                Samples::Even(samples) => t.sample(samples),
                Samples::Knots(knots) => t.sample_knots(knots),
            }
        } else {
            F::Value::default()
        }
    }
}

#[cfg(all(test, feature = "libm"))]
mod tests {
    use super::*;

    #[test]
    fn formula_of_too_few_samples_is_finite() {
        for samples in [&[][..], &[65_535]] {
            let table = Table { samples: Samples::Even(samples) };
            assert!(
                table.formula().exact(0.5).is_finite(),
                "{samples:?}, expected table.formula().exact(0.5).is_finite()"
            );
        }
    }
}
