//! Edge profiles: how the intensity falls from the axis to the edge of the cone.
//!
//! Each is a polynomial in `t`, which is 1 on the axis (or within the hotspot) and 0 at the edge and beyond.

use crate::scalar::Scalar;

/// An edge profile: a polynomial in `t` from f(0) = 0 to f(1) = 1, and the figures that design a cone with it.
///
/// The type decides which polynomial is compiled in: there is no branch per point, and a profile that is not
/// named is not linked. [`Edge`] leaves the choice to run time, at the price of that branch.
pub trait Profile: Copy + core::fmt::Debug {
    /// The intensity at `t`, in [0, 1] for `t` in [0, 1].
    fn intensity<S: Scalar>(self, t: S) -> S;

    /// Where half the intensity is left, as a fraction of the outer versine: `u = versine / outer versine`.
    fn beam_versine(self) -> f32;

    /// Where a tenth of the intensity is left, as a fraction of the outer versine.
    fn field_versine(self) -> f32;

    /// The largest slope of the intensity over the angle off axis, in units of the outer half angle: how much an
    /// error of the direction is magnified in a narrow cone.
    fn steepness(self) -> f32;
}

/// The soft edge `t^2` (Hast 2004, section 2): one multiply. It fades into the dark without a visible rim.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Soft;

/// The hard edge `1 - u^2` with `u = 1 - t` (Hast 2004, section 3): one multiply. Flat in the middle, a crisp rim.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Hard;

/// A profile chosen at run time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Edge {
    /// As [`Soft`].
    Soft,
    /// As [`Hard`].
    Hard,
}

impl Profile for Soft {
    #[inline(always)]
    fn intensity<S: Scalar>(self, t: S) -> S {
        t.times(t)
    }

    /// `1 - 1/sqrt(2)`.
    fn beam_versine(self) -> f32 {
        1.0 - core::f32::consts::FRAC_1_SQRT_2
    }

    /// `1 - 1/sqrt(10)`.
    fn field_versine(self) -> f32 {
        0.683_772_2
    }

    /// `8 / (3 sqrt(3))`: the largest slope of `(1 - x^2)^2`.
    fn steepness(self) -> f32 {
        1.539_600_7
    }
}

impl Profile for Hard {
    #[inline(always)]
    fn intensity<S: Scalar>(self, t: S) -> S {
        let u = S::ONE.minus(t);
        S::ONE.minus(u.times(u))
    }

    /// `1/sqrt(2)`.
    fn beam_versine(self) -> f32 {
        core::f32::consts::FRAC_1_SQRT_2
    }

    /// `3/sqrt(10)`.
    fn field_versine(self) -> f32 {
        0.948_683_3
    }

    /// The slope of `1 - x^4` at the edge.
    fn steepness(self) -> f32 {
        4.0
    }
}

impl Profile for Edge {
    #[inline(always)]
    fn intensity<S: Scalar>(self, t: S) -> S {
        match self {
            Self::Soft => Soft.intensity(t),
            Self::Hard => Hard.intensity(t),
        }
    }

    fn beam_versine(self) -> f32 {
        match self {
            Self::Soft => Soft.beam_versine(),
            Self::Hard => Hard.beam_versine(),
        }
    }

    fn field_versine(self) -> f32 {
        match self {
            Self::Soft => Soft.field_versine(),
            Self::Hard => Hard.field_versine(),
        }
    }

    fn steepness(self) -> f32 {
        match self {
            Self::Soft => Soft.steepness(),
            Self::Hard => Hard.steepness(),
        }
    }
}
