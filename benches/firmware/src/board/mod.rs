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

pub use processor::{begin, countdown, end, nops, opaque};

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
