//! The list: every row, once.

use luminaire::{
    Angle, Cone, Error, Fx16, Fx32, SpotLight,
    attenuation::NoAttenuation,
    falloff::{FalloffVisitor, ListedFalloff, Power, Soft, constant_falloffs},
    light::LightModel,
    number::Quick,
};
use luminaire_oracle as oracle;

use crate::{
    double::{DoubleFalloff, DoublePoint},
    kernel::{Row, Visitor},
    ours::{Highlit, OurFalloff, OurPoint},
    rival::{self, cosine},
    scene::{AXIS, EYE, INTENSITY, POSITION, Population},
    truth::{Highlight, Point, widened},
    value::Format,
};

/// The cone that kernels are set up for.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Setting {
    outer: Angle,
}

impl Setting {
    /// A soft edge's field angle of 36 degrees: wide enough that no format comes near its limits.
    /// Costs are counted here.
    pub fn standard() -> Self {
        Self::ending_at(cone(Cone::from_field(Soft, Angle::degrees(36.0))).outer())
    }

    /// The cone that ends at this angle, of more than 0 and at most 180 degrees.
    pub fn ending_at(outer: impl Into<Angle>) -> Self {
        Self { outer: outer.into() }
    }

    /// Where the cone ends.
    pub fn outer(self) -> Angle {
        self.outer
    }

    /// The versine of half the angle where the cone ends, as compiled cones have it.
    pub fn outer_versine(self) -> f32 {
        self.cone(Soft).outer_versine()
    }

    fn cone<P: ListedFalloff>(self, falloff: P) -> Cone<P> {
        cone(Cone::from_outer(falloff, self.outer))
    }

    /// The exponent with which the power of a cosine has the field angle of the soft cone.
    fn exponent(self) -> f32 {
        let field = self.cone(Soft).field().versine();
        -core::f32::consts::LN_10 / libm::log1pf(-field)
    }

    fn truth<P: ListedFalloff>(self) -> oracle::Cone {
        oracle::Cone::new(exact::<P>, self.outer_versine().into())
    }
}

/// Returns the intensity in f64 by the formula of the sample: what kernels are compared with.
fn exact<P: ListedFalloff>(t: f64) -> f64 {
    sample::<P>().formula().exact(t)
}

/// Returns the falloff of the list.
fn sample<P: ListedFalloff>() -> P {
    P::sample().expect("the parameters of the list are sound")
}

fn cone<P>(made: Result<Cone<P>, Error>) -> Cone<P> {
    made.expect("an angle of more than 0 and at most 180 degrees")
}

/// Every kernel from the angle off axis to an intensity.
pub fn falloffs(setting: Setting, visitor: &mut impl Visitor) {
    let mut formats = Formats { setting, visitor };
    constant_falloffs(&mut formats);
    formats.falloff::<Power<16>>();
    rivals(setting, visitor);
}

/// Visits a falloff in every format.
struct Formats<'a, V> {
    setting: Setting,
    visitor: &'a mut V,
}

impl<V: Visitor> FalloffVisitor for Formats<'_, V> {
    fn falloff<P: ListedFalloff>(&mut self) {
        let Self { setting, ref mut visitor } = *self;
        let (cone, truth) = (setting.cone(sample::<P>()), setting.truth::<P>());
        ours::<Fx16, P>(&cone, &truth, *visitor);
        ours::<Fx32, P>(&cone, &truth, *visitor);
        ours::<f32, P>(&cone, &truth, *visitor);
        let double = DoubleFalloff::<P>::new(setting.outer_versine());
        visitor.falloff(Row::falloff(P::NAME, "f64"), double, &truth);
    }
}

fn ours<S: Format, P: ListedFalloff>(cone: &Cone<P>, truth: &oracle::Cone, visitor: &mut impl Visitor) {
    let row = Row::falloff(P::NAME, S::NAME);
    match cone.compile::<S>() {
        Ok(falloff) => visitor.falloff(row, OurFalloff::new(falloff, cone.outer_versine()), truth),
        Err(_) => visitor.refused(row, narrowest::<S, P>()),
    }
}

/// The methods of others, at the same outer angle, or the same field angle if the model has no
/// outer angle.
fn rivals(setting: Setting, visitor: &mut impl Visitor) {
    let row = |kernel| Row::falloff(kernel, "rival");
    let (exponent, outer) = (setting.exponent(), cosine(setting.outer_versine()));
    let power = oracle::Cone::opengl(exponent.into(), 1.0);
    let soft = setting.truth::<Soft>();
    visitor.falloff(row("powf-libm"), rival::Powf::<rival::Libm>::new(exponent), &power);
    #[cfg(feature = "std")]
    visitor.falloff(row("powf-std"), rival::Powf::<rival::Std>::new(exponent), &power);
    visitor.falloff(row("table-256"), rival::CosineTable::new(exponent), &power);
    visitor.falloff(row("gltf"), rival::Gltf::new(outer), &soft);
}

/// Every kernel from a position and a normal to the irradiance, early-outs included.
pub fn points(setting: Setting, visitor: &mut impl Visitor) {
    format::<Fx16>(setting, visitor);
    format::<Fx32>(setting, visitor);
    format::<f32>(setting, visitor);
    quick::<Fx16>("fx16-quick", setting, visitor);
    doubles(setting, visitor);
}

/// The points in f64.
pub fn doubles(setting: Setting, visitor: &mut impl Visitor) {
    let outer = setting.outer_versine();
    for (kernel, population) in REJECTS.into_iter().chain([("lit", Population::Lit)]) {
        let truth = light_of::<Soft>(setting, population, 1.0, false);
        visitor.point(Row::lit(kernel, "f64"), DoublePoint::new(outer), &truth);
    }
}

const REJECTS: [(&str, Population); 2] = [("away", Population::Away), ("outside", Population::Outside)];

/// The points by the standard evaluation of a format, with those of a highlight.
fn format<S: Format>(setting: Setting, visitor: &mut impl Visitor) {
    let (spot, falling) = spots::<Soft>(setting);
    rejects::<S>(S::NAME, &spot.compile(), setting, visitor);
    lit::<S, Soft>(lit_rows(S::NAME), (spot.compile(), falling.compile()), setting, visitor);
    let surface = oracle::Classic {
        ambient: [0.0; 2],
        diffuse: [Highlit::<S>::DIFFUSE.into(), 1.0],
        specular: [Highlit::<S>::SPECULAR.into(), 1.0],
        shininess: Highlit::<S>::SHININESS.into(),
    };
    let highlight = Some(Highlight { eye: widened(EYE), surface });
    let [_, far] = lit_truths::<Soft>(setting);
    let row = Row::lit("lit-specular", S::NAME);
    match Highlit::<S>::new(&falling) {
        Ok(highlit) => visitor.point(row, highlit, &Point { highlight, ..far }),
        Err(_) => visitor.refused(row, narrowest::<S, Soft>()),
    }
}

/// The points by the quick evaluation of a format.
fn quick<S: Format + Quick>(name: &'static str, setting: Setting, visitor: &mut impl Visitor) {
    let (spot, falling) = spots::<Soft>(setting);
    rejects::<S>(name, &spot.compile_quick(), setting, visitor);
    lit::<S, Soft>(lit_rows(name), (spot.compile_quick(), falling.compile_quick()), setting, visitor);
}

/// The points that a light does not reach.
fn rejects<S: Format>(
    name: &'static str,
    light: &Result<impl LightModel<S>, Error>,
    setting: Setting,
    visitor: &mut impl Visitor,
) {
    for (kernel, population) in REJECTS {
        let row = Row::lit(kernel, name);
        let truth = light_of::<Soft>(setting, population, 1.0, false);
        match light {
            Ok(light) => visitor.point(row, OurPoint::new(*light), &truth),
            Err(_) => visitor.refused(row, narrowest::<S, Soft>()),
        }
    }
}

/// The spotlights of lit points: without attenuation, and bright with an inverse square.
fn spots<P: ListedFalloff>(setting: Setting) -> (SpotLight<P, NoAttenuation>, SpotLight<P>) {
    let bright = spot(setting).with_intensity(INTENSITY).expect("a sound intensity");
    (spot(setting).with_attenuation(NoAttenuation), bright)
}

fn lit<S: Format, P: ListedFalloff>(
    rows: [Row; 2],
    lights: (Result<impl LightModel<S>, Error>, Result<impl LightModel<S>, Error>),
    setting: Setting,
    visitor: &mut impl Visitor,
) {
    let (Ok(spot), Ok(falling)) = lights else {
        return rows.into_iter().for_each(|row| visitor.refused(row, narrowest::<S, P>()));
    };
    let [level, far] = lit_truths::<P>(setting);
    visitor.point(rows[0], OurPoint::new(spot), &level);
    visitor.point(rows[1], OurPoint::new(falling), &far);
}

/// The rows of a lit point, without and with an inverse square.
fn lit_rows(name: &'static str) -> [Row; 2] {
    ["lit", "lit-inverse-square"].map(|kernel| Row::lit(kernel, name))
}

fn lit_truths<P: ListedFalloff>(setting: Setting) -> [Point; 2] {
    [(1.0, false), (INTENSITY, true)]
        .map(|(intensity, falls)| light_of::<P>(setting, Population::Lit, intensity, falls))
}

/// The narrowest half angle in degrees that a format holds.
fn narrowest<S: Format, P: ListedFalloff>() -> f32 {
    Cone::narrowest::<S>(sample::<P>()).to_degrees() / 2.0
}

fn spot<P: ListedFalloff>(setting: Setting) -> SpotLight<P> {
    SpotLight::new(POSITION, AXIS, setting.cone(sample::<P>())).expect("a sound place and axis")
}

pub(crate) fn light_of<P: ListedFalloff>(
    setting: Setting,
    population: Population,
    intensity: f32,
    falls: bool,
) -> Point {
    let light = oracle::SpotLight::new(widened(POSITION), widened(AXIS), setting.truth::<P>());
    let attenuation = if falls { light.attenuation } else { oracle::Attenuation::None };
    let light = oracle::SpotLight { intensity: intensity.into(), attenuation, ..light };
    Point { light, highlight: None, population }
}
