//! The constants of compiled lights, and the tables of the kernel, for generators of source in other
//! languages.

#[cfg(feature = "fixed")]
use crate::display::{Encoding, Gamma22, Gamma28, Srgb, code_lights, code_thresholds};
use crate::{
    attenuation::Attenuation,
    falloff::Falloff,
    number::{Quick, Scalar},
    shade::{
        CompiledDirectionalLight, CompiledMeasuredLight, CompiledPointLight, CompiledSpotLight,
        QuickSpotLight,
    },
    vec3::Vec3,
};

/// The constants that determine the irradiance of a compiled spotlight, point light or measured light.
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
    /// The cone; `None` for a light of another kind.
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

impl<S: Scalar> CompiledDirectionalLight<S> {
    /// Returns the direction and the intensity of the light.
    pub fn parts(&self) -> (Vec3<S::Unit>, S::Gain) {
        (self.direction, self.intensity)
    }
}

impl<S: Scalar, A: Attenuation> CompiledMeasuredLight<'_, S, A> {
    /// Returns the constants of the light, except its [frame](Self::frame), its [distribution](Self::distribution), its
    /// [bound](Self::outside) and its colours.
    pub fn parts(&self) -> Parts<S, A> {
        let Self { position, attenuation, intensity, fine_below, .. } = *self;
        Parts { position, attenuation, intensity, fine_below, cone: None }
    }

    /// Returns the squared cosine of the largest angle with light, less a margin; -2 for a light at a right angle or behind.
    pub fn outside(&self) -> S {
        self.outside
    }
}

impl<S: Quick, P: Falloff, A: Attenuation> QuickSpotLight<S, P, A> {
    /// Returns the constants of the light, except those of its falloff and its colours. No point has a fine
    /// evaluation.
    pub fn parts(&self) -> Parts<S, A> {
        let Self { position, axis, attenuation, intensity, outside, .. } = *self;
        let cone = Some(ConeParts { axis, ramp: self.cone.ramp, outside });
        Parts { position, attenuation, intensity, fine_below: 0, cone }
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
    /// The codes of sRGB of 1, 2, 3, 4, 5, 6 and 8 bits.
    pub srgb: [CodeTables; 7],
    /// The codes of eight bits of the powers 2.2 and 2.8.
    pub gammas: [CodeTables; 2],
}

/// The tables of a display's codes from 0 to `2^bits - 1`, without an entry for code 0.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug)]
pub struct CodeTables {
    /// The least light whose nearest code is each, in steps of 2^-14.
    pub thresholds: &'static [u16],
    /// The least light whose nearest code is each, in steps of 2^-30.
    pub fine_thresholds: &'static [u32],
    /// The light of each code, in steps of 2^-24.
    pub lights: &'static [u32],
}

#[cfg(feature = "fixed")]
impl CodeTables {
    const fn of<L: Encoding, const LAST: usize>() -> Self {
        let (thresholds, fine_thresholds) = code_thresholds::<L, LAST>();
        Self { thresholds, fine_thresholds, lights: code_lights::<L, LAST>() }
    }
}

#[cfg(feature = "fixed")]
impl Tables {
    /// The tables that the kernel uses.
    pub const KERNEL: Self = Self {
        inverse_square_roots: &crate::number::root::NODES,
        logarithms: &crate::number::real::LOGARITHMS,
        powers: &crate::number::real::POWERS,
        srgb: [
            CodeTables::of::<Srgb, 1>(),
            CodeTables::of::<Srgb, 3>(),
            CodeTables::of::<Srgb, 7>(),
            CodeTables::of::<Srgb, 15>(),
            CodeTables::of::<Srgb, 31>(),
            CodeTables::of::<Srgb, 63>(),
            CodeTables::of::<Srgb, 255>(),
        ],
        gammas: [CodeTables::of::<Gamma22, 255>(), CodeTables::of::<Gamma28, 255>()],
    };
}
