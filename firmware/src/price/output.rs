//! What comes of an effect.

use luminaire::number::Light16;
use luminaire::{Fx16, Rgb, display::Rgb565};
use luminaire_kernels::Value;

/// A result of an effect.
pub(super) trait Output {
    /// 32 bits of which a checksum is made.
    fn fold(self) -> u32;
}

macro_rules! values {
    ($($value:ty)*) => {$(
        impl Output for $value {
            #[inline(always)]
            fn fold(self) -> u32 {
                self.bits()
            }
        }
    )*};
}

values!(f32 Fx16 Light16);

impl Output for u8 {
    #[inline(always)]
    fn fold(self) -> u32 {
        self.into()
    }
}

impl Output for Rgb565 {
    #[inline(always)]
    fn fold(self) -> u32 {
        self.0.into()
    }
}

/// Two instructions on every processor, whatever the channels are.
impl<T: Output> Output for Rgb<T> {
    #[inline(always)]
    fn fold(self) -> u32 {
        self.red.fold() ^ self.green.fold() ^ self.blue.fold()
    }
}
