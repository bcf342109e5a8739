//! The angles of a cone as chords, between which a cone changes at run time.
//!
//! The chord of an angle with versine `v` is `sqrt(v)`, that is `sqrt(2) sin(angle / 2)`. It grows
//! nearly in proportion to the angle.

use super::{product::high_half, root};

/// The largest chord: `sqrt(2)` with 31 fraction bits, of a versine of 2.
const LARGEST: u32 = 3_037_000_499;

/// The chords of a cone's inner and outer angle and of its cutoff, with 31 fraction bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chords {
    /// The chord up to which the intensity is full, at most `limit`.
    pub(super) inner: u32,
    /// The chord at which the falloff ends, at least `limit`.
    pub(super) outer: u32,
    /// The chord from which on the intensity is zero.
    pub(super) limit: u32,
}

impl Chords {
    /// Returns the chords between two cones. `part` has 32 fraction bits.
    pub(super) fn between(self, other: Self, part: u32) -> Self {
        let limit = between(self.limit, other.limit, part);
        let is_cut = self.limit < self.outer || other.limit < other.outer;
        let outer = if is_cut { between(self.outer, other.outer, part).max(limit) } else { limit };
        Self { inner: between(self.inner, other.inner, part).min(limit), outer, limit }
    }

    /// Returns the squared cosine of the limit, with 30 fraction bits and an error of less than 2
    /// units; zero from a right angle on.
    pub(super) fn squared_cosine(self) -> u32 {
        let cosine = (1_u32 << 30).saturating_sub(high_half(self.limit, self.limit)) << 1;
        high_half(cosine, cosine)
    }
}

/// Returns the number between two numbers. `part` has 32 fraction bits.
fn between(from: u32, to: u32, part: u32) -> u32 {
    if from <= to { from + high_half(to - from, part) } else { from - high_half(from - to, part) }
}

/// Returns the chord of a versine with 61 fraction bits. A versine over 2 counts as 2.
///
/// The relative error is at most 7.5e-9 and the absolute error less than 2 units, as for all
/// functions here.
pub(super) fn chord(versine: u64) -> u32 {
    root::sqrt_64(2 * versine.min(1 << 62)).min(LARGEST)
}

/// Returns the chord of a versine with `29 + 2 zoom` fraction bits. A versine over `2 / 4^zoom`
/// counts as this number.
pub(super) fn zoomed_chord(versine: u32, zoom: u32) -> u32 {
    root::sqrt_32(2 * versine.min(1 << 30)).min(LARGEST) >> zoom
}

/// Returns the versine of a chord times `4^zoom`, with 29 fraction bits, rounded to nearest.
pub(super) fn squared(chord: u32, zoom: u32) -> u32 {
    high_half(chord << zoom, chord << zoom).div_ceil(2)
}

/// Returns the largest zoom up to `most` with which a chord's versine is at most 2.
pub(super) fn zoom(chord: u32, most: u32) -> u32 {
    let zoom = (u32::BITS - root::bit_length(chord)).min(most);
    if chord << zoom > LARGEST { zoom.saturating_sub(1) } else { zoom }
}
