//! Lets the plugin be linked on macOS, whose linker does not accept undefined functions by default.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    // QEMU defines the functions, and they can be resolved only when QEMU loads the plugin.
    if std::env::var("CARGO_CFG_TARGET_VENDOR").is_ok_and(|vendor| vendor == "apple") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-undefined,dynamic_lookup");
    }
}
