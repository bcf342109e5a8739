//! Arm's timing tables, at zero wait states.

use std::ops::{Add, Mul};

use super::instruction::Instruction as I;

/// So many cycles at least, and at most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Span {
    pub(crate) least: u64,
    pub(crate) most: u64,
}

const fn span(least: u64, most: u64) -> Span {
    Span { least, most }
}

const fn exactly(cycles: u64) -> Span {
    span(cycles, cycles)
}

impl Add for Span {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        span(self.least + other.least, self.most + other.most)
    }
}

impl Mul<u64> for Span {
    type Output = Self;

    fn mul(self, count: u64) -> Self {
        span(self.least * count, self.most * count)
    }
}

/// A processor whose table is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Core {
    M0,
    M3,
    M4F,
}

/// What refilling the pipeline takes on a Cortex-M3 and M4, by the alignment and the width of the target: Arm's `P`.
const REFILL: Span = span(1, 3);

impl Core {
    /// Where the cycles are from.
    pub(crate) const fn source(self) -> &'static str {
        match self {
            Self::M0 => {
                "Arm DDI 0432C, Cortex-M0 r0p0 Technical Reference Manual, table 3-1; single-cycle multiplier"
            }
            Self::M3 => "Arm DDI 0337H, Cortex-M3 r2p0 Technical Reference Manual, table 3-1",
            Self::M4F => "Arm DDI 0439B, Cortex-M4 r0p0 Technical Reference Manual, tables 3-1 and 7-1",
        }
    }

    /// The cycles of an instruction, a branch being taken. None for what the processor does not have.
    pub(crate) fn cycles(self, instruction: I) -> Option<Span> {
        match self {
            Self::M0 => m0(instruction),
            Self::M3 => m3(instruction),
            Self::M4F => float(instruction).or_else(|| match instruction {
                // One cycle each, where the M3 takes up to seven.
                I::MultiplyAdd | I::LongMultiply | I::LongMultiplyAdd => Some(exactly(1)),
                other => m3(other),
            }),
        }
    }
}

/// Of a conditional branch that is not taken, on all three.
pub(crate) const NOT_TAKEN: Span = exactly(1);

/// DDI 0432C, table 3-1. The number of registers of a return includes the program counter.
fn m0(instruction: I) -> Option<Span> {
    let cycles = match instruction {
        I::Simple | I::Multiply => 1,
        I::Load | I::Store => 2,
        I::LoadMany(registers) | I::StoreMany(registers) => 1 + u64::from(registers),
        I::PopReturn(registers) => 4 + u64::from(registers),
        I::ConditionalBranch(_) | I::Branch | I::Jump => 3,
        I::Call => 4,
        _ => return None,
    };
    Some(exactly(cycles))
}

/// DDI 0337H, table 3-1. Loads and stores of one register that stand side by side share a cycle (its footnote b). Long
/// products end early by their operands, as divisions do.
fn m3(instruction: I) -> Option<Span> {
    Some(match instruction {
        I::Simple | I::IfThen | I::Multiply => exactly(1),
        I::MultiplyAdd => exactly(2),
        I::LongMultiply => span(3, 5),
        I::LongMultiplyAdd => span(4, 7),
        I::Divide => span(2, 12),
        I::Load | I::Store => span(1, 2),
        I::LoadMany(registers) | I::StoreMany(registers) => exactly(1 + u64::from(registers)),
        I::PopReturn(registers) => exactly(1 + u64::from(registers)) + REFILL,
        I::LoadJump | I::TableBranch => exactly(2) + REFILL,
        I::ConditionalBranch(_) | I::Branch | I::Call | I::Jump => exactly(1) + REFILL,
        _ => return None,
    })
}

/// DDI 0439B, table 7-1.
fn float(instruction: I) -> Option<Span> {
    Some(match instruction {
        I::FloatSimple => exactly(1),
        I::FloatMultiplyAdd => exactly(3),
        I::FloatDivide | I::FloatRoot => exactly(14),
        I::FloatLoad | I::FloatStore | I::FloatMovePair => exactly(2),
        I::FloatMany(registers) => exactly(1 + u64::from(registers)),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_processor_has_its_own_table() {
        let of = |instruction| [Core::M0, Core::M3, Core::M4F].map(|core| core.cycles(instruction));
        assert_eq!(of(I::Load), [Some(exactly(2)), Some(span(1, 2)), Some(span(1, 2))]);
        assert_eq!(of(I::LongMultiply), [None, Some(span(3, 5)), Some(exactly(1))]);
        assert_eq!(of(I::FloatDivide), [None, None, Some(exactly(14))]);
        assert_eq!(of(I::Call), [Some(exactly(4)), Some(span(2, 4)), Some(span(2, 4))]);
        assert_eq!(of(I::PopReturn(2))[0], Some(exactly(6)));
    }
}
