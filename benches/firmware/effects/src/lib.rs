//! Effects: functions of one input, with constants for lights and surfaces. The programs that
//! contain one effect each share their input, their output, and a panic handler that cannot be
//! linked.
#![cfg_attr(target_os = "none", no_std)]

pub mod constants;
pub mod effects;
mod input;
mod output;

pub use effects::{Entry, Listed, Visit, each, each_evaluation};
pub use input::{Input, Inputs, Place, run};
pub use output::Output;

#[cfg(feature = "f32")]
mod format {
    /// The number format of this build.
    pub type Format = f32;
    /// Its name.
    pub const FORMAT: &str = "f32";
}
#[cfg(all(feature = "fx32", not(feature = "f32")))]
mod format {
    /// The number format of this build.
    pub type Format = luminaire::Fx32;
    /// Its name.
    pub const FORMAT: &str = "fx32";
}
#[cfg(not(any(feature = "fx32", feature = "f32")))]
mod format {
    /// The number format of this build.
    pub type Format = luminaire::Fx16;
    /// Its name.
    pub const FORMAT: &str = "fx16";
}
pub use format::{FORMAT, Format};

/// Irradiance in the format.
pub type Irradiance = <Format as luminaire::Scalar>::Irradiance;
/// Light in the format, before it is fitted to a display.
pub type Light = luminaire::Rgb<Irradiance>;
/// A colour in the format.
pub type Color = luminaire::Rgb<Format>;
/// A surface point in the format.
pub type Surface = luminaire::light::SurfacePoint<Format>;

/// Makes a program of an effect, a function of one [`Input`].
///
/// A program that can panic does not link: its panic handler calls a function that is defined
/// nowhere.
#[macro_export]
macro_rules! program {
    ($effect:expr) => {
        #[cfg(target_os = "none")]
        #[panic_handler]
        fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
            unsafe extern "C" {
                safe fn a_panic_is_reachable() -> !;
            }
            a_panic_is_reachable()
        }

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
