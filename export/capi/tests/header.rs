//! The header is what cbindgen writes of the source.

use std::{env, fs, path::Path};

#[test]
fn the_header_is_that_of_the_source() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("the configuration is read");
    let mut written = Vec::new();
    cbindgen::Builder::new()
        .with_crate(root)
        .with_config(config)
        .generate()
        .expect("the header is written")
        .write(&mut written);
    let file = root.join("include/luminaire.h");
    if env::var_os("LUMINAIRE_BLESS").is_some() {
        fs::write(&file, &written).expect("the header is replaced");
    }
    let recorded = fs::read_to_string(&file).unwrap_or_default();
    let written = String::from_utf8(written).expect("a header is text");
    assert!(recorded == written, "{}: run the test with LUMINAIRE_BLESS=1", file.display());
}
