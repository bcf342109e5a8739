//! Results of effects.

use luminaire::number::{Light16, Light32};
use luminaire::{
    Fx16, Fx32, Rgb,
    display::{Gray1, Gray2, Gray4, Gray8, Rgb332, Rgb444, Rgb555, Rgb565, Rgb666},
};
use luminaire_kernels::Value;

/// A result of an effect.
pub trait Output {
    /// Reduces the result to 32 bits, which go into a checksum.
    fn fold(self) -> u32;
}

macro_rules! outputs {
    ($($output:ty: |$value:ident| $word:expr;)*) => {$(
        impl Output for $output {
            #[inline(always)]
            fn fold(self) -> u32 {
                let $value = self;
                $word
            }
        }
    )*};
}

outputs! {
    f32: |value| value.bits();
    Fx16: |value| value.bits();
    Light16: |value| value.bits();
    Fx32: |value| value.bits();
    Light32: |value| value.bits();
    u8: |code| code.into();
    u16: |duty| duty.into();
}

macro_rules! pixels {
    ($($pixel:ty)*) => {$(
        impl Output for $pixel {
            #[inline(always)]
            fn fold(self) -> u32 {
                self.0.into()
            }
        }
    )*};
}

pixels! { Gray1 Gray2 Gray4 Gray8 Rgb332 Rgb444 Rgb555 Rgb565 Rgb666 }

/// The bytes of an LED.
impl Output for [u8; 3] {
    #[inline(always)]
    fn fold(self) -> u32 {
        Rgb::from(self).fold()
    }
}

/// Folding three channels into one takes two instructions on every processor, whatever their type.
impl<T: Output> Output for Rgb<T> {
    #[inline(always)]
    fn fold(self) -> u32 {
        self.red.fold() ^ self.green.fold() ^ self.blue.fold()
    }
}
