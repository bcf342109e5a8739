//! The proof that nothing panics: programs that call each public function of the core on unknown
//! values, and that do not link if one of them can panic.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, ensure};

use crate::counted::{self, FIRMWARE, SIZE};
use crate::effects::{FX16, Format, write_source};
use crate::program::{Program, is_heap};
use crate::public::{self, Function};
use crate::target::Board;
use tools::progress::Progress;
use tools::{command, project};

/// The program that calls the functions that depend on the format.
const NO_PANIC: &str = "no_panic";
/// The program that calls the other functions. One format is enough for it.
const COMMON: &str = "no_panic_common";

/// The kernel's features that the functions are listed and compiled with, by the feature of the programs
/// that selects them: with the arithmetic of the number formats, and so with `libm`; the kernel's own
/// series instead of `libm`, with the conversions to other crates; and `micromath`.
pub(crate) const CONFIGURATIONS: [(&str, &str); 3] = [
    ("arithmetic", "fixed,arithmetic,native"),
    ("interop", "fixed,bytemuck,defmt,embedded-graphics-core04,glam034,mint05,serde"),
    ("micromath", "fixed,micromath"),
];

/// Functions without a wrapper, by path or as `Trait::function`, each with the reason.
const EXEMPT: [(&str, &str); 11] = [
    ("Attenuation::with", "passes the attenuation to code of the caller"),
    ("luminaire::falloff::with_falloff", "passes the falloff to code of the caller"),
    ("luminaire::falloff::falloffs", "passes each falloff to code of the caller"),
    ("luminaire::falloff::constant_falloffs", "passes each falloff to code of the caller"),
    ("luminaire::attenuation::attenuations", "passes each attenuation to code of the caller"),
    ("luminaire::specular::lobes", "passes each lobe to code of the caller"),
    (
        "luminaire::codegen::written_by",
        "called while constants are compiled, where a panic is a compiler's error",
    ),
    ("Debug::fmt", "text for people: the formatter of the standard library can panic"),
    ("Display::fmt", "text for people: the formatter of the standard library can panic"),
    ("Named::write_name", "source text, which build scripts write on the host"),
    ("Source::write", "source text, which build scripts write on the host"),
];

/// The types in the programs' library that depend on the format. A call that names one of them is made in
/// each format.
const OF_FORMAT: &str =
    "Format QuickFormat Irradiance Gain Offset Ray FineRay FineShare Fraction FineFraction";

/// All public functions of the core in a configuration: those called in each format, those called once,
/// and the number of exempt ones.
#[derive(Debug)]
struct Proof {
    configuration: &'static str,
    each_format: Vec<Function>,
    common: Vec<Function>,
    exempt: usize,
}

/// Links the programs of a configuration for a board in formats, which fails if a panic can be reached,
/// and checks that they have no heap. Returns the number of functions.
pub(crate) fn no_panic(
    (configuration, features): (&'static str, &str),
    board: &'static Board,
    formats: &[Format],
    progress: &Progress,
) -> Result<String> {
    let proof = Proof::write(configuration, features, progress)?;
    for &format in formats {
        let name = format.name;
        let files = proof.link(board, format, &[], progress).or_else(|error| {
            let culprits = proof.culprits(board, format, progress).unwrap_or_default();
            ensure!(culprits.is_empty(), "in {name} these can panic:\n{}", culprits.join("\n"));
            Err(error)
        })?;
        for file in files {
            let program = Program::read(&file)?;
            let heap = program.names_of(is_heap);
            ensure!(heap.is_empty(), "in {name} there is a heap: {}", heap.join(", "));
            // A program from which the linker has removed everything would prove nothing.
            ensure!(program.bytes() > 100_000, "in {name} there is nothing left to panic");
        }
    }
    let (each, common) = (proof.each_format.len(), proof.common.len());
    let all = each + common + proof.exempt;
    Ok(format!(
        "{configuration}: {all} functions, {each} in each format, {common} once, {} exempt",
        proof.exempt
    ))
}

/// The programs that are linked in a format.
fn programs(format: Format) -> &'static [&'static str] {
    if format == FX16 { &[NO_PANIC, COMMON] } else { &[NO_PANIC] }
}

impl Proof {
    /// Lists the functions with rustdoc, and writes what the programs include.
    fn write(configuration: &'static str, features: &str, progress: &Progress) -> Result<Self> {
        let folder = project::target().join("public");
        let kernel = ["--package", "luminaire", "--no-default-features", "--features", features];
        let mut rustdoc = command::cargo([&["rustdoc"], &kernel[..]].concat());
        rustdoc.arg("--target-dir").arg(&folder);
        // Only a nightly compiler writes the list, or a stable one with `RUSTC_BOOTSTRAP`.
        rustdoc.args(["--", "-Zunstable-options", "--output-format=json"]).env("RUSTC_BOOTSTRAP", "1");
        progress.run(rustdoc)?;
        let json = fs::read(folder.join("doc/luminaire.json")).context("rustdoc has written no list")?;
        let proof = Self::of(configuration, public::functions(&serde_json::from_slice(&json)?)?)?;
        let folder = project::root().join(FIRMWARE).join("target/calls").join(configuration);
        write_source(&folder, NO_PANIC, &wrappers(&proof.each_format))?;
        write_source(&folder, COMMON, &wrappers(&proof.common))?;
        Ok(proof)
    }

    fn of(configuration: &'static str, functions: Vec<Function>) -> Result<Self> {
        let is =
            |function: &Function, name| function.of_trait.as_deref() == Some(name) || function.name == name;
        for (name, _) in EXEMPT {
            let is_used = configuration != CONFIGURATIONS[0].0 || functions.iter().any(|of| is(of, name));
            ensure!(is_used, "no function is {name}: remove it from EXEMPT");
        }
        let all = functions.len();
        let is_called = |of: &Function| !EXEMPT.iter().any(|(name, _)| is(of, name));
        let called: Vec<_> = functions.into_iter().filter(is_called).collect();
        let failure = |of: &Function| Some(format!("{}: {}", of.name, of.calls.as_ref().err()?));
        let failures: Vec<_> = called.iter().filter_map(failure).collect();
        ensure!(
            failures.is_empty(),
            "no call is known of these functions; add a row to a table in benches/measure/src/public.rs:\n{}",
            failures.join("\n")
        );
        let exempt = all - called.len();
        let (each_format, common) = called.into_iter().partition(depends_on_format);
        Ok(Self { configuration, each_format, common, exempt })
    }

    /// Links programs. A program that can panic does not link, unless among the `options` of cargo is
    /// the feature `culprits`.
    fn link(
        &self,
        board: &Board,
        format: Format,
        options: &[&str],
        progress: &Progress,
    ) -> Result<Vec<PathBuf>> {
        let package = ["--profile", SIZE, "--package", "luminaire-proof", "--features", self.configuration];
        let bins: Vec<_> = programs(format).iter().flat_map(|name| ["--bin", name]).collect();
        let options = [&package, &bins[..], format.features, options].concat();
        let folder = counted::build(board, &options, progress)?.artifacts(SIZE);
        Ok(programs(format).iter().map(|name| folder.join(name)).collect())
    }

    /// The names of the functions that can panic, read from programs that are linked although they
    /// can panic.
    fn culprits(&self, board: &Board, format: Format, progress: &Progress) -> Result<Vec<&str>> {
        let files = self.link(board, format, &["--features", "culprits"], progress)?;
        let mut culprits = Vec::new();
        for (program, file) in programs(format).iter().zip(files) {
            let linked = Program::read(&file)?;
            let callers = linked.callers("a_panic_is_reachable");
            let functions = if *program == COMMON { &self.common } else { &self.each_format };
            let named = functions.iter().map(|function| function.name.as_str());
            culprits.extend(named.filter(|name| callers.contains(&*format!("{program}::{}", symbol(name)))));
        }
        Ok(culprits)
    }
}

fn depends_on_format(function: &Function) -> bool {
    let calls = function.calls.iter().flatten();
    let mut words = calls.flat_map(|call| call.split(|c: char| !c.is_alphanumeric()));
    words.any(|word| OF_FORMAT.split(' ').any(|of| of == word))
}

/// The name of a function's wrapper.
fn symbol(name: &str) -> String {
    let name = name.replace("luminaire::", "").replace("core::", "");
    let words = name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_")
}

/// A wrapper for each function, and the function that calls them all.
fn wrappers(functions: &[Function]) -> String {
    let mut text = String::new();
    for function in functions {
        let calls = function.calls.iter().flatten().map(|call| format!("        {call};\n"));
        text += &format!(
            "/// `{}`\n#[inline(never)]\n#[allow(non_snake_case, unused_unsafe, reason = \"generated\")]\n\
             fn {}() {{\n    // SAFETY: never run.\n    unsafe {{\n{}    }}\n}}\n\n",
            function.name,
            symbol(&function.name),
            calls.collect::<String>()
        );
    }
    let symbols: String = functions.iter().map(|of| format!("        {},\n", symbol(&of.name))).collect();
    text + &format!(
        "fn every_function() {{\n    let all: [fn(); {}] = [\n{symbols}    ];\n    \
         core::hint::black_box(all).iter().for_each(|function| function());\n}}\n",
        functions.len()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn function(name: &str, of_trait: Option<&str>, call: Result<&str, &str>) -> Function {
        let calls = call.map(|call| vec![call.to_owned()]).map_err(str::to_owned);
        Function { name: name.to_owned(), of_trait: of_trait.map(str::to_owned), calls }
    }

    fn proof(more: &[Function]) -> Result<Proof> {
        let exempt = EXEMPT.iter().map(|(name, _)| function("<T as Trait>::f", Some(name), Err("unknown")));
        Proof::of(CONFIGURATIONS[0].0, exempt.chain(more.iter().cloned()).collect())
    }

    #[test]
    fn function_is_exempt_common_or_called_in_each_format() {
        let common = function("luminaire::Angle::versine", None, Ok("sink(source::<luminaire::Angle>())"));
        let each = function("<luminaire::Rgb<Format>>::new", None, Ok("sink(source::<FineRay>())"));
        let proof = proof(&[common, each]).unwrap();
        assert_eq!((proof.each_format.len(), proof.common.len(), proof.exempt), (1, 1, EXEMPT.len()));
        let text = wrappers(&proof.each_format);
        assert!(text.contains("fn Rgb_Format_new() {"), "{text}");
        assert!(text.contains("        sink(source::<FineRay>());\n"), "{text}");
    }

    #[test]
    fn function_without_a_call_is_refused_by_name() {
        let refused = proof(&[function("luminaire::f", None, Err("no row"))]).unwrap_err();
        assert!(refused.to_string().contains("luminaire::f: no row"), "{refused}");
    }
}
