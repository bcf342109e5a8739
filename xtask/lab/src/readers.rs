//! Compares the angles of photometric files and fixtures with those of other readers, and reads a million
//! hostile files by each reader.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde_json::Value;
use tools::command::{answer, cargo};
use tools::progress::Progress;
use tools::suite::Suite;
use tools::{install, project, tally, tool};

/// The other readers, from PyPI.
const PACKAGES: [&str; 3] = ["photompy==0.3.1", "eulumdat-py==1.0.0", "pygdtf==1.4.5"];
/// The largest difference of an angle in degrees.
const ANGLE: f64 = 0.1;

/// Adds the steps.
pub(crate) fn run(suite: &mut Suite) {
    suite.remarked("lights: other readers find the same angles", angles);
    suite.count("lights: a million hostile files for each reader", |progress| {
        let mut test = cargo(["test", "--release", "--package", "luminaire-exchange", "--test", "hostile"]);
        test.env("LUMINAIRE_HOSTILE", "1000000");
        tally::cargo_test(test, progress)
    });
}

fn angles(progress: &Progress) -> Result<Vec<String>> {
    let python = install::program(&tool::PYTHON, progress)?;
    let folder = project::target().join("readers");
    let own = folder.join(if cfg!(windows) { "venv/Scripts/python.exe" } else { "venv/bin/python" });
    // Written last, so that an interrupted installation is done again.
    let (installed, packages) = (folder.join("venv/packages.txt"), PACKAGES.join("\n"));
    if fs::read_to_string(&installed).ok().as_ref() != Some(&packages) {
        let mut make = command(&python, ["-m", "venv"]);
        make.arg(folder.join("venv"));
        progress.run(make)?;
        let mut install = command(&own, ["-m", "pip", "install", "--quiet"]);
        install.args(PACKAGES);
        progress.run(install)?;
        fs::write(installed, packages)?;
    }
    let tests = project::root().join("exchange/tests");
    // What is written is read by another reader; one file of each kind is read by both.
    let written = [
        ("fresnel", ["--beam", "15", "--field", "26", "--lumens", "8700"].as_slice()),
        ("godot", &["--from", "godot", "spot_angle=30", "spot_angle_attenuation=2"]),
        ("file", &["--from", "exchange/tests/files/spot.ies"]),
    ];
    let mut files = vec![tests.join("files/spot.ldt")];
    for (name, source) in written {
        let file = folder.join(name).with_extension("ies");
        fs::write(&file, luminaire(&[&["export", "--to", "ies"], source].concat())?)?;
        files.push(file);
    }
    let script = |name: &str| tests.join("readers").join(name);
    let mut remarks = Vec::new();
    let told = answer(command(&own, [script("photometry.py")]).args(&files))?;
    for (file, line) in files.iter().zip(told.lines()) {
        let other: Vec<f64> = line.split_whitespace().skip(1).map(str::parse).collect::<Result<_, _>>()?;
        remarks.push(compared(file, &other)?);
    }
    ensure!(remarks.len() == files.len(), "{told}: expected a line for each of {} files", files.len());
    let gdtf = tests.join("files/fixture.gdtf");
    let told = answer(command(&own, [script("gdtf.py")]).arg(&gdtf))?;
    // The first beam's zoom replaces its beam angle: its lumens are compared.
    let lumens = told.lines().next().and_then(|line| line.split('\t').nth(3)).context("a beam")?;
    let own = luminaire(&["import", &gdtf.to_string_lossy()])?;
    ensure!(
        own.replace(',', "").contains(&format!("flux {:.0} lm", lumens.parse::<f64>()?)),
        "{own}: expected {lumens} lm"
    );
    Ok(remarks)
}

fn command<const N: usize>(program: &Path, arguments: [impl AsRef<std::ffi::OsStr>; N]) -> Command {
    let mut command = Command::new(program);
    command.args(arguments);
    command
}

fn luminaire(arguments: &[&str]) -> Result<String> {
    let mut run = cargo(["run", "--quiet", "--bin", "luminaire", "--"]);
    answer(run.args(arguments).current_dir(project::root()))
}

/// Compares beam and field angle of the first light of a file.
fn compared(file: &Path, other: &[f64]) -> Result<String> {
    let document: Value = serde_json::from_str(&luminaire(&["import", "--json", &file.to_string_lossy()])?)?;
    let own = document["lights"][0]["about"]["photometry"]["ies_degrees"].as_array().context("angles")?;
    let mut worst = 0.0_f64;
    for (own, other) in own.iter().zip(other) {
        worst = worst.max((own.as_f64().context("an angle")? - other).abs());
    }
    let name = file.file_name().unwrap_or_default().display();
    ensure!(worst <= ANGLE, "{name}: {own:?} differs from {other:?} by {worst} degrees");
    Ok(format!("{name}: angles within {worst:.4} degrees"))
}
