//! A QEMU plugin that counts the instructions executed between two marker instructions, by region
//! and address.

mod counts;
mod marker;
mod plugin;
mod qemu;
