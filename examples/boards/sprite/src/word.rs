//! An opaque pixel of the sprite.

/// An opaque pixel: from the upper bits on the normal's x and y of eight bits, its z of seven; a mark, with which a run
/// of pixels ends; five bits of the material, and three of the dither's threshold.
///
/// The normal is in units of 1/127, to the right, down and to the viewer. The threshold is that of the pixel's place in
/// the sprite, so that the dither moves with it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(transparent)]
pub struct Word(pub u32);

impl Word {
    /// Returns the normal.
    #[inline(always)]
    pub const fn normal(self) -> [i8; 3] {
        [(self.0 >> 24) as i8, (self.0 >> 16) as i8, (self.0 >> 9 & 0x7f) as i8]
    }

    /// Returns the x and y of the normal.
    #[inline(always)]
    pub(crate) const fn across(self) -> [i32; 2] {
        [self.0 as i32 >> 24, (self.0 << 8) as i32 >> 24]
    }

    /// Returns the z of the normal, times 2^9.
    #[inline(always)]
    pub(crate) const fn toward(self) -> i32 {
        (self.0 & 0xfe00) as i32
    }

    /// Returns the threshold of the dither, from 0 to 7.
    #[inline(always)]
    pub(crate) const fn threshold(self) -> u32 {
        self.0 & 7
    }

    /// Returns eight times the material.
    #[inline(always)]
    pub(crate) const fn material(self) -> u32 {
        self.0 & 0xf8
    }
}
