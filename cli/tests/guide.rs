//! The commands of the guide print what the guide shows, and its counted figures are the recorded
//! ones.

use std::fs;
use std::path::Path;
use std::process::Command;

/// What a command line in the guide begins with.
const PROGRAM: &str = "cargo run -q --bin luminaire -- ";

/// Instructions on a Cortex-M0 that a chapter repeats from `docs/effects.json`: those of a program,
/// or those by which it exceeds the soft spotlight. `{}` is the figure.
const COUNTED: [(&str, &str, bool, &str); 13] = [
    ("falloff.md", "spot-soft-lambert", false, "takes {} instructions with the soft edge"),
    ("falloff.md", "spot-smooth-lambert", true, "smoothstep takes {} more"),
    ("falloff.md", "spot-table-lambert", true, "a table {},"),
    ("falloff.md", "spot-cubic-lambert", true, "a cubic {}."),
    ("falloff.md", "spot-real-power-lambert", true, "real exponent takes {} more"),
    ("falloff.md", "spot-mixed-power-lambert", true, "which takes {} more"),
    ("microcontroller.md", "spot-soft-lambert-compiled", true, "{} instructions on a Cortex-M0 and"),
    ("microcontroller.md", "rgb565-ramp", false, "dithered pixel in {} instructions"),
    ("moving.md", "spot-soft-lambert-placed", true, "| `moved_to` | {} |"),
    ("moving.md", "spot-soft-lambert-aimed", true, "| `moved_to` and `aimed_at` | {} |"),
    ("moving.md", "spot-soft-lambert-zoomed", true, "| `zoomed` | {} |"),
    ("moving.md", "spot-soft-lambert-compiled", true, "| compile again | {} |"),
    ("scanline.md", "spot-soft-lambert-normalized", true, "for {} instructions on a Cortex-M0"),
];

/// The same of a lit point on a Cortex-M4F, from `docs/accuracy-vs-cost.json`: a chapter and a format.
const LIT: [(&str, &str, &str); 2] = [
    ("not_for.md", "f32", "a lit point takes {} instructions in `f32`"),
    ("not_for.md", "fx16", "and {} in `Fx16`"),
];

/// Falloffs on a Cortex-M0 that a chapter says to take five times the instructions of the soft one.
const FIVE_TIMES: [(&str, &str); 2] = [
    ("porting/direct3d.md", "spot-real-power-lambert"),
    ("porting/godot.md", "spot-inverted-real-power-lambert"),
];

/// The text of a file of the repository.
fn text(path: impl AsRef<Path>) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The chapters with their names.
fn chapters() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../core/guide");
    let files = fs::read_dir(folder).expect("the guide").map(|entry| entry.expect("a file").path());
    files
        .filter(|path| path.is_file())
        .map(|path| (path.display().to_string(), fs::read_to_string(&path).expect("a text")))
        .collect()
}

#[test]
fn guide_shows_what_its_commands_print() {
    let (mut commands, mut shown) = (0, 0);
    for (name, chapter) in chapters() {
        for (at, _) in chapter.match_indices(PROGRAM) {
            let (line, rest) = chapter[at..].split_once('\n').expect("a line in a block");
            let mut command = Command::new(env!("CARGO_BIN_EXE_luminaire"));
            let output = command.args(line[PROGRAM.len()..].split(' ')).output().expect("the program runs");
            let printed = String::from_utf8(output.stdout).expect("a text");
            assert!(output.status.success(), "{name}: {line}");
            commands += 1;
            let Some(block) = rest.strip_prefix("```\n\n```text\n") else { continue };
            let (block, _) = block.split_once("```").expect("the end of the block");
            let (head, code) = printed.split_once("\n\n").expect("a head and a constant");
            assert_eq!(block.trim_end(), head, "{name}: {line}");
            assert!(chapter.contains(code.trim_end()), "{name}: expected {code}");
            shown += 1;
        }
    }
    assert_eq!((commands, shown), (2, 1), "expected every command of the guide to be found");
}

/// A count as the guide writes it.
fn figure(count: f64) -> String {
    match count.round() as u32 {
        count @ 0..1_000 => count.to_string(),
        count => format!("{},{:03}", count / 1_000, count % 1_000),
    }
}

/// Panics unless a chapter has the words.
fn expect(chapter: &str, words: &str) {
    let text = text(Path::new("core/guide").join(chapter));
    let one_line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(one_line.contains(words), "{chapter}: expected `{words}`");
}

#[test]
fn guide_repeats_the_recorded_figures() {
    let record = |file| -> serde_json::Value { serde_json::from_str(&text(file)).expect("JSON") };
    let effects = record("docs/effects.json");
    let prices = &effects["boards"]["cortex-m0"]["prices"];
    let price = |program: &str, unit: &str| prices[program][unit].as_f64().expect(program);
    let instructions = |program: &str| price(program, "instructions");
    for (chapter, program, is_added, words) in COUNTED {
        let base = if is_added { instructions("spot-soft-lambert") } else { 0.0 };
        expect(chapter, &words.replace("{}", &figure(instructions(program) - base)));
    }
    let bytes = price("spot-soft-lambert-compiled", "bytes") - price("spot-soft-lambert", "bytes");
    let flash = format!("instructions on a Cortex-M0 and {} kB of flash", figure(bytes / 1_000.0));
    expect("microcontroller.md", &flash);
    for (chapter, program) in FIVE_TIMES {
        expect(chapter, "five times the instructions of a lit point on a Cortex-M0");
        let times = instructions(program) / instructions("spot-soft-lambert");
        assert!((4.5..5.5).contains(&times), "{chapter}: expected five times, found {times}");
    }
    let rows = record("docs/accuracy-vs-cost.json")["rows"].take();
    for (chapter, format, words) in LIT {
        let mut rows = rows.as_array().expect("rows").iter();
        let row = rows.find(|row| row["kernel"] == "lit-inverse-square" && row["format"] == format);
        let price = row.expect(format)["cost"]["cortex-m4f"]["instructions"].as_f64().expect("a figure");
        expect(chapter, &words.replace("{}", &figure(price)));
    }
}
