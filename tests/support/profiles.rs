//! Every profile of the kernel beside its reference: the list that the sweeps run over.

use super::{reference, sweep};
use luminaire::{
    Cone,
    falloff::{
        Cubic, Falloff, IntegerPower, InvertedIntegerPower, InvertedMixedPower, InvertedRealPower,
        MixedPower, Power, Quadratic, RealPower, Table,
    },
};

pub fn blend() -> Quadratic {
    Quadratic::new(0.5).expect("a sound slope")
}

pub fn cubic() -> Cubic {
    Cubic::with_slopes(1.25, 3.5).expect("sound slopes")
}

pub fn integer_power() -> IntegerPower {
    IntegerPower::new(15).expect("a sound exponent")
}

pub fn integer_rim() -> InvertedIntegerPower {
    InvertedIntegerPower::new(4).expect("a sound exponent")
}

pub fn mixed_power() -> MixedPower {
    MixedPower::new([1, 16], 0.375).expect("a sound mixture")
}

pub fn mixed_rim() -> InvertedMixedPower {
    InvertedMixedPower::new([2, 3], 0.5625).expect("a sound mixture")
}

pub fn real_power() -> RealPower {
    RealPower::new(2.2).expect("a sound exponent")
}

pub fn real_rim() -> InvertedRealPower {
    InvertedRealPower::new(0.75).expect("a sound exponent")
}

pub fn table() -> Table<'static> {
    Table::new(&reference::SAMPLES).expect("sound samples")
}

/// A cone of the kernel and what it stands for, both made of the outer half angle in degrees.
pub struct Shape<P> {
    pub name: &'static str,
    pub cone: fn(P, f32) -> Cone<P>,
    pub profile: P,
    pub exact: fn(reference::Falloff, f64) -> reference::Cone,
    pub oracle: reference::Falloff,
}

impl<P: Falloff> Shape<P> {
    /// The profile from the axis to the edge.
    pub fn plain(name: &'static str, profile: P, oracle: reference::Falloff) -> Self {
        Self { name, cone: plain, profile, exact: reference::Cone::new, oracle }
    }

    /// The profile around a hotspot whose versine is half the outer one, up to the roundings of f32.
    pub fn hotspot(name: &'static str, profile: P, oracle: reference::Falloff) -> Self {
        Self { name, cone: hotspot, profile, exact: exact_hotspot, oracle }
    }

    /// The profile, delimited at 0.75 of its half angle.
    pub fn delimited(name: &'static str, profile: P, oracle: reference::Falloff) -> Self {
        Self { name, cone: delimited, profile, exact: exact_delimited, oracle }
    }

    pub fn at(&self, half_degrees: f32) -> Cone<P> {
        (self.cone)(self.profile, half_degrees)
    }

    pub fn exactly_at(&self, half_degrees: f32) -> reference::Cone {
        (self.exact)(self.oracle, reference::versine(half_degrees.into()))
    }

    /// The versines that the cone has compiled, which are those of f32.
    pub fn stored_at(&self, half_degrees: f32) -> reference::Cone {
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

impl<const N: u32> Shape<Power<N>> {
    /// OpenGL's spotlight with its cutoff at the half angle.
    pub fn opengl(name: &'static str, oracle: reference::Falloff) -> Self {
        let cone = |_: Power<N>, half| Cone::opengl(sweep::half(half)).expect("a sound cutoff");
        Self { name, cone, profile: Power, exact: reference::Cone::opengl, oracle }
    }
}

/// The inner half angle of a hotspot, and the delimiter, as fractions of the outer half angle.
const HOTSPOT: f32 = 0.5;
const DELIMITER: f32 = 0.75;

fn plain<P: Falloff>(profile: P, half_degrees: f32) -> Cone<P> {
    Cone::from_outer(profile, sweep::half(half_degrees)).expect("a sound cone")
}

fn hotspot<P: Falloff>(profile: P, half_degrees: f32) -> Cone<P> {
    let cone = plain(profile, half_degrees);
    cone.with_inner(sweep::half(half_degrees * HOTSPOT)).expect("a sound hotspot")
}

fn delimited<P: Falloff>(profile: P, half_degrees: f32) -> Cone<P> {
    let cone = plain(profile, half_degrees);
    cone.with_cutoff(sweep::half(half_degrees * DELIMITER)).expect("a sound delimiter")
}

fn exact_hotspot(profile: reference::Falloff, outer: f64) -> reference::Cone {
    let inner = reference::versine(reference::half_degrees(outer) * f64::from(HOTSPOT));
    reference::Cone { inner, ..reference::Cone::new(profile, outer) }
}

fn exact_delimited(profile: reference::Falloff, outer: f64) -> reference::Cone {
    let limit = reference::versine(reference::half_degrees(outer) * f64::from(DELIMITER));
    reference::Cone { limit, ..reference::Cone::new(profile, outer) }
}

/// The answers of a generic function to every shape: each profile plain, one with a hotspot, one delimited, and
/// OpenGL's.
#[macro_export]
macro_rules! with_every_shape {
    ($function:ident :: <$format:ty>) => {
        $crate::with_every_shape!(@ $function::<$format, _>)
    };
    ($function:ident) => {
        $crate::with_every_shape!(@ $function)
    };
    (@ $($function:tt)*) => {{
        use luminaire::falloff::{Hard, InvertedPower, Linear, Power, Smooth, Soft, Step};
        use $crate::{
            profiles::{self, Shape},
            reference,
        };
        [
            $($function)*(&Shape::plain("soft", Soft, reference::soft)),
            $($function)*(&Shape::plain("hard", Hard, reference::hard)),
            $($function)*(&Shape::plain("linear", Linear, reference::linear)),
            $($function)*(&Shape::plain("cut-off", Step, reference::cut_off)),
            $($function)*(&Shape::plain("smooth", Smooth, reference::smooth)),
            $($function)*(&Shape::plain("blend", profiles::blend(), reference::blend)),
            $($function)*(&Shape::plain("cubic", profiles::cubic(), reference::cubic)),
            $($function)*(&Shape::plain("power 4", Power::<4>, reference::power_4)),
            $($function)*(&Shape::plain("power 15", Power::<15>, reference::power_15)),
            $($function)*(&Shape::plain("rim 4", InvertedPower::<4>, reference::rim_4)),
            $($function)*(&Shape::plain(
                "integer power 15",
                profiles::integer_power(),
                reference::power_15,
            )),
            $($function)*(&Shape::plain(
                "integer rim 4",
                profiles::integer_rim(),
                reference::rim_4,
            )),
            $($function)*(&Shape::plain(
                "mixed power",
                profiles::mixed_power(),
                reference::mixed_power,
            )),
            $($function)*(&Shape::plain("mixed rim", profiles::mixed_rim(), reference::mixed_rim)),
            $($function)*(&Shape::plain("table", profiles::table(), reference::table)),
            $($function)*(&Shape::hotspot("soft, hotspot", Soft, reference::soft)),
            $($function)*(&Shape::delimited("soft, delimited", Soft, reference::soft)),
            $($function)*(&Shape::<Power<15>>::opengl("OpenGL 15", reference::power_15)),
        ]
    }};
}
