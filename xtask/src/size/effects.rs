//! The programs of one effect each, built for a target in a number format.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};

use super::program::Program;
use crate::firmware::{Board, board, laboratory};
use crate::progress::Progress;
use crate::project;

/// The profile that the programs are compiled with: `opt-level = "s"`, everything seen at once.
const PROFILE: &str = "size";

/// The program that does nothing, whose bytes are no effect's.
pub(crate) const EMPTY: &str = "empty";
/// The program that evaluates every light at a point, to show that nothing panics.
pub(crate) const EVERYTHING: &str = "everything";
/// The programs that call every function between them, to show that nothing panics. What they share is in the module `raw`.
pub(crate) const PROOFS: [&str; 5] = [EVERYTHING, "batches", "lamps", "seam", "setup"];
/// The program that would have more effects if its constants said so.
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

    fn features(self) -> &'static [&'static str] {
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
    /// Builds all programs. Those that can panic do not link.
    pub(crate) fn build(board: &Board, format: Format, progress: &Progress) -> Result<Self> {
        Self::cargo(board, format, &["--bins"], progress)
    }

    /// Builds some of the programs.
    pub(crate) fn build_some(
        board: &Board,
        format: Format,
        names: &[&str],
        progress: &Progress,
    ) -> Result<Self> {
        let programs: Vec<_> = names.iter().flat_map(|name| ["--bin", name]).collect();
        Self::cargo(board, format, &programs, progress)
    }

    /// Builds one program for all boards, so that each is there when it is asked for.
    pub(crate) fn build_one_for_all(format: Format, name: &str, progress: &Progress) -> Result<()> {
        laboratory::build_for_all(&board::ALL, &Self::arguments(format, &["--bin", name]), progress)
    }

    fn cargo(board: &Board, format: Format, programs: &[&str], progress: &Progress) -> Result<Self> {
        let toolchain = laboratory::build(board, &Self::arguments(format, programs), progress)?;
        Ok(Self { folder: toolchain.artifacts(PROFILE) })
    }

    /// What cargo is told to build.
    fn arguments<'a>(format: Format, programs: &[&'a str]) -> Vec<&'a str> {
        [&["--profile", PROFILE, "--package", "luminaire-effects"], programs, format.features()].concat()
    }

    /// A program.
    pub(crate) fn program(&self, name: &str) -> Result<Program> {
        Program::read(&self.folder.join(name))
    }

    /// The effects in the order of their names, each with the bytes that its program has over the empty one.
    pub(crate) fn bytes(&self) -> Result<Vec<(String, u64)>> {
        let empty = self.program(EMPTY)?.bytes;
        let mut effects = Vec::new();
        for name in names()? {
            let bytes = self.program(&name)?.bytes.saturating_sub(empty);
            effects.push((name.replace('_', "-"), bytes));
        }
        Ok(effects)
    }
}

/// The effects: each has a source file, and a program of its name.
fn names() -> Result<Vec<String>> {
    let folder = project::root().join("firmware/effects/src/bin");
    let failed = || format!("cannot list {}", folder.display());
    let mut names = Vec::new();
    for entry in fs::read_dir(&folder).with_context(failed)? {
        let name = entry.with_context(failed)?.path().with_extension("");
        names.extend(name.file_name().map(|name| name.to_string_lossy().into_owned()));
    }
    let is_no_effect = |name: &str| [EMPTY, UNUSED].contains(&name) || PROOFS.contains(&name);
    names.retain(|name| !is_no_effect(name));
    names.sort_unstable();
    Ok(names)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_effect_has_a_file() {
        let names = names().unwrap();
        assert!(names.iter().any(|name| name == "spot_soft_lambert"), "{names:?}");
        assert!(!names.iter().any(|name| name == EMPTY), "{names:?}");
    }

    #[test]
    fn the_programs_on_any_bits_are_the_proofs() {
        let folder = project::root().join("firmware/effects/src/bin");
        for name in names().unwrap().iter().map(String::as_str).chain(PROOFS) {
            let program = fs::read_to_string(folder.join(name).with_extension("rs")).unwrap();
            assert_eq!(program.contains("luminaire_effects::raw"), PROOFS.contains(&name), "{name}");
        }
    }
}
