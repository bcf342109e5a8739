//! Calls every public function that is the same in each format, on values that the compiler does
//! not know. If one of them can panic, the program does not link. `cargo xtask` writes the calls.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[allow(clippy::wildcard_imports, reason = "the names that the calls use")]
use luminaire_effects::unknown::*;

luminaire_effects::program!(every_function);

include!("../bin/no_panic_common.calls");
