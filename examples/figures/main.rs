//! Draws the figures of `docs/FIGURES.md` into `docs/figures/`.
//!
//! `cargo run --release -p suite --example figures`. `tests/suite/figures.rs` draws the figures
//! again and compares them with the files.

mod gallery;

use std::{error::Error, fs, path::Path};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures");
    fs::create_dir_all(&folder)?;
    for figure in gallery::figures()? {
        let path = folder.join(figure.name);
        fs::write(&path, figure.file()?)?;
        println!("{}", path.display());
    }
    Ok(())
}
