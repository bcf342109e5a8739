//! The part of the README with prices: a short table and a picture.

use super::figures;
use super::list::PriceList;
use super::target::Target;

/// The lines of the README between which the part stands.
pub(super) const LINES: [&str; 2] =
    ["<!-- prices: written by `cargo xtask measure` -->\n", "<!-- end of prices -->\n"];

/// The rows, and their titles in the README.
const ROWS: [(&str, &str); 4] = [
    ("soft.fx16", "soft edge, `Fx16`"),
    ("powf-libm.rival", "power of the cosine, libm's `powf`"),
    ("lit-inverse-square.fx16", "lit point, `Fx16`"),
    ("lit-inverse-square.f32", "lit point, `f32`"),
];
/// The targets of the columns after the errors. A target without measurements has no column.
const TARGETS: [&str; 4] = ["cortex-m0", "cortex-m4f", "rv32imc", "host"];
/// The half angle of the second column of errors.
const NARROW: f64 = 1.0;
/// The target of the picture.
const PICTURE: &str = "cortex-m0";

/// The part of the README.
pub(super) fn write(list: &PriceList) -> String {
    let measured: Vec<_> = list.targets().collect();
    let named = |name: &&str| measured.iter().find(|target| target.name() == *name);
    let targets: Vec<_> = TARGETS.iter().filter_map(named).collect();
    let heads = targets.iter().map(|target| format!(" {} |", head(target)));
    let mut text = format!(
        "\n| | error at {:.0}° | at {NARROW}° |{}\n|---|---|---|{}\n",
        list.meta.half_angle,
        heads.collect::<String>(),
        "---|".repeat(targets.len())
    );
    for (name, title) in ROWS {
        let Some(row) = list.row(name) else { continue };
        let wide = row.error.as_ref().map_or_else(String::new, |error| figures::error(error.codes));
        let cone = row.narrower.iter().find(|cone| cone.half_angle == NARROW);
        let narrow = cone.map_or_else(String::new, |cone| match (&cone.error, cone.narrowest) {
            (Some(error), _) => figures::error(error.codes),
            (None, _) => "refused".to_owned(),
        });
        text += &format!("| {title} | {wide} | {narrow} |");
        for target in &targets {
            let cost = row.cost.get(target.name()).map(|cost| figures::cost(cost.amount()));
            text += &format!(" {} |", cost.unwrap_or_default());
        }
        text += "\n";
    }
    if let Some(&target) = targets.iter().find(|target| target.name() == PICTURE) {
        let title = target.title();
        text += &format!(
            "\n![Error against instructions on a {title}, both logarithmic](docs/{})\n",
            target.picture()
        );
    }
    text + "\n"
}

fn head(target: &Target) -> String {
    match target {
        Target::Host => "host, ns".to_owned(),
        Target::Browser { simd: false } => "browser, ns".to_owned(),
        Target::Browser { simd: true } => "with simd, ns".to_owned(),
        Target::Board(board) => format!("{}, instr.", board.title),
    }
}
