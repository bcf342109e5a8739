//! Inputs of any bit pattern, also those that no user would pass.

use fastrand::Rng;
use luminaire::Vec3;

/// Bit patterns that have broken arithmetic before, and random ones.
pub fn bits(rng: &mut Rng) -> u64 {
    const SEAMS: [u64; 13] = [
        0,
        1,
        0x8000_0000,
        0x7fff_ffff,
        0xffff_ffff,
        0x7f80_0000,
        0xff80_0000,
        0x7fc0_0000,
        0xffc0_0000,
        0x0080_0000,
        0x7f7f_ffff,
        u64::MAX,
        1 << 63,
    ];
    if rng.u8(..4) == 0 { SEAMS[rng.usize(..SEAMS.len())] } else { rng.u64(..) }
}

/// A vector of such patterns.
pub fn vector<T>(rng: &mut Rng, mut component: impl FnMut(u64) -> T) -> Vec3<T> {
    let mut next = || component(bits(rng));
    Vec3::new(next(), next(), next())
}
