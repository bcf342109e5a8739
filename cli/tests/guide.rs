//! The commands of the guide print what the guide shows.

use std::fs;
use std::path::Path;
use std::process::Command;

/// What a command line in the guide begins with.
const PROGRAM: &str = "cargo run -q --bin luminaire -- ";

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
