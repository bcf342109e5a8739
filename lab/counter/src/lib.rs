//! A QEMU plugin that counts the instructions executed between two marker instructions, by region
//! and address.

mod counts;
mod marker;
// The tests are a program of their own, and only inside QEMU are there functions to link against.
#[cfg(not(test))]
mod plugin;
#[cfg(not(test))]
mod qemu;
