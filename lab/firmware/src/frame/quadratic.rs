//! Where a line enters something round.

use super::camera::DEPTH_BITS;

/// `a t² - 2 b t + c`, which is the squared distance from something round, less its squared radius,
/// after `t` of a line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadratic {
    pub(super) a: i32,
    pub(super) b: i32,
    pub(super) c: i32,
}

impl Quadratic {
    /// The depth of the nearer root, for coefficients in steps of 2^-20, of a line that goes
    /// through in front of the eye.
    #[inline(always)]
    pub(super) fn depth(self) -> Option<i32> {
        let Self { a, b, c } = self;
        let square = u64::try_from(i64::from(b) * i64::from(b) - i64::from(a) * i64::from(c)).ok()?;
        let dividend = u32::try_from(b).ok()?.saturating_sub(root(square));
        // Nine bits more, for which there is room under eight metres.
        (dividend << 9).checked_div(a.cast_unsigned() >> (DEPTH_BITS - 9)).map(u32::cast_signed)
    }
}

/// The square root, of which the leading 16 bits are right.
#[inline(always)]
fn root(square: u64) -> u32 {
    let surplus = (u64::BITS - square.leading_zeros()).saturating_sub(u32::BITS).next_multiple_of(2);
    ((square >> surplus) as u32).isqrt() << (surplus / 2)
}
