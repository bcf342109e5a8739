//! The fine evaluation of the 16-bit format, for cones and lights that magnify rounding errors of
//! 15 bits too much.
//!
//! [`Cone::compile`](crate::Cone::compile) selects such cones by an error bound;
//! `Arithmetic::fine_below` gives the distance from a bright light below which points need the fine
//! evaluation.

use crate::number::{
    FixedRamp, Fx16, Fx32, Gain16, Light16, Offset, Ray, fine::Fine, fine_ray::FineRay, product::high_half,
};
use crate::vec3::Vec3;

impl Ray<Fx16> for FineRay {
    type Fraction = Fine;
    type Share = Fine;

    #[inline]
    fn distance(&self) -> Gain16 {
        Gain16::normalised(self.length(), 47 - self.bits)
    }

    #[inline]
    fn direction(&self) -> Vec3<Fx32> {
        self.unit()
    }

    #[inline(always)] // `spot-soft` on Cortex-M0: +21 instructions without.
    fn rise(&self, axis: Vec3<Fx32>, ramp: FixedRamp) -> Fine {
        ramp.rise_finely(self.versine(axis, ramp))
    }

    /// Computes the cosine from the normal, because `facing` has too few bits. The sum wraps for
    /// normals longer than 1, which is defined behaviour.
    #[inline]
    fn cosine(&self, _: i32, normal: Vec3<Fx16>) -> Fine {
        let products = self.direction.zip(normal, |d, n| {
            let n = i32::from(n.to_bits());
            (d >> 14).wrapping_mul(n).wrapping_add(((d & 0x3fff) * n) >> 14)
        });
        let along = products.x.wrapping_add(products.y).wrapping_add(products.z);
        Fine::capped(along.min(0).unsigned_abs(), -1)
    }

    #[inline]
    fn near(&self, gain: Gain16) -> Fine {
        Fine::capped(high_half(self.length(), gain.mantissa), gain.shift - self.bits - 16)
    }

    #[inline]
    fn squared_near<O: Offset<Fx16>>(&self, _: &O, gain: Gain16) -> Fine {
        Fine::capped(high_half(self.squared, gain.mantissa), gain.shift - 2 * self.bits - 1)
    }

    #[inline]
    fn expose(&self, share: Fine, gain: Gain16) -> Light16 {
        // `here`, the gain at this distance, has at least 26 bits. The product of `here` and the
        // share has at least 16 bits, unless the light is far below one linear code.
        let here = self.attenuated(gain.mantissa);
        Light16::shifted(high_half(share.0, here), gain.shift + 2 * self.bits - 49)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{FullOffset, fixed16::Offset16};

    /// With a normal longer than 1 the cosine wraps, like a 64-bit sum truncated to 32 bits.
    #[test]
    fn the_cosine_of_a_long_normal_wraps() {
        let ways =
            [Vec3::new(1 << 20, 1 << 20, 1 << 20), Vec3::new(-(1 << 20), 0, 0), Vec3::new(1 << 20, 0, 0)];
        let rays = ways.map(|way| Offset16::new(way).fine_ray());
        for (ray, n) in
            rays.into_iter().flat_map(|ray| [i16::MIN, -20_000, 1 << 14, 30_000, i16::MAX].map(|n| (ray, n)))
        {
            let product =
                |d: i32| (i64::from(d >> 14) * i64::from(n)) + ((i64::from(d & 0x3fff) * i64::from(n)) >> 14);
            let along =
                (product(ray.direction.x) + product(ray.direction.y) + product(ray.direction.z)) as i32;
            let normal = Vec3::new(n, n, n).map(Fx16::from_bits);
            assert_eq!(ray.cosine(0, normal), Fine::capped(along.min(0).unsigned_abs(), -1), "{n}");
        }
    }
}
