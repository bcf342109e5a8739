//! Recognises the marker instructions by their bits.

/// The instruction sets that the firmware is compiled for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Architecture {
    /// Arm in Thumb state, the only state of a Cortex-M.
    Thumb,
    /// RISC-V of 32 bits, with or without compressed instructions.
    RiscV,
    /// Xtensa with instructions of 16 and 24 bits.
    Xtensa,
}

/// A marker instruction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Marker {
    /// The region begins after this instruction.
    Begin,
    /// The region ends before this instruction.
    End,
}

impl Architecture {
    /// The architecture that QEMU calls `name`.
    pub(crate) fn of_target(name: &str) -> Option<Self> {
        match name {
            "arm" => Some(Self::Thumb),
            "riscv32" => Some(Self::RiscV),
            "xtensa" => Some(Self::Xtensa),
            _ => None,
        }
    }

    /// Whether the instruction that starts with this halfword has 32 bits. One of 24 bits is none of the
    /// markers, which its first halfword tells.
    ///
    /// The size that QEMU states cannot be used: for a 16-bit instruction just before the end of a
    /// page, QEMU 7.2 states a larger one.
    pub(crate) fn is_wide(self, first: u16) -> bool {
        match self {
            Self::Thumb => first >= 0xe800,
            Self::RiscV => first & 3 == 3,
            Self::Xtensa => false,
        }
    }

    /// Returns the marker with these bits, if they are one. A 16-bit instruction is in the lower
    /// half.
    pub(crate) fn marker(self, instruction: u32) -> Option<Marker> {
        match (self, instruction) {
            // mov r10, r10 and mov r11, r11
            (Self::Thumb, 0x46d2) => Some(Marker::Begin),
            (Self::Thumb, 0x46db) => Some(Marker::End),
            // slti x0, x0, 0x7b1 and slti x0, x0, 0x7b2
            (Self::RiscV, 0x7b10_2013) => Some(Marker::Begin),
            (Self::RiscV, 0x7b20_2013) => Some(Marker::End),
            // mov.n a12, a12 and mov.n a13, a13
            (Self::Xtensa, 0x0ccd) => Some(Marker::Begin),
            (Self::Xtensa, 0x0ddd) => Some(Marker::End),
            _ => None,
        }
    }
}
