//! The curves between linear light and codes.

/// The linear light of an encoded value: the value, IEC 61966-2-1, or a power of this number of fifths.
#[derive(Clone, Copy, Debug)]
pub enum Transfer {
    Linear,
    Srgb,
    Fifths(u32),
}

/// What seals [`Curve`](super::Curve).
pub trait Encoding {
    const TRANSFER: Transfer;
}

/// Declares the curves with their formulas.
macro_rules! curves {
    ($($(#[$doc:meta])* $name:ident = $formula:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum $name {}

        impl Encoding for $name {
            const TRANSFER: Transfer = $formula;
        }
    )*};
}

curves! {
    /// Codes in proportion to linear light: LEDs, whose mean light is in proportion to their duty.
    Linear = Transfer::Linear;
    /// The sRGB encoding (IEC 61966-2-1): most displays.
    Srgb = Transfer::Srgb;
    /// A power of 2.2, `light = code^2.2`: drivers and panels that apply it to the codes they get.
    Gamma22 = Transfer::Fifths(11);
    /// A power of 2.8, `light = code^2.8`: LED controllers that apply it to the codes they get.
    Gamma28 = Transfer::Fifths(14);
}

/// Returns the linear light of an encoded value in `[0, 1]`, within 1e-15.
///
/// A curve is `x = v^(n/5)`, for sRGB beyond its linear segment with `n = 12`, so `x >= v^(n/5)` is
/// equivalent to `x^5 >= v^n`: a comparison of products. By this comparison a bisection finds the
/// least `x`. The function is evaluated at compile time.
pub(super) const fn linear(transfer: Transfer, value: f64) -> f64 {
    let (base, fifths) = match transfer {
        Transfer::Linear => return value,
        Transfer::Srgb if value <= 12.92 * 0.003_130_8 => return value / 12.92,
        Transfer::Srgb => ((value + 0.055) / 1.055, 12),
        Transfer::Fifths(fifths) => (value, fifths),
    };
    let (mut power, mut factors) = (1.0, 0);
    while factors < fifths {
        power *= base;
        factors += 1;
    }
    // Floats from zero up have the same order as their bits, read as integers.
    let (mut below, mut above) = (0, 1.0_f64.to_bits());
    while above - below > 1 {
        let middle = u64::midpoint(below, above);
        let x = f64::from_bits(middle);
        if x * x * x * x * x >= power { above = middle } else { below = middle }
    }
    f64::from_bits(above)
}
