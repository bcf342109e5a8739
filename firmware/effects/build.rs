//! Places the programs in memory, and writes the lights and surfaces as constants of the chosen format.

#[path = "../memory.rs"]
mod memory;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Fx16, Fx32, Material, PointLight, Rgb, SpotLight, Vec3,
    attenuation::{
        Attenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
    },
    codegen::{Source, SourceScalar},
    display::Exposure,
    falloff::{Cubic, Falloff, Hard, InvertedPower, Linear, Power, Quadratic, Smooth, Soft, Step, Table},
    haze::Haze,
    projector::{Gobo, Projection, Shadow},
    specular::{BlinnPhong, DifferenceForm, DualConeLobe, Phong},
};

type Outcome = Result<(), Box<dyn Error>>;

/// Sixteen samples of a flood light's wide middle.
const SAMPLES: [u16; 16] = [
    65_535, 65_200, 64_300, 62_900, 60_800, 57_900, 54_000, 49_100, 43_200, 36_300, 28_700, 20_900, 13_600,
    7_300, 2_600, 0,
];
const AMBER: Rgb<f32> = Rgb::new(1.0, 0.62, 0.1);
const POSITION: Vec3<f32> = Vec3::new(1.5, 4.0, -0.75);
const AXIS: Vec3<f32> = Vec3::new(0.36, -0.8, 0.48);
/// The field angle of the spotlights.
const FIELD: Angle = Angle::degrees(36.0);

fn main() -> Outcome {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=../memory.rs");
    memory::place()?;
    if env::var_os("CARGO_FEATURE_F32").is_some() {
        constants::<f32>()
    } else if env::var_os("CARGO_FEATURE_FX32").is_some() {
        constants::<Fx32>()
    } else {
        constants::<Fx16>()
    }
}

fn constants<S: SourceScalar>() -> Outcome {
    spot::<S, _, _>("soft", Soft, NoAttenuation)?;
    spot::<S, _, _>("hard", Hard, NoAttenuation)?;
    spot::<S, _, _>("smooth", Smooth, NoAttenuation)?;
    spot::<S, _, _>("cubic", Cubic::with_slopes(1.25, 3.5)?, NoAttenuation)?;
    spot::<S, _, _>("power", Power::<8>, NoAttenuation)?;
    spot::<S, _, _>("table", Table::new(&SAMPLES)?, NoAttenuation)?;
    spot::<S, _, _>("linear", Linear, NoAttenuation)?;
    spot::<S, _, _>("cut_off", Step, NoAttenuation)?;
    spot::<S, _, _>("blend", Quadratic::new(0.75)?, NoAttenuation)?;
    spot::<S, _, _>("rim", InvertedPower::<4>, NoAttenuation)?;
    let cone = Cone::from_field(Soft, FIELD)?;
    spot_of::<S, _, _>("hotspot", cone.with_inner(Angle::degrees(12.0))?, NoAttenuation)?;
    spot_of::<S, _, _>("delimiter", cone.with_cutoff(FIELD)?, NoAttenuation)?;
    spot::<S, _, _>("inverse_square", Soft, InverseSquare)?;
    spot::<S, _, _>("polynomial", Soft, Polynomial::new(1.0, 0.2, 0.03)?)?;
    spot::<S, _, _>("smooth_range", Soft, SmoothRange::new(9.0)?)?;
    spot::<S, _, _>("windowed", Soft, GltfRange::new(InverseSquare, Some(9.0))?)?;
    spot::<S, _, _>("squared_window", Soft, FilamentRange::new(InverseSquare, Some(9.0))?)?;
    spot::<S, _, _>("hard_range", Soft, CutAt::new(InverseSquare, Some(9.0))?)?;
    let square = Projection::of(&SpotLight::new(POSITION, AXIS, cone)?)?;
    write("gobo", &Gobo::of(&panes()).on(square.compile::<S>()?))?;
    write("beam", &key(cone, InverseSquare)?.compile::<f32>()?.in_haze(&Haze::new(0.02)?))?;
    write("shadow", &Shadow::new(square.compile::<S>()?, 16, &disc().map(S::length))?)?;
    write("point", &PointLight::new(POSITION)?.with_color(AMBER)?.with_intensity(16.0)?.compile::<S>()?)?;
    write("directional", &DirectionalLight::new(AXIS)?.with_color(AMBER)?.compile::<S>())?;
    write("ambient", &AmbientLight::new(AMBER)?.with_intensity(0.1)?.compile::<S>())?;
    write("exposure", &Exposure::stops(1)?.compile::<S>())?;
    let paper = Material::new(Rgb::new(0.9, 0.9, 0.85))?;
    let gloss = Rgb::new(0.5, 0.5, 0.5);
    write("matte", &paper.compile::<S>())?;
    write("phong", &paper.with_highlight(Phong, gloss, 32)?.compile::<S>())?;
    write("blinn_phong", &paper.with_highlight(BlinnPhong, gloss, 32)?.compile::<S>())?;
    write("dual_cone", &paper.with_highlight(DualConeLobe, gloss, 32)?.compile::<S>())?;
    write("lyon", &paper.with_highlight(DifferenceForm::<_, 3>(Phong), gloss, 32)?.compile::<S>())
}

/// A window of two by two panes.
fn panes() -> [[u8; 16]; 16] {
    let is_pane = |i: usize| (3..7).contains(&i) || (9..13).contains(&i);
    std::array::from_fn(|row| {
        std::array::from_fn(|column| if is_pane(row) && is_pane(column) { 255 } else { 0 })
    })
}

/// The depths of a shadow map of 16 by 16: a disc hangs two metres from the light, in the middle of its beam.
fn disc() -> [f32; 256] {
    core::array::from_fn(|texel| {
        let (x, y) = (texel % 16, texel / 16);
        let from_middle = (2 * x).abs_diff(15).pow(2) + (2 * y).abs_diff(15).pow(2);
        if from_middle < 100 { 2.0 } else { f32::INFINITY }
    })
}

fn spot<S: SourceScalar, P: Falloff + Source, A: Attenuation + luminaire::codegen::Named>(
    name: &str,
    profile: P,
    attenuation: A,
) -> Outcome
where
    P::Compiled<S>: Source,
    A::Constants<S>: Source,
{
    spot_of::<S, P, A>(name, Cone::from_field(profile, FIELD)?, attenuation)
}

fn spot_of<S: SourceScalar, P: Falloff + Source, A: Attenuation + luminaire::codegen::Named>(
    name: &str,
    cone: Cone<P>,
    attenuation: A,
) -> Outcome
where
    P::Compiled<S>: Source,
    A::Constants<S>: Source,
{
    write(&format!("spot_{name}"), &key(cone, attenuation)?.compile::<S>()?)
}

fn key<P: Falloff, A: Attenuation>(
    cone: Cone<P>,
    attenuation: A,
) -> Result<SpotLight<P, A>, luminaire::Error> {
    SpotLight::new(POSITION, AXIS, cone)?
        .with_intensity(16.0)?
        .with_attenuation(attenuation)
        .with_color(AMBER)
}

fn write(name: &str, value: &impl Source) -> Outcome {
    let file = Path::new(&env::var("OUT_DIR")?).join(name).with_extension("rs");
    Ok(fs::write(file, value.as_source().to_string())?)
}
