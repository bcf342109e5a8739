//! The versine form in f64, from sites in f32: shows the cost of twice the width.

use core::marker::PhantomData;

use luminaire_oracle::DVec3;

use crate::{
    kernel::Kernel,
    profile::Shape,
    scene::{AXIS, POSITION, Site},
    truth::widened,
    value::Value,
};

/// A compiled cone.
#[derive(Clone, Copy, Debug)]
pub struct DoubleFalloff<P> {
    outer: f64,
    reciprocal: f64,
    profile: PhantomData<P>,
}

impl<P: Shape> DoubleFalloff<P> {
    /// The cone that ends at this versine.
    pub fn new(outer: f32) -> Self {
        let outer = f64::from(outer);
        Self { outer, reciprocal: 1.0 / outer, profile: PhantomData }
    }

    #[inline(always)]
    fn at(&self, versine: f64) -> f64 {
        if versine < self.outer { P::double((self.outer - versine) * self.reciprocal) } else { 0.0 }
    }
}

impl<P: Shape> Kernel for DoubleFalloff<P> {
    type Place = f32;
    type Input = f64;
    type Output = f64;

    fn input(&self, versine: &f32) -> f64 {
        f64::from(*versine)
    }

    #[inline(always)]
    fn evaluate(&self, versine: &f64) -> f64 {
        self.at(*versine)
    }

    #[inline(always)]
    fn touch(versine: &f64) -> u32 {
        versine.to_bits() as u32
    }
}

/// A spotlight with a soft edge, Lambert's cosine and no distance.
#[derive(Clone, Copy, Debug)]
pub struct DoublePoint {
    falloff: DoubleFalloff<luminaire::falloff::Soft>,
    axis: DVec3,
    /// The squared cosine of the outer half angle, less a margin for rounding.
    bound: f64,
}

impl DoublePoint {
    /// The points of a cone that ends at this versine.
    pub fn new(outer: f32) -> Self {
        let squared_sine = f64::from(outer) * (2.0 - f64::from(outer));
        let bound = 1.0 - squared_sine - 16.0 * f64::EPSILON;
        Self { falloff: DoubleFalloff::new(outer), axis: widened(AXIS).normalize(), bound }
    }
}

impl Kernel for DoublePoint {
    type Place = Site;
    type Input = Site;
    type Output = f64;

    fn input(&self, site: &Site) -> Site {
        *site
    }

    #[inline(always)]
    fn evaluate(&self, site: &Site) -> f64 {
        let way = widened(site.point) - widened(POSITION);
        let (squared, facing) = (way.length_squared(), -way.dot(widened(site.normal)));
        if facing <= 0.0 {
            return 0.0;
        }
        let along = way.dot(self.axis);
        if along * along.abs() < self.bound * squared {
            return 0.0;
        }
        let reciprocal = 1.0 / sqrt(squared);
        let difference = way * reciprocal - self.axis;
        self.falloff.at(0.5 * difference.length_squared()) * (facing * reciprocal)
    }

    #[inline(always)]
    fn touch(site: &Site) -> u32 {
        site.point.x.bits()
    }
}

#[inline(always)]
fn sqrt(x: f64) -> f64 {
    #[cfg(feature = "std")]
    return x.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrt(x);
}
