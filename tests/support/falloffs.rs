//! Every falloff of the kernel beside its reference: the list that the sweeps iterate over.

use super::{oracle, sweep};
use luminaire::{
    Cone, Scalar,
    falloff::{
        AnyFalloff, Cubic, Falloff, FalloffVisitor, InvertedPower, ListedFalloff, Power, Quadratic, Soft,
        falloffs,
    },
};

pub fn quadratic() -> Quadratic {
    Quadratic::new(0.5).expect("a sound slope")
}

pub fn cubic() -> Cubic {
    Cubic::with_slopes(1.25, 3.5).expect("sound slopes")
}

/// A cone of the kernel and its exact model, both functions of the outer half angle in degrees.
pub struct Shape<P> {
    pub name: &'static str,
    pub cone: fn(P, f32) -> Cone<P>,
    pub falloff: P,
    pub exact: fn(oracle::Falloff, f64) -> oracle::Cone,
    pub oracle: oracle::Falloff,
}

impl<P: Falloff> Shape<P> {
    /// The falloff from the axis to the edge.
    pub fn plain(name: &'static str, falloff: P, oracle: oracle::Falloff) -> Self {
        Self { name, cone: plain, falloff, exact: oracle::Cone::new, oracle }
    }

    /// The falloff around a hotspot whose versine is half the outer one, up to the roundings of
    /// f32.
    pub fn hotspot(name: &'static str, falloff: P, oracle: oracle::Falloff) -> Self {
        Self { name, cone: hotspot, falloff, exact: exact_hotspot, oracle }
    }

    /// The falloff, cut off at 0.75 of its half angle.
    pub fn with_cutoff(name: &'static str, falloff: P, oracle: oracle::Falloff) -> Self {
        Self { name, cone: with_cutoff, falloff, exact: exact_cut, oracle }
    }

    pub fn at(&self, half_degrees: f32) -> Cone<P> {
        (self.cone)(self.falloff, half_degrees)
    }

    /// The narrowest half angle of a format in degrees, plus a margin for the rounding of an angle.
    pub fn narrowest<S: Scalar>(&self) -> f32 {
        Cone::narrowest::<S>(self.falloff).to_degrees() / 2.0 * 1.000_01
    }

    pub fn exactly_at(&self, half_degrees: f32) -> oracle::Cone {
        (self.exact)(self.oracle, oracle::versine(half_degrees.into()))
    }

    /// The versines that the cone has compiled, which are those of f32.
    pub fn stored_at(&self, half_degrees: f32) -> oracle::Cone {
        let f32_of = |half: f32| f64::from(luminaire::Angle::from(sweep::half(half)).versine());
        let mut exact = (self.exact)(self.oracle, f32_of(half_degrees));
        if exact.inner > 0.0 {
            exact.inner = f32_of(half_degrees * HOTSPOT);
        }
        if exact.limit < exact.outer {
            exact.limit = f64::from(self.at(half_degrees).outer_versine());
        }
        exact
    }
}

impl<P: ListedFalloff> Shape<P> {
    /// The falloff of the list.
    pub fn listed() -> Self {
        Self::plain(P::NAME, sound(P::sample()), P::truth)
    }
}

impl<const N: u32> Shape<Power<N>> {
    /// OpenGL's spotlight with its cutoff at the half angle.
    pub fn opengl(name: &'static str, oracle: oracle::Falloff) -> Self {
        let cone = |_: Power<N>, half| Cone::opengl(sweep::half(half)).expect("a sound cutoff");
        Self { name, cone, falloff: Power, exact: |_, cutoff| oracle::Cone::opengl(N.into(), cutoff), oracle }
    }
}

/// A [`Shape`] whose falloff is chosen at run time, for laws that do not depend on how it is
/// chosen: one type for all shapes compiles in a fraction of the time.
pub struct AnyShape {
    pub name: &'static str,
    cone: Box<dyn Fn(f32) -> Cone<AnyFalloff>>,
}

impl AnyShape {
    pub fn at(&self, half_degrees: f32) -> Cone<AnyFalloff> {
        (self.cone)(half_degrees)
    }

    /// Every shape of [`every_shape`].
    pub fn all() -> Vec<Self> {
        fn of<P: Falloff + Into<AnyFalloff> + 'static>(shape: &Shape<P>) -> AnyShape {
            let (name, cone, falloff) = (shape.name, shape.cone, shape.falloff);
            let cone = move |half_degrees| cone(falloff, half_degrees).with_falloff(falloff.into());
            AnyShape { name, cone: Box::new(cone) }
        }
        crate::with_every_shape!(of -> AnyShape)
    }
}

/// The inner half angle of a hotspot, and the cutoff, as fractions of the outer half angle.
const HOTSPOT: f32 = 0.5;
const CUTOFF: f32 = 0.75;

fn plain<P: Falloff>(falloff: P, half_degrees: f32) -> Cone<P> {
    Cone::from_outer(falloff, sweep::half(half_degrees)).expect("a sound cone")
}

fn hotspot<P: Falloff>(falloff: P, half_degrees: f32) -> Cone<P> {
    let cone = plain(falloff, half_degrees);
    cone.with_inner(sweep::half(half_degrees * HOTSPOT)).expect("a sound hotspot")
}

fn with_cutoff<P: Falloff>(falloff: P, half_degrees: f32) -> Cone<P> {
    let cone = plain(falloff, half_degrees);
    cone.with_cutoff(sweep::half(half_degrees * CUTOFF)).expect("a sound cutoff")
}

fn exact_hotspot(falloff: oracle::Falloff, outer: f64) -> oracle::Cone {
    let inner = oracle::versine(oracle::half_degrees(outer) * f64::from(HOTSPOT));
    oracle::Cone { inner, ..oracle::Cone::new(falloff, outer) }
}

fn exact_cut(falloff: oracle::Falloff, outer: f64) -> oracle::Cone {
    let limit = oracle::versine(oracle::half_degrees(outer) * f64::from(CUTOFF));
    oracle::Cone { limit, ..oracle::Cone::new(falloff, outer) }
}

/// The shapes whose intensity never rises towards the edge. The others rise by at most a step of
/// the format.
pub const STRICT: [&str; 13] = [
    "soft",
    "hard",
    "linear",
    "soft-pair",
    "step",
    "power",
    "power-4",
    "power-15",
    "inverted-power",
    "inverted-power-4",
    "soft-hotspot",
    "soft-cutoff",
    "opengl-15",
];

/// The parameters of the list are valid.
pub fn sound<T>(sample: Result<T, luminaire::Error>) -> T {
    sample.expect("the parameters of the list are sound")
}

/// The falloffs of the list, chosen at run time.
pub fn listed() -> Vec<Shape<AnyFalloff>> {
    struct Listed(Vec<Shape<AnyFalloff>>);

    impl FalloffVisitor for Listed {
        fn falloff<P: ListedFalloff>(&mut self) {
            self.0.push(Shape::plain(P::NAME, sound(P::sample()).into(), P::truth));
        }
    }

    let mut listed = Listed(Vec::new());
    falloffs(&mut listed);
    listed.0
}

/// Soft, hard, linear and cubic of the list.
pub fn four() -> Vec<Shape<AnyFalloff>> {
    listed().into_iter().filter(|shape| ["soft", "hard", "linear", "cubic"].contains(&shape.name)).collect()
}

/// Visits a shape.
pub trait ShapeVisitor {
    /// The result for a shape.
    type Output;

    fn shape<P: Falloff + Into<AnyFalloff> + 'static>(&mut self, shape: &Shape<P>) -> Self::Output;
}

/// The results for every shape: each falloff of the list, powers whose exponent is a type, the soft
/// edge with a hotspot and with a cutoff, and OpenGL's spotlight. A falloff is chosen at run time, but
/// for the powers whose exponent is a type: these round differently. That the other types have the
/// bits of the choice is a test of its own (`any_light::any_falloff_is_what_it_was`), so each formula
/// is compiled once a format.
pub fn every_shape<V: ShapeVisitor>(visitor: V) -> Vec<V::Output> {
    let mut each = Each { visitor, results: Vec::new() };
    listed().iter().for_each(|shape| each.shape(shape));
    each.shape(&Shape::<Power<4>>::listed());
    each.shape(&Shape::<InvertedPower<4>>::listed());
    each.shape(&Shape::plain("power-15", Power::<15>, oracle::power_15));
    each.shape(&Shape::hotspot("soft-hotspot", AnyFalloff::from(Soft), oracle::soft));
    each.shape(&Shape::with_cutoff("soft-cutoff", AnyFalloff::from(Soft), oracle::soft));
    each.shape(&Shape::<Power<15>>::opengl("opengl-15", oracle::power_15));
    each.results
}

struct Each<V: ShapeVisitor> {
    visitor: V,
    results: Vec<V::Output>,
}

impl<V: ShapeVisitor> Each<V> {
    fn shape<P: Falloff + Into<AnyFalloff> + 'static>(&mut self, shape: &Shape<P>) {
        self.results.push(self.visitor.shape(shape));
    }
}

/// The results of a generic function for every shape of [`every_shape`].
#[macro_export]
macro_rules! with_every_shape {
    ($function:ident $(::<$format:ty>)?) => {
        $crate::with_every_shape!($function $(::<$format>)? -> ())
    };
    ($function:ident $(::<$format:ty>)? -> $output:ty) => {{
        use luminaire::falloff::{AnyFalloff, Falloff};
        use $crate::falloffs::{Shape, ShapeVisitor, every_shape};

        struct Function;

        impl ShapeVisitor for Function {
            type Output = $output;

            fn shape<P: Falloff + Into<AnyFalloff> + 'static>(&mut self, shape: &Shape<P>) -> $output {
                $function $(::<$format, _>)? (shape)
            }
        }

        every_shape(Function)
    }};
}
