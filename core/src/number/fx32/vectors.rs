//! Many points at once, for vector instructions: the stages of the format, with the same bits, but for the operations
//! that [`lanes`](crate::number::lanes) replaces.
//!
//! *Rare* are points whose offset a single point scales in a branch, because its largest component is less than one unit,
//! or 128 and more; and those whose light is so bright or so dark that the power of two of its shift does not fit. The
//! points of a block with one of them are evaluated one by one.

use super::{Fine, FineRay, Fx32, Light32, Offset32, SHORT, high_half, size, squared_length};
use crate::{
    number::{
        HAS_VECTORS, Lamp, Length, Ray, Share, Vectors,
        lanes::{QUICK_NODES, bits_and_power},
        root::interpolated_quickly,
    },
    vec3::{Vec3, nth},
};

/// The bit lengths of the offsets that are not rare, and the scale of a light's gain.
#[derive(Clone, Copy, Debug)]
struct Reach {
    least: u32,
    more: u32,
    left: u32,
    right: u32,
}

impl Reach {
    /// Number of bits that the product of a light is shifted by, after the product with a power of two.
    const SHIFT: i32 = 24;

    /// Returns the reach of a light; `None` if all points are rare.
    ///
    /// The light of a share is `product / 2^k` with `k = shift + 2 bits - 61`, rounded by its last bit: half of
    /// `product 2^(25 - k) / 2^24`. That power of two is the square of `2^(31 - bits)` times `2^(24 - shift)`. It has to
    /// be 1 to 2^31.
    #[inline(always)]
    fn new(shift: i32) -> Option<Self> {
        /// The bit lengths that a single point scales without a branch.
        const COMMON: [i32; 2] = [SHORT as i32 + 1, SHORT as i32 + 7];
        // Twice the bit length for an exponent of 31, and of 0.
        let most = (62 + Self::SHIFT).saturating_sub(shift);
        let least = ((most - 31 + 1) >> 1).max(COMMON[0]);
        let most = (most >> 1).min(COMMON[1]);
        (least <= most).then(|| Self {
            least: least as u32,
            more: (most - least) as u32,
            left: Self::SHIFT.saturating_sub(shift).clamp(0, 31) as u32,
            right: shift.saturating_sub(Self::SHIFT).clamp(0, 31) as u32,
        })
    }

    #[inline(always)]
    fn is_rare(&self, bits: u32) -> bool {
        bits.wrapping_sub(self.least) > self.more
    }

    /// Returns the light of a product at an offset that was scaled by a power of two.
    #[inline(always)]
    fn light(&self, product: u32, power: u32) -> Light32 {
        let power = (power.wrapping_mul(power) << self.left) >> self.right;
        let doubled = (u64::from(product) * u64::from(power)) >> Self::SHIFT;
        Light32::from_bits((doubled >> 1) + (doubled & 1))
    }
}

impl Vectors<Fx32> for Offset32 {
    const IS_VECTORISED: bool = HAS_VECTORS;

    #[inline(always)]
    fn in_vectors<const N: usize>(
        lamp: &Lamp<Fx32>,
        points: Vec3<&[Length; N]>,
        normals: Vec3<&[Fx32; N]>,
        falloff: impl Fn(Fine) -> Fine,
        shines: bool,
        lobe: impl Fn(usize, Vec3<Fx32>, Fx32) -> Fx32,
        (diffuse, specular): (&mut [Light32; N], &mut [Light32; N]),
    ) -> bool {
        if !Self::IS_VECTORISED {
            return false;
        }
        let (lamp, reach) = (*lamp, Reach::new(lamp.intensity.shift));
        let Some(reach) = reach else { return false };
        let (mut x, mut y, mut z) = ([0; N], [0; N], [0; N]);
        let (mut powers, mut squares, mut nodes) = ([0; N], [0; N], [0; N]);
        let (mut products, mut others) = ([0; N], [0; N]);
        let mut has_rare = false;
        for i in 0..N {
            let way =
                points.map(|c| nth(c, i)).zip(lamp.position, |p, l| p.to_bits().wrapping_sub(l.to_bits()));
            let (bits, power) = bits_and_power(size(way));
            let way = way.map(|c| c.wrapping_mul(power as i32));
            (x[i], y[i], z[i]) = (way.x, way.y, way.z);
            (powers[i], squares[i]) = (power, squared_length(Self { way, bits: 0 }.coarse()));
            has_rare |= reach.is_rare(bits);
        }
        if has_rare {
            return false;
        }
        for i in 0..N {
            nodes[i] = QUICK_NODES[(squares[i] >> 23) as usize];
        }
        for i in 0..N {
            let estimate = interpolated_quickly(nodes[i] >> 16, nodes[i] & 0xffff, squares[i]);
            // The bit length would be that of the light's shift and of the distance alone.
            let ray = FineRay::new(Vec3::new(x[i], y[i], z[i]), estimate, 0);
            let cosine = Ray::<Fx32>::cosine(&ray, 0, normals.map(|c| nth(c, i)));
            let falloff = falloff(Ray::<Fx32>::rise(&ray, lamp.axis, lamp.ramp));
            let here = ray.attenuated(lamp.intensity.mantissa << 4);
            products[i] = high_half(cosine.times(falloff).0, here);
            if shines {
                let lobe = lobe(i, ray.unit(), Share::<Fx32>::scalar(cosine));
                others[i] = high_half(falloff.times(Share::<Fx32>::of_scalar(lobe)).0, here);
            }
        }
        for i in 0..N {
            diffuse[i] = reach.light(products[i], powers[i]);
            if shines {
                specular[i] = reach.light(others[i], powers[i]);
            }
        }
        true
    }
}
