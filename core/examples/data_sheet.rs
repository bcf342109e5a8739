//! From a stage light's data sheet to the illuminance on a floor.

use luminaire::{Angle, Cone, Fx16, SpotLight, Vec3};

fn main() -> Result<(), luminaire::Error> {
    // Beam 22 degrees, field 40 degrees, 7,400 lumens.
    let cone = Cone::from_beam_and_field(Angle::degrees(22.0), Angle::degrees(40.0))?;
    let peak = cone.candela(7_400.0);
    println!("{peak:.0} cd on the axis; the light ends at {:.1} degrees", cone.outer().to_degrees());

    // Six metres above the floor, pointing down: candela over metres squared is lux.
    let light = SpotLight::new([0.0, 6.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_intensity(peak)?;
    let lit = light.compile::<f32>()?;
    for distance in [0.0, 0.5, 1.0, 1.5, 2.0, 2.5] {
        let lux = lit.irradiance(Vec3::new(distance, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
        println!("{distance} m from the middle: {lux:.0} lx");
    }

    // On a display whose full scale is the light in the middle, 16 bits are this near to exact arithmetic.
    let error = light.with_intensity(36.0)?.error_bound::<Fx16>(6.0..=7.0)?;
    println!("in 16 bits, a pixel is off by at most {:.2} of 255 codes", error.codes());
    Ok(())
}
