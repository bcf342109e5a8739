//! The falloffs of tools over the angle.

use crate::versine::versine;

/// A falloff of tools over the angle, between an inner and an outer half angle.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Family {
    /// Smoothstep in the cosine.
    SmoothCosine,
    /// The square of a line in the cosine, which is divided by at least `least`, between half angles in radians that
    /// are at least `apart`.
    SquareCosine { least: f64, apart: f64 },
    /// Smoothstep in the angle.
    SmoothAngle,
    /// `1 - u^p` with the versine `u` of at least `least`.
    Inverted { least: f64 },
    /// A power of the cosine, cut off.
    Cosine,
    /// A power of a line in the cosine.
    Power,
}

/// The narrowest half angle in radians.
pub(crate) const NARROWEST: f64 = 1e-5;

/// Outer and inner half angle in radians, and an exponent.
pub(crate) type Free = [f64; 3];

impl Family {
    pub(crate) fn has_inner(self) -> bool {
        !matches!(self, Self::Inverted { .. } | Self::Cosine)
    }

    pub(crate) fn has_exponent(self) -> bool {
        matches!(self, Self::Inverted { .. } | Self::Cosine | Self::Power)
    }

    /// Returns the parameters of a step at a half angle in radians; `None` for a family without one.
    pub(crate) fn step(self, end: f64) -> Option<Free> {
        match self {
            Self::SmoothCosine | Self::SmoothAngle | Self::Power => Some([end, end, 1.0]),
            Self::Cosine => Some([end, 0.0, 0.0]),
            Self::SquareCosine { .. } | Self::Inverted { .. } => None,
        }
    }

    /// Returns by how much the outer half angle in radians exceeds the inner one at least.
    pub(crate) fn apart(self) -> f64 {
        if let Self::SquareCosine { apart, .. } = self { apart } else { 0.0 }
    }

    /// Returns whether the falloff has these parameters, up to a widest half angle.
    pub(crate) fn accepts(self, [outer, inner, exponent]: Free, widest: f64) -> bool {
        let exponents = match self {
            Self::Inverted { .. } => 1.0 / 64.0..=64.0,
            Self::Cosine => 0.0..=128.0,
            _ => 1e-3..=64.0,
        };
        (NARROWEST..=widest).contains(&outer)
            && ((0.0..outer).contains(&inner) || self.step(outer) == Some([outer, inner, exponent]))
            && outer - inner >= self.apart()
            && exponents.contains(&exponent)
    }

    /// Returns the share of the intensity that the tool shows on the axis.
    pub(crate) fn on_axis(self, [outer, inner, exponent]: Free) -> f64 {
        match self {
            Self::SquareCosine { least, .. } => {
                (versine(outer) / (versine(outer) - versine(inner)).max(least)).min(1.0).powi(2)
            }
            Self::Inverted { least } => 1.0 - least.powf(exponent),
            _ => 1.0,
        }
    }

    /// Returns the intensity at a half angle in radians, as a share of that on the axis.
    pub(crate) fn at(self, free: Free, angle: f64) -> f64 {
        let [outer, inner, exponent] = free;
        if angle >= outer {
            return 0.0;
        }
        if inner == outer {
            return 1.0;
        }
        let (v, from, to) = (versine(angle), versine(inner), versine(outer));
        let t = ((to - v) / (to - from)).clamp(0.0, 1.0);
        match self {
            Self::SmoothCosine => t * t * (3.0 - 2.0 * t),
            Self::SquareCosine { least, .. } => {
                ((to - v) / (to - from).max(least)).min(1.0).powi(2) / self.on_axis(free)
            }
            Self::SmoothAngle => {
                let t = ((outer - angle) / (outer - inner)).clamp(0.0, 1.0);
                t * t * (3.0 - 2.0 * t)
            }
            Self::Inverted { least } => (1.0 - (v / to).max(least).powf(exponent)) / self.on_axis(free),
            Self::Cosine => angle.cos().powf(exponent),
            Self::Power => t.powf(exponent),
        }
    }
}
