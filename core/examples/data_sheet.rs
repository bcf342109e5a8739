//! From a stage light's data sheet to the illuminance on a floor.

use luminaire::{Angle, Cone, Fx16, SpotLight, Vec3};

fn main() -> Result<(), luminaire::Error> {
    // Beam 22 degrees, field 40 degrees, 7,400 lumens.
    let (beam, field) = (Angle::degrees(22.0), Angle::degrees(40.0));
    let cone = Cone::from_beam_and_field(beam, field)?;
    let peak = cone.candela(7_400.0);
    println!("{peak:.0} cd on the axis; the light ends at {:.1} degrees", cone.outer().to_degrees());
    // The sheet says nothing of the edge: cubics with the same two angles end between these.
    let (softest, hardest) = Cone::edge_slopes(beam, field)?;
    for (edge, slope) in [("softest", softest), ("hardest", hardest)] {
        let cone = Cone::from_beam_field_and_slope(beam, field, slope)?;
        println!("with the {edge} edge it ends at {:.1} degrees", cone.outer().to_degrees());
    }

    // Six metres above the floor, pointing down: candela over metres squared is lux.
    let light = SpotLight::new([0.0, 6.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_intensity(peak)?;
    let lit = light.compile::<f32>()?;
    for distance in [0.0, 0.5, 1.0, 1.5, 2.0, 2.5] {
        let lux = lit.irradiance(Vec3::new(distance, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
        println!("{distance} m from the middle: {lux:.0} lx");
    }
    println!("a face on the axis has 500 lx up to {:.1} m away", light.range_above(500.0));

    // On a display whose full scale is the light in the middle: codes of 255 in linear light.
    let light = light.with_intensity(36.0)?;
    let [standard, quick] =
        [light.error_bound::<Fx16>(6.0..=7.0)?, light.quick_error_bound::<Fx16>(6.0..=7.0)?];
    println!("in 16 bits, a pixel is off by at most {:.2} codes", standard.codes());
    println!("with the quick evaluation, by at most {:.2}", quick.codes());
    if let Some(between) = light.interpolation_bound(0.02, 6.0) {
        println!("between points 2 cm apart, a straight line is off by at most {:.2}", 255.0 * between);
    }
    Ok(())
}
