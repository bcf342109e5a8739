//! A small deferred software renderer, `no_std` + `alloc`.
#![no_std]
