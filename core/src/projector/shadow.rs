//! Shadows: whether anything stands between a spotlight and a point.

use super::CompiledProjection;
use crate::{
    error::{Error, Expected, Parameter},
    number::{ProjectedPoint, Scalar},
    vec3::Vec3,
};

/// A shadow map: how far a spotlight shines, on the square that it projects.
///
/// The square has so many texels on a side, row by row from its top, each row from its left. Each texel has the depth along
/// the axis of the light up to which points are lit in its middle; what is deeper is in shadow. Between four middles their
/// answers are weighted by how near they are (the 2 x 2 filter of Reeves, Salesin and Cook, *Rendering Antialiased Shadows
/// with Depth Maps*, SIGGRAPH 1987): depths are compared and never mixed.
///
/// The comparison has no tolerance of its own. Whoever draws the map gives its depths what keeps a surface from shadowing
/// itself, once per texel and not once per point. So there is no normal to be asked for either, and a point of the air
/// has a shadow as well as one of a surface.
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

/// The most texels along a side: then 16 steps of a place are in each.
const MOST: usize = 4_096;

/// Into how many parts the way from one middle to the next is divided, as a power of two: the product of two such parts is
/// a step of the 16-bit format, and exact in every other.
const SHARE_BITS: u32 = 7;

/// The whole way.
const WHOLE: u32 = 1 << SHARE_BITS;

/// Where a place lies along a row or a column of middles.
#[derive(Clone, Copy)]
struct Between {
    /// The texels before and after; one and the same in the outer half of the texels at the edge.
    texels: [u32; 2],
    /// How much each counts, of [`WHOLE`].
    shares: [u32; 2],
}

impl<'a, S: Scalar> Shadow<'a, S> {
    /// The shadow map of so many rows of as many depths on the square of a light.
    ///
    /// # Errors
    /// A side that is not from 1 to 4,096, or another number of depths than its square.
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

    /// The shadow map of these parts, as [`codegen`](crate::codegen) writes them. A texel that is missing hides nothing.
    pub const fn from_parts(projection: CompiledProjection<S>, side: u32, depths: &'a [S::Length]) -> Self {
        Self { projection, side, depths }
    }

    /// The square that the map lies on.
    pub const fn projection(&self) -> &CompiledProjection<S> {
        &self.projection
    }

    /// How many texels a side has.
    pub const fn side(&self) -> usize {
        self.side as usize
    }

    /// The depths, row by row.
    pub const fn depths(&self) -> &'a [S::Length] {
        self.depths
    }

    /// How much of the light arrives at a point, from 0 to 1: exactly one where nothing stands between, so that a factor of
    /// it changes no bit, and exactly zero in full shadow. What is off the square or behind the light has no shadow, as no
    /// light of the cone arrives there.
    #[inline]
    pub fn visibility(&self, point: Vec3<S::Length>) -> S {
        self.at(&self.projection.place(point))
    }

    /// What is left of this light at a point; where all of it is, no bit has changed.
    #[inline]
    pub fn filter(&self, light: S::Irradiance, point: Vec3<S::Length>) -> S::Irradiance {
        S::filter(light, self.visibility(point))
    }

    /// The same for a place that is known, as one that a pattern has already been asked for.
    #[inline]
    pub fn at(&self, place: &ProjectedPoint<S>) -> S {
        let (row, column) = (self.between(place.row), self.between(place.column));
        let hidden = |i: usize, j: usize| {
            let texel = row.texels[i].wrapping_mul(self.side).wrapping_add(column.texels[j]);
            let is_hidden = self.depths.get(texel as usize).is_some_and(|depth| place.depth > *depth);
            if is_hidden { row.shares[i] * column.shares[j] } else { 0 }
        };
        let hidden = hidden(0, 0) + hidden(0, 1) + hidden(1, 0) + hidden(1, 1);
        S::part(if place.is_inside() { WHOLE * WHOLE - hidden } else { WHOLE * WHOLE })
    }

    /// The middles between which a place lies that is on the square.
    #[inline]
    fn between(&self, along: i32) -> Between {
        // Half a texel back, to the middles, and a whole one forth, which keeps it from being negative.
        let steps = (along as u32).wrapping_mul(self.side).wrapping_add(1 << 15);
        let after = steps >> 16;
        let share = steps >> (16 - SHARE_BITS) & (WHOLE - 1);
        let last = self.side.saturating_sub(1);
        Between {
            texels: [after.saturating_sub(1), if after < last { after } else { last }],
            shares: [WHOLE - share, share],
        }
    }
}
