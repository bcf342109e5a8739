//! Powers and reflections in the 16-bit format, with 32-bit products.

use crate::number::{Fx16, Fx32, Versine, raised};
use crate::vec3::Vec3;

/// Returns `1 - x y` from `a = 1 - x` and `b = 1 - y`, with 32 fraction bits.
#[inline]
fn lack_of_product(a: u32, b: u32) -> u32 {
    a.saturating_add(b - (a >> 16) * (b >> 16))
}

/// Returns `(1 - versine)^exponent`.
///
/// The function computes with `1 - cosine`, which keeps its leading bits near the axis; the cosine
/// would lose these bits.
#[inline]
pub(super) fn power(versine: Versine, exponent: u32) -> Fx16 {
    let lack = raised(0, versine.to_bits().saturating_mul(8), exponent, lack_of_product);
    let lack = ((lack >> 17) + 1) >> 1;
    Fx16::from_bits(((1 << 14) - lack) as i16)
}

/// Returns `d - 2 (d.n) n` for the direction `d` and the normal `n`.
///
/// The result wraps for vectors that are not of unit length, which is defined behaviour.
#[inline]
pub(super) fn mirror(direction: Vec3<Fx32>, normal: Vec3<Fx16>) -> Vec3<Fx32> {
    let products =
        direction.zip(normal, |d, n| (((d.to_bits() >> 14) + 1) >> 1).wrapping_mul(i32::from(n.to_bits())));
    let cosine = products.x.wrapping_add(products.y).wrapping_add(products.z).wrapping_add(1 << 13) >> 14;
    direction.zip(normal, |d, n| {
        let along = cosine.wrapping_mul(i32::from(n.to_bits()));
        Fx32::from_bits(d.to_bits().wrapping_sub(along.wrapping_mul(4)))
    })
}

/// Returns the cosine of the angle of incidence.
///
/// The sum wraps for vectors that are not of unit length, which is defined behaviour.
#[inline]
pub(super) fn incidence(direction: Vec3<Fx32>, normal: Vec3<Fx16>) -> Fx16 {
    let products =
        direction.zip(normal, |d, n| (((d.to_bits() >> 15) + 1) >> 1).wrapping_mul(i32::from(n.to_bits())));
    let along = products.x.wrapping_add(products.y).wrapping_add(products.z);
    let cosine = (1_i32 << 13).wrapping_sub(along) >> 14;
    Fx16::from_bits(cosine.clamp(0, 1 << 14) as i16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Offset;
    use crate::number::fixed16::offset::Offset16;

    /// Compares with the same products in 64 bits, truncated to 32 bits.
    #[test]
    fn vectors_that_are_not_of_unit_length_wrap() {
        let components = [i32::MIN, -(1 << 30), -12_345, 0, 65_536, 1 << 30, i32::MAX];
        let vectors =
            || (0..343).map(|i| Vec3::new(i / 49, i / 7 % 7, i % 7).map(|at: usize| components[at]));
        for (d, n) in vectors().flat_map(|d| vectors().map(move |n| (d, n.map(|c| c >> 16)))) {
            let normal = n.map(|c| Fx16::from_bits(c as i16));
            let products = d.zip(n, |d, n| i64::from(((d >> 14) + 1) >> 1) * i64::from(n));
            let cosine = (products.x + products.y + products.z + (1 << 13)) as i32 >> 14;
            let exact = d.zip(n, |d, n| (i64::from(d) - 4 * i64::from(cosine) * i64::from(n)) as i32);
            assert_eq!(mirror(d.map(Fx32::from_bits), normal).map(Fx32::to_bits), exact, "{d:?} {n:?}");
            let products = d.zip(n, |d, n| i64::from(((d >> 15) + 1) >> 1) * i64::from(n));
            let along = (products.x + products.y + products.z) as i32;
            let expected = (1_i32 << 13).wrapping_sub(along) >> 14;
            assert_eq!(
                incidence(d.map(Fx32::from_bits), normal),
                Fx16::from_bits(expected.clamp(0, 1 << 14) as i16)
            );
            let offset = Offset16::new(d.map(|c| c >> 2));
            let products = normal.zip(offset.fine(), |n, v| i64::from(n.to_bits()) * i64::from(v >> 2));
            assert_eq!(offset.facing(normal), (products.x + products.y + products.z) as i32, "{d:?} {n:?}");
        }
    }
}
