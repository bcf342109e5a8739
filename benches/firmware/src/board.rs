//! Everything that differs between the targets: the entry, the output and a few instructions. On the
//! host nothing is counted: its results are what the boards' results must be.

#[cfg(target_os = "none")]
use core::arch::asm;

#[cfg(not(target_os = "none"))]
pub use core::hint::black_box as opaque;

/// Instructions of Cortex-M: the markers, which move a register to itself, and the parts of a loop.
#[cfg(all(target_os = "none", target_arch = "arm"))]
macro_rules! instructions {
    (begin) => {
        "mov r10, r10"
    };
    (end) => {
        "mov r11, r11"
    };
    (load) => {
        "movs {0}, #{1}"
    };
    (turn) => {
        "1: subs {0}, {0}, #1\nbne 1b"
    };
}

/// Instructions of RISC-V: the markers, whose result goes to the register that is always zero, and the
/// parts of a loop.
#[cfg(all(target_os = "none", target_arch = "riscv32"))]
macro_rules! instructions {
    (begin) => {
        "slti x0, x0, 0x7b1"
    };
    (end) => {
        "slti x0, x0, 0x7b2"
    };
    (load) => {
        "li {0}, {1}"
    };
    (turn) => {
        "1: addi {0}, {0}, -1\nbnez {0}, 1b"
    };
}

/// The marker that begins a region. Nothing in memory moves across it.
#[inline(always)]
pub fn begin() {
    // SAFETY: the marker changes nothing.
    #[cfg(target_os = "none")]
    unsafe {
        asm!(instructions!(begin), options(nostack, preserves_flags));
    }
}

/// The marker that ends a region. Nothing in memory moves across it.
#[inline(always)]
pub fn end() {
    // SAFETY: the marker changes nothing.
    #[cfg(target_os = "none")]
    unsafe {
        asm!(instructions!(end), options(nostack, preserves_flags));
    }
}

/// `COUNT` instructions that do nothing.
#[inline(always)]
pub fn nops<const COUNT: usize>() {
    // SAFETY: these instructions do nothing.
    #[cfg(target_os = "none")]
    unsafe {
        asm!(".rept {0}", "nop", ".endr", const COUNT, options(nomem, nostack, preserves_flags));
    }
}

/// An instruction that loads the number of turns, at most 255, then a loop of two instructions per
/// turn.
#[inline(always)]
pub fn countdown<const TURNS: u8>() {
    // SAFETY: only a register that the compiler chooses and the flags change.
    #[cfg(target_os = "none")]
    unsafe {
        asm!(instructions!(load), instructions!(turn), out(reg) _, const TURNS, options(nomem, nostack));
    }
}

/// Returns the same reference at no cost, but the compiler no longer knows what it refers to.
#[cfg(target_os = "none")]
#[inline(always)]
pub fn opaque<T>(reference: &T) -> &T {
    let mut pointer: *const T = reference;
    // SAFETY: there are no instructions, so the register keeps the pointer that it has.
    unsafe { asm!("/* {0} */", inout(reg) pointer, options(pure, nomem, nostack, preserves_flags)) };
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
        #[cfg_attr(all(target_os = "none", target_arch = "arm"), cortex_m_rt::entry)]
        #[cfg_attr(all(target_os = "none", target_arch = "riscv32"), riscv_rt::entry)]
        #[cfg(target_os = "none")]
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
