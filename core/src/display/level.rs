//! Linear codes: multiplication by the last code, without a table.

use crate::number::{Word, float::clamp};

/// Returns the code of up to 16 bits nearest to a linear value clamped to `[0, 1]`: the exact value
/// times `2^bits - 1`, rounded to nearest, ties up.
#[inline]
pub(super) fn nearest(linear: Word, bits: u32) -> u16 {
    match linear {
        Word::Single(linear) => {
            let value = clamp(linear);
            // Exact, as a product with a power of two. The code is this one or, because the value
            // times `2^bits - 1` is `scaled - value`, the one below. The difference is exact
            // (Sterbenz's lemma, and by its bits for code 1), so the comparison does not round.
            let scaled = value * (1_u32 << bits) as f32;
            let code = (scaled + 0.5) as u32;
            let is_below = scaled - (code as f32 - 0.5) < value;
            code.saturating_sub(is_below.into()) as u16
        }
        #[cfg(feature = "fixed")]
        Word::Steps14(linear) => {
            let linear = u32::from(linear.clamp(0, 1 << 14) as u16);
            ((linear << bits) - linear + (1 << 13) >> 14) as u16
        }
        #[cfg(feature = "fixed")]
        Word::Steps30(linear) => {
            let linear = u64::from(linear.clamp(0, 1 << 30) as u32);
            ((linear << bits) - linear + (1 << 29) >> 30) as u16
        }
    }
}

/// Returns a linear value clamped to `[0, 1]` times `2^bits - 1`, in units of 2^-16, for up to 16
/// bits: exact for values in units of 2^-14, else rounded up, so that only zero becomes zero.
#[inline]
pub(super) fn fine(linear: Word, bits: u32) -> u32 {
    let steps30 = match linear {
        Word::Single(linear) => {
            let steps = clamp(linear) * (1_u32 << 30) as f32;
            let whole = steps as u32;
            whole + u32::from((whole as f32) < steps)
        }
        #[cfg(feature = "fixed")]
        Word::Steps14(linear) => {
            let linear = u32::from(linear.clamp(0, 1 << 14) as u16);
            return (linear << bits) - linear << 2;
        }
        #[cfg(feature = "fixed")]
        Word::Steps30(linear) => linear.clamp(0, 1 << 30) as u32,
    };
    let linear = u64::from(steps30);
    ((linear << bits) - linear + 0x3fff >> 14) as u32
}
