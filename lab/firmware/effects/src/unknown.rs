//! Used by the programs that prove that nothing panics: values that the compiler does not know, and
//! short names for the types whose functions the programs call.

use core::hash::Hasher;
use core::mem::MaybeUninit;
use core::{hint, ptr};

use luminaire::number;
pub use luminaire::{attenuation::*, dynamic::*, falloff::*, specular::*};

pub use crate::{Format, Irradiance};

/// A gain of the format.
pub type Gain = <Format as number::Arithmetic>::Gain;
/// The offset from a light to a point.
pub type Offset = <Format as number::Arithmetic>::Offset;
/// An offset after the square root.
pub type Ray = <Offset as number::Offset<Format>>::Ray;
/// A ray with more bits.
pub type FineRay = <Offset as number::FullOffset<Format>>::FineRay;
/// A share of a light with more bits than a scalar.
pub type FineShare = <FineRay as number::Ray<Format>>::Share;
/// The argument of a profile.
pub type Fraction = <Format as number::Arithmetic>::Fraction;
/// An argument of a profile with more bits.
pub type FineFraction = <Format as number::Arithmetic>::Fine;

/// Reads a value from memory whose content the compiler does not know.
///
/// # Safety
/// The memory must hold a valid value of the type. Nothing ensures that, so only programs
/// that are never run may call this.
#[inline(always)]
pub unsafe fn source<T>() -> T {
    static mut MEMORY: MaybeUninit<[u64; 1024]> = MaybeUninit::zeroed();
    const { assert!(size_of::<T>() <= 8192, "the memory is smaller than the value") };
    // SAFETY: the memory is large enough and aligned for all types that are used here; that its
    // bits are valid is the caller's promise.
    unsafe { ptr::read_volatile((&raw const MEMORY).cast()) }
}

/// Takes a result, so that the compiler has to compute it.
#[inline(always)]
pub fn sink<T>(value: T) {
    hint::black_box(value);
}

/// A hasher for calls of `hash`; its result has no meaning.
#[derive(Clone, Copy, Default, Debug)]
pub struct Words(u64);

impl Hasher for Words {
    fn write(&mut self, bytes: &[u8]) {
        hint::black_box(bytes);
    }

    fn finish(&self) -> u64 {
        self.0
    }
}
