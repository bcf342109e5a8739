//! The counter of cycles, which is not that of the RISC-V standard.

use core::arch::asm;

/// Makes the processor count cycles. Returns the counter.
pub(crate) fn count() -> impl Fn() -> u32 {
    // SAFETY: mpcer (0x7e0) selects what is counted and mpcmr (0x7e1) starts counting; nothing else
    // uses this counter.
    unsafe { asm!("csrwi 0x7e0, 1", "csrwi 0x7e1, 1", options(nomem, nostack, preserves_flags)) };
    || {
        let cycles;
        // SAFETY: a read of the counter mpccr (0x7e2) changes nothing. Nothing in memory moves
        // across it.
        unsafe { asm!("csrr {0}, 0x7e2", out(reg) cycles, options(nostack, preserves_flags)) };
        cycles
    }
}
