//! `luminaire` for C99 and C++11: spotlights in 16-bit integers.
//!
//! The crate is a static library with the header `luminaire.h`, which cbindgen writes. A light is a
//! structure of words that the program owns; the library has no memory of its own. Every function is
//! defined for all bits and for null pointers, so a light that is not set up is not dangerous: it
//! lights something.
//!
//! | quantity | type | step |
//! |---|---|---|
//! | coordinate of a point or a light | `int32_t` | 2^-16 |
//! | component of a normal, colour channel, part | `int16_t` | 2^-14 |
//! | component of a direction | `int32_t` | 2^-30 |
//! | light | `uint32_t` | 2^-14 of full scale, which it may exceed |
#![cfg_attr(target_os = "none", no_std)]
#![allow(non_camel_case_types, reason = "the names of C")]

mod display;
mod edge;
mod many;
mod setup;
mod spot;

/// `bool` of C, which the header calls it: a program may write any byte, and all but 0 are true. A
/// `bool` of Rust has two values, and any other is undefined behaviour.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct luminaire_bool(pub u8);

pub use self::display::*;
pub use self::many::*;
pub use self::setup::*;
pub use self::spot::*;

/// The text of `luminaire.h`, for build scripts and tests that compile C.
pub const fn header() -> &'static str {
    include_str!("../include/luminaire.h")
}

/// A panic handler that no program links: no function of the kernel panics.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
