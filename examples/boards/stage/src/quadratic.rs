//! Where a line enters a round object.

use super::camera::DEPTH_BITS;

/// The polynomial `a t² - 2 b t + c`: at the parameter `t` of a line, the squared distance from the
/// centre of a round object minus its squared radius.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadratic {
    pub(super) a: i32,
    pub(super) b: i32,
    pub(super) c: i32,
}

impl Quadratic {
    /// The depth of the nearer root, or `None` if the line misses the object or meets it behind the
    /// eye. The coefficients are in steps of 2^-20.
    #[inline(always)]
    pub(super) fn depth(self) -> Option<i32> {
        let Self { a, b, c } = self;
        let square = u64::try_from(i64::from(b) * i64::from(b) - i64::from(a) * i64::from(c)).ok()?;
        let dividend = u32::try_from(b).ok()?.saturating_sub(root(square));
        // The quotient has nine more bits, which fit as long as depths are below eight metres.
        (dividend << 9).checked_div(a.cast_unsigned() >> (DEPTH_BITS - 9)).map(u32::cast_signed)
    }
}

/// The square root, exact in its leading 16 bits.
#[inline(always)]
fn root(square: u64) -> u32 {
    let surplus = (u64::BITS - square.leading_zeros()).saturating_sub(u32::BITS).next_multiple_of(2);
    ((square >> surplus) as u32).isqrt() << (surplus / 2)
}
