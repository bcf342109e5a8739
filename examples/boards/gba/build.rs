//! Passes the memory layout to the linker.

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=cartridge.x");
    let out = PathBuf::from(env::var("OUT_DIR")?);
    fs::copy("cartridge.x", out.join("cartridge.x"))?;
    println!("cargo::rustc-link-search={}", out.display());
    println!("cargo::rustc-link-arg-bins=-Tcartridge.x");
    println!("cargo::rustc-link-arg-bins=--nmagic");
    Ok(())
}
