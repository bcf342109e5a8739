//! Telling Thumb instructions apart as far as their time differs.

/// What an instruction does, by the lines of Arm's timing tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Instruction {
    /// Moves, additions, comparisons, logic, shifts, extensions, bit fields, counting zeros.
    Simple,
    /// If-then: makes up to four instructions conditional.
    IfThen,
    Multiply,
    /// With an addition or a subtraction.
    MultiplyAdd,
    /// To 64 bits.
    LongMultiply,
    /// To 64 bits, with an addition.
    LongMultiplyAdd,
    Divide,
    Load,
    Store,
    /// Of so many registers.
    LoadMany(u32),
    StoreMany(u32),
    /// Of so many registers, the last of them the program counter.
    PopReturn(u32),
    /// To the program counter.
    LoadJump,
    /// To a place so many bytes from the instruction.
    ConditionalBranch(i32),
    Branch,
    /// Of a subroutine, at a place that the instruction names.
    Call,
    /// To a place in a register, with or without a link.
    Jump,
    TableBranch,
    /// Floating point: all that takes one cycle.
    FloatSimple,
    FloatMultiplyAdd,
    FloatDivide,
    FloatRoot,
    FloatLoad,
    FloatStore,
    FloatMany(u32),
    /// Between two registers of the core and two of floating point.
    FloatMovePair,
}

use Instruction as I;

impl Instruction {
    /// Decodes an instruction from its first halfword, and the second, which only wide ones have. None where the tables
    /// of this program do not reach, as for what no compiler writes into a kernel.
    pub(crate) fn decode(first: u16, second: u16) -> Option<Self> {
        if is_wide(first) { wide(u32::from(first), u32::from(second)) } else { narrow(u32::from(first)) }
    }
}

/// Whether the instruction that starts with this halfword has 32 bits.
pub(crate) fn is_wide(first: u16) -> bool {
    first >= 0xe800
}

/// A field of an instruction: the bits from `low` to `high`.
fn bits(word: u32, high: u32, low: u32) -> u32 {
    word >> low & ((1 << (high - low + 1)) - 1)
}

/// A number of so many bits, with a sign.
fn signed(value: u32, width: u32) -> i32 {
    (value << (32 - width)).cast_signed() >> (32 - width)
}

/// Instructions of 16 bits.
fn narrow(word: u32) -> Option<I> {
    Some(match bits(word, 15, 11) {
        0b00000..=0b00111 | 0b10100 | 0b10101 => I::Simple,
        0b01000 => return data_processing(word),
        0b01001 => I::Load,
        // Of the eight with an offset in a register, the first three store.
        0b01010 | 0b01011 if bits(word, 11, 9) < 3 => I::Store,
        0b01010 | 0b01011 => I::Load,
        0b01100 | 0b01110 | 0b10000 | 0b10010 => I::Store,
        0b01101 | 0b01111 | 0b10001 | 0b10011 => I::Load,
        0b10110 | 0b10111 => return miscellaneous(word),
        0b11000 => I::StoreMany(bits(word, 7, 0).count_ones()),
        0b11001 => I::LoadMany(bits(word, 7, 0).count_ones()),
        0b11010 | 0b11011 if bits(word, 11, 8) < 14 => {
            I::ConditionalBranch(4 + 2 * signed(bits(word, 7, 0), 8))
        }
        0b11100 => I::Branch,
        _ => return None,
    })
}

/// Registers with registers, and the jumps among them.
fn data_processing(word: u32) -> Option<I> {
    let to_counter = bits(word, 7, 7) == 1 && bits(word, 2, 0) == 7;
    match bits(word, 10, 6) {
        0b01101 => Some(I::Multiply),
        0b11100..=0b11111 => Some(I::Jump),
        // An addition or a move to the program counter is a jump.
        0b10000..=0b10011 | 0b11000..=0b11011 if to_counter => Some(I::Jump),
        _ => Some(I::Simple),
    }
}

/// The stack, extensions, reversals, comparisons with zero that branch, and hints.
fn miscellaneous(word: u32) -> Option<I> {
    let registers = bits(word, 8, 0).count_ones();
    match bits(word, 11, 8) {
        0b0000 | 0b0010 | 0b1010 => Some(I::Simple),
        0b0001 | 0b0011 | 0b1001 | 0b1011 => {
            let distance = bits(word, 9, 9) << 6 | bits(word, 7, 3) << 1;
            Some(I::ConditionalBranch(4 + distance.cast_signed()))
        }
        0b0100 | 0b0101 => Some(I::StoreMany(registers)),
        0b1100 => Some(I::LoadMany(registers)),
        0b1101 => Some(I::PopReturn(registers)),
        0b1111 if bits(word, 3, 0) != 0 => Some(I::IfThen),
        0b1111 => Some(I::Simple),
        _ => None,
    }
}

/// Instructions of 32 bits.
fn wide(first: u32, second: u32) -> Option<I> {
    let operation = bits(first, 10, 4);
    match bits(first, 12, 11) {
        0b01 if operation & 0b1100100 == 0 => Some(many(first, second)),
        0b01 if operation & 0b1100100 == 0b0000100 => Some(pair(first, second)),
        0b01 if operation & 0b1100000 == 0b0100000 => Some(I::Simple),
        0b10 if second >> 15 == 0 => Some(I::Simple),
        0b10 => branch(first, second),
        0b11 if operation & 0b1110001 == 0 => Some(I::Store),
        0b11 if operation & 0b1100001 == 1 && second >> 12 == 15 && operation & 0b110 == 0b100 => {
            Some(I::LoadJump)
        }
        0b11 if operation & 0b1100001 == 1 => Some(I::Load),
        0b11 if operation & 0b1110000 == 0b0100000 => Some(I::Simple),
        0b11 if operation & 0b1111000 == 0b0110000 => {
            Some(if bits(second, 15, 12) == 15 { I::Multiply } else { I::MultiplyAdd })
        }
        0b11 if operation & 0b1111000 == 0b0111000 => Some(match bits(operation, 2, 0) {
            0b000 | 0b010 => I::LongMultiply,
            0b001 | 0b011 => I::Divide,
            _ => I::LongMultiplyAdd,
        }),
        _ if operation & 0b1000000 != 0 => float(first, second),
        _ => None,
    }
}

fn many(first: u32, second: u32) -> I {
    let registers = second.count_ones();
    match (bits(first, 4, 4), second >> 15) {
        (1, 1) => I::PopReturn(registers),
        (1, _) => I::LoadMany(registers),
        _ => I::StoreMany(registers),
    }
}

fn pair(first: u32, second: u32) -> I {
    if bits(first, 8, 5) == 0b0110 && bits(first, 4, 4) == 1 && bits(second, 15, 5) == 0b111_1000_0000 {
        I::TableBranch
    } else if bits(first, 4, 4) == 1 {
        I::LoadMany(2)
    } else {
        I::StoreMany(2)
    }
}

fn branch(first: u32, second: u32) -> Option<I> {
    match (bits(second, 14, 14), bits(second, 12, 12)) {
        (1, 1) => Some(I::Call),
        (0, 1) => Some(I::Branch),
        (0, 0) if bits(first, 9, 7) != 7 => {
            let (sign, j1, j2) = (bits(first, 10, 10), bits(second, 13, 13), bits(second, 11, 11));
            let distance =
                sign << 20 | j2 << 19 | j1 << 18 | bits(first, 5, 0) << 12 | bits(second, 10, 0) << 1;
            Some(I::ConditionalBranch(4 + signed(distance, 21)))
        }
        _ => None,
    }
}

/// Floating point of single precision: all that a Cortex-M4F has.
fn float(first: u32, second: u32) -> Option<I> {
    if bits(second, 11, 9) != 0b101 {
        return None;
    }
    if bits(first, 9, 8) == 0b10 {
        return Some(if bits(second, 4, 4) == 1 { I::FloatSimple } else { float_processing(first, second) });
    }
    if bits(first, 9, 9) == 1 {
        return None;
    }
    let is_load = bits(first, 4, 4) == 1;
    let words = bits(second, 7, 0);
    Some(match (bits(first, 8, 7), bits(first, 5, 5)) {
        (0b00, 0) => I::FloatMovePair,
        (0b10 | 0b11, 0) if bits(second, 8, 8) == 1 => I::FloatMany(2),
        (0b10 | 0b11, 0) if is_load => I::FloatLoad,
        (0b10 | 0b11, 0) => I::FloatStore,
        _ => I::FloatMany(words),
    })
}

fn float_processing(first: u32, second: u32) -> I {
    match bits(first, 7, 4) & 0b1011 {
        0b0000 | 0b0001 | 0b1001 | 0b1010 => I::FloatMultiplyAdd,
        0b1000 => I::FloatDivide,
        0b1011 if bits(first, 3, 0) == 1 && bits(second, 7, 6) == 0b11 => I::FloatRoot,
        _ => I::FloatSimple,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn narrow_instructions_are_told_apart() {
        for (word, instruction) in [
            (0x0048, I::Simple),               // lsls r0, r1, #1
            (0x1840, I::Simple),               // adds r0, r0, r1
            (0x4348, I::Multiply),             // muls r0, r1, r0
            (0x4288, I::Simple),               // cmp r0, r1
            (0x4770, I::Jump),                 // bx lr
            (0x4798, I::Jump),                 // blx r3
            (0x4687, I::Jump),                 // mov pc, r0
            (0x4680, I::Simple),               // mov r8, r0
            (0x4801, I::Load),                 // ldr r0, [pc, #4]
            (0x5088, I::Store),                // str r0, [r1, r2]
            (0x5888, I::Load),                 // ldr r0, [r1, r2]
            (0x5688, I::Load),                 // ldrsb r0, [r1, r2]
            (0x6008, I::Store),                // str r0, [r1]
            (0x6808, I::Load),                 // ldr r0, [r1]
            (0x8808, I::Load),                 // ldrh r0, [r1]
            (0x9001, I::Store),                // str r0, [sp, #4]
            (0xa801, I::Simple),               // add r0, sp, #4
            (0xb5f0, I::StoreMany(5)),         // push {r4-r7, lr}
            (0xbdf0, I::PopReturn(5)),         // pop {r4-r7, pc}
            (0xbc30, I::LoadMany(2)),          // pop {r4, r5}
            (0xb280, I::Simple),               // uxth r0, r0
            (0xbf08, I::IfThen),               // it eq
            (0xbf00, I::Simple),               // nop
            (0xb110, I::ConditionalBranch(8)), // cbz r0, .+8
            (0xc903, I::LoadMany(2)),          // ldm r1!, {r0, r1}
            (0xd0fe, I::ConditionalBranch(0)), // beq .
            (0xd001, I::ConditionalBranch(6)), // beq .+6
            (0xe7fe, I::Branch),               // b .
        ] {
            assert_eq!(Instruction::decode(word, 0), Some(instruction), "{word:#x}");
        }
        assert_eq!(Instruction::decode(0xdf00, 0), None, "a call of the supervisor");
    }

    #[test]
    fn wide_instructions_are_told_apart() {
        for (first, second, instruction) in [
            (0xfb01, 0xf000, I::Multiply),             // mul r0, r1, r0
            (0xfb01, 0x2000, I::MultiplyAdd),          // mla r0, r1, r0, r2
            (0xfba1, 0x0102, I::LongMultiply),         // umull r0, r1, r1, r2
            (0xfbc1, 0x0102, I::LongMultiplyAdd),      // smlal r0, r1, r1, r2
            (0xfbb0, 0xf0f1, I::Divide),               // udiv r0, r0, r1
            (0xfab0, 0xf080, I::Simple),               // clz r0, r0
            (0xeb00, 0x0041, I::Simple),               // add.w r0, r0, r1, lsl #1
            (0xf04f, 0x30ff, I::Simple),               // mov.w r0, #-1
            (0xf3c0, 0x0007, I::Simple),               // ubfx r0, r0, #0, #8
            (0xf8d1, 0x0004, I::Load),                 // ldr.w r0, [r1, #4]
            (0xf8c1, 0x0004, I::Store),                // str.w r0, [r1, #4]
            (0xf85d, 0xfb04, I::LoadJump),             // ldr pc, [sp], #4
            (0xe9d1, 0x0200, I::LoadMany(2)),          // ldrd r0, r2, [r1]
            (0xe9cd, 0x0200, I::StoreMany(2)),         // strd r0, r2, [sp]
            (0xe92d, 0x41f0, I::StoreMany(6)),         // push.w {r4-r8, lr}
            (0xe8bd, 0x81f0, I::PopReturn(6)),         // pop.w {r4-r8, pc}
            (0xe8df, 0xf000, I::TableBranch),          // tbb [pc, r0]
            (0xf000, 0xf800, I::Call),                 // bl .+4
            (0xf000, 0xb800, I::Branch),               // b.w .+4
            (0xf000, 0x8002, I::ConditionalBranch(8)), // beq.w .+8
            (0xee30, 0x0a20, I::FloatSimple),          // vadd.f32 s0, s0, s1
            (0xee20, 0x0a20, I::FloatSimple),          // vmul.f32 s0, s0, s1
            (0xee00, 0x0a20, I::FloatMultiplyAdd),     // vmla.f32 s0, s0, s1
            (0xee80, 0x0a20, I::FloatDivide),          // vdiv.f32 s0, s0, s1
            (0xeeb1, 0x0ac0, I::FloatRoot),            // vsqrt.f32 s0, s0
            (0xeeb4, 0x0a60, I::FloatSimple),          // vcmp.f32 s0, s1
            (0xeef1, 0xfa10, I::FloatSimple),          // vmrs APSR_nzcv, fpscr
            (0xee10, 0x0a10, I::FloatSimple),          // vmov r0, s0
            (0xed91, 0x0a01, I::FloatLoad),            // vldr s0, [r1, #4]
            (0xed81, 0x0a01, I::FloatStore),           // vstr s0, [r1, #4]
            (0xed2d, 0x8a04, I::FloatMany(4)),         // vpush {s16-s19}
            (0xecbd, 0x8a04, I::FloatMany(4)),         // vpop {s16-s19}
            (0xec51, 0x0a10, I::FloatMovePair),        // vmov r0, r1, s0, s1
        ] {
            assert_eq!(Instruction::decode(first, second), Some(instruction), "{first:#x} {second:#x}");
        }
    }
}
