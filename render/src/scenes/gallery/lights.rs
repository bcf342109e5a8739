//! The spotlights of the gallery, with each falloff and each attenuation in turn.

use crate::scenes::{MovingLight, room::aimed};
use luminaire::{
    Angle, Cone, Error, Rgb, SpotLight, Vec3,
    attenuation::{
        AnyAttenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial,
        SmoothRange, Windowed,
    },
    falloff::{
        AnyFalloff, Hard, InvertedPower, InvertedRealPower, Linear, Power, RealPower, Smooth, Soft, Step,
        Table,
    },
};

/// A falloff as measured by a goniometer: 11 samples from the axis to the outer angle, with a
/// bright ring.
const MEASURED: [u16; 11] =
    [65_535, 64_200, 61_000, 56_500, 53_900, 54_800, 47_000, 30_500, 14_200, 4_100, 0];

/// Number of falloffs and of attenuations.
const PROFILES: usize = 12;
const DISTANCES: usize = 8;

/// Creates a spotlight on a track. `number` selects its falloff and attenuation. The intensity is
/// chosen so that a facing surface at the target has the irradiance `level`.
pub(super) fn track_spot(
    number: usize,
    position: Vec3<f32>,
    target: Vec3<f32>,
    level: f32,
) -> Result<MovingLight, Error> {
    let (name, cone) = kind(number % PROFILES)?;
    let spot = aimed(position, target, cone)?.with_attenuation(distance(number % DISTANCES)?);
    Ok(MovingLight::new(name, lit_to(level, target, spot.with_color(tint(number))?)?))
}

/// Creates a spotlight with a hotspot and an iris.
pub(super) fn follow_spot(position: Vec3<f32>, target: Vec3<f32>) -> Result<MovingLight, Error> {
    let cone = Cone::from_outer(Hard, Angle::degrees(16.0))?
        .with_inner(Angle::degrees(9.0))?
        .with_cutoff(Angle::degrees(14.5))?;
    let spot = aimed(position, target, cone)?.with_color(Rgb::new(0.9, 0.95, 1.0))?.with_intensity(9.0)?;
    Ok(MovingLight::new("follow spot", spot))
}

/// Returns the name and the cone of a kind of spotlight. The beam angle or the field angle is about
/// 40 degrees.
fn kind(number: usize) -> Result<(&'static str, Cone<AnyFalloff>), Error> {
    let field = |falloff: AnyFalloff| Cone::from_field(falloff, Angle::degrees(42.0));
    let data_sheet = |beam: f32, field: f32| {
        let cone = Cone::from_beam_and_field(Angle::degrees(beam), Angle::degrees(field))?;
        Ok(cone.with_falloff(AnyFalloff::from(cone.falloff())))
    };
    Ok(match number {
        0 => ("Fresnel", field(Soft.into())?),
        1 => ("profile spot", field(Hard.into())?),
        2 => ("wall washer", data_sheet(30.0, 44.0)?),
        3 => ("PAR", data_sheet(24.0, 44.0)?),
        4 => ("pebble convex", field(Smooth.into())?),
        5 => ("reflector lamp", field(Power::<3>.into())?),
        6 => ("framing projector", Cone::from_outer(Step.into(), Angle::degrees(34.0))?),
        7 => ("accent spot", field(Linear.into())?),
        8 => ("zoom profile", field(InvertedPower::<4>.into())?),
        9 => ("lensed spot", field(RealPower::new(2.75)?.into())?),
        10 => ("contour spot", field(InvertedRealPower::new(3.5)?.into())?),
        _ => ("measured spot", field(Table::of(&MEASURED).into())?),
    })
}

/// Returns one of the attenuations.
fn distance(number: usize) -> Result<AnyAttenuation, Error> {
    Ok(match number {
        0 => InverseSquare.into(),
        1 => FilamentRange::new(InverseSquare, Some(9.0))?.into(),
        2 => Polynomial::new(0.0, 0.5, 0.8)?.into(),
        3 => SmoothRange::new(8.0)?.into(),
        4 => GltfRange::new(InverseSquare, Some(8.0))?.into(),
        5 => CutAt::new(InverseSquare, Some(9.0))?.into(),
        6 => Windowed::new(Polynomial::new(0.2, 0.0, 1.0)?, Some(9.0))?.into(),
        _ => Windowed::new(NoAttenuation, Some(7.0))?.into(),
    })
}

/// Returns the shade of white of a light: from incandescent to cool fluorescent.
fn tint(number: usize) -> Rgb<f32> {
    let cool = (number * 5 % 8) as f32 / 7.0;
    Rgb::new(1.0, 0.8 + 0.16 * cool, 0.56 + 0.4 * cool)
}

/// Sets the intensity so that a facing surface at the target has the irradiance `level`, with any
/// attenuation.
fn lit_to(
    level: f32,
    target: Vec3<f32>,
    spot: SpotLight<AnyFalloff, AnyAttenuation>,
) -> Result<SpotLight<AnyFalloff, AnyAttenuation>, Error> {
    let facing = spot.axis().map(|component| -component);
    let lit = spot.with_intensity(1.0)?.compile::<f32>()?.irradiance(target, facing);
    spot.with_intensity(level / lit)
}
