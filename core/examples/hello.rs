//! A pixel under a spotlight: the shortest program with the kernel.

use luminaire::{Angle, Cone, Fx16, Rgb, SpotLight, display};

fn main() -> Result<(), luminaire::Error> {
    // A soft-edged stage light with a field angle of 15 degrees, four metres up, pointing down.
    let cone = Cone::soft(Angle::degrees(15.0))?;
    let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone)?;
    let lit = spot.with_intensity(16.0)?.compile::<Fx16>()?; // full scale on the floor

    // A point on the floor where the beam angle ends, and its normal.
    let light = lit.irradiance(Fx16::point([0.343, 0.0, 0.0]), Fx16::normal([0.0, 1.0, 0.0]));
    let pixel = display::Rgb565::from_linear(display::clip(Rgb::lit(light, lit.color())));
    println!("{light:.3} of full scale, {:#06x} as RGB565", pixel.0);
    Ok(())
}
