//! Places the programs in memory, and writes the light of the program `still`.

mod memory;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use luminaire::{Angle, Cone, Fx16, Soft, Source, Spot, Vec3};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=memory.rs");
    memory::place()?;
    // Three metres above a floor, and at a slant.
    let cone = Cone::from_field(Soft, Angle::degrees(50.0))?;
    let key =
        Spot::new(Vec3::new(-1.0, 3.0, -0.5), Vec3::new(0.3, -1.0, 0.15), cone)?.with_intensity(10.0)?;
    let file = Path::new(&env::var("OUT_DIR")?).join("key.rs");
    fs::write(file, key.compile::<Fx16>()?.as_source().to_string())?;
    Ok(())
}
