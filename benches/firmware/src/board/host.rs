//! The host, where nothing is counted: its results are what the boards' results must be.

use core::hint::black_box;

/// Does nothing: there are no regions on the host.
pub fn begin() {}

/// Does nothing: there are no regions on the host.
pub fn end() {}

/// Returns the same reference, but the compiler no longer knows what it refers to.
#[inline(always)]
pub fn opaque<T>(reference: &T) -> &T {
    black_box(reference)
}

/// Does nothing.
pub fn nops<const COUNT: usize>() {}

/// Does nothing.
pub fn countdown<const TURNS: u8>() {}
