//! Everything that differs between the targets: the entry, the output and a few instructions.

#[cfg(all(target_os = "none", target_arch = "arm"))]
#[path = "thumb.rs"]
mod processor;
#[cfg(all(target_os = "none", target_arch = "riscv32"))]
#[path = "riscv.rs"]
mod processor;
#[cfg(not(target_os = "none"))]
#[path = "host.rs"]
mod processor;

#[cfg(not(target_os = "none"))]
pub use core::hint::black_box as opaque;
pub use processor::{begin, countdown, end, nops};

/// Returns the same reference at no cost, but the compiler no longer knows what it refers to.
#[cfg(target_os = "none")]
#[inline(always)]
pub fn opaque<T>(reference: &T) -> &T {
    let mut pointer: *const T = reference;
    // SAFETY: there are no instructions, so the register keeps the pointer that it has.
    unsafe {
        core::arch::asm!("/* {0} */", inout(reg) pointer, options(pure, nomem, nostack, preserves_flags))
    };
    // SAFETY: the pointer comes from a reference of the same lifetime.
    unsafe { &*pointer }
}

/// Prints a line for the tools to read: by semihosting on a board, to stdout on the host.
#[cfg(target_os = "none")]
pub use semihosting::println;
#[cfg(not(target_os = "none"))]
pub use std::println;

/// Makes a function the program's entry; when it returns, the program ends with success.
#[macro_export]
macro_rules! entry {
    ($program:path) => {
        #[cfg(all(target_os = "none", target_arch = "arm"))]
        #[cortex_m_rt::entry]
        fn start() -> ! {
            $program();
            semihosting::process::exit(0)
        }

        #[cfg(all(target_os = "none", target_arch = "riscv32"))]
        #[riscv_rt::entry]
        fn start() -> ! {
            $program();
            semihosting::process::exit(0)
        }

        #[cfg(not(target_os = "none"))]
        fn main() {
            $program();
        }
    };
}
