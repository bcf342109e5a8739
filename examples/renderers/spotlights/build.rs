//! Places the program in memory.

#[path = "../../../benches/firmware/memory.rs"]
mod memory;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    memory::place(None)
}
