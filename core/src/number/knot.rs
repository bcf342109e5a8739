//! Knots: starts of the straight lines of a table.

/// A knot of a [`Table`](crate::falloff::Table): the start of a straight line of intensity over
/// `u`.
///
/// `u` is 0 on the axis and 1 at the edge of the cone. The line ends at the next knot or, after the
/// last knot, at the edge. [`Table::from_angles`](crate::falloff::Table::from_angles) makes knots.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Knot {
    /// The argument `u` at which this line segment of the curve starts, in units of 1/65,536.
    pub(super) place: u16,
    /// The intensity at the start of the line; 65,535 is full intensity.
    pub(super) value: u16,
    /// Increase of `value` per unit of `place`, with 15 fraction bits; negative on a falling line.
    pub(super) slope: i32,
}

/// Number of fraction bits of the slope of a knot.
pub(super) const SLOPE_BITS: u32 = 15;

impl Knot {
    /// Returns the knot of the line from `value` at `place` to `next` at `end`. `place` and `end`
    /// are in units of 1/65,536 of `u`.
    ///
    /// The slope is rounded towards zero, so that a table with monotone values is monotone.
    pub fn line([place, end]: [u32; 2], [value, next]: [u16; 2]) -> Self {
        let rise = i32::from(next) - i32::from(value);
        let width = end.saturating_sub(place).max(1) as i32;
        Self { place: place as u16, value, slope: (rise << SLOPE_BITS) / width }
    }

    /// Builds a knot from the position, the intensity and the slope of its line.
    ///
    /// The position and the intensity are those of the start of the line, the position in units of
    /// 1/65,536 of `u`.
    ///
    /// Any bits are accepted. Generated source calls this function.
    pub const fn from_bits(place: u16, value: u16, slope: i32) -> Self {
        Self { place, value, slope }
    }

    /// Returns the start of the line (in 1/65,536 of `u`), the intensity at the start and the
    /// slope.
    pub const fn to_bits(self) -> (u16, u16, i32) {
        (self.place, self.value, self.slope)
    }

    /// Returns the argument `u` at which this line segment of the curve starts, in units of 1/65,536.
    pub(crate) fn start(self) -> u32 {
        self.place.into()
    }

    /// Returns the derivative of the intensity with respect to `u`.
    pub(crate) fn rise(self) -> f32 {
        self.slope as f32 * (2.0 / 65_535.0)
    }

    /// Returns the `u` at which the line starts.
    pub(crate) fn versine(self) -> f32 {
        f32::from(self.place) / 65_536.0
    }

    /// Returns the intensity of the line at `u`, in `[0, 1]`.
    pub(crate) fn intensity(self, u: f32) -> f32 {
        (f32::from(self.value) / 65_535.0 + self.rise() * (u - self.versine())).clamp(0.0, 1.0)
    }

    /// Returns the last knot that starts at or before `place`, in units of 1/65,536 of `u`.
    ///
    /// Returns the first knot if all knots start later, and a knot of intensity 0 if there are
    /// none.
    #[inline]
    pub(super) fn at(knots: &[Self], place: u32) -> Self {
        let after = knots.partition_point(|knot| u32::from(knot.place) <= place);
        knots.get(after.saturating_sub(1)).copied().unwrap_or_default()
    }
}

/// Returns a sample and its successor; the last sample is its own successor.
#[inline]
pub(super) fn neighbours(samples: &[u16], index: usize) -> (u16, u16) {
    let here = samples.get(index).copied().unwrap_or(0);
    (here, samples.get(index + 1).copied().unwrap_or(here))
}
