//! Writes every compiled value of `lights` as Rust source, which the test `generated` includes.

mod lights;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use luminaire::codegen::{Source, as_source};

/// Rust source: a list of names and constants.
struct Listing(String);

impl lights::Visit for Listing {
    fn value<T: Source>(&mut self, name: String, value: T) {
        self.0 += &format!("({name:?}, &const {} as &dyn Constant),\n", as_source(&value));
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=tests/suite/generated");
    let mut listing = Listing(String::new());
    lights::all(&mut listing)?;
    let out = env::var("OUT_DIR")?;
    fs::write(Path::new(&out).join("constants.rs"), format!("[\n{}]\n", listing.0))?;
    Ok(())
}
