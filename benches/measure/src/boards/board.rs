//! The processors whose instructions are counted, each on a board that QEMU emulates.

/// A processor with the board that it sits on.
#[derive(Debug, PartialEq)]
pub struct Board {
    /// The processor, as the command line and the tables name it.
    pub name: &'static str,
    /// The processor's name in texts for people.
    pub title: &'static str,
    /// The target that firmware for it is compiled for.
    pub target: &'static str,
    /// The program of QEMU that emulates the board.
    pub emulator: &'static str,
    /// QEMU's arguments that select the board.
    pub machine: &'static [&'static str],
}

/// A RISC-V without a floating point unit.
pub(crate) const RV32IMC: Board = Board {
    name: "rv32imc",
    title: "RV32IMC",
    target: "riscv32imc-unknown-none-elf",
    emulator: "qemu-system-riscv32",
    machine: &["-M", "virt", "-bios", "none", "-cpu", "rv32,a=false,f=false,d=false"],
};

/// All boards: the Cortex-M from the smallest up, then the RISC-V.
pub static ALL: [Board; 4] = [
    Board {
        name: "cortex-m0",
        title: "Cortex-M0",
        target: "thumbv6m-none-eabi",
        emulator: "qemu-system-arm",
        machine: &["-M", "microbit"],
    },
    Board {
        name: "cortex-m3",
        title: "Cortex-M3",
        target: "thumbv7m-none-eabi",
        emulator: "qemu-system-arm",
        machine: &["-M", "lm3s6965evb"],
    },
    Board {
        name: "cortex-m4f",
        title: "Cortex-M4F",
        target: "thumbv7em-none-eabihf",
        emulator: "qemu-system-arm",
        machine: &["-M", "mps2-an386"],
    },
    RV32IMC,
];

impl Board {
    /// Returns the board of this name, or an error that lists the names.
    pub fn named(name: &str) -> Result<&'static Self, String> {
        ALL.iter().find(|board| board.name == name).ok_or_else(|| {
            let names: Vec<_> = ALL.iter().map(|board| board.name).collect();
            format!("there is no target {name}; there are {}", names.join(", "))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_board_is_found_by_its_name_or_the_names_are_told() {
        assert_eq!(Board::named("rv32imc").unwrap().emulator, "qemu-system-riscv32");
        let refused = Board::named("cortex-m1").unwrap_err();
        assert!(refused.contains("cortex-m1") && refused.contains("cortex-m4f"), "{refused}");
    }
}
