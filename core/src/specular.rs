//! Specular lobes: the highlight of a light on a surface.
//!
//! The following vectors have unit length: L is the direction to the light, V the direction to the
//! eye, N the normal, R the mirror direction of L about N, and H the half vector of L and V. The
//! exponent m is the shininess.
//!
//! | type | lobe | source |
//! |---|---|---|
//! | [`NoSpecular`] | none; its code is not compiled in | |
//! | [`Phong`] | `max(0, R.V)^m` | Phong 1975 |
//! | [`MirroredPhong`] | [`Phong`] with a view direction that is already mirrored at the surface | |
//! | [`BlinnPhong`] | `max(0, N.H)^m` | Blinn 1977; OpenGL and Direct3D 9 |
//! | [`DualConeLobe`] | `max(0, R.H)^m` | the dual-cone GLSL article |
//! | [`DifferenceForm`] of one of these | `max(0, 1 - k \|a - b\|^2 / 2)^(2^n)`, `k = m / 2^n`, with the two directions a and b of that lobe | Lyon 1993, *Phong Shading Reformulation for Hardware Renderer Simplification* |
//!
//! The cosine of the angle between two directions a and b is computed as `1 - |a - b|^2 / 2` from
//! their difference. A dot product near 1 would lose precision in a narrow lobe, as in a narrow
//! beam.
//!
//! A surface that faces away from the light has no highlight, as in OpenGL. The textbook equation
//! without this condition would let light shine through the surface.

mod highlight;

use core::fmt::{self, Formatter};

#[cfg(feature = "arithmetic")]
pub use self::highlight::Highlight;
#[cfg(not(feature = "arithmetic"))]
use self::highlight::Highlight;

#[cfg(feature = "arithmetic")]
use crate::{
    models::{Listed, listed},
    source::Source,
};
use crate::{
    number::Scalar,
    source::{Named, name, named},
    vec3::Vec3,
};

/// A specular lobe. The type selects the lobe at compile time: there is no branch per point, and an
/// unused lobe is not linked.
pub trait SpecularLobe: Copy + PartialEq + core::fmt::Debug {
    /// Whether the lobe has a highlight; `false` only for [`NoSpecular`].
    const SHINES: bool = true;
    /// The smallest shininess for which the lobe is defined.
    const LEAST_SHININESS: u32 = 1;
    /// The constants of the lobe in a number format.
    type Constants<S: Scalar>: Copy + PartialEq + core::fmt::Debug;

    /// Compiles a lobe of this shininess for the format `S`.
    fn constants<S: Scalar>(shininess: u32) -> Self::Constants<S>;

    /// Returns the versine of the angle between the lobe's two directions at which the lobe becomes
    /// zero.
    fn end(shininess: u32) -> f32;

    /// Evaluates the lobe, in [0, 1]. `incoming` points from the light to the surface, `view` from
    /// the surface to the eye.
    fn lobe<S: Scalar>(
        constants: &Self::Constants<S>,
        incoming: Vec3<S::Unit>,
        normal: Vec3<S>,
        view: Vec3<S::Unit>,
    ) -> S;
}

/// No specular lobe.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct NoSpecular;

/// `max(0, R.V)^m`: maximal for an eye in the mirror direction.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Phong;

/// `max(0, N.H)^m`: maximal for an eye in the mirror direction. A `BlinnPhong` lobe is about as
/// wide as a [`Phong`] lobe with a quarter of the shininess, and costs one more square root per
/// point and light.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct BlinnPhong;

/// `max(0, R.H)^m`, as written in the dual-cone GLSL article.
///
/// This lobe is neither Phong's nor Blinn's lobe. For an eye in the mirror direction, H is the
/// normal, so the lobe is only the m-th power of the cosine of the angle of incidence. The maximum
/// of the lobe is where H is the mirror direction: for an eye at three times the angle of
/// incidence.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct DualConeLobe;

/// [`Phong`] with a view direction V' that is already mirrored at the surface.
/// `|R - V| = |L - V'|`, so V' can be computed once per point instead of R for every light.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct MirroredPhong;

/// Lyon's difference form of another lobe, with `N` squarings. The shininess becomes a factor
/// instead of an exponent. So every point takes the same number of steps for every material, as
/// vector instructions require.
///
/// The lobe is defined for a shininess of at least `2^N`. The lobe is 0 from a certain angle on;
/// with fewer squarings this angle is smaller.
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
    /// A ramp over the versines 0 to 1, and the exponent. The ramp determines the scale of a
    /// versine.
    type Constants<S: Scalar> = (S::Ramp, u32);

    fn constants<S: Scalar>(shininess: u32) -> (S::Ramp, u32) {
        (S::ramp(0.0, 1.0, 1.0), shininess)
    }

    fn end(_: u32) -> f32 {
        1.0
    }

    #[inline(always)] // `lit-specular.fx16` on Cortex-M0: +41 instructions without.
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
    /// `1 - k versine`, as a ramp that ends in 0 at the versine `1 / k`.
    type Constants<S: Scalar> = S::Ramp;

    fn constants<S: Scalar>(shininess: u32) -> S::Ramp {
        let end = Self::end(shininess);
        S::ramp(0.0, end, end)
    }

    fn end(shininess: u32) -> f32 {
        (1_u32 << N) as f32 / shininess as f32
    }

    #[inline(always)] // `difference-form` on Cortex-M0: +32 instructions without.
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

/// A visitor of the lobes of the list, for surfaces in the format `S`.
#[cfg(feature = "arithmetic")]
pub trait LobeVisitor<S: Scalar> {
    /// Visits a lobe.
    fn lobe<H: Listed + SpecularLobe<Constants<S>: Source> + Named>(&mut self);
}

/// Visits the specular lobes.
#[cfg(feature = "arithmetic")]
pub fn lobes<S: Scalar>(visitor: &mut impl LobeVisitor<S>) {
    visitor.lobe::<Phong>();
    visitor.lobe::<MirroredPhong>();
    visitor.lobe::<BlinnPhong>();
    visitor.lobe::<DualConeLobe>();
    visitor.lobe::<DifferenceForm<Phong, 3>>();
}

#[cfg(feature = "arithmetic")]
listed! {
    /// The highlight of the mirrored direction: a material with a specular colour.
    Phong = "phong", Ok(Phong);
    /// Phong's highlight for a direction to the eye that is mirrored at the surface, once for all lights.
    MirroredPhong = "mirrored-phong", Ok(MirroredPhong);
    /// The highlight of the half angle.
    BlinnPhong = "blinn-phong", Ok(BlinnPhong);
    /// A spotlight's falloff about the mirrored direction.
    DualConeLobe = "dual-cone", Ok(DualConeLobe);
    /// Phong's highlight by a difference of directions and three squarings.
    DifferenceForm<Phong, 3> = "difference-form", Ok(DifferenceForm(Phong));
}
