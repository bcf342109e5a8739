//! The host, where nothing is counted: it says what the results must be.

use core::hint::black_box;

/// Begins nothing.
pub fn begin() {}

/// Ends nothing.
pub fn end() {}

/// The same reference, but the compiler no longer knows what it refers to.
#[inline(always)]
pub fn opaque<T>(reference: &T) -> &T {
    black_box(reference)
}

/// Does nothing.
pub fn nops<const COUNT: usize>() {}

/// Does nothing.
pub fn countdown<const TURNS: u8>() {}
