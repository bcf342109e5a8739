//! The headers of C have no undefined behaviour, by Frama-C's Eva: an interpreter of C over sets of values.

use std::fmt::Write as _;
use std::fs;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use fastrand::Rng;
use luminaire::Fx16;
use luminaire::dynamic::AnyLight;
use luminaire_export::{C_HEADERS, Language, Scene, export_scene};

use tools::progress::Progress;
use tools::suite::Suite;
use tools::{install, tool};

use crate::expected::lights;

#[path = "../../../export/tests/support/functions.rs"]
mod functions;
use functions::functions;

/// What calls the functions with all values.
const MAIN: &str = include_str!("../../../export/tests/proof.c");

/// The reads of flash that AVR's C library has.
const FLASH: &str = "#define PROGMEM\n#define pgm_read_byte(at) (*(at))\n\
                     #define pgm_read_word(at) (*(at))\n#define pgm_read_dword(at) (*(at))\n";

/// Processors, with Frama-C's name of their types and what their compilers define.
const PROCESSORS: [(&str, &str, &str); 3] = [
    ("32 bits", "gcc_x86_32", ""),
    ("Cortex-M0", "gcc_x86_32", "-D__ARM_ARCH_6M__"),
    ("AVR, whose int has 16 bits", "gcc_x86_16", "-D__AVR__ -U__SIZEOF_INT__"),
];

/// Lines with what Eva does there, and their number. It follows each value of a variable by itself; or it takes a loop
/// as a whole, within limits that it has to prove. That is a choice of precision and time; it assumes nothing of the
/// values.
const ANNOTATIONS: [(&str, &str, usize); 4] = [
    ("    while (light >= LUMINAIRE_READ_", "dynamic_split code", 3),
    ("    while (start < count) {", "split count", 1),
    ("    if ((packer->width + size + 7) >> 3 >", "split size", 1),
    (
        "        for (int step = 0; step < 16; ++step) {",
        "loop invariant -54149 <= least <= 16384; loop invariant -54149 <= most <= 16384; loop unroll 0",
        1,
    ),
];

/// How many states Eva follows by themselves, and the values of an expression that has a variable twice. The
/// bisection of a cone's edge needs only one state: 20 of them take twice as long.
/// Only shifts of negative numbers to the right are no alarms: the header rejects compilers that do not
/// keep the sign. Unsigned numbers wrap.
const OPTIONS: &str = "-eva -eva-precision 2 -eva-split-limit 300 -eva-split-return auto \
    -eva-slevel-function luminaire_knot_at:10000,luminaire_pack:1000,luminaire_row_skipped:2000,packing:1000,\
luminaire_cone_from_beam_and_field:0,luminaire_edge_versine:0 \
    -eva-subdivide-non-linear-function luminaire_start:256 \
    -eva-no-print -eva-no-show-progress -metrics -metrics-eva-cover";

/// Lights of each falloff with each of their variants.
const VARIANTS: usize = 3;

/// Adds the step. As root on Debian, it installs Frama-C.
pub(crate) fn step(suite: &mut Suite) {
    suite.remarked("c: Eva finds no undefined behaviour", prove);
}

fn prove(progress: &Progress) -> Result<Vec<String>> {
    let program = install::program(&tool::FRAMA_C, progress)?;
    let folder = tempfile::tempdir().context("no folder")?;
    let write = |name: &str, text: &str| {
        fs::write(folder.path().join(name), text).with_context(|| format!("cannot write {name}"))
    };
    let mut found = [0; ANNOTATIONS.len()];
    for (name, text) in C_HEADERS {
        let mut text = text.to_owned();
        for ((line, annotation, _), found) in ANNOTATIONS.iter().zip(&mut found) {
            *found += text.matches(line).count();
            text = text.replace(line, &format!("    /*@ {annotation}; */\n{line}"));
        }
        write(name, &text)?;
    }
    for ((line, _, expected), found) in ANNOTATIONS.iter().zip(found) {
        ensure!(found == *expected, "{found} lines `{}`: expected {expected}", line.trim_start());
    }
    fs::create_dir(folder.path().join("avr")).context("no folder")?;
    write("avr/pgmspace.h", FLASH)?;
    write("lights.h", &constant_lights()?)?;
    write("proof.c", MAIN)?;
    let analyses = PROCESSORS.map(|(_, types, defines)| {
        let mut eva = Command::new(&program);
        eva.args(["-machdep", types]).arg(format!("-cpp-extra-args=-I{} {defines}", folder.path().display()));
        eva.arg(folder.path().join("proof.c")).args(OPTIONS.split_whitespace());
        eva
    });
    let functions: Vec<_> = functions().map(|(name, _)| name).collect();
    let mut remarks = Vec::new();
    for ((name, ..), output) in PROCESSORS.iter().zip(progress.outputs(analyses.into())?) {
        let reached = |function: &&&str| output.contains(&format!("\n  {function}: "));
        if let Some(function) = functions.iter().find(|function| !reached(function)) {
            bail!("{name}: {function} is not analysed: expected a call in export/tests/proof.c");
        }
        let is_proved = ["  0 alarms generated", "100% of the logical properties reached have been proven"]
            .iter()
            .all(|line| output.contains(line));
        ensure!(is_proved, "{name}: Eva has alarms");
        remarks.push(format!("{name}: {} functions analysed, 0 alarms", functions.len()));
    }
    Ok(remarks)
}

/// Lights of all falloffs and attenuations, and a function that evaluates them at a point, one by one and together.
fn constant_lights() -> Result<String> {
    let mut rng = Rng::with_seed(2001);
    let spots = lights::spots::<Fx16>(&mut rng, VARIANTS).into_iter().map(AnyLight::from);
    let all: Vec<_> =
        spots.chain(lights::points_of_light::<Fx16>(&mut rng).into_iter().map(AnyLight::from)).collect();
    let names: Vec<_> = (0..all.len()).map(|index| format!("light{index}")).collect();
    let named = names.iter().map(String::as_str).zip(all.iter().copied());
    let (text, refused) = export_scene(&Scene { name: "room", ambient: &[] }, named, Language::CFixed)?;
    ensure!(refused.is_empty(), "expected C of each light, found {refused:?}");
    let mut calls = "    room_light(&room_start, point, normal);\n".to_owned();
    for (index, light) in all.into_iter().enumerate() {
        let _ = writeln!(calls, "    light{index}_irradiance(point, normal);");
        if matches!(light, AnyLight::Spot(_)) {
            let _ = writeln!(calls, "    light{index}_falloff(point);");
        }
    }
    Ok(format!(
        "{text}\nstatic void lights_at(const int32_t point[3], const int16_t normal[3]) {{\n{calls}}}\n"
    ))
}
