//! What comes of an effect.

use luminaire::number::{Light16, Light32};
use luminaire::{Fx16, Fx32, Rgb, display::Rgb565};

/// A result of an effect.
pub trait Output {
    /// 32 bits of which a checksum is made.
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
    f32: |value| value.to_bits();
    Fx16: |value| i32::from(value.to_bits()).cast_unsigned();
    Light16: |value| value.to_bits();
    Fx32: |value| value.to_bits().cast_unsigned();
    Light32: |value| (value.to_bits() >> 32) as u32 ^ value.to_bits() as u32;
    u8: |code| code.into();
    Rgb565: |pixel| pixel.0.into();
}

/// Two instructions on every processor, whatever the channels are.
impl<T: Output> Output for Rgb<T> {
    #[inline(always)]
    fn fold(self) -> u32 {
        self.red.fold() ^ self.green.fold() ^ self.blue.fold()
    }
}
