//! Highlights: how brightly a surface mirrors a light into the eye.
//!
//! With L the direction to the light, V the direction to the eye, N the normal, R the mirror image of L and H halfway
//! between L and V, all of unit length, and m the shininess:
//!
//! | type | lobe | source |
//! |---|---|---|
//! | [`NoSpecular`] | none, and nothing of it is compiled in | |
//! | [`Phong`] | `max(0, R.V)^m` | Phong 1975 |
//! | [`MirroredPhong`] | the same for a view that is mirrored in the surface | |
//! | [`BlinnPhong`] | `max(0, N.H)^m` | Blinn 1977; OpenGL and Direct3D 9 |
//! | [`DualConeLobe`] | `max(0, R.H)^m` | the dual-cone GLSL article |
//! | [`DifferenceForm`] of one of these | `max(0, 1 - k \|difference\|^2 / 2)^(2^n)`, `k = m / 2^n` | Lyon 1993, *Phong Shading Reformulation for Hardware Renderer Simplification* |
//!
//! Every cosine is had from the difference of its two directions, `1 - |a - b|^2 / 2`: a highlight is a narrow beam,
//! and loses what a narrow beam would lose to an inner product.
//!
//! A surface that faces away from the light has no highlight, as in OpenGL; the bare equation of the textbooks would let
//! the light shine through.

mod highlight;

use core::fmt::{self, Formatter};

#[cfg(feature = "arithmetic")]
pub use self::highlight::Highlight;
#[cfg(not(feature = "arithmetic"))]
use self::highlight::Highlight;

use crate::{
    number::Scalar,
    source::{Named, name, named},
    vec3::Vec3,
};

/// A kind of highlight. The type decides which one is compiled in: there is no branch per point, and a highlight that
/// is not named is not linked.
pub trait SpecularLobe: Copy + PartialEq + core::fmt::Debug {
    /// Whether there is any highlight at all.
    const SHINES: bool = true;
    /// The least shininess that the kind of highlight is defined for.
    const LEAST_SHININESS: u32 = 1;
    /// What the highlight knows once it is compiled for a format.
    type Constants<S: Scalar>: Copy + PartialEq + core::fmt::Debug;

    /// Compiles a highlight of this shininess for the format `S`.
    fn constants<S: Scalar>(shininess: u32) -> Self::Constants<S>;

    /// The versine between the two directions whose nearness makes the highlight from which on there is none.
    fn end(shininess: u32) -> f32;

    /// The lobe, in [0, 1]: `incoming` goes from the light to the surface, `view` from the surface to the eye.
    fn lobe<S: Scalar>(
        constants: &Self::Constants<S>,
        incoming: Vec3<S::Unit>,
        normal: Vec3<S>,
        view: Vec3<S::Unit>,
    ) -> S;
}

/// No highlight.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct NoSpecular;

/// `max(0, R.V)^m`: brightest where the eye is in the mirror direction.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Phong;

/// `max(0, N.H)^m`: brightest where the eye is in the mirror direction, and about as wide as [`Phong`] of a quarter of
/// its shininess. One more root for a point and a light.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct BlinnPhong;

/// `max(0, R.H)^m`, as the dual-cone GLSL article writes it.
///
/// It is neither Phong's nor Blinn's. Where the eye is in the mirror direction H is the normal, and the lobe is only the
/// m-th power of the cosine of the angle of incidence; it is brightest where H is the mirror direction, which is for
/// an eye at three times that angle.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct DualConeLobe;

/// [`Phong`] of a view that has been mirrored in the surface already: `|R - V|` is `|L - V'|`, and V' is found once for a
/// point and not once for each light.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct MirroredPhong;

/// Lyon's difference form of another highlight, by `N` squarings: the shininess goes into a factor, so that every point
/// takes the same few steps whatever its material, which suits vector instructions.
///
/// Defined from a shininess of `2^N` on. It ends at a finite angle, and is the narrower the fewer the squarings.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct DifferenceForm<H, const N: u32>(pub H);

named!(NoSpecular Phong MirroredPhong BlinnPhong DualConeLobe);

impl<H: Named, const N: u32> Named for DifferenceForm<H, N> {
    fn write_name(out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "DifferenceForm<{}, {N}>", name::<H>())
    }
}

impl SpecularLobe for NoSpecular {
    const SHINES: bool = false;
    const LEAST_SHININESS: u32 = 0;
    type Constants<S: Scalar> = ();

    fn constants<S: Scalar>(_: u32) {}

    fn end(_: u32) -> f32 {
        0.0
    }

    #[inline]
    fn lobe<S: Scalar>((): &(), _: Vec3<S::Unit>, _: Vec3<S>, _: Vec3<S::Unit>) -> S {
        S::ZERO
    }
}

impl<H: Highlight> SpecularLobe for H {
    /// The ramp from 0 to 1, whose scale the versine is in, and the exponent.
    type Constants<S: Scalar> = (S::Ramp, u32);

    fn constants<S: Scalar>(shininess: u32) -> (S::Ramp, u32) {
        (S::ramp(0.0, 1.0, 1.0), shininess)
    }

    fn end(_: u32) -> f32 {
        1.0
    }

    #[inline(always)] // `lit-specular.fx16` on Cortex-M0: +41 without.
    fn lobe<S: Scalar>(
        &(ramp, shininess): &(S::Ramp, u32),
        incoming: Vec3<S::Unit>,
        normal: Vec3<S>,
        view: Vec3<S::Unit>,
    ) -> S {
        let [a, b] = H::directions(incoming, normal, view);
        S::power(S::versine_between(a, b, ramp), shininess)
    }
}

impl<H: Highlight, const N: u32> SpecularLobe for DifferenceForm<H, N> {
    const LEAST_SHININESS: u32 = 1 << N;
    /// `1 - k versine` is a ramp that ends at a versine of `1 / k`.
    type Constants<S: Scalar> = S::Ramp;

    fn constants<S: Scalar>(shininess: u32) -> S::Ramp {
        let end = Self::end(shininess);
        S::ramp(0.0, end, end)
    }

    fn end(shininess: u32) -> f32 {
        (1_u32 << N) as f32 / shininess as f32
    }

    #[inline(always)] // `difference-form` on Cortex-M0: +32 without.
    fn lobe<S: Scalar>(&ramp: &S::Ramp, incoming: Vec3<S::Unit>, normal: Vec3<S>, view: Vec3<S::Unit>) -> S {
        let [a, b] = H::directions(incoming, normal, view);
        let base = S::rise(ramp, S::versine_between(a, b, ramp)).scalar();
        (0..N).fold(base, |power, _| power.times(power))
    }
}

impl Highlight for Phong {
    #[inline]
    fn directions<S: Scalar>(
        incoming: Vec3<S::Unit>,
        normal: Vec3<S>,
        view: Vec3<S::Unit>,
    ) -> [Vec3<S::Unit>; 2] {
        [S::mirror(incoming, normal), view]
    }
}

impl Highlight for MirroredPhong {
    #[inline(always)]
    fn directions<S: Scalar>(incoming: Vec3<S::Unit>, _: Vec3<S>, view: Vec3<S::Unit>) -> [Vec3<S::Unit>; 2] {
        [incoming, view]
    }
}

impl Highlight for BlinnPhong {
    #[inline]
    fn directions<S: Scalar>(
        incoming: Vec3<S::Unit>,
        normal: Vec3<S>,
        view: Vec3<S::Unit>,
    ) -> [Vec3<S::Unit>; 2] {
        [S::normal_unit(normal), S::direction_between(incoming, view)]
    }
}

impl Highlight for DualConeLobe {
    #[inline]
    fn directions<S: Scalar>(
        incoming: Vec3<S::Unit>,
        normal: Vec3<S>,
        view: Vec3<S::Unit>,
    ) -> [Vec3<S::Unit>; 2] {
        [S::mirror(incoming, normal), S::direction_between(incoming, view)]
    }
}
