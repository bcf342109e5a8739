//! The light of a spotlight at one point: the shortest program with the kernel.

use luminaire::{Angle, Cone, SpotLight, Vec3};

fn main() -> Result<(), luminaire::Error> {
    // A Fresnel whose data sheet says: field angle 15 degrees. Four metres up, pointing down: an
    // intensity of 4 x 4 is full scale on the floor below.
    let cone = Cone::soft(Angle::degrees(15.0))?;
    let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_intensity(16.0)?;
    let lit = spot.compile::<f32>()?;

    // A point on the floor 34 cm from the middle, where the beam angle ends, and its unit normal.
    let light = lit.irradiance(Vec3::new(0.343, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
    println!("light {light:.3} of full scale");
    Ok(())
}
