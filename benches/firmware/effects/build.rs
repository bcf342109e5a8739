//! Places the programs in memory, and writes the lights and surfaces as constants of the chosen
//! format.

#[path = "../memory.rs"]
mod memory;

use std::marker::PhantomData;
use std::path::Path;
use std::{env, fs};

use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Error, Fx16, Fx32, Material, MeasuredLight, PointLight, Rgb,
    Scalar, SpotLight, Vec3,
    attenuation::{
        Attenuation, AttenuationVisitor, Decay, FilamentRange, InverseSquare, NoAttenuation, Windowed,
        attenuations,
    },
    codegen::{ConeParts, Named, Parts, Source, as_source},
    display::{Exposure, Palette, Rgb565Ramp},
    dynamic::{Effect, Effects},
    falloff::{
        AnyFalloff, Cubic, Falloff, FalloffVisitor, Hard, InvertedRealPower, ListedFalloff, Power, Quadratic,
        Soft, Table, constant_falloffs,
    },
    haze::Haze,
    light::{
        CompiledMeasuredLight, CompiledPointLight, CompiledSpotLight, Distribution, LightModel, Symmetry,
    },
    models::Listed,
    projector::{Gobo, Projection, Shadow},
    specular::{LobeVisitor, Phong, SpecularLobe, lobes},
};
include!("src/paper.rs");

type Outcome = Result<(), Box<dyn std::error::Error>>;

const AMBER: Rgb<f32> = Rgb::new(1.0, 0.62, 0.1);
const POSITION: Vec3<f32> = Vec3::new(1.5, 4.0, -0.75);
const AXIS: Vec3<f32> = Vec3::new(0.36, -0.8, 0.48);
/// The side of the light that is not round.
const SIDE: Vec3<f32> = Vec3::new(0.8, 0.36, 0.0);
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
        write("quick", &soft()?.compile::<f32>()?)?;
        choices(Choices::of_format::<f32>()?)?;
        constants::<f32>()
    } else if env::var_os("CARGO_FEATURE_FX32").is_some() {
        write("quick", &soft()?.compile::<Fx32>()?)?;
        choices(Choices::of_format::<Fx32>()?)?;
        constants::<Fx32>()
    } else {
        quick()?;
        fine()?;
        choices(Choices::of_fx16()?)?;
        constants::<Fx16>()
    }
}

fn soft() -> Result<SpotLight<Soft, NoAttenuation>, Error> {
    key(Cone::from_field(Soft, FIELD)?, NoAttenuation)
}

/// Calls a macro with the four edges whose lit points have prices by every evaluation.
macro_rules! edges {
    ($row:ident) => {
        $row!("lit", Soft);
        $row!("lit-hard", Hard);
        $row!("lit-quadratic", Quadratic::new(0.5)?);
        $row!("lit-cubic", Cubic::with_slopes(1.25, 3.5)?);
    };
}

/// The lights of the quick evaluation.
fn quick() -> Outcome {
    macro_rules! row {
        ($name:literal, $edge:expr) => {
            let cone = Cone::from_field($edge, FIELD)?;
            write(concat!($name, "-quick"), &key(cone, NoAttenuation)?.compile_quick::<Fx16>()?)?;
            write(
                concat!($name, "-inverse-square-quick"),
                &key(cone, InverseSquare)?.compile_quick::<Fx16>()?,
            )?;
        };
    }
    edges!(row);
    write("quick", &soft()?.compile_quick::<Fx16>()?)
}

/// The lights of which every point takes the fine evaluation, in a cone that is nearly too narrow, or the
/// coarse one, by a dim light.
fn fine() -> Outcome {
    macro_rules! row {
        ($name:literal, $edge:expr) => {
            let narrow = 1.02 * Cone::narrowest::<Fx16>($edge).to_degrees();
            let cone = Cone::from_outer($edge, Angle::degrees(narrow))?;
            write(concat!($name, "-fine"), &key(cone, NoAttenuation)?.compile::<Fx16>()?)?;
            let dim = |cone| key(cone, InverseSquare)?.with_intensity(1.0)?.compile::<Fx16>();
            write(concat!($name, "-inverse-square-fine"), &dim(cone)?)?;
            write(concat!($name, "-inverse-square-coarse"), &dim(Cone::from_field($edge, FIELD)?)?)?;
        };
    }
    edges!(row);
    Ok(())
}

/// The lit points that have one model each of the library's lists, by the evaluations whose price no other program
/// counts; and those of two pairs of models, which files of other tools have most.
#[derive(Default)]
struct Choices {
    rows: String,
    failed: Option<Box<dyn std::error::Error>>,
}

/// The models whose lit points another program counts by every evaluation.
const EVALUATED: [&str; 5] = ["soft", "hard", "quadratic", "cubic", "inverse-square"];

/// The pairs: a measured light, and a spotlight of Godot.
const PAIRS: [&str; 2] = ["lit-table-inverse-square", "lit-inverted-real-power-decay-square"];

/// Writes the function that visits the rows.
fn choices(Choices { rows, failed }: Choices) -> Outcome {
    failed.map_or(Ok(()), Err)?;
    let file = Path::new(&env::var("OUT_DIR")?).join("choices.rs");
    Ok(fs::write(
        file,
        format!("/// Visits the rows.\npub fn each_choice(visit: &mut impl Visit) {{\n{rows}}}\n"),
    )?)
}

impl Choices {
    /// The rows of a format with one evaluation.
    fn of_format<S: Scalar>() -> Result<Self, Box<dyn std::error::Error>> {
        let mut choices = Self::default();
        choices.power::<S>()?;
        let [table, godot] = PAIRS;
        choices.row("surface", table, &key(field(Table::sample()?)?, InverseSquare)?.compile::<S>()?)?;
        let cone = field(InvertedRealPower::sample()?)?;
        choices.row("surface", godot, &key(cone, fading()?)?.compile::<S>()?)?;
        Ok(choices)
    }

    /// The rows by the quick, the coarse and the fine evaluation.
    fn of_fx16() -> Result<Self, Box<dyn std::error::Error>> {
        let mut choices = Self::default();
        choices.power::<Fx16>()?;
        choices.falloff::<Power<16>>();
        constant_falloffs(&mut choices);
        attenuations(&mut choices);
        let [table, godot] = PAIRS;
        choices.by_each(table, Table::sample()?, InverseSquare)?;
        choices.by_each(godot, InvertedRealPower::sample()?, fading()?)?;
        let point = PointLight::new(POSITION)?.with_color(AMBER)?.compile::<Fx16>()?;
        choices.row("surface", "point-coarse", &point)?;
        let Parts { position, attenuation, intensity, .. } = point.parts();
        // Not of all bits: every point light has points that keep the coarse light, so that it computes both.
        let below = u32::MAX - 1;
        let near: CompiledPointLight<Fx16> =
            CompiledPointLight::from_parts(position, attenuation, intensity, below, point.colors());
        choices.row("surface", "point-fine", &near)?;
        let samples = oval();
        let lamp = lamp(&samples)?.compile::<Fx16>()?;
        choices.row("surface", "measured-coarse", &lamp)?;
        let Parts { position, attenuation, intensity, .. } = lamp.parts();
        let (frame, table, outside) = (lamp.frame(), lamp.distribution(), lamp.outside());
        let colors = lamp.colors();
        let near: CompiledMeasuredLight<'_, Fx16> = CompiledMeasuredLight::from_parts(
            position,
            frame,
            table,
            outside,
            attenuation,
            intensity,
            below,
            colors,
        );
        choices.row("surface", "measured-fine", &near)?;
        Ok(choices)
    }

    /// Adds the row of a power that costs more than the one of the list: their difference is that of products.
    fn power<S: Scalar>(&mut self) -> Outcome {
        self.row("surface", "lit-power-16", &key(field(Power::<16>)?, NoAttenuation)?.compile::<S>()?)
    }

    /// Adds the rows of a falloff and an attenuation by the quick, the coarse and the fine evaluation.
    fn by_each<P: Falloff, A: Attenuation>(&mut self, name: &str, falloff: P, attenuation: A) -> Outcome {
        let cone = field(falloff)?;
        self.row("surface", &format!("{name}-quick"), &key(cone, attenuation)?.compile_quick::<Fx16>()?)?;
        let dim = |cone| key(cone, attenuation)?.with_intensity(1.0);
        self.row("surface", &format!("{name}-coarse"), &dim(cone)?.compile::<Fx16>()?)?;
        self.row("narrow", &format!("{name}-fine"), &finely(&dim(narrow(falloff)?)?)?)
    }

    /// Adds a row whose points are of a kind of inputs, and writes its light.
    fn row(&mut self, inputs: &str, name: &str, light: &impl Source) -> Outcome {
        self.rows += &format!("    lit! {{ visit, {inputs}: {name:?}; }}\n");
        write(name, light)
    }

    /// Keeps the first failure: the visitors of the lists return none.
    fn keep(&mut self, outcome: Outcome) {
        if let Err(error) = outcome {
            self.failed.get_or_insert(error);
        }
    }
}

impl FalloffVisitor for Choices {
    fn falloff<P: ListedFalloff>(&mut self) {
        if EVALUATED.contains(&P::NAME) {
            return;
        }
        let rows = |choices: &mut Self| {
            let (name, falloff) = (format!("lit-{}", P::NAME), P::sample()?);
            let quick = key(field(falloff)?, NoAttenuation)?.compile_quick::<Fx16>()?;
            choices.row("surface", &format!("{name}-quick"), &quick)?;
            choices.row("narrow", &format!("{name}-fine"), &finely(&key(narrow(falloff)?, NoAttenuation)?)?)
        };
        let outcome = rows(self);
        self.keep(outcome);
    }
}

impl AttenuationVisitor for Choices {
    fn attenuation<A: Listed + Attenuation>(&mut self) {
        if EVALUATED.contains(&A::NAME) {
            return;
        }
        let rows = |choices: &mut Self| choices.by_each(&format!("lit-{}", A::NAME), Soft, A::sample()?);
        let outcome = rows(self);
        self.keep(outcome);
    }
}

/// The attenuation of Godot.
fn fading() -> Result<Windowed<Decay>, Error> {
    Windowed::new(Decay::sample()?, FilamentRange::sample()?.range())
}

/// A cone with the field angle of the spotlights.
fn field<P: Falloff>(falloff: P) -> Result<Cone<P>, Error> {
    Cone::from_field(falloff, FIELD)
}

/// A cone that is nearly too narrow, but not narrower than that of the soft edge, in which the points are.
fn narrow<P: Falloff>(falloff: P) -> Result<Cone<P>, Error> {
    let soft = Cone::narrowest::<Fx16>(Soft).to_degrees();
    Cone::from_outer(falloff, Angle::degrees(1.02 * Cone::narrowest::<Fx16>(falloff).to_degrees().max(soft)))
}

/// The light compiled so that all points take the fine evaluation, as those of a steep cone do.
fn finely<P: Falloff, A: Attenuation>(
    spot: &SpotLight<P, A>,
) -> Result<CompiledSpotLight<Fx16, P, A>, Error> {
    let (light, cone) = (spot.compile::<Fx16>()?, spot.cone().compile::<Fx16>()?);
    let Parts { position, attenuation, intensity, cone: parts, .. } = light.parts();
    let ConeParts { axis, outside, .. } = parts.expect("a spotlight has a cone");
    let colors = light.colors();
    let below = u32::MAX;
    Ok(CompiledSpotLight::from_parts(position, axis, cone, outside, attenuation, intensity, below, colors))
}

fn constants<S: Scalar>() -> Outcome {
    listed::<S>()?;
    let cone = Cone::from_field(Soft, FIELD)?;
    spot_of::<S, _, _>("hotspot", cone.with_inner(Angle::degrees(12.0))?, NoAttenuation)?;
    spot_of::<S, _, _>("cutoff", cone.with_cutoff(FIELD)?, NoAttenuation)?;
    write("bright", &key(cone, NoAttenuation)?.with_intensity(BRIGHT)?.compile::<S>()?)?;
    spot_of::<S, _, _>("wide", Cone::from_field(Soft, WIDE_FIELD)?, NoAttenuation)?;
    let narrow = Angle::degrees(1.02 * Cone::narrowest::<Fx16>(Soft).to_degrees());
    write("narrow", &Cone::from_outer(Soft, narrow)?.outer_versine())?;
    write("part", &S::from_f32(0.375))?;
    write("position", &POSITION.map(S::length))?;
    write("radius", &S::length(0.25))?;
    write("axis_back", &SpotLight::new(POSITION, AXIS.map(|c| -c), cone)?.compile::<S>()?.axis())?;
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
    let samples = oval();
    write("measured", &lamp(&samples)?.with_intensity(BRIGHT)?.compile::<S>()?)?;
    write("directional", &DirectionalLight::new(AXIS)?.with_color(AMBER)?.compile::<S>())?;
    write("ambient", &AmbientLight::new(AMBER)?.with_intensity(0.1)?.compile::<S>())?;
    write("exposure", &Exposure::stops(1)?.compile::<S>())?;
    write(
        "ramp",
        &Rgb565Ramp::new(AMBER.map(|channel| 0.09 * channel), AMBER.map(|channel| 0.9 * channel))?,
    )?;
    let cells = format!("{:?}", Palette::new(&PAPER)?.cells());
    fs::write(Path::new(&env::var("OUT_DIR")?).join("cells.rs"), cells)?;
    macro_rules! row {
        ($name:literal, $edge:expr) => {
            spot_of::<S, _, _>(
                concat!($name, "-inverse-square"),
                Cone::from_field($edge, FIELD)?,
                InverseSquare,
            )?;
        };
    }
    edges!(row);
    write("highlight", &Phong::constants::<S>(32))?;
    write("diffuse", &S::from_f32(0.625))?;
    write("specular", &S::from_f32(0.375))?;
    write("matte", &paper()?.compile::<S>())
}

/// Writes a light or a material for each model of the library's lists, as implementations of
/// `Listed`, and the rows of the catalogue.
fn listed<S: Scalar>() -> Outcome {
    let mut models = Models {
        implementations: String::new(),
        lists: String::new(),
        rows: String::new(),
        format: PhantomData::<S>,
    };
    constant_falloffs(&mut models);
    models.list("falloffs");
    attenuations(&mut models);
    models.list("attenuations");
    lobes::<S>(&mut models);
    models.list("lobes");
    let folder = env::var("OUT_DIR")?;
    fs::write(Path::new(&folder).join("listed.rs"), models.implementations)?;
    Ok(fs::write(Path::new(&folder).join("models.rs"), models.lists)?)
}

/// The source of the implementations and of the lists so far, and of the rows of the next list.
struct Models<S> {
    implementations: String,
    lists: String,
    rows: String,
    format: PhantomData<S>,
}

impl<S: Scalar> Models<S> {
    /// Ends a list: a function that visits its rows.
    fn list(&mut self, name: &str) {
        let rows = std::mem::take(&mut self.rows);
        self.lists += &format!("pub(super) fn {name}(visit: &mut impl Visit) {{\n{rows}}}\n");
    }

    /// The irradiance of a spotlight that has the model.
    fn spot<M: Listed, P: Falloff, A: Attenuation>(
        &mut self,
        [name, kind]: [&str; 2],
        (effects, over): (Effects, &str),
        falloff: Result<P, Error>,
        attenuation: Result<A, Error>,
    ) {
        let light = (|| key(Cone::from_field(falloff?, FIELD)?, attenuation?)?.compile::<S>())();
        let light = light.expect(SOUND);
        let effect = "Irradiance { Self::CONSTANT.irradiance(surface.point, surface.normal) }";
        let kind = format!("CompiledSpotLight<Format, {kind}>");
        self.model::<M>([name, &kind, effect], (effects, over), &light);
    }

    fn model<M: Listed>(
        &mut self,
        [name, kind, effect]: [&str; 3],
        (effects, over): (Effects, &str),
        constant: &impl Source,
    ) {
        let (output, _) = effect.split_once(' ').expect("a type and a block");
        let model = M::TYPE;
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
        let with: String = effects.iter().map(|effect| format!(".with(Effect::{effect:?})")).collect();
        let over = if name == over { String::new() } else { format!("\"{over}\"") };
        self.rows += &format!(
            "    visit.effect(
                Entry {{
                    title: {:?}, name: <{model}>::NAME, listed: Some({model:?}),
                    effects: Effects::NONE{with}, over: &[{over}], what: {:?},
                }},
                Inputs::surface,
                <{model}>::effect,
            );\n",
            M::NAME,
            M::DOC
        );
    }
}

/// Why a sample is accepted.
const SOUND: &str = "the parameters of the lists are sound";

/// The lit point of the price list has a soft edge, and needs no further name.
impl<S: Scalar> FalloffVisitor for Models<S> {
    fn falloff<P: ListedFalloff>(&mut self) {
        let name = if P::NAME == "soft" { "lit".to_owned() } else { format!("lit-{}", P::NAME) };
        let kind = format!("{}, NoAttenuation", P::TYPE);
        let falloff: AnyFalloff = P::sample().expect(SOUND).into();
        let effects = Effects::NONE.with(falloff.effect());
        self.spot::<P, _, _>([&name, &kind], (effects, "lit"), P::sample(), Ok(NoAttenuation));
    }
}

/// An attenuation that limits the inverse square to a range is compared with the plain inverse square.
impl<S: Scalar> AttenuationVisitor for Models<S> {
    fn attenuation<A: Listed + Attenuation>(&mut self) {
        let (name, kind) = (format!("lit-{}", A::NAME), format!("Soft, {}", A::TYPE));
        let effects = A::sample().expect(SOUND).effects();
        let shown = if effects.has(Effect::Range) && effects.has(Effect::InverseSquare) {
            let window = effects.iter().filter(|effect| *effect != Effect::InverseSquare);
            (window.fold(Effects::NONE, Effects::with), "lit-inverse-square")
        } else {
            (effects, "lit")
        };
        self.spot::<A, _, _>([&name, &kind], shown, Ok(Soft), A::sample());
    }
}

impl<S: Scalar> LobeVisitor<S> for Models<S> {
    fn lobe<H: Listed + SpecularLobe<Constants<S>: Source> + Named>(&mut self) {
        let grey = Rgb::new(0.5, 0.5, 0.5);
        let surface = (|| paper()?.with_highlight(H::sample()?, grey, 32))();
        let surface = surface.expect(SOUND).compile::<S>();
        let kind = format!("CompiledMaterial<Format, {}>", H::TYPE);
        let effect = "Light { Self::CONSTANT.reflect(&surface, &DIRECTIONAL) }";
        let effects = Effects::NONE.with(Effect::Specular);
        self.model::<H>([H::NAME, &kind, effect], (effects, "matte"), &surface);
    }
}

fn paper() -> Result<Material, Error> {
    Material::new(Rgb::new(0.9, 0.9, 0.85))
}

/// A quadrant of a light that is dark from the horizon on and falls faster to the front than to the side, in 17 by 17 samples.
fn oval() -> [u16; 17 * 17] {
    std::array::from_fn(|i| {
        let [x, y] = [i % 17, i / 17].map(|place| place as f32 / 16.0);
        (65_535.0 * ((1.0 - x - y).max(0.0) * (1.0 - 0.6 * y))).round() as u16
    })
}

/// The light that is not round.
fn lamp(samples: &[u16]) -> Result<MeasuredLight<'_>, Error> {
    MeasuredLight::new(POSITION, AXIS, SIDE, Distribution::new(samples, 33, Symmetry::Quadrant)?)?
        .with_color(AMBER)
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
        .with_intensity(if attenuation.growth() > 0.0 { BRIGHT } else { 1.0 })?
        .with_attenuation(attenuation)
        .with_color(AMBER)
}

fn write(name: &str, value: &impl Source) -> Outcome {
    let file = Path::new(&env::var("OUT_DIR")?).join(name).with_extension("rs");
    Ok(fs::write(file, as_source(value).to_string())?)
}
