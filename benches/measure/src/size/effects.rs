//! The programs of one effect each, built for a target in a number format.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use super::program::Program;
use crate::boards::{Board, laboratory};
use crate::effects::catalogue::{self, Entry};
use tools::progress::Progress;
use tools::project;

/// The profile that the programs are compiled with: `opt-level = "s"` and link-time optimisation.
pub(crate) const PROFILE: &str = "size";

/// The program that does nothing. Its bytes are subtracted from those of every effect.
pub(crate) const EMPTY: &str = "empty";
/// The program with effects that its constants switch off.
pub(crate) const UNUSED: &str = "unused";

/// A number format, which a feature of the programs selects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Format {
    Fx16,
    Fx32,
    F32,
}

impl Format {
    pub(crate) const ALL: [Self; 3] = [Self::Fx16, Self::Fx32, Self::F32];

    /// The name that the library gives it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Fx16 => "fx16",
            Self::Fx32 => "fx32",
            Self::F32 => "f32",
        }
    }

    /// Arguments of cargo that select it.
    pub(crate) fn features(self) -> &'static [&'static str] {
        match self {
            Self::Fx16 => &[],
            Self::Fx32 => &["--features", "fx32"],
            Self::F32 => &["--features", "f32"],
        }
    }
}

/// The programs that were built, by name. Another format for the same target replaces them.
#[derive(Debug)]
pub(crate) struct Effects {
    folder: PathBuf,
}

impl Effects {
    /// Builds all programs. A program that can panic does not link.
    pub(crate) fn build(board: &Board, format: Format, progress: &Progress) -> Result<Self> {
        Self::build_some(&["--bins"], board, format, progress)
    }

    /// Builds the programs that arguments of cargo select.
    pub(crate) fn build_some(
        programs: &[&str],
        board: &Board,
        format: Format,
        progress: &Progress,
    ) -> Result<Self> {
        write_programs()?;
        let package = ["--profile", PROFILE, "--package", "luminaire-effects"];
        let arguments = [&package, programs, format.features()];
        let toolchain = laboratory::build(board, &arguments.concat(), progress)?;
        Ok(Self { folder: toolchain.artifacts(PROFILE) })
    }

    /// A program.
    pub(crate) fn program(&self, name: &str) -> Result<Program> {
        Program::read(&self.folder.join(name))
    }

    /// The effects in the order of their names, each with the bytes of its program minus those of
    /// the empty program.
    pub(crate) fn bytes(&self) -> Result<Vec<(String, u64)>> {
        let empty = self.program(EMPTY)?.bytes;
        let mut effects = Vec::new();
        for program in programs().into_keys().filter(|program| *program != EMPTY) {
            let bytes = self.program(&file_name(program))?.bytes.saturating_sub(empty);
            effects.push((program.to_owned(), bytes));
        }
        Ok(effects)
    }
}

/// The programs by name, each with the function of the one effect that it runs.
fn programs() -> BTreeMap<&'static str, String> {
    let function = |entry: &Entry| match entry.listed {
        Some(model) => {
            // Spaced as rustfmt does it: `stringify!` writes a type as `Power < 4 >`.
            let model = model.replace(' ', "").replace(',', ", ");
            format!("<{model} as luminaire_effects::Listed>::effect")
        }
        None => format!("luminaire_effects::effects::{}", file_name(entry.program)),
    };
    let nothing = (EMPTY, "|(): ()| ()".to_owned());
    catalogue::entries().map(|entry| (entry.program, function(entry))).chain([nothing]).collect()
}

fn file_name(program: &str) -> String {
    program.replace('-', "_")
}

/// The folder of the generated source files.
fn folder() -> PathBuf {
    project::root().join("benches/firmware/effects/src/bin")
}

/// Writes a source file if its content changes: cargo would recompile a file that is written again.
pub(crate) fn write_source(folder: &Path, name: &str, source: &str) -> Result<()> {
    let file = folder.join(name);
    let failed = || format!("cannot write {}", file.display());
    fs::create_dir_all(folder).with_context(failed)?;
    if fs::read_to_string(&file).ok().as_deref() != Some(source) {
        fs::write(&file, source).with_context(failed)?;
    }
    Ok(())
}

/// Writes the source files of the programs, and removes the files of programs that no longer exist.
pub(crate) fn write_programs() -> Result<()> {
    let programs = programs();
    for (program, function) in &programs {
        let source = format!(
            "//! The effect `{program}` alone. Written by `cargo xtask`.\n\
             #![cfg_attr(target_os = \"none\", no_std, no_main)]\n\n\
             #[allow(unused_imports, clippy::wildcard_imports, reason = \"the types of the lists\")]\n\
             use luminaire::{{attenuation::*, falloff::*, specular::*}};\n\n\
             luminaire_effects::program!({function});\n"
        );
        write_source(&folder(), &format!("{}.rs", file_name(program)), &source)?;
    }
    let failed = || format!("cannot clear {}", folder().display());
    for entry in fs::read_dir(folder()).with_context(failed)? {
        let path = entry.with_context(failed)?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().replace('_', "-");
        if path.extension().is_some_and(|it| it == "rs") && !programs.contains_key(name.as_str()) {
            fs::remove_file(path).with_context(failed)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_effect_has_one_program_and_each_program_one_function() {
        let programs = programs();
        assert!(programs["spot-hard-lambert"].starts_with("<Hard as "), "{programs:?}");
        assert!(programs["difference-form"].starts_with("<DifferenceForm<Phong, 3> as "), "{programs:?}");
        assert!(programs["rgb565-dithered"].ends_with("::rgb565_dithered"), "{programs:?}");
        let functions: std::collections::BTreeSet<_> = programs.values().collect();
        assert_eq!(functions.len(), programs.len());
    }
}
