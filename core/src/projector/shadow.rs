//! Shadow maps: whether a surface hides a spotlight from a point.

use super::CompiledProjection;
use super::projected::ProjectedPoint;
use crate::{
    error::{Error, Expected, Parameter},
    number::{STEPS, Scalar},
    vec3::Vec3,
};

/// A shadow map: the depths up to which a spotlight shines, on the square of its projection.
///
/// The map has `side` by `side` texels, in row-major order from the top left. Each texel holds a
/// depth along the axis of the light: points that project to the centre of the texel are lit up to
/// this depth, and deeper points are in shadow. Between the centres of four texels, the results of
/// the four depth comparisons are interpolated bilinearly; depths are never interpolated. This is
/// the 2 x 2 filter of Reeves, Salesin and Cook, *Rendering Antialiased Shadows with Depth Maps*,
/// SIGGRAPH 1987.
///
/// The comparison adds no bias. The renderer of the map adds the bias against self-shadowing to the
/// depths, once per texel instead of once per point. A look-up needs no normal, so a look-up also
/// works for points in the air.
///
/// ```
/// use luminaire::{Angle, Cone, SpotLight, Vec3, falloff::Soft, projector::{Projection, Shadow}};
/// // Two metres below the light, a board covers all that is on its left.
/// let cone = Cone::from_outer(Soft, Angle::degrees(90.0))?;
/// let spot = SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?;
/// let square = Projection::of(&spot)?.compile::<f32>()?;
/// let depths = [2.0, 2.0, 9.0, 9.0].repeat(4);
/// let shadow = Shadow::new(square, 4, &depths)?;
/// assert_eq!(shadow.visibility(Vec3::new(-2.0, 0.0, 0.0)), 0.0);
/// assert_eq!(shadow.visibility(Vec3::new(2.0, 0.0, 0.0)), 1.0);
/// assert_eq!(shadow.visibility(Vec3::new(0.0, 0.0, 0.0)), 0.5);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Shadow<'a, S: Scalar> {
    pub(crate) projection: CompiledProjection<S>,
    pub(crate) side: u32,
    pub(crate) depths: &'a [S::Length],
}

/// Largest number of texels per side. At this number each texel has 16 coordinate steps.
const MOST: usize = 4_096;

/// Number of bits of an interpolation weight.
///
/// The product of two weights is in units of 2^-14, the step of the 16-bit format, so every format
/// represents the product exactly.
const SHARE_BITS: u32 = 7;

/// In the interpolation between four texels: the sum of the two weights along one axis.
const WHOLE: u32 = 1 << SHARE_BITS;

/// Position along a row or a column, between two texel centres.
#[derive(Clone, Copy)]
struct Between {
    /// The texels before and after the position; equal in the outer half of a texel at the edge.
    texels: [u32; 2],
    /// The weights of the texels, which sum to [`WHOLE`].
    shares: [u32; 2],
}

impl<'a, S: Scalar> Shadow<'a, S> {
    /// Creates a shadow map of `side` rows of `side` depths on the square of a light.
    ///
    /// # Errors
    /// A side outside 1 to 4,096, or a number of depths other than the square of the side.
    pub fn new(
        projection: CompiledProjection<S>,
        side: usize,
        depths: &'a [S::Length],
    ) -> Result<Self, Error> {
        if !(1..=MOST).contains(&side) {
            let accepted = Expected::WholeBetween(1, MOST as u32);
            return Err(Error { parameter: Parameter::Side, value: side as f32, accepted });
        }
        if depths.len() != side * side {
            let accepted = Expected::Exactly((side * side) as f32);
            let (parameter, value) = (Parameter::SampleCount, depths.len() as f32);
            return Err(Error { parameter, value, accepted });
        }
        Ok(Self::from_parts(projection, side as u32, depths))
    }

    /// Creates a shadow map from its parts, as [`codegen`](crate::codegen) writes them.
    ///
    /// A texel without a depth, past the end of `depths`, hides nothing.
    pub const fn from_parts(projection: CompiledProjection<S>, side: u32, depths: &'a [S::Length]) -> Self {
        Self { projection, side, depths }
    }

    /// Returns the projection: the square that the map lies on.
    pub const fn projection(&self) -> &CompiledProjection<S> {
        &self.projection
    }

    /// Returns the number of texels per side.
    pub const fn side(&self) -> usize {
        self.side as usize
    }

    /// Returns the depths, row by row.
    pub const fn depths(&self) -> &'a [S::Length] {
        self.depths
    }

    /// Returns the visibility of the light from a point, in `[0, 1]`.
    ///
    /// The visibility is exactly 1 if nothing is between the light and the point, so that a
    /// multiplication by the visibility changes no bit. In full shadow the visibility is exactly 0.
    /// Off the square the nearest texel of the border applies: the rim of the cone touches the sides
    /// of the square, and the position of a point at the rim is rounded. Points behind the light have
    /// depth 0 and visibility 1.
    #[inline]
    pub fn visibility(&self, point: Vec3<S::Length>) -> S {
        self.at(&self.projection.project(point))
    }

    /// Attenuates a light by the visibility at a point; a visibility of 1 changes no bit.
    #[inline]
    pub fn filter(&self, light: S::Irradiance, point: Vec3<S::Length>) -> S::Irradiance {
        S::filter(light, self.visibility(point))
    }

    /// Returns the [`visibility`](Self::visibility) at a known position on the square, such as a
    /// position computed for a gobo.
    #[inline]
    pub fn at(&self, place: &ProjectedPoint<S>) -> S {
        let (row, column) = (self.between(place.row), self.between(place.column));
        let hidden = |i: usize, j: usize| {
            let texel = row.texels[i].wrapping_mul(self.side).wrapping_add(column.texels[j]);
            let is_hidden = self.depths.get(texel as usize).is_some_and(|depth| place.depth > *depth);
            if is_hidden { row.shares[i] * column.shares[j] } else { 0 }
        };
        let hidden = hidden(0, 0) + hidden(0, 1) + hidden(1, 0) + hidden(1, 1);
        S::from_steps((WHOLE * WHOLE - hidden) as i32)
    }

    /// Returns the texel centres around a coordinate, clamped to the square.
    #[inline]
    fn between(&self, along: i32) -> Between {
        // Subtracts half a texel, to count from the texel centres, and adds one texel, so that the
        // value is at least 0.
        let steps = (along.clamp(0, STEPS - 1) as u32).wrapping_mul(self.side).wrapping_add(1 << 15);
        let after = steps >> 16;
        let share = steps >> (16 - SHARE_BITS) & (WHOLE - 1);
        let last = self.side.saturating_sub(1);
        Between {
            texels: [after.saturating_sub(1), if after < last { after } else { last }],
            shares: [WHOLE - share, share],
        }
    }
}
