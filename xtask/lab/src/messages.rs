//! What the compiler tells of mistakes that people make with the kernel, where its words are ours.

use std::fs;

use anyhow::{Result, ensure};

use tools::progress::Progress;
use tools::suite::Suite;
use tools::{command, project};

/// Mistakes: the body of a function, and the words that lead to the mend.
const MISTAKES: [(&str, &str); 6] = [
    ("let _ = Cone::soft(15.0)?;", "expected an angle: `Angle::degrees(..)`, the full angle of a data sheet"),
    ("let _ = Cone::from_beam_and_field(7.0, 15.0)?;", "which is `HalfAngle::degrees(7.5)`"),
    ("let _ = Rgb565::from_linear(Rgb::<Light16>::default());", "`display::clip` makes a colour of it"),
    (
        "shade(&[PointLight::new([0.0; 3])?]);",
        "a described light is compiled for a number format: `light.compile::<Fx16>()`",
    ),
    (
        "let _ = SpotLight::new([0.0; 3], [0.0, 1.0, 0.0], Cone::soft(Angle::degrees(9.0))?)?.compile_quick::<f32>();",
        "`f32` has no quick evaluation",
    ),
    (
        "PointLight::new([0.0; 3])?.compile::<Fx16>()?.moved_to(Fx16::point([1.0; 3]));",
        "moved_to` that must be used",
    ),
];

/// Adds the step.
pub(crate) fn run(suite: &mut Suite) {
    suite.step("messages: mistakes with the kernel are told in its own words", |progress| {
        check("", "", progress)?;
        MISTAKES.iter().try_for_each(|(mistake, told)| check(mistake, told, progress))
    });
}

/// Compiles a project with a mistake; fails unless the compiler says these words. Without a mistake it must
/// compile.
fn check(mistake: &str, told: &str, progress: &Progress) -> Result<()> {
    let folder = project::target().join("messages");
    let kernel = project::root().join("core");
    let manifest = format!(
        "[package]\nname = 'mistake'\nedition = '2024'\n\n[dependencies]\nluminaire = {{ path = {kernel:?} }}\n\n[workspace]\n"
    );
    let program = format!(
        "#![deny(unused_must_use)]\n#![allow(unused_imports)]\n\
         use luminaire::{{*, display::*, light::*, number::*}};\n\
         pub fn shade<L: LightModel<Fx16>>(_: &[L]) {{}}\n\
         pub fn mistake() -> Result<(), Error> {{\n    {mistake}\n    Ok(())\n}}\n"
    );
    fs::create_dir_all(folder.join("src"))?;
    for (file, text) in [("Cargo.toml", manifest), ("src/lib.rs", program)] {
        fs::write(folder.join(file), text)?;
    }
    progress.say("Compiling", mistake);
    let mut check = command::cargo(["check"]);
    check.current_dir(&folder).env("CARGO_TARGET_DIR", folder.join("target"));
    let ended = command::capture(check, |_| {})?;
    ensure!(ended.success == mistake.is_empty(), "`{mistake}`:\n{}", ended.output);
    ensure!(ended.output.contains(told), "`{mistake}`: expected `{told}`, found\n{}", ended.output);
    Ok(())
}
