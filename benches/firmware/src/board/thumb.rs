//! Cortex-M.

use core::arch::asm;

/// The marker that begins a region. Nothing in memory moves across it.
#[inline(always)]
pub fn begin() {
    // SAFETY: a move of a register to itself changes nothing.
    unsafe { asm!("mov r10, r10", options(nostack, preserves_flags)) };
}

/// The marker that ends a region. Nothing in memory moves across it.
#[inline(always)]
pub fn end() {
    // SAFETY: a move of a register to itself changes nothing.
    unsafe { asm!("mov r11, r11", options(nostack, preserves_flags)) };
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
    // SAFETY: only a register that the compiler chooses and the flags change.
    unsafe {
        asm!("movs {0}, #{1}", "1:", "subs {0}, {0}, #1", "bne 1b", out(reg) _, const TURNS, options(nomem, nostack));
    }
}
