//! Chooses the mutant: a module of the instrumented copy of the kernel, not of this crate.

extern crate std;

use std::fs::{File, OpenOptions};
use std::io::Write;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

static STATE: OnceLock<(u32, Option<File>)> = OnceLock::new();
static SEEN: [AtomicBool; COUNT] = [const { AtomicBool::new(false) }; COUNT];

/// Whether one of `count` mutants from `first` on is chosen. At compile time none is.
#[inline]
pub const fn any(first: u32, count: u32) -> bool {
    core::intrinsics::const_eval_select((first, count), none, reach)
}

const fn none(_: u32, _: u32) -> bool {
    false
}

fn state() -> &'static (u32, Option<File>) {
    STATE.get_or_init(|| {
        let chosen = std::env::var("LUMINAIRE_MUTANT").ok().and_then(|id| id.parse().ok());
        let seen = std::env::var_os("LUMINAIRE_MUTANTS_SEEN");
        let open = |path| OpenOptions::new().append(true).create(true).open(path).unwrap();
        (chosen.unwrap_or(u32::MAX), seen.map(open))
    })
}

/// With `LUMINAIRE_MUTANTS_SEEN`, appends the first of the mutants to that file, once.
#[inline]
fn reach(first: u32, count: u32) -> bool {
    let (chosen, seen) = state();
    if let Some(seen) = seen {
        record(first, seen);
    }
    chosen.wrapping_sub(first) < count
}

#[cold]
fn record(first: u32, mut seen: &File) {
    if !SEEN[first as usize].swap(true, Ordering::Relaxed) {
        seen.write_all(std::format!("{first}\n").as_bytes()).unwrap();
    }
}
