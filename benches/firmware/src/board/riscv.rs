//! RISC-V.

use core::arch::asm;

/// The marker that begins a region. Nothing in memory moves across it.
#[inline(always)]
pub fn begin() {
    // SAFETY: the result of the comparison goes to the register that is always zero.
    unsafe { asm!("slti x0, x0, 0x7b1", options(nostack, preserves_flags)) };
}

/// The marker that ends a region. Nothing in memory moves across it.
#[inline(always)]
pub fn end() {
    // SAFETY: the result of the comparison goes to the register that is always zero.
    unsafe { asm!("slti x0, x0, 0x7b2", options(nostack, preserves_flags)) };
}

/// `COUNT` instructions that do nothing.
#[inline(always)]
pub fn nops<const COUNT: usize>() {
    // SAFETY: these instructions do nothing.
    unsafe { asm!(".rept {0}", "nop", ".endr", const COUNT, options(nomem, nostack, preserves_flags)) };
}

/// An instruction that loads the number of turns, at most 255, then a loop of two instructions per
/// turn.
#[inline(always)]
pub fn countdown<const TURNS: u8>() {
    // SAFETY: only a register that the compiler chooses changes.
    unsafe {
        asm!("li {0}, {1}", "1:", "addi {0}, {0}, -1", "bnez {0}, 1b", out(reg) _, const TURNS, options(nomem, nostack));
    }
}
