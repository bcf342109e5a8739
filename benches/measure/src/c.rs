//! C on microcontrollers: the library for C.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, ensure};

use crate::qemu::{Qemu, prints_the_same};
use crate::target::{BOARDS, Board};
use tools::progress::Progress;
use tools::suite::Suite;
use tools::toolchain::Toolchain;
use tools::{command, compilers, project};

/// The package of the library, and the name of its file.
const LIBRARY: (&str, &str) = ("luminaire-c", "libluminaire_c.a");

/// The program that calls every function of the library.
const CALLS: &str = "export/capi/tests/calls.c";

/// A board that runs programs of C, and the compiler with the options for it.
struct Machine {
    board: &'static Board,
    compiler: &'static str,
    options: &'static [&'static str],
    /// A file to compile beside the program.
    beside: Option<&'static str>,
}

/// No emulated board with a Cortex-M0 has room for the text output of newlib, so one with a Cortex-M3 runs
/// its code.
static ROOMY: Board = Board::arm("cortex-m0", "Cortex-M0", "thumbv6m-none-eabi", &["-M", "mps2-an385"]);

static MACHINES: [Machine; 2] = [
    Machine {
        board: &ROOMY,
        compiler: "arm-none-eabi-gcc",
        options: &[
            "-mcpu=cortex-m0",
            "-mthumb",
            "--specs=rdimon.specs",
            "-Wl,--section-start=.vectors=0",
            "-Wl,--undefined=vectors",
        ],
        beside: Some("benches/firmware/src/vectors.c"),
    },
    Machine {
        board: &BOARDS[3],
        compiler: "riscv64-unknown-elf-gcc",
        options: &[
            "-march=rv32imc",
            "-mabi=ilp32",
            "--specs=picolibc.specs",
            "--oslib=semihost",
            "--crt0=semihost",
            // Code and data in the RAM of the board, a megabyte each.
            "-Wl,--defsym=__flash=0x80000000,--defsym=__flash_size=0x100000",
            "-Wl,--defsym=__ram=0x80100000,--defsym=__ram_size=0x100000",
        ],
        beside: None,
    },
];

/// Adds the steps. They fail unless C, compiled by gcc, has the bits of the kernel.
pub fn steps(suite: &mut Suite) {
    for machine in &MACHINES {
        let name = machine.board.name;
        suite.step(
            &format!("c: a program that calls the library on {name} prints what the host's prints"),
            |progress| called(machine, progress),
        );
    }
}

/// Builds the program for this machine and for a small processor, and compares what they print.
fn called(machine: &'static Machine, progress: &Progress) -> Result<()> {
    let Machine { board, compiler, options, beside } = machine;
    compilers::find(progress)?;
    let (package, library) = LIBRARY;
    progress.run(command::cargo(["build", "--package", package]))?;
    let program = compiled("cc", &[], None, &project::target().join("debug").join(library))?;
    let expected = command::answer(&mut Command::new(program))?;

    let toolchain = Toolchain::find(board.target, progress)?.with_flags(board.flags);
    toolchain.build(project::root(), &["--release", "--package", package], progress)?;
    let options = [&["-Os", "-Wl,--gc-sections"], *options].concat();
    let library = toolchain.artifacts("release").join(library);
    let program = compiled(compiler, &options, *beside, &library)?;
    // picolibc writes single letters to the console. Without a device for it, QEMU writes them to its
    // standard error.
    let mut qemu = Qemu::find(board, progress)?.command(",chardev=console");
    let found = command::answer(qemu.args(["-chardev", "stdio,id=console", "-kernel"]).arg(&program))?;
    ensure!(expected.lines().count() > 1000, "expected many results, found {expected}");
    prints_the_same(board, &found, &expected)
}

/// Compiles the program and a file beside it with a library. Returns its file.
fn compiled(compiler: &str, options: &[&str], beside: Option<&str>, library: &Path) -> Result<PathBuf> {
    let (root, program) = (project::root(), project::target().join(format!("calls-{compiler}")));
    let mut compile = Command::new(compiler);
    compile.args(["-std=c99", "-Wall", "-Wextra", "-Wpedantic"]).args(options);
    compile.arg("-I").arg(root.join("export/capi/include")).arg(root.join(CALLS));
    compile.args(beside.map(|file| root.join(file))).arg(library);
    compile.args(["-lm", "-o"]).arg(&program);
    command::answer(&mut compile)?;
    Ok(program)
}
