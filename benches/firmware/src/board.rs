//! Everything that differs between the targets: the entry, the output and a few instructions. On the
//! host nothing is counted: its results are what the boards' results must be.

#[cfg(target_os = "none")]
use core::arch::asm;
use core::hint::black_box;

#[cfg(not(target_os = "none"))]
pub use core::hint::black_box as opaque;

/// Instructions of Cortex-M: the markers, which move a register to itself, the parts of a loop, and the stack pointer.
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
    (stack) => {
        "mov {0}, sp"
    };
}

/// Instructions of RISC-V: the markers, whose result goes to the register that is always zero, the
/// parts of a loop, and the stack pointer.
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
    (stack) => {
        "mv {0}, sp"
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

/// Words below the stack pointer that [`depth`] paints.
#[cfg(target_os = "none")]
const PAINTED: usize = 1024;

/// A word that a program seldom writes.
#[cfg(target_os = "none")]
const PAINT: u32 = 0x9d2c_5680;

/// Returns the bytes of stack that a call takes, those of its return address and of registers that it saves
/// included: the stack is painted, and the lowest word is found whose paint is gone. On the host zero.
#[inline(never)]
pub fn depth(call: impl FnOnce() -> u32) -> usize {
    #[cfg(not(target_os = "none"))]
    {
        black_box(called(call));
        0
    }
    #[cfg(target_os = "none")]
    {
        let stack: *mut u32;
        // SAFETY: a register is read.
        unsafe { asm!(instructions!(stack), out(reg) stack, options(nomem, nostack, preserves_flags)) };
        // SAFETY: below the pointer are 4 kB of the board's memory that nothing uses, because this
        // function has made its own frame, calls nothing meanwhile, and no interrupt is enabled.
        (1..=PAINTED).for_each(|word| unsafe { stack.sub(word).write_volatile(PAINT) });
        // The result is taken here, so that the call is made and has no stack for it.
        black_box(called(call));
        // SAFETY: the same words.
        let is_gone = |word: &usize| unsafe { stack.sub(*word).read_volatile() } != PAINT;
        size_of::<u32>() * (1..=PAINTED).rev().find(is_gone).unwrap_or_default()
    }
}

#[inline(never)]
fn called(call: impl FnOnce() -> u32) -> u32 {
    call()
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
