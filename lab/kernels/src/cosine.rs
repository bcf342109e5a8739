//! f32 with the versine by `1 - l.s`, which cancels in narrow beams: both numbers are near 1.

use luminaire::{Vec3, light::CompiledCone};

use crate::{
    kernel::Kernel,
    profile::Shape,
    scene::{AXIS, POSITION, Site},
    value::Value,
};

/// A compiled cone whose input is the cosine of the angle off axis.
#[derive(Clone, Copy, Debug)]
pub struct CosineFalloff<P: Shape> {
    falloff: CompiledCone<f32, P>,
}

impl<P: Shape> CosineFalloff<P> {
    /// Wraps a compiled cone.
    pub fn new(falloff: CompiledCone<f32, P>) -> Self {
        Self { falloff }
    }
}

impl<P: Shape> Kernel for CosineFalloff<P> {
    type Place = f32;
    type Input = f32;
    type Output = f32;

    fn input(&self, versine: &f32) -> f32 {
        cosine(*versine)
    }

    #[inline(always)]
    fn evaluate(&self, cosine: &f32) -> f32 {
        self.falloff.at(1.0 - cosine)
    }

    #[inline(always)]
    fn touch(cosine: &f32) -> u32 {
        cosine.bits()
    }
}

/// The cosine nearest to a versine.
pub(crate) fn cosine(versine: f32) -> f32 {
    (1.0 - f64::from(versine)) as f32
}

/// A spotlight with a soft edge and Lambert's cosine, without distance: one inner product serves
/// the reject and the versine.
#[derive(Clone, Copy, Debug)]
pub struct CosinePoint {
    outer: f32,
    reciprocal: f32,
    /// The squared cosine of the outer half angle, less a margin for rounding.
    bound: f32,
}

impl CosinePoint {
    /// The points of a cone that ends at this versine.
    pub fn new(outer: f32) -> Self {
        Self { outer, reciprocal: 1.0 / outer, bound: reject_bound(outer) }
    }
}

/// The bound of the early-out by squares, as in the kernel: with a margin for rounding.
pub(crate) fn reject_bound(outer: f32) -> f32 {
    1.0 - outer * (2.0 - outer) - 16.0 * f32::EPSILON
}

/// The offset from the light to a point, its squared length, and how far the surface faces the
/// light.
#[inline(always)]
pub(crate) fn way(site: &Site) -> (Vec3<f32>, f32, f32) {
    let way = site.point.zip(POSITION, |point, light| point - light);
    (way, way.dot(way), -way.dot(site.normal))
}

impl Kernel for CosinePoint {
    type Place = Site;
    type Input = Site;
    type Output = f32;

    fn input(&self, site: &Site) -> Site {
        *site
    }

    #[inline(always)]
    fn evaluate(&self, site: &Site) -> f32 {
        let (way, squared, facing) = way(site);
        if facing <= 0.0 {
            return 0.0;
        }
        let along = way.dot(AXIS);
        if along * along.abs() < self.bound * squared {
            return 0.0;
        }
        let reciprocal = 1.0 / sqrt(squared);
        let versine = 1.0 - along * reciprocal;
        let t = ((self.outer - versine) * self.reciprocal).clamp(0.0, 1.0);
        t * t * (facing * reciprocal)
    }

    #[inline(always)]
    fn touch(site: &Site) -> u32 {
        site.point.x.bits()
    }
}

/// The square root as the crate `luminaire` takes it.
#[inline(always)]
pub(crate) fn sqrt(x: f32) -> f32 {
    #[cfg(feature = "std")]
    return x.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrtf(x);
}
