//! The constants of compiled lights, and the tables of the kernel, for generators of source in other
//! languages.

use crate::{
    attenuation::Attenuation,
    falloff::Falloff,
    number::Scalar,
    shade::{CompiledPointLight, CompiledSpotLight},
    vec3::Vec3,
};

/// The constants that determine the irradiance of a compiled spotlight or point light.
#[derive(Clone, Copy, Debug)]
pub struct Parts<S: Scalar, A: Attenuation> {
    /// The position.
    pub position: Vec3<S::Length>,
    /// The constants of the attenuation.
    pub attenuation: A::Constants<S>,
    /// The intensity.
    pub intensity: S::Gain,
    /// The encoded distance below which a point needs the fine evaluation.
    pub fine_below: u32,
    /// The cone; `None` for a point light.
    pub cone: Option<ConeParts<S>>,
}

/// The constants of a compiled cone, except those of its falloff.
#[derive(Clone, Copy, Debug)]
pub struct ConeParts<S: Scalar> {
    /// The unit axis.
    pub axis: Vec3<S::Unit>,
    /// The map from a versine to the falloff's argument `t`.
    pub ramp: S::Ramp,
    /// The squared cosine of the outer angle, less a margin: points below it are outside the cone.
    pub outside: S,
}

impl<S: Scalar, P: Falloff, A: Attenuation> CompiledSpotLight<S, P, A> {
    /// Returns the constants of the light, except those of its falloff and its colours.
    pub fn parts(&self) -> Parts<S, A> {
        let Self { position, axis, attenuation, intensity, fine_below, outside, .. } = *self;
        let cone = Some(ConeParts { axis, ramp: self.cone.ramp, outside });
        Parts { position, attenuation, intensity, fine_below, cone }
    }
}

impl<S: Scalar, A: Attenuation> CompiledPointLight<S, A> {
    /// Returns the constants of the light, except its colours.
    pub fn parts(&self) -> Parts<S, A> {
        let Self { position, attenuation, intensity, fine_below, .. } = *self;
        Parts { position, attenuation, intensity, fine_below, cone: None }
    }
}

/// The tables of the 16-bit format.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug)]
pub struct Tables {
    /// Values of `2^31 / sqrt(n)` at multiples of 2^25, from `n = 2^30` on.
    pub inverse_square_roots: &'static [u16],
    /// `1 / c` with 31 fraction bits and `log2 c` with 32, for the middles `c` of 64 segments of
    /// `[1, 2)`.
    pub logarithms: &'static [(u32, u32)],
    /// `2^-c` with 32 fraction bits, for the middles `c` of 64 segments of `[0, 1)`.
    pub powers: &'static [u32],
}

#[cfg(feature = "fixed")]
impl Tables {
    /// The tables that the kernel uses.
    pub const KERNEL: Self = Self {
        inverse_square_roots: &crate::number::root::NODES,
        logarithms: &crate::number::real::LOGARITHMS,
        powers: &crate::number::real::POWERS,
    };
}
