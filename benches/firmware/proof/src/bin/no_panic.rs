//! Calls every public function that depends on the format, on values that the compiler does not
//! know. If one of them can panic, the program does not link. `cargo xtask` writes the calls.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_proof::program!("no_panic.rs");
