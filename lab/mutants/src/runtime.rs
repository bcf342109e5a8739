//! Chooses the mutant: a module of the instrumented copy of the kernel, not of this crate.

extern crate std;

use std::fs::{File, OpenOptions};
use std::io::Write;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

/// In place of a mutant: the slow path is needed, to read the environment or to record.
const UNKNOWN: u32 = u32::MAX;
const NONE: u32 = u32::MAX - 1;

static CHOSEN: AtomicU32 = AtomicU32::new(UNKNOWN);
static SEEN: [AtomicBool; COUNT] = [const { AtomicBool::new(false) }; COUNT];

/// Whether one of `count` mutants from `first` on is chosen. At compile time none is.
#[inline(always)]
pub const fn any(first: u32, count: u32) -> bool {
    core::intrinsics::const_eval_select((first, count), none, reach)
}

const fn none(_: u32, _: u32) -> bool {
    false
}

/// The kernel passes here between any two operations: there is only a load and a comparison.
#[inline(always)]
fn reach(first: u32, count: u32) -> bool {
    let chosen = CHOSEN.load(Ordering::Relaxed);
    if chosen == UNKNOWN { first_reach(first, count) } else { chosen.wrapping_sub(first) < count }
}

/// With `LUMINAIRE_MUTANTS_SEEN`, appends the first of the mutants to that file, once. Without, the
/// choice is read and kept.
#[cold]
#[inline(never)]
fn first_reach(first: u32, count: u32) -> bool {
    static FILE: OnceLock<Option<File>> = OnceLock::new();
    let file = FILE.get_or_init(|| {
        let open = |path| OpenOptions::new().append(true).create(true).open(path).unwrap();
        std::env::var_os("LUMINAIRE_MUTANTS_SEEN").map(open)
    });
    if let Some(mut file) = file.as_ref() {
        let seen = &SEEN[first as usize];
        if !seen.load(Ordering::Relaxed) && !seen.swap(true, Ordering::Relaxed) {
            file.write_all(std::format!("{first}\n").as_bytes()).unwrap();
        }
        return false;
    }
    let chosen = std::env::var("LUMINAIRE_MUTANT").ok().and_then(|id| id.parse().ok()).unwrap_or(NONE);
    CHOSEN.store(chosen, Ordering::Relaxed);
    chosen.wrapping_sub(first) < count
}
