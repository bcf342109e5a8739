//! Lets the plugin be linked where a library is expected to know who has its functions.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    // It is QEMU that has them, and it is there only when it loads the plugin.
    if std::env::var("CARGO_CFG_TARGET_VENDOR").is_ok_and(|vendor| vendor == "apple") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-undefined,dynamic_lookup");
    }
}
