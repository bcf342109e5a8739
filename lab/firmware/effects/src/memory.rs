//! Inputs that the compiler does not know, and an output that it cannot leave out.

use core::mem::MaybeUninit;
use core::ptr;

use luminaire::number::{Light16, Light32};
use luminaire::{Fx16, Fx32, Rgb, haze::ViewRay};

use crate::Surface;

/// What an effect is computed from.
pub trait Input {
    /// Reads it from memory that anything may have been written to.
    fn read() -> Self;
}

/// Runs an effect once, from memory to memory.
#[inline(always)]
pub fn run<I: Input, O>(effect: impl FnOnce(I) -> O) {
    let output = effect(I::read());
    let mut memory = MaybeUninit::uninit();
    // SAFETY: the memory is our own, and of the output's type.
    unsafe { ptr::write_volatile(memory.as_mut_ptr(), output) };
}

impl Input for () {
    fn read() {}
}

/// A pixel's position in the picture.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Its column.
    pub x: u32,
    /// Its row.
    pub y: u32,
}

impl<A: Input, B: Input> Input for (A, B) {
    #[inline(always)]
    fn read() -> Self {
        (A::read(), B::read())
    }
}

macro_rules! inputs {
    ($($input:ty)*) => {$(
        impl Input for $input {
            #[inline(always)]
            fn read() -> Self {
                static mut MEMORY: MaybeUninit<$input> = MaybeUninit::zeroed();
                // SAFETY: numbers, for which every bit pattern is a value, and zero until a
                // debugger writes others.
                unsafe { ptr::read_volatile(&raw const MEMORY).assume_init() }
            }
        }
    )*};
}

inputs!(Place Surface ViewRay Rgb<f32> Rgb<Fx16> Rgb<Fx32> Rgb<Light16> Rgb<Light32>);
