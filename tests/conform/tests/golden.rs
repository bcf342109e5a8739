//! The file of the conformance vectors: this machine computes its outputs, and it has every case of
//! every model.

use std::process::Command;

use luminaire_conform::Check;

const FILE: &str = include_str!("../vectors.txt");

/// Checks a file. Returns the report and the check with its counts.
fn check(file: &str) -> (String, Check) {
    let (mut check, mut report) = (Check::default(), String::new());
    for line in file.lines() {
        check.take(line, &mut report).expect("writing to a string does not fail");
    }
    (report, check)
}

#[test]
fn this_machine_computes_the_same_bits() {
    let (report, check) = check(FILE);
    assert!(check.is_passed(), "{report}{check}");
}

/// `cargo xtask conform --bless` would write the same inputs. The outputs are tested by
/// `this_machine_computes_the_same_bits`.
#[test]
fn the_file_holds_the_cases_that_are_generated() {
    let generated = Command::new(env!("CARGO_BIN_EXE_conform")).arg("generate").output().expect("it runs");
    let generated = String::from_utf8(generated.stdout).expect("text");
    let inputs = |file: &str| -> Vec<_> {
        file.lines().map(|line| line.split(" -> ").next().unwrap_or_default().to_owned()).collect()
    };
    assert_eq!(inputs(FILE), inputs(&generated));
}

/// Three faults are counted and reported: a case with other outputs, a case with too few or too
/// many words, and a case of an unknown model.
#[test]
fn what_differs_is_told() {
    let section = "[clip fx16] light:u18f14\n";
    let (report, passed) = check(&format!("{section}00004000 00008000 00000001 -> 4000 4000 0001\n"));
    assert!(passed.is_passed() && report.is_empty(), "{report}");
    for (case, found) in [
        ("00004000 00008000 00000001 -> 4000 4000 0002", "4000 4000 0001"),
        ("00004000 00008000 -> 4000 4000", "not understood"),
        ("00004000 00008000 00000001 00000002 -> 4000 4000 0001", "not understood"),
        ("00004000 00008000 1 -> 4000 4000 0001", "not understood"),
        ("00004000 00008000 00000001", "not understood"),
    ] {
        let (report, failed) = check(&format!("{section}{case} # a remark\n"));
        assert_eq!(report, format!("line 2: {case}, found {found}\n"));
        assert_eq!((failed.to_string().as_str(), failed.is_passed()), ("1 cases, 1 differ", false));
    }
    let (report, failed) = check("[clip fx8] light\n00 -> 00\n");
    assert!(report.ends_with("found not understood\n") && !failed.is_passed(), "{report}");
    assert!(!check("").1.is_passed(), "a file without cases proves nothing");
}
