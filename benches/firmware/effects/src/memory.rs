//! Inputs whose values the compiler does not know, and outputs that it cannot optimise away.

use core::mem::MaybeUninit;
use core::ptr;

use luminaire::number::{Light16, Light32};
use luminaire::{Fx16, Fx32, Rgb};

use crate::Surface;

/// An input of an effect.
pub trait Input {
    /// Reads the input from memory whose content the compiler does not know.
    fn read() -> Self;
}

/// Runs an effect once: reads its input from memory and writes its output to memory.
#[inline(always)]
pub fn run<I: Input, O>(effect: impl FnOnce(I) -> O) {
    let output = effect(I::read());
    let mut memory = MaybeUninit::uninit();
    // SAFETY: the memory is a local variable of the output's type.
    unsafe { ptr::write_volatile(memory.as_mut_ptr(), output) };
}

impl Input for () {
    fn read() {}
}

/// A pixel's position in the picture.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// The pixel's column.
    pub x: u32,
    /// The pixel's row.
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
                // SAFETY: the input consists of numbers, for which every bit pattern is valid, and
                // the memory is initialised to zero.
                unsafe { ptr::read_volatile(&raw const MEMORY).assume_init() }
            }
        }
    )*};
}

inputs!(Place Surface Rgb<f32> Rgb<Fx16> Rgb<Fx32> Rgb<Light16> Rgb<Light32>);
