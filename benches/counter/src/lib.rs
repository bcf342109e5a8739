//! A QEMU plugin that counts the instructions executed between two marker instructions, by region
//! and address.

mod counts;
mod marker;
// Left out of the tests: QEMU defines the functions that these modules call, and a test program is
// linked without QEMU.
#[cfg(not(test))]
mod plugin;
#[cfg(not(test))]
mod qemu;
