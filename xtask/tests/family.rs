//! What the commands start ends with them.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::PermissionsExt as _;
use std::path::Path;
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

/// A cargo whose compiler runs for an hour. It writes the compiler's number into a file.
const CARGO: &str = "#!/bin/sh\nsleep 3600 &\necho $! > \"$0.compiler\"\nwait\n";

/// Waits until something is the case, for ten seconds.
fn wait_until(what: &str, mut is_so: impl FnMut() -> bool) {
    let end = Instant::now() + Duration::from_secs(10);
    while !is_so() {
        assert!(Instant::now() < end, "expected within ten seconds: {what}");
        thread::sleep(Duration::from_millis(20));
    }
}

#[test]
fn signal_ends_a_command_and_the_compilers_of_its_cargo() {
    for signal in ["TERM", "INT", "HUP"] {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(signal);
        // A number of an earlier run would name a program that is not ours.
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        let [cargo, number] = ["cargo", "cargo.compiler"].map(|name| folder.join(name));
        fs::write(&cargo, CARGO).unwrap();
        fs::set_permissions(&cargo, fs::Permissions::from_mode(0o755)).unwrap();
        let mut xtask = Command::new(env!("CARGO_BIN_EXE_xtask"));
        let mut xtask = xtask.arg("test").env("CARGO", &cargo).spawn().unwrap();
        let compiler = || fs::read_to_string(&number).unwrap_or_default().trim().to_owned();
        wait_until("a compiler", || !compiler().is_empty());
        let killed =
            Command::new("sh").arg("-c").arg(format!("kill -{signal} {}", xtask.id())).status().unwrap();
        assert!(killed.success());
        assert!(!xtask.wait().unwrap().success(), "{signal}");
        // One that has ended may stay listed until its parent, an init, takes notice.
        let runs = |number: &str| {
            let state = fs::read_to_string(Path::new("/proc").join(number).join("stat")).unwrap_or_default();
            !state.is_empty() && !state.contains(") Z ")
        };
        wait_until("the end of the compiler", || !runs(&compiler()));
    }
}
