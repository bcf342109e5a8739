//! The still life of the stage in key, fill and back light. The falloffs of the lights match the
//! beam angle and the field angle of a data sheet.

use super::{MovingLight, Setup, room::aimed};
use crate::scenes::stage;
use luminaire::{Angle, Cone, Error, Rgb, Vec3};

pub(super) fn setup() -> Result<Setup, Error> {
    let cone = |beam, field| Cone::from_beam_and_field(Angle::degrees(beam), Angle::degrees(field));
    let key = aimed(Vec3::new(-4.0, 4.6, 5.6), Vec3::new(-0.2, 0.65, -0.2), cone(20.0, 27.0)?)?
        .with_color(Rgb::new(1.0, 0.82, 0.6))?
        .with_intensity(90.0)?;
    let fill = aimed(Vec3::new(4.4, 3.2, 4.4), Vec3::new(0.1, 1.0, -1.2), cone(24.0, 50.0)?)?
        .with_color(Rgb::new(0.42, 0.62, 1.0))?
        .with_intensity(28.0)?;
    let back = aimed(Vec3::new(1.5, 4.4, -3.0), Vec3::new(-0.1, 0.4, 0.3), cone(24.0, 40.0)?)?
        .with_color(Rgb::new(0.9, 0.88, 1.0))?
        .with_intensity(75.0)?;
    let fixtures = [
        MovingLight::new("profile spot (key)", key).with_shadow(512),
        MovingLight::new("Fresnel (fill)", fill),
        MovingLight::new("PAR (back)", back).with_shadow(512),
    ];
    Ok(Setup::new(stage::scene()?, stage::camera(), fixtures.into()))
}
