//! C on microcontrollers: the library for C, and a lit point in the floats of C.

use std::path::PathBuf;
use std::process::Command;
use std::{array, fs};

use anyhow::{Context, Result, ensure};
use luminaire::{Angle, Cone, Fx16, SpotLight, falloff::Soft, number::Length};
use luminaire_effects::Inputs;

use crate::counted::thousandths;
use crate::program::Program;
use crate::qemu::{Qemu, prints_the_same};
use crate::record::{Group, Line};
use crate::target::{BOARDS, Board, ESP8266};
use tools::progress::Progress;
use tools::suite::Suite;
use tools::{command, compilers, project};

/// The files of the library.
pub(crate) const LIBRARY: &str = "export/c/src";

/// The program that calls its functions.
const CALLS: &str = "export/tests/calls.c";

/// The program that counts its calls, and one whose size is counted.
const PRICES: &str = "benches/firmware/src/prices.c";
const MOVING: &str = "benches/firmware/src/moving.c";

/// The name of their figures on record.
pub(crate) fn figure(name: &str) -> String {
    format!("c.{name}")
}

/// How they are optimised, and the units of their figures: `-O2` is the level of many builds by CMake and of
/// ESP-IDF's for speed, `-Os` that of the Arduino IDE.
pub(crate) const LEVELS: [(&str, &str); 3] =
    [("-O3", "instructions"), ("-O2", "instructions_at_o2"), ("-Os", "instructions_for_size")];

/// The calls that are counted: name, and what they are; a row counts for each of its pixels.
pub(crate) const CALLS_COUNTED: [(&str, &str); 16] = [
    ("irradiance", "`luminaire_spot_irradiance`, of a point in the light"),
    ("light", "`luminaire_spot_light`, with a colour"),
    ("light-away", "`luminaire_spot_irradiance`, of a point outside the cone"),
    ("falloff", "`luminaire_spot_falloff`"),
    ("can-reach", "`luminaire_spot_can_reach`"),
    ("normal", "`luminaire_normal_from_unit_bytes`"),
    ("changes", "`luminaire_spot_move`, `_dim` and `_aim`"),
    ("zoom", "`luminaire_spot_zoom`"),
    ("set-up", "`luminaire_cone_from_field` and `luminaire_spot_set_up`"),
    ("both-angles", "`luminaire_cone_from_beam_and_field`"),
    ("row", "`luminaire_row_add`, a pixel of a row across a light"),
    ("row-beside", "`luminaire_row_add`, a pixel of a row that the light does not reach"),
    ("rgb565", "`luminaire_rgb565`"),
    ("rgb565-dithered", "`luminaire_rgb565_dithered`"),
    ("srgb", "`luminaire_srgb`"),
    ("gray4-dithered", "`luminaire_pixel_dithered(LUMINAIRE_GRAY4, ..)`"),
];

/// A lit point in floats, by the functions of libgcc on a processor without a floating point unit.
const LIT: &str = "benches/firmware/src/lit.c";

/// The processor that it and worst cases are counted on, and the name of its figures.
pub(crate) const SMALLEST: &str = "cortex-m0";
const LIT_BY_LIBGCC: &str = "lit-inverse-square-libgcc.rival";

/// The number of its inputs.
const COUNT: usize = 256;

/// A board that runs programs of C, and the compiler with the options for it.
pub(crate) struct Machine {
    pub(crate) board: &'static Board,
    pub(crate) compiler: &'static str,
    pub(crate) options: &'static [&'static str],
    /// A file to compile beside the program.
    pub(crate) beside: Option<&'static str>,
}

/// No emulated board with a Cortex-M0 has room for the text output of newlib or for pictures, so one with a
/// Cortex-M3 runs its code.
pub(crate) static ROOMY: Board =
    Board::arm("cortex-m0", "Cortex-M0", "thumbv6m-none-eabi", &["-M", "mps2-an385"]);

static MACHINES: [Machine; 4] = [
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
        board: &BOARDS[2],
        compiler: "arm-none-eabi-gcc",
        options: &[
            "-mcpu=cortex-m4",
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
    Machine {
        board: &ESP8266,
        compiler: "xtensa-lx106-elf-gcc",
        options: &[
            "-mlongcalls",
            // The compiler does not look where Debian has this file.
            "--specs=/usr/lib/xtensa-lx106-elf/picolibc.specs",
            "-DPICOLIBC_INTEGER_PRINTF_SCANF",
            "-nostartfiles",
            "-Tbenches/firmware/src/xtensa.ld",
        ],
        beside: Some("benches/firmware/src/xtensa.c"),
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
    let program = compiled("cc", &[], &[project::root().join(CALLS)])?;
    let expected = command::answer(&mut Command::new(program))?;

    let options = [&["-Os", "-Wl,--gc-sections"], *options].concat();
    let files: Vec<_> = beside.iter().chain([&CALLS]).map(|file| project::root().join(file)).collect();
    let program = compiled(compiler, &options, &files)?;
    let mut qemu = Qemu::find(board, progress)?.with_console().command();
    let found = command::answer(qemu.arg("-kernel").arg(&program))?;
    ensure!(expected.lines().count() > 1000, "expected many results, found {expected}");
    prints_the_same(board, &found, &expected)
}

/// The machine with the processor of a board.
pub(crate) fn machine(board: &Board) -> Option<&'static Machine> {
    MACHINES.iter().find(|machine| machine.board.name == board.name)
}

/// Adds what C costs on a board, if one of the machines is it: the calls of the library, the size of a
/// program, and the floats of C.
pub(crate) fn add(board: &Board, group: &mut Group, progress: &Progress) -> Result<()> {
    let Some(machine) = machine(board) else { return Ok(()) };
    compilers::find(progress)?;
    add_prices(machine, group, progress)?;
    if board.name == SMALLEST {
        add_lit_by_libgcc(group, progress)?;
    }
    Ok(())
}

/// What C costs on a board that runs nothing else.
pub(crate) fn counted(board: &'static Board, progress: &Progress) -> Result<Group> {
    let machine = machine(board).with_context(|| format!("{} compiles no C", board.name))?;
    compilers::find(progress)?;
    let version = command::answer(Command::new(machine.compiler).arg("-dumpfullversion"))?;
    let compiler = format!("{} {}", machine.compiler, version.trim());
    let mut group =
        Group::about(&[("compiler", compiler), ("runs_on", Qemu::find(board, progress)?.describe())]);
    add_prices(machine, &mut group, progress)?;
    Ok(group)
}

/// Counts the instructions of the calls at each level. The results must be the host's.
fn add_prices(machine: &Machine, group: &mut Group, progress: &Progress) -> Result<()> {
    let Machine { board, compiler, options, beside } = machine;
    let root = project::root();
    let expected = command::answer(&mut Command::new(compiled("cc", &["-O2"], &[root.join(PRICES)])?))?;
    let files: Vec<_> = beside.iter().chain([&PRICES]).map(|file| root.join(file)).collect();
    for (level, unit) in LEVELS {
        let program = compiled(compiler, &[&[level], *options].concat(), &files)?;
        let (found, regions) = Qemu::find(board, progress)?.with_console().count(&program, progress)?;
        prints_the_same(board, &found, &expected)?;
        let lines = Line::all(&found)?;
        ensure!(lines.len() == regions.len(), "{PRICES}: {} lines, {} regions", lines.len(), regions.len());
        let sums: Vec<_> = regions.iter().map(|region| region.values().sum::<u64>() as f64).collect();
        for (line, sum) in lines.iter().zip(&sums).skip(1) {
            let count = (sum - sums[0]) / COUNT as f64;
            group.add(&figure(&line.name), unit, (10.0 * count).round() / 10.0);
        }
    }
    let sized = [&["-Os", "-ffunction-sections", "-fdata-sections", "-Wl,--gc-sections"], *options].concat();
    let alone = ["-nostartfiles", "-Wl,-e,main"];
    let program = compiled(compiler, &[&sized[..], &alone].concat(), &[root.join(MOVING)])?;
    group.add(&figure("moving"), "bytes", Program::read(&program)?.bytes());
    Ok(())
}

/// Counts the instructions of a lit point in C on a Cortex-M0, with the floats of libgcc. It must have the
/// bits of the host, and the light of the kernel.
fn add_lit_by_libgcc(group: &mut Group, progress: &Progress) -> Result<()> {
    let Machine { board, compiler, options, beside } = &MACHINES[0];
    let (root, target) = (project::root(), project::target());
    let mut inputs = Inputs::default();
    let surfaces = array::from_fn::<_, COUNT, _>(|_| inputs.surface());
    let sites = surfaces.map(|site| (site.point.map(Length::to_f32), site.normal.map(Fx16::to_f32)));
    let rows = sites.map(|(point, normal)| {
        let [point, normal] = [point, normal].map(|v| format!("{:e}f, {:e}f, {:e}f", v.x, v.y, v.z));
        format!("{{ {point}, {normal} }},\n")
    });
    fs::write(target.join("lit-inputs.h"), rows.concat())?;
    let include = format!("-I{}", target.display());
    let common = ["-O3", "-ffp-contract=off", &include];
    let expected = command::answer(&mut Command::new(compiled("cc", &common, &[root.join(LIT)])?))?;
    let files: Vec<_> = beside.iter().chain([&LIT]).map(|file| root.join(file)).collect();
    let program = compiled(compiler, &[&common, *options].concat(), &files)?;
    let (found, regions) = Qemu::find(board, progress)?.count(&program, progress)?;
    prints_the_same(board, &found, &expected)?;

    let cone = Cone::from_field(Soft, Angle::degrees(36.0))?;
    let spot = SpotLight::new([1.5, 4.0, -0.75], [0.36, -0.8, 0.48], cone)?.with_intensity(16.0)?;
    let spot = spot.compile::<f32>()?;
    let lines = Line::all(&found)?;
    let lights: Vec<_> = lines.iter().filter(|line| line.unit == "light").collect();
    ensure!(lights.len() == COUNT && regions.len() == 2, "{LIT}: {} results", lights.len());
    for ((point, normal), light) in sites.into_iter().zip(lights) {
        let (found, exact) = (light.value.parse::<f32>()?, spot.irradiance(point, normal));
        ensure!((found - exact).abs() < 1e-4, "{LIT}: {found} at {point:?}, {exact} by the kernel");
    }
    let [idle, busy] = [0, 1].map(|region| regions[region].values().sum::<u64>() as f64);
    group.add(LIT_BY_LIBGCC, "instructions", thousandths((busy - idle) / COUNT as f64));
    Ok(())
}

/// Compiles a program for C99. Returns its file.
pub(crate) fn compiled(compiler: &str, options: &[&str], files: &[PathBuf]) -> Result<PathBuf> {
    let (root, program) = (project::root(), project::target().join(format!("calls-{compiler}")));
    let mut compile = Command::new(compiler);
    // Files that options name are relative to it.
    compile.current_dir(root);
    compile.args(["-std=c99", "-Wall", "-Wextra", "-Wpedantic"]).args(options);
    compile.arg("-I").arg(root.join(LIBRARY)).args(files);
    compile.args(["-lm", "-o"]).arg(&program);
    command::answer(&mut compile)?;
    Ok(program)
}
