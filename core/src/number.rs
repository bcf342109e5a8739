//! Number formats, and the fixed-point number types.
//!
//! | | [`f32`] | [`Fx32`] | [`Fx16`] |
//! |---|---|---|---|
//! | intensity, normal, colour | `f32` | `Fx32` | `Fx16` |
//! | coordinate of a point: [`Scalar::Length`] | `f32` | [`Length`] | [`Length`] |
//! | component of a direction: [`Scalar::Unit`] | `f32` | [`Fx32`] | [`Fx32`] |
//! | irradiance: [`Scalar::Irradiance`] | `f32` | [`Light32`] | [`Light16`] |
//! | versine of the angle off axis, scaled to the cone | `f32`, not scaled | [`Versine`] | [`Versine`] |
//! | coefficient of a falloff | `f32` | [`Weight32`] | [`Weight16`] |
//! | step of an intensity | 2^-23 | 2^-30 | 2^-14 |
//! | overflow | irradiance of one light clamped at 2^64, else IEEE 754 | saturates | saturates |
//! | widest product | 24 bits of a float | 64 bits; from a point to its light mostly the upper half | 32 bits; in steep cones and bright light the upper half of 64 |
//! | suited to | processors with an FPU | 32-bit multipliers, exact pictures | Cortex-M0 and the like |
//!
//! In every format and for every bit pattern:
//!
//! - No operation panics.
//! - A NaN in a point, a normal or a versine gives zero light.
//! - A falloff is in `[0, 1]`: exactly 1 on the axis (or the first value of a table), exactly 0 at and
//!   outside the edge.

mod arithmetic;
pub(crate) mod float;
#[cfg(feature = "fixed")]
pub(crate) mod fx16;
#[cfg(feature = "fixed")]
pub(crate) mod fx32;
mod knot;
#[cfg(feature = "fixed")]
mod lanes;
#[cfg(all(test, feature = "fixed"))]
#[path = "../proofs/mod.rs"]
mod proofs;
#[cfg(feature = "fixed")]
pub(crate) mod ramp;
pub(crate) mod real;
#[cfg(feature = "fixed")]
pub(crate) mod root;
mod set_up;
#[cfg(feature = "fixed")]
mod sphere;
mod stages;
#[cfg(feature = "fixed")]
mod types;

#[cfg(feature = "fixed")]
pub use self::types::{Fx16, Fx32, Length, Light16, Light32, Versine, Weight16, Weight32};
#[cfg(feature = "fixed")]
use self::types::{nearest, rounded};
#[cfg(feature = "arithmetic")]
pub use self::{
    arithmetic::{Directed, Fraction, Gain, Lamp, Offset, OffsetAlong, Ray, Rise, Share, Types, Vectors},
    real::RealExponent,
    set_up::{Arithmetic, Directions, Errors, Lights, Places, Ramps, Slopes, Word},
    stages::{Placing, Rounding, Stages},
};
#[cfg(not(feature = "arithmetic"))]
pub(crate) use self::{
    arithmetic::{Directed, Fraction, Gain, Lamp, Offset, OffsetAlong, Ray, Rise, Share, Types, Vectors},
    real::RealExponent,
    set_up::{Arithmetic, Directions, Errors, Lights, Places, Ramps, Slopes, Word},
    stages::{Placing, Rounding, Stages},
};
pub(crate) use self::{
    float::BRIGHTEST,
    set_up::{HALF_A_CODE, STEPS},
    stages::KEPT,
};
pub use self::{knot::Knot, real::InversePower};
use crate::{
    source::{Named, Source},
    vec3::Vec3,
};

/// Marks a branch as rarely taken, like `core::hint::cold_path`, which is stable from Rust 1.95.
#[cfg(feature = "fixed")]
#[cold]
const fn cold_path() {}

/// Whether the processor has vector instructions, for integers and for floats.
pub(crate) const HAS_VECTORS: bool =
    cfg!(any(target_feature = "sse2", target_feature = "simd128", target_feature = "neon"));

/// A number format that the kernel computes in: `f32`, [`Fx32`] or [`Fx16`].
///
/// The fixed-point formats need the feature `fixed`. The trait is sealed: no other crate can add a
/// format, so that each format can be measured. [`number`](crate::number) lists the guarantees of
/// every format.
///
/// ```
/// use luminaire::{Error, Scalar, SpotLight};
///
/// /// The irradiance of a spotlight at a point of the floor, computed in the format `S`.
/// fn on_the_floor<S: Scalar>(spot: &SpotLight, point: [f32; 3]) -> Result<f32, Error> {
///     let lit = spot.compile::<S>()?;
///     Ok(S::light_to_f32(lit.irradiance(S::point(point), S::normal([0.0, 1.0, 0.0]))))
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no number format",
    label = "expected `f32`, `Fx16` or `Fx32`",
    note = "light may exceed full scale and has a type of its own: `display::clip` makes a colour of it"
)]
pub trait Scalar:
    Arithmetic<
        Position = <Self as Scalar>::Length,
        Direction = <Self as Scalar>::Unit,
        Received = <Self as Scalar>::Irradiance,
        Weight: Source,
        Ramp: Source,
        Frame: Source,
        Gain: Source,
    > + Source
    + Named
    + Copy
    + Default
    + PartialOrd
    + core::fmt::Debug
    + 'static
{
    /// A component of a position in world coordinates.
    type Length: Source + Copy + Default + PartialOrd + core::fmt::Debug;
    /// A component of a unit vector, at the format's finest resolution.
    type Unit: Source + Copy + Default + PartialEq + core::fmt::Debug;
    /// Irradiance at a surface, at least 0; 1 is full scale.
    type Irradiance: Irradiance<Scalar = Self>;

    /// The name of the format, as written in the price list.
    const NAME: &'static str;
    /// Zero.
    const ZERO: Self;
    /// One, which is full scale.
    const ONE: Self;
    /// The unit in the last place (ULP) of 1.
    const STEP: f32;
    /// The largest magnitude of a coordinate of a light's position. The constant does not limit the
    /// coordinates of points.
    ///
    /// A compiled light can be moved farther. In fixed point, differences of coordinates wrap: if a light is beyond
    /// `32,767 - 2^13 - 256` in `Fx16` or beyond `32,767 - 128` in `Fx32`, points and spheres within 256 units of the opposite end of the
    /// range of [`Length`](Self::Length) may count as near.
    const FARTHEST: f32;

    /// Returns the nearest value of the format. Fixed point saturates, and NaN becomes zero.
    fn from_f32(value: f32) -> Self;
    /// Returns the value as `f32`, rounded if it has more bits than an `f32`.
    fn to_f32(self) -> f32;
    /// Returns the nearest length of the format.
    fn length(value: f32) -> Self::Length;
    /// Returns the point with these coordinates, each rounded to the nearest length.
    ///
    /// `Fx16` and `Fx32` also have a `const` function of this name.
    fn point(position: impl Into<Vec3<f32>>) -> Vec3<Self::Length> {
        position.into().map(Self::length)
    }
    /// Returns the normal with these components, each rounded to the nearest scalar.
    ///
    /// `Fx16` and `Fx32` also have a `const` function of this name.
    fn normal(direction: impl Into<Vec3<f32>>) -> Vec3<Self> {
        direction.into().map(Self::from_f32)
    }
    /// Returns a vector of any length as a normal: scaled to length 1. An interpolated normal, for
    /// example, is shorter than 1.
    ///
    /// The result is zero, and so receives no light, if the vector is zero, and in `f32` if its
    /// squared length is not a normal number. The error of a component is at most 0.501 steps of 2^-14
    /// in [`Fx16`], 2.5e-8 in [`Fx32`] and 2.7e-7 in `f32` (derived). No fixed-point format divides.
    fn normalize(normal: Vec3<Self>) -> Vec3<Self> {
        normal_along(Self::normal_unit(normal))
    }
    /// Returns the normal along a vector of three signed bytes, as vertex formats store it.
    ///
    /// The bytes are signed: a normal map from an image has unsigned ones, which
    /// [`normals_from_opengl`](crate::draw::normals_from_opengl) converts. They need not be those of a
    /// unit vector, so 127 or 128 may mean 1. Three zeros give
    /// zero, which receives no light. The errors are those of [`normalize`](Self::normalize).
    fn normal_from_bytes(bytes: [i8; 3]) -> Vec3<Self> {
        normal_along(Self::unit_of_bytes(bytes))
    }
    /// Returns the normal along a vector of three signed bytes whose length is about 127, as
    /// [`normals_from_opengl`](crate::draw::normals_from_opengl) returns it from a normal map, with a
    /// tenth of the instructions of [`normal_from_bytes`](Self::normal_from_bytes).
    ///
    /// One step of Newton's iteration scales the vector: `n (3 - |n|^2) / 2` with `n` in units of 127. For the
    /// nearest bytes to any unit vector, the error of a component is at most 1.3e-4 (exhaustive). Longer and
    /// shorter vectors give a normal that is too short, which receives less light. The result is the same in
    /// every format.
    #[inline]
    fn normal_from_unit_bytes(bytes: [i8; 3]) -> Vec3<Self> {
        const SQUARE: u32 = 127 * 127;
        // From units of 127^3 / 2 to 2^-22, in units of 2^-15.
        const SCALE: u32 = ((1 << 37) / (2 * 127 * SQUARE as u64)) as u32;
        let bytes: Vec3<i32> = bytes.map(i32::from).into();
        let square = (bytes.x * bytes.x + bytes.y * bytes.y + bytes.z * bytes.z) as u32;
        let factor = (((3 * SQUARE).saturating_sub(square) * SCALE) >> 15) as i32;
        bytes.map(|c| Self::from_steps((c * factor + (1 << 7)) >> 8))
    }
    /// Returns an irradiance as `f32`, for display and for tests.
    fn light_to_f32(light: Self::Irradiance) -> f32;
}

/// The irradiance of a number format: [`Scalar::Irradiance`].
pub trait Irradiance:
    Source + Copy + Default + PartialOrd + core::fmt::Debug + core::ops::Add<Output = Self> + core::ops::AddAssign
{
    /// The format.
    type Scalar: Scalar<Irradiance = Self>;
}

/// Implements [`Scalar`] for a fixed-point format, and its conversions without an import of that trait.
#[cfg(feature = "fixed")]
macro_rules! fixed_point {
    ($($name:ident, $label:literal, $light:ident, farthest $farthest:literal;)*) => {$(
        impl Scalar for $name {
            type Length = Length;
            type Unit = Fx32;
            type Irradiance = $light;

            const NAME: &'static str = $label;
            const ZERO: Self = Self::ZERO;
            const ONE: Self = Self::ONE;
            const STEP: f32 = 1.0 / (1 << Self::FRACTION_BITS) as f32;
            const FARTHEST: f32 = $farthest;

            #[inline]
            fn from_f32(value: f32) -> Self {
                Self::from_f32(value)
            }

            fn to_f32(self) -> f32 {
                self.to_f32()
            }

            #[inline]
            fn length(value: f32) -> Length {
                Length::from_f32(value)
            }

            #[inline]
            fn light_to_f32(light: $light) -> f32 {
                light.to_f32()
            }
        }

        impl Irradiance for $light {
            type Scalar = $name;
        }

        impl $name {
            /// Returns the nearest length: see [`Length::from_f32`].
            pub const fn length(value: f32) -> Length {
                Length::from_f32(value)
            }

            /// Returns a vector of any length as a normal: see [`Scalar::normalize`].
            pub fn normalize(normal: Vec3<Self>) -> Vec3<Self> {
                <Self as Scalar>::normalize(normal)
            }

            /// Returns the normal along a vector of three signed bytes: see [`Scalar::normal_from_bytes`].
            pub fn normal_from_bytes(bytes: [i8; 3]) -> Vec3<Self> {
                <Self as Scalar>::normal_from_bytes(bytes)
            }

            /// Returns the normal along a vector of three signed bytes whose length is about 127: see
            /// [`Scalar::normal_from_unit_bytes`].
            #[inline]
            pub fn normal_from_unit_bytes(bytes: [i8; 3]) -> Vec3<Self> {
                <Self as Scalar>::normal_from_unit_bytes(bytes)
            }
        }
    )*};
}

#[cfg(feature = "fixed")]
fixed_point! {
    Fx16, "fx16", Light16, farthest 16_383.0;
    Fx32, "fx32", Light32, farthest 32_639.0;
}

/// A number format with a quick evaluation, which has fewer instructions and a larger error:
/// [`Fx16`].
///
/// Points, normals and light have the same types as in the standard evaluation, so one scene can
/// have lights of both evaluations. [`SpotLight::compile_quick`](crate::SpotLight::compile_quick)
/// compiles a light for the quick evaluation.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no quick evaluation",
    note = "`Fx16` has a quick evaluation; for other formats use `compile`"
)]
pub trait Quick: Scalar {
    /// An offset with fewer bits than the standard one.
    #[doc(hidden)]
    type QuickOffset: OffsetAlong<Self, Facing = <Self::Offset as Offset<Self>>::Facing> + Vectors<Self>;

    /// Returns the errors of the stages of the quick evaluation at a distance.
    #[doc(hidden)]
    fn quick_stages(distance: f64) -> Stages;

    /// Converts an axis to the form that rays of the quick evaluation take.
    #[doc(hidden)]
    fn quick_axis(axis: Vec3<Self::Unit>) -> Vec3<Self::Unit>;
    /// Compiles a ramp for versines of the quick evaluation: see `Ramps::ramp`.
    #[doc(hidden)]
    fn quick_ramp(inner: f32, outer: f32, limit: f32) -> Self::Ramp;
    /// Returns the ramp of the cone between the cones of two ramps: see `Ramps::zoomed`.
    #[doc(hidden)]
    fn quick_zoomed(from: Self::Ramp, to: Self::Ramp, part: Self) -> (Self::Ramp, Self);
    /// Returns the axis of which [`quick_axis`](Self::quick_axis) made this one.
    #[doc(hidden)]
    fn standard_axis(quick: Vec3<Self::Unit>) -> Vec3<Self::Unit>;
}

/// Returns the unit vector along an offset; `None` if the offset has no direction.
pub(crate) fn unit<S: Scalar>(offset: S::Offset) -> Option<Vec3<S::Unit>> {
    S::has_direction(&offset).then(|| S::fine_ray(&offset).direction())
}

/// Returns the side and the front of a light: the unit vector orthogonal to its axis that is nearest to `side`, and the
/// one orthogonal to both. `None` if axis and side have one direction, within the resolution of the format.
pub(crate) fn across<S: Scalar>(axis: Vec3<S::Unit>, side: Vec3<S::Unit>) -> Option<[Vec3<S::Unit>; 2]> {
    let front = unit::<S>(S::offset_along(S::cross(side, axis)))?;
    let side = unit::<S>(S::offset_along(S::cross(axis, front)))?;
    Some([side, front])
}

/// Returns the normal along a vector; zero if the vector has no direction.
fn normal_along<S: Scalar>(direction: Vec3<S::Unit>) -> Vec3<S> {
    unit::<S>(S::offset_along(direction)).map_or_else(Vec3::default, S::unit_normal)
}

/// Returns the bound for [`Offset::is_outside`]: the squared cosine of the outer half angle,
/// less a margin for rounding errors.
///
/// A point is outside the cone if `z |z| < bound |v|^2`, where `v` is the vector from the light to
/// the point and `z` the component of `v` along the axis. Both sides of the inequality have
/// rounding errors. An outer versine is at most 1, so the cosine of the outer half angle is not
/// negative.
///
/// The derivative of `c |c|` with respect to the cosine `c` is at most 2. So with a margin of 16
/// steps (`Errors::OUTSIDE_STEP`) the test rejects no point whose versine exceeds the outer
/// versine by up to 8 steps. In every format the error of a versine is less than 8 steps. The
/// additional margin `squared_sine * EPSILON` covers the rounding of the squared sine, which is
/// computed in `f32` for every format. The squared cosine is computed from the squared sine, because
/// the squared sine of a narrow cone keeps its leading bits.
pub(crate) fn outside_bound<S: Scalar>(outer_versine: f32) -> S {
    let squared_sine = outer_versine * (2.0 - outer_versine);
    let margin = squared_sine * f32::EPSILON + 16.0 * S::OUTSIDE_STEP;
    S::ONE.minus(S::from_f32(squared_sine)).minus(S::from_f32(margin))
}

/// Returns `base^exponent` by repeated squaring. `product` is the multiplication of a format, and
/// `one` its neutral element.
#[inline]
fn raised<T: Copy>(one: T, base: T, exponent: u32, product: impl Fn(T, T) -> T) -> T {
    let (mut power, mut square, mut rest) = (one, base, exponent);
    while rest > 0 {
        if rest % 2 == 1 {
            power = product(power, square);
        }
        square = product(square, square);
        rest /= 2;
    }
    power
}

/// Converts a value to the exactly equal `mantissa / 2^shift` with a mantissa of 24 bits.
///
/// The mantissa is zero for zero, negative and subnormal values and NaN. Infinity counts as
/// `f32::MAX`.
#[cfg(feature = "fixed")]
fn mantissa_and_shift(value: f32) -> (u32, i32) {
    if !matches!(value.partial_cmp(&0.0), Some(core::cmp::Ordering::Greater)) {
        return (0, 0);
    }
    let bits = value.min(f32::MAX).to_bits();
    let (exponent, fraction) = ((bits >> 23) as i32, bits & 0x007f_ffff);
    if exponent == 0 { (0, 0) } else { (fraction | 0x0080_0000, 150 - exponent) }
}

/// Clamps the shift of a gain to `[-4096, 4096]`, so that sums of shifts cannot overflow.
///
/// With a shift outside this range, a product with the gain is zero or saturates.
#[cfg(feature = "fixed")]
const fn within_reach(shift: i32) -> i32 {
    if shift < -4096 {
        -4096
    } else if shift > 4096 {
        4096
    } else {
        shift
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use super::*;
    use fixed::types::{I2F14, I2F30, I16F16, I18F14, I34F30};

    extern crate std;

    /// Returns the expected results: those of the crate `fixed`, whose conversion has branches.
    fn expected(value: f32) -> (Fx16, Fx32, Length) {
        if value.is_nan() {
            return Default::default();
        }
        (
            I2F14::saturating_from_num(value).into(),
            I2F30::saturating_from_num(value).into(),
            I16F16::saturating_from_num(value).into(),
        )
    }

    #[test]
    fn infinity_is_the_largest_number() {
        assert_eq!(mantissa_and_shift(f32::INFINITY), mantissa_and_shift(f32::MAX));
        assert_eq!([-1.0, f32::NAN, 1e-40].map(mantissa_and_shift), [(0, 0); 3]);
    }

    #[test]
    fn shifts_are_clamped_to_their_reach() {
        assert_eq!(
            [-5_000, -4_097, -4_095, 0, 4_095, 4_097].map(within_reach),
            [-4_096, -4_096, -4_095, 0, 4_095, 4_096]
        );
    }

    /// No error falls where a slope rises.
    fn errors_rise_with_slopes<S: Scalar>() {
        let mut rng = fastrand::Rng::with_seed(510);
        for _ in 0..20_000 {
            let slope = |rng: &mut fastrand::Rng| 1e-2 * 1e9_f32.powf(rng.f32());
            let [angle, fraction, beside_axis] = [(); 3].map(|()| slope(&mut rng));
            let less = Slopes { angle, fraction, beside_axis };
            let by = 1e6_f32.powf(rng.f32());
            let more = match rng.u8(..3) {
                0 => Slopes { angle: angle * by, ..less },
                1 => Slopes { fraction: fraction * by, ..less },
                _ => Slopes { beside_axis: beside_axis * by, ..less },
            };
            let outer = 1e-8_f32.powf(rng.f32());
            let limit = outer * rng.f32().max(1e-3);
            assert!(S::rounding(&less) <= S::rounding(&more), "{less:?} {more:?}");
            let [less, more] = [less, more].map(|slopes| S::coarse_error(&slopes, outer, limit));
            assert!(less <= more, "{less} {more}");
        }
    }

    #[test]
    fn errors_of_each_format_rise_with_slopes() {
        errors_rise_with_slopes::<f32>();
        errors_rise_with_slopes::<Fx32>();
        errors_rise_with_slopes::<Fx16>();
    }

    /// The numbers that the documentation has, of a direction and a frame at a right angle.
    #[test]
    fn places_on_a_square_have_their_stated_errors() {
        fn error<S: Scalar>(is_fine: bool) -> f64 {
            S::placing(is_fine).error(if is_fine { S::fine_stages(2.0) } else { S::stages(2.0) }.turn, 1.0)
        }
        let errors = [error::<f32>(false), error::<Fx32>(false), error::<Fx16>(false), error::<Fx16>(true)];
        let stated = [2.5e-6, 1.2e-7, 2e-4, 8.2e-7];
        for (error, stated) in errors.into_iter().zip(stated) {
            assert!((0.9 * stated..=stated).contains(&error), "{errors:?}");
        }
    }

    #[test]
    fn conversion_rounds_and_saturates_as_the_crate_fixed_does() {
        let stride = if std::env::var_os("LUMINAIRE_FULL").is_some() { 1 } else { 509 };
        for bits in (0..=u32::MAX).step_by(stride) {
            let value = f32::from_bits(bits);
            let found = (Fx16::from_f32(value), Fx32::from_f32(value), Fx16::length(value));
            assert_eq!(found, expected(value), "{value} ({bits:#x})");
            assert_eq!(Fx32::length(value), found.2);
            assert_eq!(Fx16::axis(Vec3::new(value, 0.0, 0.0)).x, found.1);
            let weight = if value.is_nan() { 0.0 } else { value.clamp(-4.0, 4.0) };
            assert_eq!(Fx16::weight(value), I18F14::saturating_from_num(weight).into());
            assert_eq!(Fx32::weight(value), I34F30::saturating_from_num(weight).into());
        }
    }
}
