//! Patterns that a spotlight projects.

use super::CompiledProjection;
use super::projected::ProjectedPoint;
use crate::{
    error::{Error, Expected, Parameter},
    number::Scalar,
    vec3::Vec3,
};

/// A gobo (in engines: a light cookie): a square grid of transmissions in the gate of a spotlight.
///
/// A transmission of 255 passes all light, and 0 passes none. The transmissions are in row-major
/// order from the top left, as seen from the light. Each transmission applies at the centre of its
/// texel, and between four centres the gobo interpolates bilinearly. The interpolation uses
/// integers, so a position has the same transmission in every format, except for the rounding to
/// that format. The outermost centres are half a texel from the edge of the square. Beyond these
/// centres, and off the square, the transmission is the nearest transmission of the border: the rim
/// of the cone touches the sides of the square, and the position of a point at the rim is rounded.
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
/// // On the wall at z = 0 the square is 8 wide, and the centres of its texels are 8 / 3 apart.
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

/// Largest number of transmissions per side. At this number there are 16 coordinate steps from one
/// transmission to the next.
const MOST: usize = 4_096;

/// Fraction bits of a position between two transmissions, and of the interpolation weights.
const FRACTION_BITS: u32 = 12;

impl<'a> Gobo<'a> {
    /// Creates a gobo of `side` rows of `side` transmissions.
    ///
    /// # Errors
    /// A side outside 1 to 4,096, or a number of transmissions other than the square of the side.
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

    /// Creates a gobo from transmissions known at compile time, row by row.
    ///
    /// `COUNT` is the square of a side from 1 to 4,096; any other count does not compile.
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

    /// Returns the number of transmissions per side.
    pub const fn side(self) -> usize {
        self.side as usize
    }

    /// Returns the transmissions, row by row.
    pub const fn transmissions(self) -> &'a [u8] {
        self.transmissions
    }

    /// Mounts the gobo on the square of a spotlight.
    pub const fn on<S: Scalar>(self, projection: CompiledProjection<S>) -> CompiledGobo<'a, S> {
        CompiledGobo { projection, gobo: self }
    }

    /// Returns the transmission at a position, in `[0, 1]`.
    ///
    /// The result is exactly 1 between transmissions of 255, and exactly 0 between transmissions of
    /// 0.
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

    /// Returns the transmissions at positions with these columns and rows: for each position that
    /// of [`transmission`](Self::transmission).
    ///
    /// The look-ups have a loop of their own, so that compilers use vector instructions for the
    /// rest.
    #[inline]
    pub fn transmission_each<S: Scalar, const N: usize>(self, columns: &[i32; N], rows: &[i32; N]) -> [S; N] {
        let (mut first, mut right, mut down) = ([0; N], [0; N], [0; N]);
        for i in 0..N {
            let (column, row);
            (column, right[i]) = self.part(columns[i]);
            (row, down[i]) = self.part(rows[i]);
            first[i] = row * self.side + column;
        }
        let [mut top, mut bottom] = [[(0, 0); N]; 2];
        for i in 0..N {
            top[i] = (self.nth(first[i]), self.nth(first[i] + 1));
            bottom[i] = (self.nth(first[i] + self.side), self.nth(first[i] + self.side + 1));
        }
        core::array::from_fn(|i| {
            let [top, bottom] = [top[i], bottom[i]].map(|(left, next)| between(left, next, right[i]));
            S::weighted_byte(between(top, bottom, down[i]))
        })
    }

    /// Returns the index of the transmission before a coordinate, and the weight of the next
    /// transmission.
    ///
    /// The weight is zero if the index is that of the last transmission of a row or column.
    #[inline]
    fn part(self, steps: i32) -> (u32, u32) {
        const LOST: u32 = 16 - FRACTION_BITS;
        let steps = steps.clamp(0, (1 << 16) - 1) as u32;
        // `way` is the distance from the centre of the first texel to the middle of the coordinate
        // step, in 65,536ths of a texel.
        let way = (steps * self.side).saturating_sub((1 << 15) - self.side / 2);
        let last = (self.side - 1) << 16;
        let way = if way < last { way } else { last };
        (way >> 16, ((way & 0xffff) + (1 << (LOST - 1))) >> LOST)
    }

    /// Returns a transmission; 0 for an index past the end, whose weight is zero.
    #[inline]
    fn nth(self, index: u32) -> u32 {
        u32::from(self.transmissions.get(index as usize).copied().unwrap_or(0))
    }
}

/// Interpolates from one value to another; the result is scaled by `2^FRACTION_BITS`.
///
/// The difference `to - from` may wrap around; the sum then wraps back to the correct value.
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
    /// Creates a compiled gobo from its parts, as [`codegen`](crate::codegen) writes them.
    pub const fn from_parts(projection: CompiledProjection<S>, gobo: Gobo<'a>) -> Self {
        Self { projection, gobo }
    }

    /// Returns the projection: the square that the gobo lies on.
    pub const fn projection(&self) -> &CompiledProjection<S> {
        &self.projection
    }

    /// Returns the gobo.
    pub const fn gobo(&self) -> Gobo<'a> {
        self.gobo
    }

    /// Returns the transmission at a point, in `[0, 1]`.
    #[inline]
    pub fn at(&self, point: Vec3<S::Length>) -> S {
        self.gobo.transmission(&self.projection.project(point))
    }

    /// Attenuates a light by the transmission at a point; a transmission of 1 changes no bit.
    #[inline]
    pub fn filter(&self, light: S::Irradiance, point: Vec3<S::Length>) -> S::Irradiance {
        S::filter(light, self.at(point))
    }
}
