//! The host, where nothing is counted: its results are what the boards' results must be.

/// Does nothing: there are no regions on the host.
pub fn begin() {}

/// Does nothing: there are no regions on the host.
pub fn end() {}

/// Does nothing.
pub fn nops<const COUNT: usize>() {}

/// Does nothing.
pub fn countdown<const TURNS: u8>() {}
