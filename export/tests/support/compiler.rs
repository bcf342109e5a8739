//! Compilers of C and C++ on this machine.
#![allow(dead_code, reason = "each test uses a part")]

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// Set where the compilers must be installed.
const TOOLS: &str = "LUMINAIRE_TOOLS";

/// Writes the library for C into a folder, and a stand-in for the header with which an AVR reads its flash.
pub(crate) fn write_headers(folder: &Path) {
    for (name, text) in luminaire_export::C_HEADERS {
        fs::write(folder.join(name), text).expect("a folder");
    }
    let read = |name, bits| {
        format!("static inline uint{bits}_t pgm_read_{name}(const uint{bits}_t *at) {{ return *at; }}\n")
    };
    let reads = [("byte", 8), ("word", 16), ("dword", 32)].map(|(name, bits)| read(name, bits)).concat();
    fs::create_dir_all(folder.join("avr")).expect("a folder");
    let text = format!("#ifndef FLASH\n#define FLASH\n#define PROGMEM\n{reads}#endif\n");
    fs::write(folder.join("avr/pgmspace.h"), text).expect("a folder");
}

/// Says that a program is not installed.
///
/// # Panics
/// The environment variable says that it must be.
pub(crate) fn is_missing<T>(program: &str) -> Option<T> {
    assert!(std::env::var_os(TOOLS).is_none(), "{program} is not installed, and {TOOLS} is set");
    println!("not tested: {program} is not installed");
    None
}

/// Compiles a file; `None` without the compiler.
///
/// # Panics
/// The compiler fails, or is not installed and the environment variable says that it must be.
pub(crate) fn compile(compiler: &str, flags: &str, file: &Path, output: &Path) -> Option<()> {
    let mut compile = Command::new(compiler);
    compile.args(flags.split_whitespace()).args("-Wall -Wextra -Werror -pedantic -x".split(' '));
    let language = if compiler.ends_with("++") { "c++" } else { "c" };
    let Ok(compiled) =
        compile.arg(language).arg(file).arg("-o").arg(output).args(["-x", "none", "-lm"]).output()
    else {
        return is_missing(compiler);
    };
    assert!(compiled.status.success(), "{compiler} {flags}: {}", String::from_utf8_lossy(&compiled.stderr));
    Some(())
}

/// Compiles a file for the smallest processors that are supported.
///
/// # Panics
/// A warning, or a call of a routine for floats or divisions.
pub(crate) fn compile_in_integers(file: &Path) {
    let object = file.with_extension("o");
    for (compiler, flags) in [
        ("arm-none-eabi-gcc", "-std=c99 -Os -mcpu=cortex-m0 -mthumb -ffreestanding -c"),
        ("arm-none-eabi-g++", "-std=c++11 -Os -mcpu=cortex-m0 -mthumb -ffreestanding -c"),
        ("riscv64-unknown-elf-gcc", "-std=c99 -Os -march=rv32imc -mabi=ilp32 -ffreestanding -c"),
    ] {
        if compile(compiler, flags, file, &object).is_none() {
            continue;
        }
        let object = fs::read(&object).expect("an object");
        // Names of routines for floats and divisions begin so, in both ABIs.
        for routine in [
            "__aeabi_f",
            "__aeabi_d",
            "__aeabi_ui",
            "__aeabi_id",
            "__aeabi_ld",
            "__aeabi_ul",
            "__div",
            "__udiv",
            "__mod",
            "__umod",
            "malloc",
        ] {
            let calls = object.windows(routine.len()).any(|name| name == routine.as_bytes());
            assert!(!calls, "{compiler} calls {routine}..");
        }
    }
}

/// Compiles a text with the library `luminaire` into a file.
///
/// # Panics
/// The compiler fails with every build of the library beside this test.
pub(crate) fn compile_rust(text: &str, kind: &str, to: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let path = to.with_extension("rs");
    fs::write(&path, text)?;
    let mut libraries = Vec::new();
    let program = std::env::current_exe()?;
    let dependencies = program.parent().ok_or("a folder of programs")?;
    for entry in fs::read_dir(dependencies)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.starts_with("libluminaire-") && name.ends_with(".rlib") {
            libraries.push((entry.metadata()?.modified()?, entry.path()));
        }
    }
    libraries.sort();
    // The newest is usually that of this program; any will do that this compiler has built.
    let mut told = None;
    for (_, library) in libraries.into_iter().rev() {
        let mut compiler = Command::new(std::env::var_os("RUSTC").unwrap_or("rustc".into()));
        compiler.args(["--edition=2024", "--cap-lints=allow", "-L"]);
        compiler.arg(format!("dependency={}", dependencies.display())).arg("--extern");
        compiler.arg(format!("luminaire={}", library.display())).args(["--crate-type", kind, "-o"]).arg(to);
        let output = compiler.arg(&path).output()?;
        if output.status.success() {
            return Ok(());
        }
        // The newest says what is wrong with the text: an older one may lack what the text calls.
        told = told.or(Some(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    panic!("{}", told.as_deref().unwrap_or("no library is built"));
}

/// The bytes of words.
pub(crate) fn bytes(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

/// Compiles a program for this machine and runs it on words; `None` without the compiler.
pub(crate) fn run(compiler: &str, flags: &str, file: &Path, input: &[u32]) -> Option<Vec<u32>> {
    let program = file.with_extension("program");
    compile(compiler, flags, file, &program)?;
    let mut process =
        Command::new(&program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("a program");
    let bytes = bytes(input);
    let mut stdin = process.stdin.take().expect("a pipe");
    let writer = std::thread::spawn(move || stdin.write_all(&bytes));
    let output = process.wait_with_output().expect("an end");
    let _ = writer.join();
    assert!(output.status.success(), "{compiler} {flags}: {}", String::from_utf8_lossy(&output.stderr));
    let words =
        output.stdout.chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().expect("a word")));
    Some(words.collect())
}
