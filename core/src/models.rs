//! The lists of falloffs and of attenuations: each model is one row. The list of specular lobes,
//! which are never chosen at run time, is beside them in [`specular`](crate::specular).
//!
//! From its row a model gets the run-time enum and its dispatch, its effect, and with the feature
//! `arithmetic` a [`Listed`] implementation. Everything else that needs every model (conformance
//! vectors, prices, programs, exports, tests) visits the lists:
//! [`falloffs`](crate::falloff::falloffs), [`constant_falloffs`](crate::falloff::constant_falloffs),
//! [`attenuations`](crate::attenuation::attenuations) and [`lobes`](crate::specular::lobes).

/// Calls a macro with the given arguments, followed by the list of all run-time falloffs.
///
/// A row is `doc variant(type) = name, truth;`. `doc` is one sentence; `variant` is the variant in
/// [`AnyFalloff`](crate::falloff::AnyFalloff) and [`Effect`](crate::dynamic::Effect); `type` is a
/// [`Model`](crate::model::Model), whose numbers tell its sample; `name` is the name in records; `truth` is the
/// function of the sample in f64, with as few operations as possible.
///
/// In rows that end with `constant type = name, value, truth`, this type replaces the run-time type in programs
/// that know the falloff at compile time.
macro_rules! falloffs {
    ($consumer:ident $(; $($arguments:tt)*)?) => {
        $consumer! {
            $($($arguments)*)?
            /// The soft edge, `t^2`.
            Soft(Soft) = "soft", |t| t * t;
            /// The hard edge, `1 - u^2`.
            Hard(Hard) = "hard", |t| t * (2.0 - t);
            /// The straight ramp, `t`.
            Linear(Linear) = "linear", |t| t;
            /// Smoothstep, `t^2 (3 - 2t)`.
            Smooth(Smooth) = "smooth", |t| t * t * (3.0 - 2.0 * t);
            /// A step: all or nothing.
            Step(Step) = "step", |t| if t > 0.0 { 1.0 } else { 0.0 };
            /// A quadratic between soft and hard: for most pairs of a beam angle and a field angle.
            Quadratic(Quadratic) = "quadratic", |t| t * (0.5 + 0.5 * t);
            /// A monotone cubic: for the pairs of angles that no quadratic has.
            Cubic(Cubic) = "cubic", |t| t * (1.25 + t * (2.75 * t - 3.0));
            /// Two soft falloffs, a narrow one within a wide one: a soft edge for a beam and a field angle.
            SoftPair(SoftPair) = "soft-pair", |t| 0.625 * t * t + 0.375 * squared(f64::max(4.0 * t - 3.0, 0.0));
            /// An integer power: a concentrated beam.
            Power(IntegerPower) = "power", |t| power(t, 15.0),
                constant Power<4> = "power-4", Power, |t| squared(squared(t));
            /// An inverted integer power: a flat middle and a steep edge.
            InvertedPower(InvertedIntegerPower) = "inverted-power", |t| 1.0 - squared(squared(1.0 - t)),
                constant InvertedPower<4> = "inverted-power-4", InvertedPower, |t| 1.0 - squared(squared(1.0 - t));
            /// A power of a non-integer exponent.
            RealPower(RealPower) = "real-power", |t| power(t, 2.25);
            /// An inverted power of a non-integer exponent: the cones of Godot.
            InvertedRealPower(InvertedRealPower) = "inverted-real-power", |t| 1.0 - power(1.0 - t, 2.5);
            /// Samples with straight lines between them: a light that was measured.
            Table(Table<'static>) = "table", |t| interpolated(t);
        }
    };
}

/// Calls a macro with the given arguments, followed by the list of all run-time attenuations.
///
/// A row is `doc variant(type) = law;`, where `law` is the name in data and in words of a command. `type` is a
/// [`Model`](crate::model::Model), or such a law with a window; its numbers tell its sample.
/// Three parts of a row are optional:
///
/// - `from law` after the type: the law without a range, which converts into the variant.
/// - `effect doc variant = name`: the law as a variant of [`Effect`](crate::dynamic::Effect).
/// - `doc type = name`, any number of times: a type that replaces the run-time type in programs
///   that know the attenuation at compile time.
macro_rules! attenuations {
    ($consumer:ident $(; $($arguments:tt)*)?) => {
        $consumer! {
            $($($arguments)*)?
            /// No attenuation, with an optional cut-off range.
            Constant(CutAt<NoAttenuation>) from NoAttenuation = "constant",
                effect /// A light without attenuation.
                Unattenuated = "unattenuated";
            /// The inverse-square law, with an optional cut-off range.
            InverseSquare(CutAt<InverseSquare>) from InverseSquare = "inverse-square",
                effect /// The inverse-square law.
                InverseSquare = "inverse-square",
                /// The law of a small source: the default of every spot and point light.
                InverseSquare = "inverse-square",
                /// Cut off at a range: nothing from there on, and the law unchanged before.
                CutAt<InverseSquare> = "cut-at";
            /// One over a polynomial, with an optional cut-off range.
            Polynomial(CutAt<Polynomial>) from Polynomial = "polynomial",
                effect /// An attenuation of one over a polynomial of the distance.
                Polynomial = "polynomial",
                /// `1/(a0 + a1 d + a2 d^2)`, capped at 1: the lights of OpenGL and Direct3D.
                Polynomial = "polynomial";
            /// The inverse-square law with glTF's window.
            GltfRange(GltfRange) = "inverse-square",
                /// The window by which lights of glTF end at their range.
                GltfRange = "gltf-range";
            /// No attenuation, with the window `(1 - (d/r)^4)^2`.
            WindowedConstant(Windowed<NoAttenuation>) = "constant";
            /// The inverse-square law with the window `(1 - (d/r)^4)^2`.
            FilamentRange(FilamentRange) = "inverse-square",
                /// The window of glTF squared, as Filament and Godot have it.
                FilamentRange = "filament-range";
            /// One over a polynomial, with the window `(1 - (d/r)^4)^2`.
            WindowedPolynomial(Windowed<Polynomial>) = "polynomial";
            /// Smoothstep to a range.
            SmoothRange(SmoothRange) = "smoothstep",
                effect /// An attenuation by smoothstep to a range.
                SmoothRange = "smooth-range",
                /// A smoothstep that ends at a range.
                SmoothRange = "smooth-range";
            /// A real power of the distance, with an optional cut-off range.
            Decay(CutAt<Decay>) from Decay = "decay",
                effect /// A real power of the distance.
                Decay = "decay",
                /// `d^-k` with a real exponent, capped: by a logarithm and an exponential.
                Decay = "decay";
            /// A real power of the distance, with the window `(1 - (d/r)^4)^2`: three.js and Godot.
            WindowedDecay(Windowed<Decay>) = "decay";
        }
    };
}

#[cfg(feature = "arithmetic")]
pub use crate::model::{Accepts, Model, Number};

pub(crate) use {attenuations, falloffs};

/// What the lists know of a model.
#[cfg(feature = "arithmetic")]
pub trait Listed: Sized {
    /// The name in records.
    const NAME: &'static str;
    /// The type, as Rust writes it.
    const TYPE: &'static str;
    /// What the model is, in a sentence.
    const DOC: &'static str;

    /// Returns one value of the model.
    ///
    /// # Errors
    /// None: the parameters of the lists are accepted.
    fn sample() -> Result<Self, crate::error::Error>;
}

/// Implements [`Listed`] for rows `doc type = name, sample;`.
#[cfg(feature = "arithmetic")]
macro_rules! listed {
    ($(#[doc = $doc:literal] $type:ty = $name:literal, $sample:expr;)*) => {$(
        impl $crate::models::Listed for $type {
            const NAME: &'static str = $name;
            const TYPE: &'static str = stringify!($type);
            const DOC: &'static str = $doc.trim_ascii();

            fn sample() -> Result<Self, $crate::error::Error> {
                $sample
            }
        }
    )*};
}

#[cfg(feature = "arithmetic")]
pub(crate) use listed;

/// Samples evenly spaced over the versine; 65,535 is full intensity.
#[allow(unreachable_pub, reason = "public with the feature arithmetic")]
pub const SAMPLES: [u16; 10] = [65_535, 65_000, 63_211, 60_007, 51_234, 39_876, 24_321, 11_111, 3_210, 0];

/// Returns `x^2`.
#[cfg(feature = "arithmetic")]
#[inline(always)]
pub fn squared(x: f64) -> f64 {
    x * x
}

/// Returns `x^exponent`.
#[cfg(feature = "arithmetic")]
pub fn power(x: f64, exponent: f64) -> f64 {
    libm::pow(x, exponent)
}

/// Returns the linear interpolation in [`SAMPLES`] at `t`.
#[cfg(feature = "arithmetic")]
#[inline(always)]
pub fn interpolated(t: f64) -> f64 {
    let segments = SAMPLES.len() - 1;
    let place = (1.0 - t) * segments as f64;
    let index = (place as usize).min(segments - 1);
    let [from, to] = [SAMPLES[index], SAMPLES[index + 1]].map(f64::from);
    (from + (to - from) * (place - index as f64)) / 65_535.0
}
