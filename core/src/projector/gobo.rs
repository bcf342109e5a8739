//! Patterns that a spotlight projects.

use super::CompiledProjection;
use crate::{
    error::{Error, Expected, Parameter},
    number::{ProjectedPoint, Scalar},
    vec3::Vec3,
};

/// A gobo: a square of transmissions in the gate of a spotlight, which its light throws on what it meets.
///
/// 255 lets all light through and 0 none, in row-major order from the top left as they are seen from the light. Each stands
/// in the middle of its part of the square, and between four of them the light goes over by linear interpolation in both
/// directions, in integers: the same place has the same transmission in every format, rounded to that. Outside the
/// outermost middles, half a part from the edge, and off the square the nearest transmission of the border goes on; the
/// light of the cone ends within the square anyway.
///
/// ```
/// use luminaire::{Angle, Cone, SpotLight, Vec3, falloff::Soft, projector::{Gobo, Projection}};
/// // A mullion: a bar from top to bottom.
/// const MULLION: Gobo<'static> = Gobo::of(&[
///     255, 0, 255, //
///     255, 0, 255, //
///     255, 0, 255,
/// ]);
/// let cone = Cone::from_outer(Soft, Angle::degrees(90.0))?;
/// let spot = SpotLight::new(Vec3::new(0.0, 1.0, 4.0), Vec3::new(0.0, 0.0, -1.0), cone)?;
/// let gobo = MULLION.on(Projection::of(&spot)?.compile::<f32>()?);
/// // On the wall at z = 0 the square is 8 wide, and the middles of its parts 8 / 3 apart.
/// assert_eq!(gobo.at(Vec3::new(0.0, 1.0, 0.0)), 0.0);
/// assert_eq!(gobo.at(Vec3::new(-3.0, 0.0, 0.0)), 1.0);
/// assert!((gobo.at(Vec3::new(4.0 / 3.0, 2.0, 0.0)) - 0.5).abs() < 1e-3);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Gobo<'a> {
    side: u32,
    transmissions: &'a [u8],
}

/// The most transmissions along a side: then 16 steps of a place are between two of them.
const MOST: usize = 4_096;

/// How many fraction bits the way from one transmission to the next has, and the weights of the interpolation.
const FRACTION_BITS: u32 = 12;

impl<'a> Gobo<'a> {
    /// The gobo of so many rows of as many transmissions.
    ///
    /// # Errors
    /// A side that is not from 1 to 4,096, or another number of transmissions than its square.
    pub fn new(side: usize, transmissions: &'a [u8]) -> Result<Self, Error> {
        if !(1..=MOST).contains(&side) {
            let accepted = Expected::WholeBetween(1, MOST as u32);
            return Err(Error { parameter: Parameter::Side, value: side as f32, accepted });
        }
        if transmissions.len() != side * side {
            let accepted = Expected::Exactly((side * side) as f32);
            return Err(Error {
                parameter: Parameter::SampleCount,
                value: transmissions.len() as f32,
                accepted,
            });
        }
        Ok(Self { side: side as u32, transmissions })
    }

    /// The gobo of transmissions that are known when the program is compiled, row by row: `COUNT` is the square of a
    /// side from 1 to 4,096. Another count does not compile.
    pub const fn of<const COUNT: usize>(transmissions: &'a [u8; COUNT]) -> Self {
        let side = const {
            let side = COUNT.isqrt();
            assert!(
                side * side == COUNT && side >= 1 && side <= MOST,
                "expected N * N transmissions, N from 1 to 4,096"
            );
            side as u32
        };
        Self { side, transmissions }
    }

    /// How many transmissions a side has.
    pub const fn side(self) -> usize {
        self.side as usize
    }

    /// The transmissions, row by row.
    pub const fn transmissions(self) -> &'a [u8] {
        self.transmissions
    }

    /// The gobo on the square of a spotlight.
    pub const fn on<S: Scalar>(self, projection: CompiledProjection<S>) -> CompiledGobo<'a, S> {
        CompiledGobo { projection, gobo: self }
    }

    /// What is left of the light at a place: from exactly zero to exactly one, and one everywhere behind glass without a
    /// pattern.
    #[inline]
    pub fn transmission<S: Scalar>(self, place: &ProjectedPoint<S>) -> S {
        let (column, right) = self.part(place.column);
        let (row, down) = self.part(place.row);
        let first = row * self.side + column;
        let [top, bottom] = [first, first + self.side].map(|left| {
            let (left, next) = (self.nth(left), self.nth(left + 1));
            between(left, next, right)
        });
        S::weighted_byte(between(top, bottom, down))
    }

    /// The transmission before a place along a side, and how far it is to the next: no way from the last one.
    #[inline]
    fn part(self, steps: i32) -> (u32, u32) {
        const LOST: u32 = 16 - FRACTION_BITS;
        let steps = steps.clamp(0, (1 << 16) - 1) as u32;
        // From the middle of the first transmission to the middle of the step, in 65,536ths of a part.
        let way = (steps * self.side).saturating_sub((1 << 15) - self.side / 2);
        let last = (self.side - 1) << 16;
        let way = if way < last { way } else { last };
        (way >> 16, ((way & 0xffff) + (1 << (LOST - 1))) >> LOST)
    }

    /// A transmission; one that would be after the last has no weight.
    #[inline]
    fn nth(self, index: u32) -> u32 {
        u32::from(self.transmissions.get(index as usize).copied().unwrap_or(0))
    }
}

/// The value so far on the way from one to another, times the whole way. A difference may wrap, and the sum comes back.
#[inline]
fn between(from: u32, to: u32, way: u32) -> u32 {
    (from << FRACTION_BITS).wrapping_add(to.wrapping_sub(from).wrapping_mul(way))
}

/// A gobo on the square of a spotlight, compiled for the format `S`. Made by [`Gobo::on`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledGobo<'a, S: Scalar> {
    pub(crate) projection: CompiledProjection<S>,
    pub(crate) gobo: Gobo<'a>,
}

impl<'a, S: Scalar> CompiledGobo<'a, S> {
    /// The gobo of these parts, as [`codegen`](crate::codegen) writes them.
    pub const fn from_parts(projection: CompiledProjection<S>, gobo: Gobo<'a>) -> Self {
        Self { projection, gobo }
    }

    /// The square that the gobo lies on.
    pub const fn projection(&self) -> &CompiledProjection<S> {
        &self.projection
    }

    /// The gobo.
    pub const fn gobo(&self) -> Gobo<'a> {
        self.gobo
    }

    /// What is left of the light at a point: a factor from 0 to 1.
    #[inline]
    pub fn at(&self, point: Vec3<S::Length>) -> S {
        self.gobo.transmission(&self.projection.place(point))
    }

    /// What is left of this light at a point; where all of it is, no bit has changed.
    #[inline]
    pub fn filter(&self, light: S::Irradiance, point: Vec3<S::Length>) -> S::Irradiance {
        S::filter(light, self.at(point))
    }
}
