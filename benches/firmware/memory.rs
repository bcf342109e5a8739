//! Places a program in the memory of the board that QEMU emulates for the target. The build scripts
//! share this file.

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

/// Flash at address 0 and RAM at 2^29, as on most Cortex-M.
fn cortex_m(flash: &str, ram: &str) -> String {
    placed([0, 0x2000_0000], flash, ram)
}

fn placed([flash_at, ram_at]: [u32; 2], flash: &str, ram: &str) -> String {
    format!(
        "MEMORY {{\n  FLASH : ORIGIN = {flash_at:#x}, LENGTH = {flash}\n  RAM : ORIGIN = {ram_at:#x}, LENGTH = {ram}\n}}\n"
    )
}

/// One RAM for everything, at the address where QEMU's board `virt` has it.
fn virt(ram: &str) -> String {
    let mut script = format!("MEMORY {{\n  RAM : ORIGIN = 0x80000000, LENGTH = {ram}\n}}\n");
    for region in ["TEXT", "RODATA", "DATA", "BSS", "HEAP", "STACK"] {
        script += &format!("REGION_ALIAS(\"REGION_{region}\", RAM);\n");
    }
    script
}

/// Passes the target's memory layout to the linker. `flash` replaces the board's size of flash, for
/// programs that are only linked. Does nothing for the host.
pub(crate) fn place(flash: Option<&str>) -> Result<(), Box<dyn Error>> {
    let (memory, scripts): (String, &[&str]) = match env::var("TARGET")?.as_str() {
        "thumbv6m-none-eabi" => (cortex_m(flash.unwrap_or("256K"), "16K"), &["link.x"]), // microbit
        "thumbv7m-none-eabi" => (cortex_m(flash.unwrap_or("256K"), "64K"), &["link.x"]), // lm3s6965evb
        "thumbv7em-none-eabihf" => (cortex_m("4M", "4M"), &["link.x"]),                  // mps2-an386, -an500
        // mps2-an505: the secure aliases of its memories.
        "thumbv8m.main-none-eabihf" => (placed([0x1000_0000, 0x3800_0000], "4M", "4M"), &["link.x"]),
        "riscv32imc-unknown-none-elf" | "riscv32imac-unknown-none-elf" => {
            (virt(flash.unwrap_or("1M")), &["memory.x", "link.x"])
        }
        // The host runs the same program to say what its results must be.
        _ => return Ok(()),
    };
    let out = PathBuf::from(env::var("OUT_DIR")?);
    fs::write(out.join("memory.x"), memory)?;
    println!("cargo::rustc-link-search={}", out.display());
    for script in scripts {
        println!("cargo::rustc-link-arg-bins=-T{script}");
    }
    Ok(())
}
