//! Lit points in f32.

use core::hint::black_box;

use luminaire::Vec3;
use micromath::F32Ext;

use super::values::{RANGE, lit, root};
use crate::{
    scene::{AXIS, INTENSITY, POSITION},
    value::Green,
};

/// The square root of the processor, or of the crate libm.
#[inline(always)]
fn sqrt(x: f32) -> f32 {
    #[cfg(feature = "std")]
    return f32::sqrt(x);
    #[cfg(not(feature = "std"))]
    luminaire_native::sqrt(x).unwrap_or_else(|| libm::sqrtf(x))
}

#[inline(always)]
fn between(from: Vec3<f32>, to: Vec3<f32>) -> Vec3<f32> {
    to.zip(from, |to, from| to - from)
}

/// A soft spotlight as a shader has it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plain {
    outer: f32,
}

impl Plain {
    pub(crate) const fn new(outer: f32) -> Self {
        Self { outer: 1.0 - outer }
    }

    #[inline(always)]
    fn at(&self, point: Vec3<f32>, normal: Vec3<f32>) -> f32 {
        let way = between(POSITION, point);
        let squared = way.dot(way);
        let length = sqrt(squared);
        let unit = way.map(|c| c / length);
        let t = ((unit.dot(AXIS) - self.outer) / (1.0 - self.outer)).clamp(0.0, 1.0);
        INTENSITY * t * t * (-unit.dot(normal)).max(0.0) / squared
    }
}

/// A soft spotlight by the difference of the direction and the axis, which keeps the bits of narrow cones.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Difference {
    /// The reciprocal of twice the outer versine.
    reciprocal: f32,
}

impl Difference {
    pub(crate) const fn new(outer: f32) -> Self {
        Self { reciprocal: 0.5 / outer }
    }

    #[inline(always)]
    fn at(&self, point: Vec3<f32>, normal: Vec3<f32>) -> f32 {
        let way = between(POSITION, point);
        let facing = way.dot(normal);
        if facing < 0.0 {
            let reciprocal = 1.0 / sqrt(way.dot(way));
            let apart = way.zip(AXIS, |way, axis| way * reciprocal - axis);
            let t = 1.0 - apart.dot(apart) * self.reciprocal;
            if t > 0.0 {
                let scaled = t * reciprocal;
                return INTENSITY * scaled * scaled * (-facing * reciprocal);
            }
        }
        0.0
    }
}

/// A soft spotlight by an inner product and the reciprocal root of the crate micromath, which is off by 5 %,
/// with two steps of Newton's method.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Micromath {
    outer: f32,
    reciprocal: f32,
}

impl Micromath {
    pub(crate) const fn new(outer: f32) -> Self {
        Self { outer: 1.0 - outer, reciprocal: 1.0 / outer }
    }

    #[inline(always)]
    fn at(&self, point: Vec3<f32>, normal: Vec3<f32>) -> f32 {
        let way = between(POSITION, point);
        let facing = -way.dot(normal);
        if facing > 0.0 {
            let squared = way.dot(way);
            let step = |root: f32| root * (1.5 - 0.5 * squared * root * root);
            let reciprocal = step(step(F32Ext::invsqrt(squared)));
            let t = (way.dot(AXIS) * reciprocal - self.outer) * self.reciprocal;
            if t > 0.0 {
                let scaled = t * reciprocal;
                return INTENSITY * scaled * scaled * (facing * reciprocal);
            }
        }
        0.0
    }
}

/// The spotlight of TGX 1.1, in one channel and without its highlight: `Renderer3D.h`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tgx {
    outer: f32,
    reciprocal: f32,
}

impl Tgx {
    pub(crate) const fn new(outer: f32) -> Self {
        Self { outer: 1.0 - outer, reciprocal: 1.0 / outer }
    }

    #[inline(always)]
    fn at(&self, point: Vec3<f32>, normal: Vec3<f32>) -> f32 {
        let back = between(point, POSITION);
        let squared = back.dot(back);
        if squared <= 1e-12 || squared >= RANGE * RANGE {
            return 0.0;
        }
        let facing = back.dot(normal);
        if facing <= 0.0 {
            return 0.0;
        }
        let reciprocal = 1.0 / sqrt(squared);
        let window = 1.0 - squared * (1.0 / (RANGE * RANGE));
        let cosine = -back.dot(AXIS) * reciprocal;
        if cosine <= self.outer {
            return 0.0;
        }
        let t = (cosine - self.outer) * self.reciprocal;
        let t = if t > 1.0 { 1.0 } else { t };
        facing * reciprocal * (window * window * (t * t))
    }
}

/// The spotlight of embedded-3dgfx 0.7, which takes micromath's root and cosines without a standard library:
/// `pipeline/shade/lights.rs`. Its channels are cut to the codes of RGB565.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Embedded3dgfx {
    /// The outer half angle in radians.
    outer: f32,
}

impl Embedded3dgfx {
    /// Sums the series of the arc sine of the root of half the versine.
    pub(crate) const fn new(outer: f32) -> Self {
        let squared = outer as f64 / 2.0;
        let (mut sum, mut term, mut n) = (0.0, root(squared), 0.0);
        while n < 40.0 {
            sum += term / (2.0 * n + 1.0);
            term *= squared * (2.0 * n + 1.0) / (2.0 * n + 2.0);
            n += 1.0;
        }
        Self { outer: (2.0 * sum) as f32 }
    }

    #[inline(always)]
    fn at(&self, point: Vec3<f32>, normal: Vec3<f32>) -> Green {
        let way = between(POSITION, point);
        let squared = way.dot(way);
        if !(1e-6..RANGE * RANGE).contains(&squared) {
            return Green(0);
        }
        let length = F32Ext::sqrt(squared);
        let unit = way.map(|c| c / length);
        // A light of the crate is in memory, so that its two cosines are computed at each point.
        let [outer, inner] = black_box([self.outer, 0.0]).map(F32Ext::cos);
        let cosine = unit.dot(AXIS);
        if cosine <= outer {
            return Green(0);
        }
        let t = if inner > outer { ((cosine - outer) / (inner - outer)).clamp(0.0, 1.0) } else { 1.0 };
        let window = (1.0 - squared / (RANGE * RANGE)).max(0.0);
        let factor = t * t * window * (-unit.dot(normal)).max(0.0);
        let [red, green] = [31.0, 63.0].map(|white: f32| (white * factor).min(white) as u16);
        Green(red << 11 | green << 5 | red)
    }
}

lit!(Plain: f32 => f32);
lit!(Difference: f32 => f32);
lit!(Micromath: f32 => f32);
lit!(Tgx: f32 => f32);
lit!(Embedded3dgfx: f32 => Green);
