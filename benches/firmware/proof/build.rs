//! Places the programs in memory, and says where the calls of the configuration are.

#[path = "../memory.rs"]
mod memory;

use std::env;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=../memory.rs");
    // The programs are larger than a board's flash, and are only linked.
    memory::place(Some("8M"))?;
    let has = |feature: &str| env::var_os(format!("CARGO_FEATURE_{feature}")).is_some();
    if has("CULPRITS") {
        println!("cargo::rustc-link-arg-bins=--defsym=a_panic_is_reachable=main");
        println!("cargo::rustc-link-arg-bins=--emit-relocs");
    }
    if has("INTEROP") {
        println!("cargo::rustc-link-arg-bins=-Tdefmt.x");
    }
    if let Some(configuration) = ["ARITHMETIC", "INTEROP", "MICROMATH"].into_iter().find(|name| has(name)) {
        let calls =
            format!("{}/../target/calls/{}", env::var("CARGO_MANIFEST_DIR")?, configuration.to_lowercase());
        println!("cargo::rustc-env=CALLS={calls}");
    }
    Ok(())
}
