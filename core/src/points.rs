//! Surface points, and where the points of one call come from.

use crate::{
    number::{Offset, Ray, Scalar},
    vec3::{Vec3, nth},
};

/// A surface point, with its normal and the direction to the eye.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfacePoint<S: Scalar> {
    /// The position, in the unit of the lights' positions.
    pub point: Vec3<S::Length>,
    /// The normal, of unit length.
    pub normal: Vec3<S>,
    /// The direction from the point to the eye, of unit length. Unused for a matte surface.
    pub view: Vec3<S::Unit>,
}

impl<S: Scalar> SurfacePoint<S> {
    /// Creates a point of a matte surface, which looks the same from every side.
    #[inline]
    pub fn matte(point: Vec3<S::Length>, normal: Vec3<S>) -> Self {
        Self { point, normal, view: Vec3::default() }
    }

    /// Creates a point that is seen by an eye. The direction to the eye takes one square root per
    /// point, whatever the number of lights.
    #[inline]
    pub fn seen_from(eye: Vec3<S::Length>, point: Vec3<S::Length>, normal: Vec3<S>) -> Self {
        Self { point, normal, view: S::Offset::between(point, eye).ray().direction() }
    }
}

/// Surface points as a structure of arrays: see [`SurfacePoint`].
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoints<'a, S: Scalar, const N: usize> {
    /// The positions of the points.
    pub point: Vec3<&'a [S::Length; N]>,
    /// The normals, of unit length.
    pub normal: Vec3<&'a [S; N]>,
    /// The directions from the points to the eye, of unit length. Unused for matte surfaces.
    pub view: Vec3<&'a [S::Unit; N]>,
}

impl<S: Scalar, const N: usize> SurfacePoints<'_, S, N> {
    /// Returns point `i`; for `i >= N`, a point with all components 0.
    #[inline]
    pub fn at(&self, i: usize) -> SurfacePoint<S> {
        SurfacePoint {
            point: self.point.map(|column| nth(column, i)),
            normal: self.normal.map(|column| nth(column, i)),
            view: self.view.map(|column| nth(column, i)),
        }
    }
}

/// The points of a [`Row`](crate::light::Row): a function from an index to a point, or [`AlongX`].
#[doc(hidden)]
pub trait Points<S: Scalar> {
    /// Whether all points have the same y and z, and their x rises or falls with the index.
    const ALONG_X: bool = false;

    /// Returns the point of an index.
    fn at(&self, index: usize) -> Vec3<S::Length>;
}

impl<S: Scalar, F: Fn(usize) -> Vec3<S::Length>> Points<S> for F {
    #[inline]
    fn at(&self, index: usize) -> Vec3<S::Length> {
        self(index)
    }
}

/// The points of [`Row::along_x`](crate::light::Row::along_x).
#[derive(Clone, Copy, Debug)]
pub struct AlongX<T, F> {
    pub(crate) y: T,
    pub(crate) z: T,
    pub(crate) x: F,
}

impl<S: Scalar, F: Fn(usize) -> S::Length> Points<S> for AlongX<S::Length, F> {
    const ALONG_X: bool = true;

    #[inline]
    fn at(&self, index: usize) -> Vec3<S::Length> {
        Vec3 { x: (self.x)(index), y: self.y, z: self.z }
    }
}

/// The points of every `STEP`-th index from the first on.
pub(crate) struct Every<'a, F, const STEP: usize = 1> {
    pub(crate) points: &'a F,
    pub(crate) first: usize,
}

impl<S: Scalar, F: Points<S>, const STEP: usize> Points<S> for Every<'_, F, STEP> {
    const ALONG_X: bool = F::ALONG_X;

    #[inline(always)]
    fn at(&self, index: usize) -> Vec3<S::Length> {
        self.points.at(self.first.wrapping_add(index.wrapping_mul(STEP)))
    }
}
