//! The instructions of processors that the crate `luminaire` uses and that `no_std` Rust without unsafe
//! code does not offer.
//!
//! The crate has unsafe code so that the kernel has none.
#![no_std]

/// Returns the square root, correctly rounded: the bits of `f32::sqrt`, except that the sign and the
/// payload of a NaN are the processor's.
///
/// `None` where this crate knows no instruction: the constant folds away. It knows that of the
/// floating point units of Arm (`target_abi = "eabihf"`: Cortex-M4F, M7 and M33). Stable Rust does not
/// show to crates whether a RISC-V has one.
///
/// ```
/// let root = luminaire_native::sqrt(2.0).unwrap_or_else(|| 2.0_f32.sqrt());
/// assert_eq!(root, 2.0_f32.sqrt());
/// ```
#[inline(always)]
#[must_use]
pub fn sqrt(x: f32) -> Option<f32> {
    #[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
    return Some(arm::sqrtf(x));
    #[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
    return {
        let _ = x;
        None
    };
}

/// The square root of C.
///
/// LLVM knows the function by its name: it writes `vsqrt.f32` in place, and calls the function only for
/// a number that may be negative or NaN, where that of C may set `errno`. The instruction cannot be
/// written by `asm!`: for a floating point unit of single precision rustc refuses the class `sreg` of
/// registers. An operand moved through other registers would take five instructions more.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
mod arm {
    // Weak: a C library's own function, or that of later versions of Rust, may replace it.
    core::arch::global_asm!(
        // The assembler that lists the symbols of a library knows no features of the target.
        ".fpu vfpv2",
        ".pushsection .text.sqrtf, \"ax\", %progbits",
        ".weak sqrtf",
        ".type sqrtf, %function",
        ".p2align 2",
        "sqrtf:",
        "vsqrt.f32 s0, s0",
        "bx lr",
        ".size sqrtf, . - sqrtf",
        ".popsection",
    );

    // SAFETY: this is C's function, defined above, which takes any number and touches no memory but
    // `errno`.
    unsafe extern "C" {
        pub(super) safe fn sqrtf(x: f32) -> f32;
    }
}
