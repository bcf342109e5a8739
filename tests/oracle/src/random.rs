//! Random numbers for inputs that are on record: their bits never change.

use glam::DVec3;

/// The generator `SplitMix64` of G. L. Steele, D. Lea and C. H. Flood, *Fast Splittable
/// Pseudorandom Number Generators*, OOPSLA 2014, with a sequence of its own for each seed.
#[derive(Clone, Copy, Debug)]
pub struct SplitMix64(pub u64);

impl SplitMix64 {
    /// 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number in [`least`, `most`).
    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * ((self.bits() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// A whole number below `count`.
    pub fn below(&mut self, count: u64) -> u64 {
        self.bits() % count
    }

    /// A vector of components in [`least`, `most`).
    pub fn vector(&mut self, least: f64, most: f64) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| self.between(least, most)))
    }
}
