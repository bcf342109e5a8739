//! The targets: this machine, a browser, and processors on boards that QEMU emulates.

/// What is measured together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// The errors, which are the same on every target.
    Errors,
    /// This machine; costs are times.
    Host,
    /// A browser, with or without vector instructions; costs are times.
    Browser {
        /// Whether it may use vector instructions.
        simd: bool,
    },
    /// A microcontroller; costs are instructions.
    Board(&'static Board),
    /// A microcontroller that no code of Rust is compiled for; costs are instructions of the library for C.
    OfC(&'static Board),
}

/// A processor with the board that it sits on.
#[derive(Debug, PartialEq)]
pub struct Board {
    /// The processor, as the command line and the record name it.
    pub name: &'static str,
    /// The processor's name in texts for people.
    pub title: &'static str,
    /// The target that firmware in Rust for it is compiled for; empty if there is none.
    pub target: &'static str,
    /// The flag of rustc for a processor with more features than the target's; empty if it has none.
    pub flags: &'static str,
    /// The program of QEMU that emulates the board.
    pub emulator: &'static str,
    /// QEMU's arguments that select the board.
    pub machine: &'static [&'static str],
}

/// All boards: the Cortex-M from the smallest up, a RISC-V without a floating point unit; then later
/// processors, of which the Cortex-M33 and the Hazard3 are the two kinds of cores of an RP2350.
pub static BOARDS: [Board; 7] = [
    Board::arm("cortex-m0", "Cortex-M0", "thumbv6m-none-eabi", &["-M", "microbit"]),
    Board::arm("cortex-m3", "Cortex-M3", "thumbv7m-none-eabi", &["-M", "lm3s6965evb"]),
    Board::arm("cortex-m4f", "Cortex-M4F", "thumbv7em-none-eabihf", &["-M", "mps2-an386"]),
    Board {
        name: "rv32imc",
        title: "RV32IMC",
        target: "riscv32imc-unknown-none-elf",
        flags: "",
        emulator: "qemu-system-riscv32",
        machine: &["-M", "virt", "-bios", "none", "-cpu", "rv32,a=false,f=false,d=false"],
    },
    Board {
        flags: "-Ctarget-cpu=cortex-m7",
        ..Board::arm("cortex-m7", "Cortex-M7", "thumbv7em-none-eabihf", &["-M", "mps2-an500"])
    },
    Board::arm("cortex-m33", "Cortex-M33", "thumbv8m.main-none-eabihf", &["-M", "mps2-an505"]),
    Board {
        name: "hazard3",
        title: "Hazard3",
        target: "riscv32imac-unknown-none-elf",
        flags: "-Ctarget-feature=+zba,+zbb",
        emulator: "qemu-system-riscv32",
        machine: &["-M", "virt", "-bios", "none", "-cpu", "rv32,f=false,d=false,zba=true,zbb=true"],
    },
];

/// The core of an ESP8266, which the compiler of this project does not know.
pub(crate) static ESP8266: Board = Board {
    name: "esp8266",
    title: "ESP8266",
    target: "",
    flags: "",
    emulator: "qemu-system-xtensa",
    machine: &["-M", "sim", "-cpu", "lx106"],
};

impl Board {
    pub(crate) const fn arm(
        name: &'static str,
        title: &'static str,
        target: &'static str,
        machine: &'static [&'static str],
    ) -> Self {
        Self { name, title, target, flags: "", emulator: "qemu-system-arm", machine }
    }

    /// Whether the crate `luminaire-native` knows a square root of the processor.
    pub(crate) fn has_root(&self) -> bool {
        self.target.ends_with("eabihf")
    }
}

impl Target {
    /// Every target, in the order of the page.
    pub fn all() -> Vec<Self> {
        let others = [Self::Errors, Self::Host, Self::Browser { simd: false }, Self::Browser { simd: true }];
        others.into_iter().chain(BOARDS.iter().map(Self::Board)).chain([Self::OfC(&ESP8266)]).collect()
    }

    /// Returns the target of this name, or an error that lists the names.
    pub fn named(name: &str) -> Result<Self, String> {
        let names: Vec<_> = Self::all().iter().map(Self::name).collect();
        let found = Self::all().into_iter().find(|target| target.name() == name);
        found.ok_or_else(|| format!("target = {name}: expected one of {}", names.join(", ")))
    }

    /// The name on the command line and in the record.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Errors => "errors",
            Self::Host => "host",
            Self::Browser { simd: false } => "wasm",
            Self::Browser { simd: true } => "wasm-simd",
            Self::Board(board) | Self::OfC(board) => board.name,
        }
    }

    /// The name for people.
    pub fn title(&self) -> &'static str {
        match self {
            Self::Errors => "Errors",
            Self::Host => "Host",
            Self::Browser { simd: false } => "Browser",
            Self::Browser { simd: true } => "Browser, SIMD",
            Self::Board(board) | Self::OfC(board) => board.title,
        }
    }

    /// The unit of the costs.
    pub fn unit(&self) -> &'static str {
        if matches!(self, Self::Board(_) | Self::OfC(_)) { "instructions" } else { "ns" }
    }
}

/// A newcomer waits for the targets that rustup adds by itself, so that the workflow adds the others.
#[test]
fn the_target_of_every_board_is_added_by_rustup_or_by_the_workflow() {
    let read = |file: &str| std::fs::read_to_string(tools::project::root().join(file)).unwrap();
    let added = read("rust-toolchain.toml") + &read(".github/workflows/ci.yml");
    let words: Vec<_> = added.split(|c: char| c.is_whitespace() || "[],\"".contains(c)).collect();
    for board in &BOARDS {
        assert!(words.contains(&board.target), "{}", board.target);
    }
}
