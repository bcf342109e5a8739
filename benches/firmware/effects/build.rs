//! Places the programs in memory, and writes the lights and surfaces as constants of the chosen
//! format.

#[path = "../memory.rs"]
mod memory;

use std::path::Path;
use std::{env, fs};

use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Error, Fx16, Fx32, Material, PointLight, Rgb, SpotLight,
    Vec3,
    codegen::{Named, Source, SourceScalar, as_source},
    display::{Exposure, Rgb565Ramp},
    haze::Haze,
    models::SAMPLES,
    number::Quick,
    projector::{Gobo, Projection, Shadow},
};
#[allow(clippy::wildcard_imports, reason = "the types of the lists")]
use luminaire::{attenuation::*, falloff::*, specular::*};

type Outcome = Result<(), Box<dyn std::error::Error>>;

const AMBER: Rgb<f32> = Rgb::new(1.0, 0.62, 0.1);
const POSITION: Vec3<f32> = Vec3::new(1.5, 4.0, -0.75);
const AXIS: Vec3<f32> = Vec3::new(0.36, -0.8, 0.48);
/// The position of the eye, as in the scene of the kernels.
const EYE: Vec3<f32> = Vec3::new(-0.5, 3.5, 1.0);
/// The intensity of lights that reach full scale at a distance of 4.
const BRIGHT: f32 = 16.0;
/// The field angle of the spotlights.
const FIELD: Angle = Angle::degrees(36.0);
/// The field angle of the spotlight that another one zooms towards.
const WIDE_FIELD: Angle = Angle::degrees(72.0);

fn main() -> Outcome {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=../memory.rs");
    memory::place(None)?;
    if env::var_os("CARGO_FEATURE_F32").is_some() {
        quick::<f32>()?;
        constants::<f32>()
    } else if env::var_os("CARGO_FEATURE_FX32").is_some() {
        write("quick", &soft()?.compile::<Fx32>()?)?;
        constants::<Fx32>()
    } else {
        quick::<Fx16>()?;
        constants::<Fx16>()
    }
}

fn soft() -> Result<SpotLight<Soft, NoAttenuation>, Error> {
    key(Cone::from_field(Soft, FIELD)?, NoAttenuation)
}

fn quick<S: SourceScalar + Quick>() -> Outcome {
    write("quick", &soft()?.compile_quick::<S>()?)
}

fn constants<S: SourceScalar>() -> Outcome {
    listed::<S>()?;
    let cone = Cone::from_field(Soft, FIELD)?;
    spot_of::<S, _, _>("hotspot", cone.with_inner(Angle::degrees(12.0))?, NoAttenuation)?;
    spot_of::<S, _, _>("cutoff", cone.with_cutoff(FIELD)?, NoAttenuation)?;
    write("bright", &key(cone, NoAttenuation)?.with_intensity(BRIGHT)?.compile::<S>()?)?;
    spot_of::<S, _, _>("wide", Cone::from_field(Soft, WIDE_FIELD)?, NoAttenuation)?;
    write("part", &S::from_f32(0.375))?;
    write("position", &POSITION.map(S::length))?;
    write("radius", &S::length(0.25))?;
    write("axis_back", &SpotLight::new(POSITION, AXIS.map(|c| -c), cone)?.axis_in::<S>())?;
    let square = Projection::of(&SpotLight::new(POSITION, AXIS, cone)?)?;
    write("gobo", &Gobo::of(&panes()).on(square.compile::<S>()?))?;
    write("eye", &EYE.map(S::length))?;
    let (beam, haze) = (key(cone, InverseSquare)?, Haze::new(0.02)?);
    if env::var_os("CARGO_FEATURE_F32").is_some() {
        write("beam", &beam.compile::<f32>()?.in_haze(&haze))?;
    } else {
        write("beam", &beam.compile::<Fx16>()?.in_haze(&haze))?;
    }
    write("shadow", &Shadow::new(square.compile::<S>()?, 16, &disc().map(S::length))?)?;
    write("point", &PointLight::new(POSITION)?.with_color(AMBER)?.with_intensity(BRIGHT)?.compile::<S>()?)?;
    write("directional", &DirectionalLight::new(AXIS)?.with_color(AMBER)?.compile::<S>())?;
    write("ambient", &AmbientLight::new(AMBER)?.with_intensity(0.1)?.compile::<S>())?;
    write("exposure", &Exposure::stops(1)?.compile::<S>())?;
    write(
        "ramp",
        &Rgb565Ramp::new(AMBER.map(|channel| 0.09 * channel), AMBER.map(|channel| 0.9 * channel))?,
    )?;
    write("matte", &paper()?.compile::<S>())
}

/// Writes a light or a material for each model of the library's lists.
fn listed<S: SourceScalar>() -> Outcome {
    macro_rules! falloffs {
        ($($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr;)*) => {
            $(spot::<S, $type, _>(concat!("spot-", $name, "-lambert"), $sample, Ok(NoAttenuation))?;)*
        };
    }
    luminaire::constant_falloffs!(falloffs);
    macro_rules! attenuations {
        ($($(#[$doc:meta])* $variant:ident($run_time:ty) = any $any:expr
           $(, $(#[$its_doc:meta])* $type:ty = $name:literal, $value:expr)*;)*) => {
            $($(spot::<S, _, $type>(concat!("spot-soft-lambert-", $name), Ok(Soft), $value)?;)*)*
        };
    }
    luminaire::attenuations!(attenuations);
    macro_rules! lobes {
        ($($(#[$doc:meta])* $type:ty = $name:literal, $value:expr;)*) => {
            $(write($name, &paper()?.with_highlight::<$type>($value, Rgb::new(0.5, 0.5, 0.5), 32)?.compile::<S>())?;)*
        };
    }
    luminaire::lobes!(lobes);
    Ok(())
}

fn paper() -> Result<Material, Error> {
    Material::new(Rgb::new(0.9, 0.9, 0.85))
}

/// The gobo: a window of two by two panes, in 16 by 16 texels.
fn panes() -> [u8; 256] {
    let is_pane = |i: usize| (3..7).contains(&i) || (9..13).contains(&i);
    std::array::from_fn(|part| if is_pane(part / 16) && is_pane(part % 16) { 255 } else { 0 })
}

/// The depths of a shadow map of 16 by 16: a disc hangs two metres from the light, in the middle of
/// its beam.
fn disc() -> [f32; 256] {
    core::array::from_fn(|texel| {
        let (x, y) = (texel % 16, texel / 16);
        let from_middle = (2 * x).abs_diff(15).pow(2) + (2 * y).abs_diff(15).pow(2);
        if from_middle < 100 { 2.0 } else { f32::INFINITY }
    })
}

fn spot<S: SourceScalar, P: Falloff + Source, A: Attenuation + Named>(
    name: &str,
    profile: Result<P, Error>,
    attenuation: Result<A, Error>,
) -> Outcome
where
    P::Compiled<S>: Source,
    A::Constants<S>: Source,
{
    spot_of::<S, P, A>(name, Cone::from_field(profile?, FIELD)?, attenuation?)
}

fn spot_of<S: SourceScalar, P: Falloff + Source, A: Attenuation + Named>(
    name: &str,
    cone: Cone<P>,
    attenuation: A,
) -> Outcome
where
    P::Compiled<S>: Source,
    A::Constants<S>: Source,
{
    write(name, &key(cone, attenuation)?.compile::<S>()?)
}

fn key<P: Falloff, A: Attenuation>(cone: Cone<P>, attenuation: A) -> Result<SpotLight<P, A>, Error> {
    SpotLight::new(POSITION, AXIS, cone)?
        .with_intensity(if attenuation.grows() { BRIGHT } else { 1.0 })?
        .with_attenuation(attenuation)
        .with_color(AMBER)
}

fn write(name: &str, value: &impl Source) -> Outcome {
    let file = Path::new(&env::var("OUT_DIR")?).join(name).with_extension("rs");
    Ok(fs::write(file, as_source(value).to_string())?)
}
