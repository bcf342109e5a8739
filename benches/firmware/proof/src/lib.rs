//! What the programs share that prove that nothing panics: values that the compiler does not know,
//! and short names for the types whose functions the programs call.
#![cfg_attr(target_os = "none", no_std)]

#[cfg(feature = "interop")]
mod interop;
#[path = "../../no_panic.rs"]
mod no_panic;

use core::hash::Hasher;
use core::mem::MaybeUninit;
use core::{hint, ptr};

#[cfg(feature = "interop")]
pub use interop::{Data, Screen};
use luminaire::{Scalar, Vec3};
pub use luminaire::{attenuation::*, dynamic::*, falloff::*, specular::*};

#[cfg(feature = "f32")]
pub use f32 as Format;
#[cfg(not(any(feature = "fx32", feature = "f32")))]
pub use luminaire::Fx16 as Format;
#[cfg(feature = "fx32")]
pub use luminaire::Fx32 as Format;

/// The format that has a quick evaluation.
pub type QuickFormat = luminaire::Fx16;
/// Irradiance in the format.
pub type Irradiance = <Format as Scalar>::Irradiance;

#[cfg(feature = "arithmetic")]
mod arithmetic {
    use super::Format;
    use luminaire::number;

    /// A gain of the format.
    pub type Gain = <Format as number::Types>::Gain;
    /// The offset from a light to a point.
    pub type Offset = <Format as number::Types>::Offset;
    /// An offset after the square root.
    pub type Ray = <Offset as number::Offset<Format>>::Ray;
    /// A ray with more bits.
    pub type FineRay = <Format as number::Types>::FineRay;
    /// A share of a light with more bits than a scalar.
    pub type FineShare = <FineRay as number::Ray<Format>>::Share;
    /// The argument of a profile.
    pub type Fraction = <Format as number::Types>::Fraction;
    /// An argument of a profile with more bits.
    pub type FineFraction = <Format as number::Types>::Fine;
}
#[cfg(feature = "arithmetic")]
pub use arithmetic::*;

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

/// [`source`], for the implementations of traits.
#[inline(always)]
fn any<T>() -> T {
    // SAFETY: no program that uses this package is ever run.
    unsafe { source() }
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

/// A specular lobe with unknown results. It stands for all lobes, those of other crates included:
/// the functions of each lobe of the library are called by themselves.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct AnyLobe;

impl SpecularLobe for AnyLobe {
    type Constants<S: Scalar> = S;

    #[inline(always)]
    fn constants<S: Scalar>(shininess: u32) -> S {
        sink(shininess);
        any()
    }

    #[inline(always)]
    fn end(shininess: u32) -> f32 {
        sink(shininess);
        any()
    }

    #[inline(always)]
    fn lobe<S: Scalar>(constants: &S, incoming: Vec3<S::Unit>, normal: Vec3<S>, view: Vec3<S::Unit>) -> S {
        sink((*constants, incoming, normal, view));
        any()
    }
}

/// Makes a program of the calls in a file, which does not link if one of them can panic.
#[macro_export]
macro_rules! program {
    ($calls:literal) => {
        #[allow(clippy::wildcard_imports, reason = "the names that the calls use")]
        use $crate::*;

        $crate::without_panic!(every_function());

        include!(concat!(env!("CALLS"), "/", $calls));
    };
}
