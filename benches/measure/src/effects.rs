//! What kernels and effects cost on boards: instructions, cycles and bytes.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use luminaire_effects::{Entry, Input, Inputs, Output, Visit, each};

use crate::counted::{self, Cost, FIRMWARE, Firmware, SIZE, thousandths};
use crate::documents::kernels;
use crate::program::Program;
use crate::record::Group;
use crate::target::Board;
use tools::demo::chips;
use tools::progress::Progress;
use tools::project;

/// The program that runs every effect.
const EFFECTS: &str = "effects";
/// The program that does nothing. Its bytes are subtracted from those of every effect.
pub(crate) const EMPTY: &str = "empty";
/// The program with effects that its constants switch off.
pub(crate) const UNUSED: &str = "unused";

/// A number format, which a feature of the programs selects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Format {
    /// The name that the library gives it.
    pub(crate) name: &'static str,
    /// Arguments of cargo that select it in the programs of one effect each.
    pub(crate) features: &'static [&'static str],
    /// Arguments of cargo that select it in the programs that run all effects.
    pub(crate) effects: [&'static str; 2],
}

pub(crate) const FX16: Format = Format { name: "fx16", features: &[], effects: ["--features", "effects"] };
const FX32: Format =
    Format { name: "fx32", features: &["--features", "fx32"], effects: ["--features", "effects-fx32"] };
pub(crate) const F32: Format =
    Format { name: "f32", features: &["--features", "f32"], effects: ["--features", "effects-f32"] };

pub(crate) const FORMATS: [Format; 3] = [FX16, FX32, F32];

/// The processors whose bytes are counted, and of which every effect is on record: the smallest, and one
/// with a floating point unit, each with the format that suits it.
pub(crate) const SUITED: [(&str, Format); 2] = [("cortex-m0", FX16), ("cortex-m4f", F32)];

/// The processors on which the lit points of others are counted, one of each kind.
pub(crate) const COMPARED: [&str; 4] = ["cortex-m0", "cortex-m4f", "cortex-m33", "rv32imc"];

/// A group of the catalogue.
#[derive(Debug)]
pub(crate) struct Chapter {
    pub(crate) title: &'static str,
    pub(crate) note: &'static str,
    pub(crate) entries: Vec<Entry>,
}

/// The catalogue of effects, in the order of the page.
pub(crate) fn catalogue() -> Vec<Chapter> {
    struct Reader(Vec<Chapter>);
    impl Visit for Reader {
        fn group(&mut self, title: &'static str, note: &'static str) {
            self.0.push(Chapter { title, note, entries: Vec::new() });
        }

        fn effect<I: Input, O: Output>(&mut self, entry: Entry, _: fn(&mut Inputs) -> I, _: impl Fn(I) -> O) {
            self.again(entry);
        }

        fn again(&mut self, entry: Entry) {
            self.0.last_mut().expect("a group begins first").entries.push(entry);
        }
    }
    let mut reader = Reader(Vec::new());
    each(&mut reader);
    reader.0
}

/// The name of a program's figures: `lit-hard-quick` in `fx16` is `lit-hard.fx16-quick`.
pub(crate) fn figure(program: &str, format: &str) -> String {
    let name = program.replace('_', "-");
    for evaluation in ["-quick", "-fine", "-coarse"] {
        if let Some(kernel) = name.strip_suffix(evaluation) {
            return format!("{kernel}.{format}{evaluation}");
        }
    }
    format!("{name}.{format}")
}

/// Whether an entry of the catalogue has a price in a format. The quick evaluation is of `Fx16` alone.
pub(crate) fn has_price(entry: &Entry, format: Format) -> bool {
    format == FX16 || entry.name != "lit_quick"
}

/// Whether a kernel is on record of a processor in every format: a lit point by an evaluation, or an early-out; and
/// what else pictures take on the smallest processor.
fn is_priced(name: &str, board: &Board) -> bool {
    let kernel = name.split('.').next().unwrap_or_default();
    ["away", "lit-specular"].contains(&kernel)
        || kernels().any(|own| own == kernel)
        || (board.name == SUITED[0].0 && chips::kernels().any(|own| own == kernel))
}

/// The costs of every kernel on a board.
pub(crate) fn costs(board: &'static Board, progress: &Progress) -> Result<Vec<Cost>> {
    let (mut costs, _) = Firmware::new("cost", &[]).costs(board, progress)?;
    costs.extend(rivals(board, progress)?);
    for format in FORMATS {
        costs.extend(of_format(format, board, progress)?);
    }
    Ok(costs)
}

/// The costs of the effects, and of lit points by other evaluations, in a format on a board.
fn of_format(format: Format, board: &'static Board, progress: &Progress) -> Result<Vec<Cost>> {
    let (mut costs, _) = Firmware::new(EFFECTS, &format.effects).costs(board, progress)?;
    for program in ["evaluations", "choices"] {
        costs.extend(Firmware::new(program, &format.effects).costs(board, progress)?.0);
    }
    for cost in &mut costs {
        let (program, format) = cost.name.split_once('.').context("a name has no format")?;
        cost.name = figure(program, format);
    }
    // These formats have one evaluation.
    costs.retain(|cost| !cost.name.ends_with("32-quick"));
    Ok(costs)
}

/// The figures of a board: the kernels, the lit points in each format, and every effect in the format that
/// suits the board, with its bytes of flash.
pub(crate) fn counted(board: &'static Board, progress: &Progress) -> Result<Group> {
    let (kernels, run) = Firmware::new("cost", &[]).costs(board, progress)?;
    let mut group = run.group();
    kernels.iter().chain(&rivals(board, progress)?).for_each(|cost| add(&mut group, cost));
    for format in FORMATS {
        let is_suited = SUITED.contains(&(board.name, format));
        let costs = of_format(format, board, progress)?;
        costs
            .iter()
            .filter(|cost| is_suited || is_priced(&cost.name, board))
            .for_each(|cost| add(&mut group, cost));
        if is_suited {
            for_size(format, board, &mut group, progress)?;
        }
    }
    Ok(group)
}

/// The costs of the lit points of others, where they are counted.
fn rivals(board: &'static Board, progress: &Progress) -> Result<Vec<Cost>> {
    if COMPARED.contains(&board.name) {
        Ok(Firmware::new("rivals", &[]).costs(board, progress)?.0)
    } else {
        Ok(Vec::new())
    }
}

fn add(group: &mut Group, cost: &Cost) {
    group.add(&cost.name, "instructions", thousandths(cost.instructions));
    if let Some(cycles) = cost.cycles {
        group.add(&cost.name, "cycles", thousandths(cycles));
    }
    group.add(&cost.name, "bytes", cost.bytes);
}

/// Adds what is counted of programs that are compiled for size. Every program of the catalogue must have
/// been counted for speed, too.
fn for_size(format: Format, board: &'static Board, group: &mut Group, progress: &Progress) -> Result<()> {
    let (costs, _) =
        Firmware { profile: SIZE, ..Firmware::new(EFFECTS, &format.effects) }.costs(board, progress)?;
    let folder = build(&["--bins"], board, format, progress)?;
    let empty = Program::read(&folder.join(EMPTY))?.bytes();
    let chapters = catalogue();
    let entries = chapters.iter().flat_map(|chapter| &chapter.entries);
    for entry in entries.filter(|entry| has_price(entry, format)) {
        let name = figure(entry.name, format.name);
        let is_it = |cost: &&Cost| cost.name == format!("{}.{}", entry.name, format.name);
        let cost = costs.iter().find(is_it).with_context(|| format!("{name} was not counted for size"))?;
        ensure!(group.figures.contains_key(&name), "{name} was not counted for speed");
        group.add(&name, "instructions_for_size", thousandths(cost.instructions));
        let bytes = Program::read(&folder.join(file_name(entry.name)))?.bytes().saturating_sub(empty);
        group.add(&name, "flash", bytes);
    }
    Ok(())
}

/// Builds for size the programs of one effect each that arguments of cargo select. A program that can
/// panic does not link. Returns their folder, where another format for the same target replaces them.
pub(crate) fn build(
    programs: &[&str],
    board: &Board,
    format: Format,
    progress: &Progress,
) -> Result<PathBuf> {
    write_programs()?;
    let package = ["--profile", SIZE, "--package", "luminaire-effects"];
    let options = [&package, programs, format.features].concat();
    Ok(counted::build(board, &options, progress)?.artifacts(SIZE))
}

fn file_name(program: &str) -> String {
    program.replace('-', "_")
}

/// The programs by file name, each with the function of the one effect that it runs.
fn programs() -> BTreeMap<String, String> {
    let function = |entry: &Entry| match entry.listed {
        Some(model) => {
            // Spaced as rustfmt does it: `stringify!` writes a type as `Power < 4 >`.
            let model = model.replace(' ', "").replace(',', ", ");
            format!("<{model} as luminaire_effects::Listed>::effect")
        }
        None => format!("luminaire_effects::effects::{}", entry.name),
    };
    let entries = catalogue().into_iter().flat_map(|chapter| chapter.entries);
    let programs = entries.map(|entry| (file_name(entry.name), function(&entry)));
    programs.chain([(EMPTY.to_owned(), "|(): ()| ()".to_owned())]).collect()
}

/// Writes a source file if its content changes: cargo would recompile a file that is written again.
pub(crate) fn write_source(folder: &Path, name: &str, source: &str) -> Result<()> {
    fs::create_dir_all(folder)?;
    let file = folder.join(format!("{name}.rs"));
    if fs::read_to_string(&file).ok().as_deref() != Some(source) {
        fs::write(&file, source).with_context(|| format!("cannot write {}", file.display()))?;
    }
    Ok(())
}

/// Writes the source files of the programs, and removes the files of programs that no longer exist.
pub(crate) fn write_programs() -> Result<()> {
    let (programs, folder) = (programs(), project::root().join(FIRMWARE).join("effects/src/bin"));
    for (program, function) in &programs {
        let source = format!(
            "//! The effect `{program}` alone. Written by `cargo xtask`.\n\
             #![cfg_attr(target_os = \"none\", no_std, no_main)]\n\n\
             #[allow(unused_imports, clippy::wildcard_imports, reason = \"the types of the lists\")]\n\
             use luminaire::{{attenuation::*, falloff::*, specular::*}};\n\n\
             luminaire_effects::program!({function});\n"
        );
        write_source(&folder, program, &source)?;
    }
    for entry in fs::read_dir(&folder)? {
        let path = entry?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        if !programs.contains_key(&*name) {
            fs::remove_file(&path)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use luminaire::dynamic::Effects;

    use super::*;

    #[test]
    fn catalogue_has_every_effect_and_the_programs_that_it_compares_with() {
        let entries: Vec<_> = catalogue().into_iter().flat_map(|chapter| chapter.entries).collect();
        let priced = entries.iter().flat_map(|entry| entry.effects.iter()).fold(Effects::NONE, Effects::with);
        assert_eq!(priced, Effects::ALL);
        for entry in &entries {
            let known = |over: &&str| entries.iter().any(|entry| entry.name == *over);
            assert!(entry.over.iter().all(known) && entry.what.ends_with('.'), "{entry:?}");
        }
    }
}
