//! Places the programs in memory, and writes the lights and surfaces as constants of the chosen
//! format.

#[path = "../memory.rs"]
mod memory;

use std::marker::PhantomData;
use std::path::Path;
use std::{env, fs};

use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Error, Fx16, Fx32, Material, PointLight, Rgb, Scalar,
    SpotLight, Vec3,
    attenuation::{Attenuation, AttenuationVisitor, InverseSquare, NoAttenuation, attenuations},
    codegen::{Named, Source, as_source},
    display::{Exposure, Rgb565Ramp},
    falloff::{Falloff, FalloffVisitor, ListedFalloff, Soft, constant_falloffs},
    haze::Haze,
    models::Listed,
    number::Quick,
    projector::{Gobo, Projection, Shadow},
    specular::{LobeVisitor, SpecularLobe, lobes},
};
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

fn quick<S: Quick>() -> Outcome {
    write("quick", &soft()?.compile_quick::<S>()?)
}

fn constants<S: Scalar>() -> Outcome {
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

/// Writes a light or a material for each model of the library's lists, as implementations of
/// `Listed`.
fn listed<S: Scalar>() -> Outcome {
    let mut models =
        Models { implementations: String::new(), calls: String::new(), format: PhantomData::<S> };
    constant_falloffs(&mut models);
    attenuations(&mut models);
    lobes::<S>(&mut models);
    let Models { implementations, calls, .. } = models;
    let each = format!("pub(super) fn each(visit: &mut impl super::Visit) {{\n{calls}}}\n");
    Ok(fs::write(Path::new(&env::var("OUT_DIR")?).join("listed.rs"), implementations + &each)?)
}

/// The source of the implementations so far, and of the calls that visit them.
struct Models<S> {
    implementations: String,
    calls: String,
    format: PhantomData<S>,
}

impl<S: Scalar> Models<S> {
    /// The irradiance of a spotlight that has the model.
    fn spot<P: Falloff, A: Attenuation>(
        &mut self,
        [model, name, kind]: [&str; 3],
        falloff: Result<P, Error>,
        attenuation: Result<A, Error>,
    ) {
        let light = (|| key(Cone::from_field(falloff?, FIELD)?, attenuation?)?.compile::<S>())();
        let light = light.expect("the parameters of the lists are sound");
        let effect = "Irradiance { Self::CONSTANT.irradiance(surface.point, surface.normal) }";
        self.model(model, name, &format!("CompiledSpotLight<Format, {kind}>"), &light, effect);
    }

    fn model(&mut self, model: &str, name: &str, kind: &str, constant: &impl Source, effect: &str) {
        let (output, _) = effect.split_once(' ').expect("a type and a block");
        self.implementations += &format!(
            "impl Listed for {model} {{
                const NAME: &'static str = \"{name}\";
                type Constant = {kind};
                const CONSTANT: Self::Constant = {};
                type Output = {output};

                #[inline(always)]
                fn effect(surface: Surface) -> {effect}
            }}\n",
            as_source(constant)
        );
        self.calls += &format!("    visit.surface(<{model}>::NAME, <{model}>::effect);\n");
    }
}

impl<S: Scalar> FalloffVisitor for Models<S> {
    fn falloff<P: ListedFalloff>(&mut self) {
        let name = format!("spot-{}-lambert", P::NAME);
        let kind = format!("{}, NoAttenuation", P::TYPE);
        self.spot([P::TYPE, &name, &kind], P::sample(), Ok(NoAttenuation));
    }
}

impl<S: Scalar> AttenuationVisitor for Models<S> {
    fn attenuation<A: Listed + Attenuation>(&mut self) {
        let name = format!("spot-soft-lambert-{}", A::NAME);
        let kind = format!("Soft, {}", A::TYPE);
        self.spot([A::TYPE, &name, &kind], Ok(Soft), A::sample());
    }
}

impl<S: Scalar> LobeVisitor<S> for Models<S> {
    fn lobe<H: Listed + SpecularLobe<Constants<S>: Source> + Named>(&mut self) {
        let grey = Rgb::new(0.5, 0.5, 0.5);
        let surface = (|| paper()?.with_highlight(H::sample()?, grey, 32))();
        let surface = surface.expect("the parameters of the lists are sound").compile::<S>();
        let kind = format!("CompiledMaterial<Format, {}>", H::TYPE);
        let effect = "Light { Self::CONSTANT.reflect(&surface, &DIRECTIONAL) }";
        self.model(H::TYPE, H::NAME, &kind, &surface, effect);
    }
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

fn spot_of<S: Scalar, P: Falloff, A: Attenuation>(name: &str, cone: Cone<P>, attenuation: A) -> Outcome {
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
