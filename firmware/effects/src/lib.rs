//! What programs of one effect have in common: the constants, the inputs and the output, and a panic that cannot be
//! linked.
#![cfg_attr(target_os = "none", no_std)]

pub mod constants;
mod memory;

pub use memory::{Input, Place, run};

#[cfg(feature = "f32")]
mod format {
    /// The number format of this build.
    pub type Format = f32;
}
#[cfg(all(feature = "fx32", not(feature = "f32")))]
mod format {
    /// The number format of this build.
    pub type Format = luminaire::Fx32;
}
#[cfg(not(any(feature = "fx32", feature = "f32")))]
mod format {
    /// The number format of this build.
    pub type Format = luminaire::Fx16;
}
pub use format::Format;

/// Light in the format, before it is fitted to a display.
pub type Light = luminaire::Rgb<<Format as luminaire::Scalar>::Irradiance>;
/// A colour in the format.
pub type Color = luminaire::Rgb<Format>;
/// A surface point in the format.
pub type Surface = luminaire::Surface<Format>;

/// A program that can panic needs this function, which is nowhere: it does not link.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    unsafe extern "C" {
        safe fn a_panic_is_reachable() -> !;
    }
    a_panic_is_reachable()
}

/// Makes a program of an effect, a function of one [`Input`].
#[macro_export]
macro_rules! program {
    ($effect:expr) => {
        #[cfg(all(target_os = "none", target_arch = "arm"))]
        #[cortex_m_rt::entry]
        fn start() -> ! {
            loop {
                $crate::run($effect);
            }
        }

        #[cfg(all(target_os = "none", target_arch = "riscv32"))]
        #[riscv_rt::entry]
        fn start() -> ! {
            loop {
                $crate::run($effect);
            }
        }

        #[cfg(not(target_os = "none"))]
        fn main() {
            $crate::run($effect);
        }
    };
}
