//! The versine form in f64, from sites in f32: shows the cost of twice the width.

use core::marker::PhantomData;

use luminaire::falloff::ListedFalloff;

use crate::{
    kernel::Kernel,
    scene::{AXIS, POSITION, Site},
    truth,
    value::Value,
};

/// A vector. Not one of a library: the instructions of this kernel are on record, to the last one.
type Vector = [f64; 3];

/// A compiled cone.
#[derive(Clone, Copy, Debug)]
pub struct DoubleFalloff<P> {
    outer: f64,
    reciprocal: f64,
    falloff: PhantomData<P>,
}

impl<P: ListedFalloff> DoubleFalloff<P> {
    /// The cone that ends at this versine.
    pub fn new(outer: f32) -> Self {
        let outer = f64::from(outer);
        Self { outer, reciprocal: 1.0 / outer, falloff: PhantomData }
    }

    #[inline(always)]
    fn at(&self, versine: f64) -> f64 {
        if versine < self.outer { P::truth((self.outer - versine) * self.reciprocal) } else { 0.0 }
    }
}

impl<P: ListedFalloff> Kernel for DoubleFalloff<P> {
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
    axis: Vector,
    /// The squared cosine of the outer half angle, less a margin for rounding.
    bound: f64,
}

impl DoublePoint {
    /// The points of a cone that ends at this versine.
    pub fn new(outer: f32) -> Self {
        let squared_sine = f64::from(outer) * (2.0 - f64::from(outer));
        let bound = 1.0 - squared_sine - 16.0 * f64::EPSILON;
        Self { falloff: DoubleFalloff::new(outer), axis: truth::widened(AXIS).normalize().to_array(), bound }
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
        let way = minus(widened(site.point), widened(POSITION));
        let (squared, facing) = (dot(way, way), -dot(way, widened(site.normal)));
        if facing <= 0.0 {
            return 0.0;
        }
        let along = dot(way, self.axis);
        if along * along.abs() < self.bound * squared {
            return 0.0;
        }
        let reciprocal = 1.0 / sqrt(squared);
        let difference = minus(scaled(way, reciprocal), self.axis);
        self.falloff.at(0.5 * dot(difference, difference)) * (facing * reciprocal)
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

fn widened(v: luminaire::Vec3<f32>) -> Vector {
    [v.x.into(), v.y.into(), v.z.into()]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn scaled(a: Vector, by: f64) -> Vector {
    a.map(|c| c * by)
}
