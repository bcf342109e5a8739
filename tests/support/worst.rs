//! The worst of all places: where a spotlight's intensity is furthest from the exact one, looked
//! for by climbing.

use super::{falloffs::Shape, format::Format, sweep};
use luminaire::{SpotLight, Vec3, falloff::Falloff};
use std::fmt;

/// A light in the origin by its axis, and a point.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub axis: Vec3<f32>,
    pub point: Vec3<f32>,
}

/// An input that was found, and the error of the intensity there.
#[derive(Clone, Debug)]
pub struct Find {
    pub format: String,
    pub shape: String,
    pub half_degrees: f32,
    pub place: Place,
    pub error: f64,
}

impl fmt::Display for Find {
    /// A line of the file: numbers that must be exact as the bits of f32.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}, {:08x}", self.format, self.shape, self.half_degrees.to_bits())?;
        let Place { axis, point } = self.place;
        for component in [axis.x, axis.y, axis.z, point.x, point.y, point.z] {
            write!(f, ", {:08x}", component.to_bits())?;
        }
        write!(f, ", {:.3e}", self.error)
    }
}

impl Find {
    /// Reads a line of the file; shapes may have a comma in their name.
    pub fn parse(line: &str) -> Option<Self> {
        let (format, rest) = line.split_once(", ")?;
        let mut words: Vec<_> = rest.rsplitn(9, ", ").collect();
        words.reverse();
        let bits = |index: usize| u32::from_str_radix(words.get(index)?, 16).ok().map(f32::from_bits);
        let vector = |first: usize| Some(Vec3::new(bits(first)?, bits(first + 1)?, bits(first + 2)?));
        Some(Self {
            format: format.to_owned(),
            shape: (*words.first()?).to_owned(),
            half_degrees: bits(1)?,
            place: Place { axis: vector(2)?, point: vector(5)? },
            error: words.get(8)?.parse().ok()?,
        })
    }
}

/// The error of the intensity of a shape at an input; `None` if the light is refused, or jumps
/// there.
pub fn error<S: Format, P: Falloff>(shape: &Shape<P>, half_degrees: f32, place: Place) -> Option<f64> {
    let cone = shape.exactly_at(half_degrees);
    let spot = SpotLight::new(Vec3::default(), place.axis, shape.at(half_degrees)).ok()?;
    let exact = sweep::stored::<S, _, _>(&spot, cone);
    let point = place.point.map(S::length);
    let found = spot.compile::<S>().ok()?.falloff_at(point).exact();
    Some((found - exact.falloff(S::exact_point(point))).abs())
}

/// Whether a shape has a slope everywhere: where it jumps there is no error of the intensity to
/// look for.
pub fn is_smooth<P: Falloff>(shape: &Shape<P>) -> bool {
    let cone = shape.exactly_at(1.0);
    !cone.jumps_near(cone.limit, 1.0)
}
