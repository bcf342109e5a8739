//! Measured profiles.

use super::{Curve, Profile, without_coefficients};
use crate::{
    angle::Angle,
    error::{Accepted, Error, Parameter},
    scalar::{Fraction, Scalar},
    trig,
};

/// A table of measured intensities, with linear interpolation: two multiplies.
///
/// The samples are evenly spaced in the **versine** of the angle off axis, from the axis (or the rim of the hotspot)
/// to the edge: sample `i` of `n` stands at `u = i / (n - 1)`. So a place in the table is a multiply away from
/// `u`, and no trigonometry happens per point. Data that are evenly spaced in the angle, as goniometers give
/// them, are resampled once by [`Table::from_angles`].
///
/// 65,535 is full intensity, whatever the number format. A table need not begin at full intensity, end at none or be
/// monotone; beyond its last sample it is dark. Beam and field are where it falls to half and a tenth of *full*
/// intensity for the last time.
///
/// ```
/// use luminaire::{Angle, Cone, Table};
/// // Every ten degrees off axis, up to 40: the intensities as the data sheet has them.
/// let mut samples = [0; 64];
/// let table = Table::from_angles(&[1.0, 0.93, 0.61, 0.18, 0.0], Angle::degrees(80.0), &mut samples)?;
/// let cone = Cone::from_outer(table, Angle::degrees(80.0))?;
/// assert!((cone.beam().to_degrees() - 45.0).abs() < 1.0);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Table<'a> {
    samples: &'a [u16],
}

/// What counts as full intensity.
const FULL: f32 = 65_535.0;

impl<'a> Table<'a> {
    /// The table of these samples.
    ///
    /// # Errors
    /// Fewer than 2 samples, or more than 65,536.
    pub fn new(samples: &'a [u16]) -> Result<Self, Error> {
        check_count(samples.len())?;
        Ok(Self { samples })
    }

    /// The table of samples that are known when the program is compiled, from 2 to 65,536 of them.
    pub const fn of<const N: usize>(samples: &'a [u16; N]) -> Self {
        const { assert!(N >= 2 && N <= 65_536, "a table has 2 to 65,536 samples") };
        Self { samples }
    }

    /// Resamples intensities that are evenly spaced in the angle, from the axis to the outer angle, into `samples`,
    /// which are evenly spaced in the versine. 1 is full intensity. For a cone without a hotspot of that outer angle.
    ///
    /// Linear interpolation over the angle becomes linear interpolation over the versine between more points; near
    /// the axis, where the versine hardly grows with the angle, a sample stands for a larger step of the angle: `k`
    /// samples have their first off the axis at about `1 / sqrt(k - 1)` of the outer half angle.
    ///
    /// # Errors
    /// Fewer than 2 measured values or samples, more than 65,536, a measured value outside [0, 1], or an outer angle
    /// that is not more than 0 and at most 180 degrees.
    pub fn from_angles(
        measured: &[f32],
        outer: impl Into<Angle>,
        samples: &'a mut [u16],
    ) -> Result<Self, Error> {
        check_count(measured.len())?;
        check_count(samples.len())?;
        let outer = outer.into();
        if !(outer > Angle::degrees(0.0) && outer <= Angle::degrees(180.0)) {
            let accepted = Accepted::AngleUpTo(180.0);
            return Err(Error { parameter: Parameter::OuterAngle, value: outer.to_degrees(), accepted });
        }
        if let Some(&value) = measured.iter().find(|value| !(0.0..=1.0).contains(*value)) {
            return Err(Error { parameter: Parameter::Sample, value, accepted: Accepted::Between(0.0, 1.0) });
        }
        let last = (samples.len() - 1) as f32;
        for (i, sample) in samples.iter_mut().enumerate() {
            let angle = Angle::from_versine(outer.versine() * (i as f32 / last));
            let place = angle.to_degrees() / outer.to_degrees() * (measured.len() - 1) as f32;
            *sample = (interpolated(measured, place) * FULL + 0.5) as u16;
        }
        Ok(Self { samples })
    }

    /// The samples, from the axis to the edge.
    pub fn samples(self) -> &'a [u16] {
        self.samples
    }

    /// The segments from the axis to the edge: each with the `u` where it begins, and its two intensities.
    fn segments(self) -> impl DoubleEndedIterator<Item = (f32, f32, f32)> {
        let width = self.width();
        let pairs = self.samples.windows(2).enumerate();
        pairs.map(move |(i, pair)| (i as f32 * width, f32::from(pair[0]) / FULL, f32::from(pair[1]) / FULL))
    }

    /// How much of `u` a segment takes.
    fn width(self) -> f32 {
        1.0 / (self.samples.len() - 1) as f32
    }

    /// The last `u` with this intensity; 1 where the table ends above it, 0 where it is always below.
    fn versine_of(self, intensity: f32) -> f32 {
        for (start, from, to) in self.segments().rev() {
            if to >= intensity {
                return start + self.width();
            }
            if from >= intensity {
                return start + self.width() * (from - intensity) / (from - to);
            }
        }
        0.0
    }
}

fn check_count(count: usize) -> Result<(), Error> {
    if (2..=65_536).contains(&count) {
        Ok(())
    } else {
        let accepted = Accepted::Between(2.0, 65_536.0);
        Err(Error { parameter: Parameter::SampleCount, value: count as f32, accepted })
    }
}

/// The value at a place between those of a slice; from its last one on, the last.
fn interpolated(values: &[f32], place: f32) -> f32 {
    let index = place as usize;
    let at = |index| values.get(index).or(values.last()).copied().unwrap_or_default();
    let (here, next) = (at(index), at(index + 1));
    here + (next - here) * (place - index as f32)
}

impl Profile for Table<'_> {
    without_coefficients!();

    fn beam_versine(self) -> f32 {
        self.versine_of(0.5)
    }

    fn field_versine(self) -> f32 {
        self.versine_of(0.1)
    }

    /// The largest slope of its segments, each taken where it is widest, and at least that of a step.
    fn steepness(self, hotspot: f32) -> f32 {
        let (span, width) = (1.0 - hotspot, self.width());
        self.segments().fold(1.0, |largest, (start, from, to)| {
            let versine = hotspot + (start + width) * span;
            let slope = 2.0 * ((to - from) / width).abs() * trig::sqrt(versine) / span;
            if slope > largest { slope } else { largest }
        })
    }

    fn integral(self, u: f32) -> f32 {
        let width = self.width();
        self.segments().fold(0.0, |sum, (start, from, to)| {
            let part = ((u - start) / width).clamp(0.0, 1.0);
            sum + width * part * (from + (to - from) * part / 2.0)
        })
    }
}

impl<S: Scalar> Curve<S> for Table<'_> {
    #[inline(always)]
    fn intensity(self, t: S::Fraction) -> S {
        // A table may end above zero: the edge is dark all the same.
        if t.step() > S::ZERO { t.sample(self.samples) } else { S::ZERO }
    }
}
