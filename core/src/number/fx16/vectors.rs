//! Many points at once, for vector instructions: the stages of the format, with the same bits.
//!
//! A processor with vectors computes a stage of several points in one instruction, as long as the stage has
//! no branch, no look-up, and no shift that differs from point to point. Four operations of a single point
//! have one of these, and are replaced; all other stages are the functions that a single point takes.
//!
//! | operation | one point | many points |
//! |---|---|---|
//! | bit length of an offset | an instruction or a table | the exponent of its size as f32, exact for 24 bits |
//! | offset of 17 and of 15 bits | a shift by the bit length | a product with `2^(31 - bits)`, then constant shifts |
//! | nodes of the root | a look-up within the root | look-ups in a loop of their own |
//! | light | a shift by twice the bit length | a product with the square of that power of two |
//!
//! Points for which a single point would take a branch are *rare*: those near the light, which may need the fine
//! evaluation, and those so far away that a product would not fit. The points of a block with one of them are
//! evaluated one by one.
//! A surface that faces away, and a point outside the cone, have a share of zero without a branch.

use super::{
    Fraction16, Gain16, Light16, Offset16, QuickOffset16, QuickRay16, Ray16, WAY_BITS, product_at, root,
};
use crate::{
    number::{Fraction, Fx16, Fx32, HAS_VECTORS, Lamp, Length, Offset, Ray, Share, Vectors},
    vec3::{Vec3, nth},
};

/// Number of bits that an offset is scaled to.
const BITS: u32 = 31;

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

/// Returns a node and its difference to the next one.
const fn pair(nodes: &[u16], place: usize) -> u32 {
    if place + 1 < nodes.len() {
        (nodes[place] as u32) << 16 | nodes[place].wrapping_sub(nodes[place + 1]) as u32
    } else {
        0
    }
}

/// Builds a table of pairs of nodes from the place of each number of nine bits.
macro_rules! pairs {
    ($nodes:expr, $bits:ident => $place:expr) => {{
        let mut pairs = [0; 512];
        let mut $bits = 0;
        while $bits < pairs.len() {
            pairs[$bits] = pair(&$nodes, $place);
            $bits += 1;
        }
        pairs
    }};
}

impl Among for Offset16 {
    const NODES: &'static [u32; 512] = {
        // The root of a squared length below 2^30 is that of four times the squared length.
        const PAIRS: [u32; 512] = pairs!(root::NODES, bits => if bits < 128 { bits } else { bits >> 2 });
        &PAIRS
    };

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
    const NODES: &'static [u32; 512] = {
        const PAIRS: [u32; 512] = pairs!(root::QUICK_NODES, bits => bits >> 1);
        &PAIRS
    };

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

/// Returns the bit length of a number, and `2^(31 - bits)`, for 1 to 24 bits.
///
/// Any other number has a bit length outside this range.
#[inline(always)]
fn bits_and_power(number: u32) -> (u32, u32) {
    const BIAS: u32 = 126;
    let exponent = (number as i32 as f32).to_bits() >> 23;
    let bits = exponent.wrapping_sub(BIAS);
    // WebAssembly has no vector shift that differs from lane to lane; LLVM builds this power for x86.
    let power = if cfg!(target_arch = "wasm32") {
        f32::from_bits((2 * BIAS + BITS + 1).wrapping_sub(exponent) << 23) as i32 as u32
    } else {
        1 << (BITS.wrapping_sub(bits) & 31)
    };
    (bits, power)
}

impl<O: Among> Vectors<Fx16> for O {
    const IS_VECTORISED: bool = HAS_VECTORS;

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
