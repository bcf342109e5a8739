//! Every model, as a function of a case.

mod beam;
mod display;
mod falloff;
mod light;
mod material;
mod seam;

use core::marker::PhantomData;

use luminaire::{
    Fx16, Fx32,
    attenuation::{
        Attenuation, AttenuationVisitor, CutAt, Decay, FilamentRange, GltfRange, InverseSquare,
        NoAttenuation, Polynomial, SmoothRange, attenuations,
    },
    falloff::{
        Cubic, FalloffVisitor, Hard, ListedFalloff, Power, Quadratic, Soft, SoftOrHard, SoftPair, Table,
        constant_falloffs,
    },
    specular::{BlinnPhong, DifferenceForm, DualConeLobe, MirroredPhong, NoSpecular, Phong},
};

use crate::case::{Case, Evaluate, Outcome};
use crate::word::Format;

/// A model in the formats that it has.
#[derive(Clone, Copy, Debug)]
pub struct Model {
    /// The first word of its name in the file, with a space; empty if `name` is the whole name.
    pub kind: &'static str,
    /// The rest of its name in the file.
    pub name: &'static str,
    /// The model in each of its [`formats`](Self::formats); only in the first if the model belongs to
    /// set-up.
    pub runs: &'static [Evaluate],
}

impl Model {
    /// Returns the formats, as the file names them. The quick evaluation is of `fx16` alone.
    pub fn formats(&self) -> &'static [&'static str] {
        if self.name.starts_with("quick ") { &["fx16"] } else { &["f32", "fx16", "fx32"] }
    }

    /// Returns whether this is the model's name in the file.
    fn is_named(&self, name: &str) -> bool {
        name.strip_prefix(self.kind) == Some(self.name)
    }
}

/// Finds the model of a section such as `spot soft fx16`.
pub(crate) fn find(section: &str) -> Option<Evaluate> {
    let (name, format) = section.rsplit_once(' ')?;
    let mut found = None;
    each_model(&mut |model| {
        if model.is_named(name) {
            let runs = model.formats().iter().zip(model.runs);
            found = runs.filter(|(known, _)| **known == format).map(|(_, run)| *run).next();
        }
    });
    found
}

/// A model in every format. Its expression refers to the format by the name `$format`.
macro_rules! each {
    ($name:expr, $format:ident, $case:ident => $outcome:expr) => {
        Model {
            kind: "",
            name: $name,
            runs: &[
                |$case| {
                    type $format = f32;
                    $outcome
                },
                |$case| {
                    type $format = Fx16;
                    $outcome
                },
                |$case| {
                    type $format = Fx32;
                    $outcome
                },
            ],
        }
    };
}

/// A model of set-up, which is computed in f32 whatever the format.
macro_rules! once {
    ($name:expr, $case:ident => $outcome:expr) => {
        Model { kind: "", name: $name, runs: &[|$case| $outcome] }
    };
}

fn quadratic(case: &mut Case<'_>) -> Result<Quadratic, luminaire::Error> {
    Quadratic::new(case.number("edge slope of a quadratic"))
}

fn cubic(case: &mut Case<'_>) -> Result<Cubic, luminaire::Error> {
    let (edge, middle) = (case.number("edge slope"), case.number("middle slope"));
    Cubic::with_slopes(edge, middle)
}

fn soft_pair(case: &mut Case<'_>) -> Result<SoftPair, luminaire::Error> {
    let (share, ratio) = (case.number("share"), case.number("ratio"));
    SoftPair::new(share, ratio)
}

fn table(_: &mut Case<'_>) -> Result<Table<'static>, luminaire::Error> {
    Table::new(&falloff::SAMPLES)
}

fn polynomial(case: &mut Case<'_>) -> Result<Polynomial, luminaire::Error> {
    let [constant, linear, quadratic] = falloff::components(case.vector("coefficients"));
    Polynomial::new(constant, linear, quadratic)
}

fn decay(case: &mut Case<'_>) -> Result<Decay, luminaire::Error> {
    let (exponent, most) = (case.number("exponent"), case.number("cap"));
    Decay::new(exponent, most)
}

fn range(case: &mut Case<'_>) -> f32 {
    case.number("range")
}

/// Visits all models: first the cones, falloffs and attenuations of the library's lists. A model in `WRITTEN`
/// replaces the model of the list with the same name: its parameters are inputs.
pub fn each_model(visit: &mut dyn FnMut(&Model)) {
    for kind in ["cone ", "falloff "] {
        constant_falloffs(&mut Listed { kind, visit });
    }
    attenuations(&mut Listed { kind: "point ", visit });
    WRITTEN.iter().for_each(visit);
}

/// Visits the models of one kind: `cone `, `falloff ` or `point `.
struct Listed<'a> {
    kind: &'static str,
    visit: &'a mut dyn FnMut(&Model),
}

impl FalloffVisitor for Listed<'_> {
    fn falloff<P: ListedFalloff>(&mut self) {
        let runs = if self.kind == "cone " { Runs::<P>::CONE } else { Runs::<P>::FALLOFF };
        self.listed(P::NAME, runs);
    }
}

impl AttenuationVisitor for Listed<'_> {
    fn attenuation<A: luminaire::models::Listed + Attenuation>(&mut self) {
        self.listed(A::NAME, Points::<A>::RUNS);
    }
}

impl Listed<'_> {
    fn listed(&mut self, name: &'static str, runs: &'static [Evaluate]) {
        let model = Model { kind: self.kind, name, runs };
        if !WRITTEN.iter().any(|written| model.is_named(written.name)) {
            (self.visit)(&model);
        }
    }
}

/// The runs of an attenuation of the list.
struct Points<A>(PhantomData<A>);

impl<A: luminaire::models::Listed + Attenuation> Points<A> {
    const RUNS: &'static [Evaluate] = &[Self::point::<f32>, Self::point::<Fx16>, Self::point::<Fx32>];

    fn point<S: Format>(case: &mut Case<'_>) -> Outcome {
        light::point::<S, A>(case, |_| A::sample())
    }
}

/// The runs of a falloff of the list.
struct Runs<P>(PhantomData<P>);

impl<P: ListedFalloff> Runs<P> {
    const CONE: &'static [Evaluate] = &[|case| falloff::cone::<P>(case, |_| P::sample())];
    const FALLOFF: &'static [Evaluate] =
        &[Self::falloff::<f32>, Self::falloff::<Fx16>, Self::falloff::<Fx32>];

    fn falloff<S: Format>(case: &mut Case<'_>) -> Outcome {
        falloff::falloff::<S, P>(case, |_| P::sample())
    }
}

static WRITTEN: &[Model] = &[
    once!("cone quadratic", case => falloff::cone(case, quadratic)),
    once!("cone cubic", case => falloff::cone(case, cubic)),
    once!("cone power-15", case => falloff::cone(case, |_| Ok(Power::<15>))),
    once!("cone table", case => falloff::cone(case, table)),
    once!("cone two-angles", case => falloff::two_angles(case)),
    once!("cone two-angles-and-slope", case => falloff::two_angles_and_slope(case)),
    once!("cone opengl-15", case => falloff::opengl(case)),
    each!("falloff quadratic", S, case => falloff::falloff::<S, _>(case, quadratic)),
    each!("falloff cubic", S, case => falloff::falloff::<S, _>(case, cubic)),
    each!("falloff soft-pair", S, case => falloff::falloff::<S, _>(case, soft_pair)),
    each!("falloff power-1", S, case => falloff::falloff::<S, _>(case, |_| Ok(Power::<1>))),
    each!("falloff power-15", S, case => falloff::falloff::<S, _>(case, |_| Ok(Power::<15>))),
    each!("falloff power-128", S, case => falloff::falloff::<S, _>(case, |_| Ok(Power::<128>))),
    each!("falloff table", S, case => falloff::falloff::<S, _>(case, table)),
    each!("spot soft", S, case => light::spot::<S, _>(case, |_| Ok(Soft))),
    each!("spot hard", S, case => light::spot::<S, _>(case, |_| Ok(Hard))),
    each!("spot either-edge", S, case => light::spot::<S, _>(case, |_| Ok(SoftOrHard::Hard))),
    Model { kind: "", name: "quick soft", runs: &[|case| light::quick::<Fx16, _>(case, Soft)] },
    Model { kind: "", name: "quick hard", runs: &[|case| light::quick::<Fx16, _>(case, Hard)] },
    each!("spot between", S, case => light::between::<S>(case)),
    each!("point unattenuated", S, case => light::point::<S, _>(case, |_| Ok(NoAttenuation))),
    each!("point inverse-square", S, case => light::point::<S, _>(case, |_| Ok(InverseSquare))),
    each!("point polynomial", S, case => light::point::<S, _>(case, polynomial)),
    each!("point smooth-range", S, case => light::point::<S, _>(case, |case| SmoothRange::new(range(case)))),
    each!("point decay", S, case => light::point::<S, _>(case, decay)),
    each!("point gltf-range", S, case => light::point::<S, _>(case, |case| GltfRange::new(InverseSquare, Some(range(case))))),
    each!("point gltf-range-without-range", S, case => light::point::<S, _>(case, |_| GltfRange::new(InverseSquare, None))),
    each!("point filament-range", S, case => {
        light::point::<S, _>(case, |case| FilamentRange::new(InverseSquare, Some(range(case))))
    }),
    each!("point cut-at", S, case => {
        light::point::<S, _>(case, |case| CutAt::new(NoAttenuation, Some(range(case))))
    }),
    each!("measured level", S, case => light::measured::<S>(case, &light::LEVEL)),
    each!("measured steep", S, case => light::measured::<S>(case, &light::STEEP)),
    each!("place", S, case => beam::place::<S>(case)),
    each!("gobo", S, case => beam::gobo::<S>(case)),
    each!("shadow", S, case => beam::shadow::<S>(case)),
    once!("air-light", case => beam::in_scattering(case)),
    each!("directional", S, case => light::directional::<S>(case)),
    each!("ambient", S, case => light::ambient::<S>(case)),
    each!("reflect matte", S, case => material::reflect::<S, _>(case, NoSpecular)),
    each!("reflect phong", S, case => material::reflect::<S, _>(case, Phong)),
    each!("reflect mirrored-phong", S, case => material::reflect::<S, _>(case, MirroredPhong)),
    each!("reflect blinn-phong", S, case => material::reflect::<S, _>(case, BlinnPhong)),
    each!("reflect dual-cone", S, case => material::reflect::<S, _>(case, DualConeLobe)),
    each!("reflect difference-form-2-phong", S, case => material::reflect::<S, _>(case, DifferenceForm::<_, 2>(Phong))),
    each!("reflect difference-form-3-blinn-phong", S, case => material::reflect::<S, _>(case, DifferenceForm::<_, 3>(BlinnPhong))),
    each!("glow", S, case => material::glow::<S>(case)),
    each!("view", S, case => material::view::<S>(case)),
    each!("lit-point", S, case => material::lit_point::<S>(case)),
    each!("expose", S, case => display::expose::<S>(case)),
    each!("clip", S, case => display::clip::<S>(case)),
    each!("keep-hue", S, case => display::compress_keep_hue::<S>(case)),
    each!("srgb", S, case => display::srgb::<S>(case)),
    each!("rgb565", S, case => display::rgb565::<S>(case)),
    each!("srgb-dithered", S, case => display::srgb_dithered::<S>(case)),
    each!("rgb565-dithered", S, case => display::rgb565_dithered::<S>(case)),
    once!("decode-srgb", case => display::decode(case)),
    each!("convert", S, case => seam::convert::<S>(case)),
    each!("arithmetic", S, case => seam::arithmetic::<S>(case)),
    each!("light", S, case => seam::light::<S>(case)),
];
