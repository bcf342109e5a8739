//! Passes the HAL's memory layout to the linker.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-link-arg-bins=-Tlinkall.x");
    // The layout names all functions of the ROM, such as those for floats. The relocations tell which
    // of them the program calls.
    println!("cargo::rustc-link-arg-bins=--emit-relocs");
}
