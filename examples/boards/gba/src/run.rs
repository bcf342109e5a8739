//! A run of pixels in the processor's own instructions.
//!
//! `luminaire_sprite::cells::run` has the same in Rust, and the same bits. Of that the compiler keeps some of the numbers on
//! the stack, because Rust's inline assembly and its compiled functions leave two of the 16 registers out, and it multiplies
//! by either factor: the processor takes a cycle for each byte of the second one.

use core::arch::naked_asm;

use luminaire_sprite::{
    Word,
    cells::{Column, Run},
};

/// What the loop has in registers.
#[repr(C)]
struct Registers {
    words: *const Word,
    columns: *const Column,
    pixels: *mut u16,
    tilt: [i32; 2],
    levels: *const u8,
    table: *const u16,
}

/// Draws a run of pixels, as `cells::run` does.
pub(crate) fn run(run: Run<'_>) {
    let Run { words, columns, tilt, shown, pixels } = run;
    if words.is_empty() || words.len() != columns.len() || words.len() != pixels.len() {
        return;
    }
    let registers = Registers {
        words: words.as_ptr(),
        columns: columns.as_ptr(),
        pixels: pixels.as_mut_ptr(),
        tilt,
        levels: shown.levels.as_ptr(),
        table: shown.pixels.as_ptr(),
    };
    // SAFETY: the words, the columns and the pixels are as many, and the mark of the last word ends the loop after it. The
    // upper 13 bits of a product are an index of the levels; those of a material and two levels have 15.
    unsafe { draw(&raw const registers) }
}

#[unsafe(naked)]
unsafe extern "C" fn draw(registers: *const Registers) {
    naked_asm!(
        ".arm",
        "push {{r4-r11, lr}}",
        "ldm r0, {{r0-r6}}",
        "2:",
        // Eight pixels to a round: a branch that is taken costs two cycles more.
        ".rept 8",
        "ldr r7, [r0], #4",
        "ldm r1!, {{r8, r9, r10}}", // the light of both, and their tilts in x
        "and r12, r7, #0xfe00",
        "asr r11, r7, #24",
        "mla lr, r9, r11, r12",
        "mla r9, r10, r11, r12",
        "lsl r11, r7, #8",
        "asr r11, r11, #24",
        "mla lr, r3, r11, lr",
        "mla r9, r4, r11, r9",
        "lsr r10, r8, #16",
        "eor r8, r8, r10, lsl #16",
        "mul r12, lr, r10",
        "mul r11, r9, r8",
        "ldrb r10, [r5, r12, lsr #19]", // a surface that faces away is dark by the table's upper half
        "ldrb r9, [r5, r11, lsr #19]",
        "and r8, r7, #7",
        "and r11, r7, #0xf8",
        "add r10, r10, r8",
        "eor r8, r8, #7",
        "add r9, r9, r8",
        "and r10, r10, #0xf8",
        "bic r9, r9, #7",
        "add r11, r6, r11, lsl #8",
        "add r11, r11, r10, lsl #3",
        "add r11, r11, r9, lsr #2", // two bytes to a pixel
        "ldrh r11, [r11]",
        "strh r11, [r2], #2",
        "tst r7, #0x100",
        "bne 3f",
        ".endr",
        "b 2b",
        "3:",
        "pop {{r4-r11, lr}}",
        "bx lr",
    )
}
