//! The list: every row, once.

use luminaire::{
    Angle, Cone, Error, Fx16, Fx32, Scalar, SpotLight,
    attenuation::{Attenuation, NoAttenuation},
    falloff::{FalloffVisitor, ListedFalloff, Power, Smooth, Soft, constant_falloffs},
    light::LightModel,
    number::Quick,
};
use luminaire_oracle as oracle;

use crate::{
    cosine::cosine,
    double::{DoubleFalloff, DoublePoint},
    falloff::{exact, sample},
    kernel::{Row, Visitor},
    ours::{Highlit, OurFalloff, OurPoint},
    rival,
    scene::{AXIS, EYE, POSITION, Population},
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

fn cone<P>(made: Result<Cone<P>, luminaire::Error>) -> Cone<P> {
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
        shape::<P>(self.setting, self.visitor);
    }
}

/// A falloff in every format.
fn shape<P: ListedFalloff>(setting: Setting, visitor: &mut impl Visitor) {
    let falloff = sample::<P>();
    let cone = setting.cone(falloff);
    let truth = setting.truth::<P>();
    ours::<Fx16, P>(&cone, &truth, visitor);
    ours::<Fx32, P>(&cone, &truth, visitor);
    ours::<f32, P>(&cone, &truth, visitor);
    let double = DoubleFalloff::<P>::new(setting.outer_versine());
    visitor.falloff(Row::falloff(P::NAME, "f64"), double, &truth);
}

fn ours<S: Format, P: ListedFalloff>(cone: &Cone<P>, truth: &oracle::Cone, visitor: &mut impl Visitor) {
    let row = Row::falloff(P::NAME, S::NAME);
    match cone.compile::<S>() {
        Ok(falloff) => visitor.falloff(row, OurFalloff::new(falloff, cone.outer_versine()), truth),
        Err(_) => visitor.refused(row, Cone::narrowest::<S>(cone.falloff()).to_degrees() / 2.0),
    }
}

/// The methods of others, at the same outer angle, or the same field angle if the model has no
/// outer angle.
fn rivals(setting: Setting, visitor: &mut impl Visitor) {
    let row = |kernel| Row::falloff(kernel, "rival");
    let (exponent, outer) = (setting.exponent(), cosine(setting.outer_versine()));
    let power = oracle::Cone::opengl(exponent.into(), 1.0);
    let soft = setting.truth::<Soft>();
    let smooth = setting.truth::<Smooth>();
    visitor.falloff(row("powf-libm"), rival::Powf::<rival::Libm>::new(exponent), &power);
    #[cfg(feature = "std")]
    visitor.falloff(row("powf-std"), rival::Powf::<rival::Std>::new(exponent), &power);
    visitor.falloff(row("powf-micromath"), rival::Powf::<rival::Micromath>::new(exponent), &power);
    visitor.falloff(row("table-256"), rival::CosineTable::new(exponent), &power);
    visitor.falloff(row("schlick"), rival::Schlick::new(exponent), &power);
    visitor.falloff(row("smoothstep"), rival::Smoothstep::new(outer), &smooth);
    visitor.falloff(row("gltf"), rival::Gltf::new(outer), &soft);
    let cosine = oracle::Cone::opengl(1.0, 1.0);
    visitor.falloff(row("clamp"), rival::Clamp, &cosine);
}

/// Every kernel from a position and a normal to the irradiance, early-outs included.
pub fn points(setting: Setting, visitor: &mut impl Visitor) {
    format::<Fx16>(setting, visitor);
    format::<Fx32>(setting, visitor);
    format::<f32>(setting, visitor);
    quick::<Fx16>("fx16-quick", setting, visitor);
    quick::<f32>("f32-quick", setting, visitor);
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

/// Intensity of the light with an inverse square: full scale at a distance of 4.
const INTENSITY: f32 = 16.0;

fn format<S: Format>(setting: Setting, visitor: &mut impl Visitor) {
    let near = light_of::<Soft>(setting, Population::Lit, 1.0, false);
    let far = light_of::<Soft>(setting, Population::Lit, INTENSITY, true);
    let surface = oracle::Classic {
        ambient: [0.0; 2],
        diffuse: [Highlit::<S>::DIFFUSE.into(), 1.0],
        specular: [Highlit::<S>::SPECULAR.into(), 1.0],
        shininess: Highlit::<S>::SHININESS.into(),
    };
    let shiny = Point { highlight: Some(Highlight { eye: widened(EYE), surface }), ..far };
    let refused = Cone::narrowest::<S>(Soft).to_degrees() / 2.0;
    let (spot, falling) = spots::<Soft>(setting);
    let Ok(highlit) = Highlit::<S>::new(&falling) else {
        for kernel in ["away", "outside", "lit", "lit-inverse-square", "lit-specular"] {
            visitor.refused(Row::lit(kernel, S::NAME), refused);
        }
        return;
    };
    for (kernel, population) in REJECTS {
        point::<S, _>(kernel, &spot, &light_of::<Soft>(setting, population, 1.0, false), visitor);
    }
    point::<S, _>("lit", &spot, &near, visitor);
    point::<S, _>("lit-inverse-square", &falling, &far, visitor);
    visitor.point(Row::lit("lit-specular", S::NAME), highlit, &shiny);
}

/// The points by the quick evaluation of a format.
fn quick<S: Format + Quick>(name: &'static str, setting: Setting, visitor: &mut impl Visitor) {
    let (spot, falling) = spots::<Soft>(setting);
    for (kernel, population) in REJECTS {
        if let Ok(light) = spot.compile_quick::<S>() {
            let truth = light_of::<Soft>(setting, population, 1.0, false);
            visitor.point(Row::lit(kernel, name), OurPoint::new(light), &truth);
        } else {
            visitor.refused(Row::lit(kernel, name), narrowest::<S, Soft>());
        }
    }
    let rows = LIT.map(|kernel| Row::lit(kernel, name));
    lit::<S, Soft>(rows, (spot.compile_quick(), falling.compile_quick()), setting, visitor);
}

/// The lit points of a cone with the edge `P`, without and with an inverse square, in every format
/// and by every evaluation.
pub fn rungs<P: ListedFalloff>(kernels: [&'static str; 2], setting: Setting, visitor: &mut impl Visitor) {
    let rows = |format| kernels.map(|kernel| Row::lit(kernel, format));
    let (spot, falling) = spots::<P>(setting);
    lit::<Fx16, P>(rows("fx16-quick"), (spot.compile_quick(), falling.compile_quick()), setting, visitor);
    lit::<Fx16, P>(rows(Fx16::NAME), (spot.compile(), falling.compile()), setting, visitor);
    lit::<Fx32, P>(rows(Fx32::NAME), (spot.compile(), falling.compile()), setting, visitor);
    lit::<f32, P>(rows("f32-quick"), (spot.compile_quick(), falling.compile_quick()), setting, visitor);
    lit::<f32, P>(rows(f32::NAME), (spot.compile(), falling.compile()), setting, visitor);
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

/// The kernels of a lit point, without and with an inverse square.
const LIT: [&str; 2] = ["lit", "lit-inverse-square"];

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

fn light_of<P: ListedFalloff>(
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

fn point<S: Format, A: Attenuation>(
    kernel: &'static str,
    spot: &SpotLight<Soft, A>,
    truth: &Point,
    visitor: &mut impl Visitor,
) {
    if let Ok(light) = spot.compile::<S>() {
        visitor.point(Row::lit(kernel, S::NAME), OurPoint::new(light), truth);
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use std::collections::HashSet;
    use std::vec::Vec;

    use super::*;
    use crate::kernel::Kernel;
    use crate::scene::{Site, Sites};
    use crate::value::Value;

    /// Collects the names, and compares every kernel coarsely with its exact model.
    #[derive(Default)]
    struct Census {
        rows: Vec<Row>,
        refused: Vec<Row>,
        worst: f64,
        outer: f32,
    }

    impl Visitor for Census {
        fn falloff<K: Kernel<Place = f32>>(&mut self, row: Row, kernel: K, truth: &oracle::Cone) {
            self.rows.push(row);
            for i in 0..100 {
                let versine = self.outer * (i as f32 + 0.5) / 100.0;
                let error = kernel.evaluate(&kernel.input(&versine)).exact() - truth.falloff(versine.into());
                self.worst =
                    self.worst.max(if row.format == "rival" { 0.0 } else { oracle::counted(error.abs()) });
            }
        }

        fn point<K: Kernel<Place = Site>>(&mut self, row: Row, kernel: K, truth: &Point) {
            self.rows.push(row);
            for site in Sites::new(truth.population, self.outer).take(256) {
                let (light, exact) = (kernel.evaluate(&kernel.input(&site)).exact(), truth.at(&site));
                if truth.population == Population::Lit {
                    assert!(exact > 0.0, "{row:?} has a site that is dark");
                    let error = (light - exact).abs() / exact.max(1.0);
                    self.worst = self.worst.max(oracle::counted(error));
                } else {
                    assert_eq!((light, exact), (0.0, 0.0), "{row:?} has a site that is lit");
                }
            }
        }

        fn refused(&mut self, row: Row, _: f32) {
            self.refused.push(row);
        }
    }

    fn census(setting: Setting) -> Census {
        let mut census = Census { outer: setting.outer_versine(), ..Census::default() };
        falloffs(setting, &mut census);
        points(setting, &mut census);
        census
    }

    #[test]
    fn every_kernel_stands_beside_its_own_truth_and_no_name_twice() {
        let census = census(Setting::standard());
        assert!(census.worst < 1e-3, "off by {}", census.worst);
        let names: HashSet<_> = census.rows.iter().map(|row| (row.kernel, row.format)).collect();
        assert_eq!((names.len(), census.refused.len()), (census.rows.len(), 0));
        assert!(census.rows.iter().all(|row| !row.kernel.contains(' ')));
    }

    #[test]
    fn what_a_format_cannot_hold_is_told() {
        let census = census(Setting::ending_at(Angle::degrees(2.0)));
        let refused = |kernel| census.refused.iter().any(|row| (row.kernel, row.format) == (kernel, "fx16"));
        assert!(refused("hard") && !refused("soft"));
    }
}
