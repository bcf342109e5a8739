//! Powers and reflections in the 32-bit format.

use super::wide;
use crate::number::{Fx32, Versine, product::high_half, raised};
use crate::vec3::Vec3;

/// Returns `1 - x y` from `a = 1 - x` and `b = 1 - y`, with 32 fraction bits.
#[inline]
fn lack_of_product(a: u32, b: u32) -> u32 {
    a.saturating_add(b - high_half(a, b))
}

/// Returns `(1 - versine)^exponent`.
///
/// The function computes with `1 - cosine`, which keeps its leading bits near the axis; the cosine
/// would lose these bits.
#[inline]
pub(super) fn power(versine: Versine, exponent: u32) -> Fx32 {
    let lack = raised(0, versine.to_bits().saturating_mul(8), exponent, lack_of_product);
    let lack = ((lack >> 1) + 1) >> 1;
    Fx32::from_bits((1 << 30) - lack as i32)
}

/// Returns the inner product of a direction and a normal, with 58 fraction bits.
#[inline]
fn inner(direction: Vec3<Fx32>, normal: Vec3<Fx32>) -> i64 {
    let products = direction.zip(normal, |d, n| wide(d.to_bits(), n.to_bits()) >> 2);
    products.x + products.y + products.z
}

/// Returns `d - 2 (d.n) n` for the direction `d` and the normal `n`.
///
/// The result wraps for vectors that are not of unit length, which is defined behaviour.
#[inline]
pub(super) fn mirror(direction: Vec3<Fx32>, normal: Vec3<Fx32>) -> Vec3<Fx32> {
    let cosine = (inner(direction, normal) + (1 << 27)) >> 28;
    direction.zip(normal, |d, n| {
        let twice_along = cosine.wrapping_mul(n.to_bits().into()).wrapping_add(1 << 28) >> 29;
        Fx32::from_bits(d.to_bits().wrapping_sub(twice_along as i32))
    })
}

/// Returns the cosine of the angle of incidence.
#[inline]
pub(super) fn incidence(direction: Vec3<Fx32>, normal: Vec3<Fx32>) -> Fx32 {
    let cosine = ((1 << 27) - inner(direction, normal)) >> 28;
    Fx32::from_bits(cosine.clamp(0, 1 << 30) as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares with the same products in 128 bits, truncated to 64 and to 32 bits.
    #[test]
    fn vectors_that_are_not_of_unit_length_wrap() {
        let components = [i32::MIN, -(1 << 30), -12_345, 0, 1 << 30, i32::MAX];
        let vectors =
            || (0..216).map(|i| Vec3::new(i / 36, i / 6 % 6, i % 6).map(|at: usize| components[at]));
        for (d, n) in vectors().flat_map(|d| vectors().map(move |n| (d, n))) {
            let [direction, normal] = [d, n].map(|vector| vector.map(Fx32::from_bits));
            let cosine = i128::from((inner(direction, normal) + (1 << 27)) >> 28);
            let exact = d.zip(n, |d, n| {
                let twice_along = (cosine * i128::from(n) + (1 << 28)) as i64 >> 29;
                (i128::from(d) - i128::from(twice_along)) as i32
            });
            assert_eq!(mirror(direction, normal).map(Fx32::to_bits), exact, "{d:?} {n:?}");
        }
    }
}
