//! Polylines over the versine.

/// A knot of a [`Table`](crate::falloff::Table): where a straight line begins that goes on to the next knot,
/// or to the edge.
///
/// [`Table::from_angles`](crate::falloff::Table::from_angles) makes them.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Knot {
    /// The `u` where the line begins, in 65,536ths.
    pub(super) place: u16,
    /// The intensity there, 65,535 being full.
    pub(super) value: u16,
    /// How much the intensity rises over 2^-16 of `u`, with 15 fraction bits.
    pub(super) slope: i32,
}

/// The fraction bits of a slope.
pub(super) const SLOPE_BITS: u32 = 15;

impl Knot {
    /// The knot from a place to an end, both in 65,536ths of `u`, of a line between two values:
    /// rounded to fall or rise a little less, so that a table of them is monotone where its values
    /// are.
    pub(crate) fn line([place, end]: [u32; 2], [value, next]: [u16; 2]) -> Self {
        let rise = i32::from(next) - i32::from(value);
        let width = end.saturating_sub(place).max(1) as i32;
        Self { place: place as u16, value, slope: (rise << SLOPE_BITS) / width }
    }

    /// The knot of a place, a value and a slope of any bits, as generated source writes it.
    pub const fn from_bits(place: u16, value: u16, slope: i32) -> Self {
        Self { place, value, slope }
    }

    /// The place, the value and the slope.
    pub const fn to_bits(self) -> (u16, u16, i32) {
        (self.place, self.value, self.slope)
    }

    /// The place where the line begins.
    pub(crate) fn place(self) -> u32 {
        self.place.into()
    }

    /// How much the line rises over all of `u`.
    pub(crate) fn rise(self) -> f32 {
        self.slope as f32 * (2.0 / 65_535.0)
    }

    /// The `u` where the line begins.
    pub(crate) fn versine(self) -> f32 {
        f32::from(self.place) / 65_536.0
    }

    /// The intensity of the line at a `u`, from 0 to 1.
    pub(crate) fn intensity(self, u: f32) -> f32 {
        (f32::from(self.value) / 65_535.0 + self.rise() * (u - self.versine())).clamp(0.0, 1.0)
    }

    /// The last of the knots whose place is not over this one, in 65,536ths of `u`; a dark one if
    /// there is none.
    #[inline]
    pub(super) fn at(knots: &[Self], place: u32) -> Self {
        let after = knots.partition_point(|knot| u32::from(knot.place) <= place);
        knots.get(after.saturating_sub(1)).copied().unwrap_or_default()
    }
}
