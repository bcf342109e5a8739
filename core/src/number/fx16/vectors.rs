//! Many points at once, for vector instructions: the stages of the format, with the same bits, but for the operations
//! that [`lanes`](crate::number::lanes) replaces.
//!
//! Points for which a single point would take a branch are *rare*: those near the light, which may need the fine
//! evaluation, and those so far away that a product would not fit. The points of a block with one of them are
//! evaluated one by one.
//! A surface that faces away, and a point outside the cone, have a share of zero without a branch.

use super::{
    Fraction16, Gain16, Light16, Offset16, QuickOffset16, QuickRay16, Ray16, WAY_BITS, product_at, root,
};
use crate::{
    number::{
        Fraction, Fx16, Fx32, HAS_VECTORS, Lamp, Length, Offset, Ray, Share, Vectors,
        lanes::{BITS, NODES, QUICK_NODES, bits_and_power},
    },
    vec3::{Vec3, nth},
};

/// An offset of the standard or of the quick evaluation, among many points.
pub(crate) trait Among:
    Offset<Fx16, Facing = i32, Ray: Ray<Fx16, Share = Fx16, Fraction = Fraction16>>
{
    /// The nodes of the root by the upper nine bits of a squared length: a node in the upper 16 bits, and its
    /// difference to the next in the lower ones.
    const NODES: &'static [u32; 512];

    /// Returns the offset that was scaled to [`BITS`] bits.
    fn of(way: Vec3<i32>) -> Self;
    /// Returns the squared length.
    fn squared(&self) -> u32;
    /// Returns the ray, from the squared length and its nodes.
    fn ray_by(&self, squared: u32, nodes: u32) -> Self::Ray;
    /// Returns the reciprocal length of a ray.
    fn reciprocal(ray: &Self::Ray) -> u32;
}

impl Among for Offset16 {
    const NODES: &'static [u32; 512] = &NODES;

    #[inline(always)]
    fn of(way: Vec3<i32>) -> Self {
        // The bit length is that of `Reach`: only the last shift would need it.
        Self { way, shift: BITS - WAY_BITS, bits: 0 }
    }

    #[inline(always)]
    fn squared(&self) -> u32 {
        self.squared()
    }

    #[inline(always)]
    fn ray_by(&self, squared: u32, nodes: u32) -> Ray16 {
        let is_long = squared >= 1 << 30;
        let guess =
            root::interpolated(nodes >> 16, nodes & 0xffff, if is_long { squared } else { squared << 2 });
        self.ray_with(squared, if is_long { (guess + 1) >> 1 } else { guess })
    }

    #[inline(always)]
    fn reciprocal(ray: &Ray16) -> u32 {
        ray.reciprocal
    }
}

impl Among for QuickOffset16 {
    const NODES: &'static [u32; 512] = &QUICK_NODES;

    #[inline(always)]
    fn of(way: Vec3<i32>) -> Self {
        Self { way: way.map(|c| c >> (BITS - super::COARSE_BITS)), bits: 0 }
    }

    #[inline(always)]
    fn squared(&self) -> u32 {
        super::squared_length(self.way)
    }

    #[inline(always)]
    fn ray_by(&self, squared: u32, nodes: u32) -> QuickRay16 {
        let reciprocal = root::interpolated_quickly(nodes >> 16, nodes & 0xffff, squared);
        QuickRay16 { offset: *self, squared, reciprocal }
    }

    #[inline(always)]
    fn reciprocal(ray: &QuickRay16) -> u32 {
        ray.reciprocal
    }
}

/// The bit lengths of the offsets that are not rare, and the scale of a light's gain.
#[derive(Clone, Copy, Debug)]
struct Reach {
    least: u32,
    more: u32,
    /// The bit length and the squared length below which a point of this bit length is near.
    near_bits: u32,
    near: u32,
    left: u32,
    right: u32,
}

impl Reach {
    /// Returns the reach of a light; `None` if all points are rare.
    ///
    /// The light of a share is `product / 2^k` with `k = scale + 2 bits - 32`, rounded by its last bit: half of
    /// `product 2^(65 - scale - 2 bits) / 2^32`. That power of two is the square of `2^(31 - bits)` times
    /// `2^(3 - scale)`. It has to fit 32 bits, and the square, too, so `bits` is at least 16; where it is below 1, the
    /// light is 0.
    #[inline(always)]
    fn new(gain: Gain16, fine_below: u32) -> Option<Self> {
        /// The most bits of which the exponent of an f32 is exact.
        const MOST: i32 = 24;
        let scale = gain.scale();
        let near_bits = fine_below >> 26;
        let least = (35 - scale).div_euclid(2).max(16).max(near_bits as i32);
        (least <= MOST).then(|| Self {
            least: least as u32,
            more: (MOST - least) as u32,
            near_bits,
            near: (fine_below & ((1 << 26) - 1)).saturating_mul(1 << 4),
            left: (3 - scale).clamp(0, 31) as u32,
            right: (scale - 3).clamp(0, 31) as u32,
        })
    }

    #[inline(always)]
    fn is_rare(&self, bits: u32, squared: u32) -> bool {
        (bits.wrapping_sub(self.least) > self.more) | ((bits == self.near_bits) & (squared < self.near))
    }

    /// Returns the light of a product at an offset that was scaled by a power of two.
    #[inline(always)]
    fn light(&self, product: u32, power: u32) -> Light16 {
        let power = (power.wrapping_mul(power) << self.left) >> self.right;
        let doubled = ((u64::from(product) * u64::from(power)) >> 32) as u32;
        Light16::from_bits((doubled >> 1) + (doubled & 1))
    }
}

impl<O: Among> Vectors<Fx16> for O {
    const IS_VECTORISED: bool = HAS_VECTORS;
    const HAS_ONE_CUBIC: bool = true;

    #[inline(always)]
    fn in_vectors<const N: usize>(
        lamp: &Lamp<Fx16>,
        points: Vec3<&[Length; N]>,
        normals: Vec3<&[Fx16; N]>,
        falloff: impl Fn(Fraction16) -> Fx16,
        shines: bool,
        lobe: impl Fn(usize, Vec3<Fx32>, Fx16) -> Fx16,
        (diffuse, specular): (&mut [Light16; N], &mut [Light16; N]),
    ) -> bool {
        if !Self::IS_VECTORISED {
            return false;
        }
        let (lamp, reach) = (*lamp, Reach::new(lamp.intensity, lamp.fine_below));
        let Some(reach) = reach else { return false };
        let (mut x, mut y, mut z) = ([0; N], [0; N], [0; N]);
        let (mut powers, mut squares, mut nodes) = ([0; N], [0; N], [0; N]);
        let mut has_rare = false;
        for i in 0..N {
            let way =
                points.map(|c| nth(c, i)).zip(lamp.position, |p, l| p.to_bits().wrapping_sub(l.to_bits()));
            let (bits, power) = bits_and_power(root::size(way));
            let way = way.map(|c| c.wrapping_mul(power as i32));
            let offset = Self::of(way);
            let squared = offset.squared();
            (x[i], y[i], z[i]) = (way.x, way.y, way.z);
            (powers[i], squares[i]) = (power, squared);
            has_rare |= reach.is_rare(bits, squared);
        }
        if has_rare {
            return false;
        }
        for i in 0..N {
            nodes[i] = Self::NODES[(squares[i] >> 23) as usize];
        }
        for i in 0..N {
            let offset = Self::of(Vec3::new(x[i], y[i], z[i]));
            let ray = offset.ray_by(squares[i], nodes[i]);
            let normal = normals.map(|c| nth(c, i));
            let cosine = ray.cosine(offset.facing(normal), normal);
            let falloff = falloff(ray.rise(lamp.axis, lamp.ramp));
            let light =
                |share| reach.light(product_at(Self::reciprocal(&ray), share, lamp.intensity), powers[i]);
            diffuse[i] = light(cosine.times_value(falloff));
            if shines {
                specular[i] = light(falloff.times(lobe(i, ray.direction(), cosine.value())));
            }
        }
        true
    }
}
