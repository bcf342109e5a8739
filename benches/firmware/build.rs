//! Places the programs in memory.

mod memory;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=memory.rs");
    memory::place(None)
}
