use luminaire::{Angle, Cone, Fx16, Rgb, SpotLight, codegen::as_source};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cone = Cone::soft(Angle::degrees(40.0))?;
    let warm = SpotLight::new([1.5, 1.0, 3.0], [-0.3, 0.0, -1.0], cone)?.with_intensity(9.0)?;
    let cool = SpotLight::new([3.5, 1.5, 3.0], [0.2, 0.0, -1.0], cone)?.with_intensity(9.0)?;
    let warm = warm.with_color(Rgb::new(1.0, 0.6, 0.3))?.compile::<Fx16>()?;
    let cool = cool.with_color(Rgb::new(0.3, 0.5, 1.0))?.compile::<Fx16>()?;
    let text = format!("[{}, {}]", as_source(&warm), as_source(&cool));
    std::fs::write(std::path::Path::new(&std::env::var("OUT_DIR")?).join("lights.rs"), text)?;
    // The link.x of cortex-m-rt includes memory.x itself.
    if std::env::var("CARGO_CFG_TARGET_ARCH")? == "riscv32" {
        println!("cargo::rustc-link-arg-bins=-Tmemory-riscv.x");
    }
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    Ok(())
}
