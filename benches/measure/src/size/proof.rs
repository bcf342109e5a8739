//! The proof that nothing panics: programs that call each public function of the core on unknown
//! values, and that do not link if one of them can panic.

use std::fmt;
use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, ensure};

use super::effects::{self, Format, PROFILE};
use super::program::Program;
use super::public::{self, Function};
use crate::boards::{Board, laboratory};
use tools::progress::Progress;
use tools::{command, project};

/// The program that calls the functions that depend on the format.
const NO_PANIC: &str = "no_panic";
/// The program that calls the other functions. One format is enough for it.
const COMMON: &str = "no_panic_common";

/// The kernel's features that the functions are listed and compiled with, named as the feature of the
/// programs that selects them.
#[derive(Debug)]
pub(crate) struct Configuration {
    pub(crate) name: &'static str,
    features: &'static str,
}

/// With the arithmetic of the number formats, and so with `libm`.
pub(crate) const MAIN: Configuration = Configuration { name: "arithmetic", features: "fixed,arithmetic" };
/// The further configurations: the kernel's own series instead of `libm`, with the conversions to other
/// crates; and `micromath`.
pub(crate) const MORE: [Configuration; 2] = [
    Configuration {
        name: "interop",
        features: "fixed,bytemuck,defmt,embedded-graphics-core04,glam034,mint05,serde",
    },
    Configuration { name: "micromath", features: "fixed,micromath" },
];

/// Functions without a wrapper, by path or as `Trait::function`, each with the reason.
const EXEMPT: [(&str, &str); 10] = [
    ("Debug::fmt", "text for people: the formatter of the standard library can panic"),
    ("Display::fmt", "text for people: the formatter of the standard library can panic"),
    ("Named::write_name", "source text, which build scripts write on the host"),
    ("Source::write", "source text, which build scripts write on the host"),
    ("<luminaire::attenuation::AnyAttenuation>::with", "passes the attenuation to code of the caller"),
    ("luminaire::falloff::with_falloff", "passes the falloff to code of the caller"),
    ("luminaire::falloff::falloffs", "passes each falloff to code of the caller"),
    ("luminaire::falloff::constant_falloffs", "passes each falloff to code of the caller"),
    ("luminaire::attenuation::attenuations", "passes each attenuation to code of the caller"),
    ("luminaire::specular::lobes", "passes each lobe to code of the caller"),
];

/// The types in the programs' library that depend on the format. A call that names one of them is made in
/// each format.
const OF_FORMAT: [&str; 10] = [
    "Format",
    "QuickFormat",
    "Irradiance",
    "Gain",
    "Offset",
    "Ray",
    "FineRay",
    "FineShare",
    "Fraction",
    "FineFraction",
];

/// All public functions of the core: those called in each format, those called once, and the number
/// of exempt ones.
#[derive(Debug)]
pub(crate) struct Proof {
    configuration: &'static Configuration,
    each_format: Vec<Function>,
    common: Vec<Function>,
    exempt: usize,
}

impl Proof {
    /// Lists the functions with rustdoc, and writes what the programs include.
    pub(crate) fn write(configuration: &'static Configuration, progress: &Progress) -> Result<Self> {
        let folder = project::target().join("public");
        let mut rustdoc = command::cargo("rustdoc");
        rustdoc.args([
            "--package",
            "luminaire",
            "--no-default-features",
            "--features",
            configuration.features,
        ]);
        rustdoc.arg("--target-dir").arg(&folder);
        // Only a nightly compiler writes the list, or a stable one with `RUSTC_BOOTSTRAP`.
        rustdoc.args(["--", "-Zunstable-options", "--output-format=json"]).env("RUSTC_BOOTSTRAP", "1");
        progress.run(rustdoc)?;
        let json = fs::read(folder.join("doc/luminaire.json")).context("rustdoc has written no list")?;
        let proof = Self::of(configuration, public::functions(&serde_json::from_slice(&json)?)?)?;
        let folder = project::root().join("benches/firmware/target/calls").join(configuration.name);
        for (program, functions) in [(NO_PANIC, &proof.each_format), (COMMON, &proof.common)] {
            effects::write_source(&folder, &format!("{program}.rs"), &wrappers(functions))?;
        }
        Ok(proof)
    }

    /// Links programs. A program that can panic does not link, unless among the `arguments` of cargo is
    /// the feature `culprits`.
    pub(crate) fn link(
        &self,
        board: &Board,
        format: Format,
        programs: &[&str],
        arguments: &[&str],
        progress: &Progress,
    ) -> Result<Vec<PathBuf>> {
        let mut all =
            vec!["--profile", PROFILE, "--package", "luminaire-proof", "--features", self.configuration.name];
        all.extend(programs.iter().flat_map(|name| ["--bin", name]));
        let toolchain = laboratory::build(board, &[&all, format.features(), arguments].concat(), progress)?;
        Ok(programs.iter().map(|name| toolchain.artifacts(PROFILE).join(name)).collect())
    }

    fn of(configuration: &'static Configuration, functions: Vec<Function>) -> Result<Self> {
        let is =
            |function: &Function, name| function.of_trait.as_deref() == Some(name) || function.name == name;
        for (name, _) in EXEMPT {
            ensure!(
                configuration.name != MAIN.name || functions.iter().any(|function| is(function, name)),
                "no function is {name}: remove it from EXEMPT"
            );
        }
        let all = functions.len();
        let called =
            functions.into_iter().filter(|function| !EXEMPT.iter().any(|(name, _)| is(function, name)));
        let called: Vec<_> = called.collect();
        let failures = called.iter().filter_map(|function| {
            let reason = function.calls.as_ref().err()?;
            Some(format!("{}: {reason}", function.name))
        });
        let failures: Vec<_> = failures.collect();
        ensure!(
            failures.is_empty(),
            "no call is known of these functions; add a row to a table in benches/measure/src/size/public.rs:\n{}",
            failures.join("\n")
        );
        let exempt = all - called.len();
        let (each_format, common) = called.into_iter().partition(depends_on_format);
        Ok(Self { configuration, each_format, common, exempt })
    }

    /// The names of the functions that can panic, read from programs that are linked although they
    /// can panic.
    pub(crate) fn culprits(
        &self,
        board: &Board,
        format: Format,
        programs: &[&str],
        progress: &Progress,
    ) -> Result<Vec<&str>> {
        let files = self.link(board, format, programs, &["--features", "culprits"], progress)?;
        let mut culprits = Vec::new();
        for (program, file) in programs.iter().zip(files) {
            let callers = Program::callers(&file, "a_panic_is_reachable")?;
            let functions = if *program == COMMON { &self.common } else { &self.each_format };
            let named = functions.iter().map(|function| function.name.as_str());
            culprits.extend(named.filter(|name| callers.contains(&format!("{program}::{}", symbol(name)))));
        }
        Ok(culprits)
    }
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (each, common) = (self.each_format.len(), self.common.len());
        let all = each + common + self.exempt;
        write!(
            f,
            "{}: {all} functions, {each} wrappers per format and {common} for all, {} exempt",
            self.configuration.name, self.exempt
        )
    }
}

/// The programs that are linked in a format.
pub(crate) fn programs(format: Format) -> &'static [&'static str] {
    if format == Format::Fx16 { &[NO_PANIC, COMMON] } else { &[NO_PANIC] }
}

fn depends_on_format(function: &Function) -> bool {
    let calls = function.calls.iter().flatten();
    let mut words = calls.flat_map(|call| call.split(|c: char| !c.is_alphanumeric()));
    words.any(|word| OF_FORMAT.contains(&word))
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

    /// One function for each exemption, followed by `more`.
    fn functions(more: &[Function]) -> Vec<Function> {
        let exempt = EXEMPT.iter().map(|(name, _)| function("<T as Trait>::f", Some(name), Err("unknown")));
        exempt.chain(more.iter().cloned()).collect()
    }

    #[test]
    fn functions_are_exempt_common_or_called_in_each_format() {
        let common = function("luminaire::Angle::versine", None, Ok("sink(source::<luminaire::Angle>())"));
        let each = function("<luminaire::Rgb<Format>>::new", None, Ok("sink(source::<FineRay>())"));
        let proof = Proof::of(&MAIN, functions(&[common, each])).unwrap();
        assert_eq!(
            proof.to_string(),
            "arithmetic: 12 functions, 1 wrappers per format and 1 for all, 10 exempt"
        );
        let text = wrappers(&proof.each_format);
        assert!(text.contains("fn Rgb_Format_new() {"), "{text}");
        assert!(text.contains("        sink(source::<FineRay>());\n"), "{text}");
        assert!(text.contains("[fn(); 1] = [\n        Rgb_Format_new,\n"), "{text}");
    }

    #[test]
    fn a_function_without_a_call_is_refused_by_name() {
        let refused =
            Proof::of(&MAIN, functions(&[function("luminaire::f", None, Err("no row"))])).unwrap_err();
        assert!(refused.to_string().contains("luminaire::f: no row"), "{refused}");
    }

    #[test]
    fn an_exemption_of_no_function_is_refused() {
        let refused = Proof::of(&MAIN, functions(&[])[1..].to_vec()).unwrap_err().to_string();
        assert!(refused.contains(EXEMPT[0].0) && refused.contains("remove it"), "{refused}");
    }

    #[test]
    fn every_short_name_of_the_format_is_known() {
        let file = project::root().join("benches/firmware/proof/src/lib.rs");
        let text = fs::read_to_string(file).unwrap();
        let types = text.lines().filter_map(|line| line.trim().strip_prefix("pub type ")?.split_once(' '));
        let mut names: Vec<_> = types.map(|(name, _)| name).chain(["Format"]).collect();
        let mut known = OF_FORMAT.to_vec();
        names.sort_unstable();
        known.sort_unstable();
        assert_eq!(names, known);
    }
}
