//! The beam of a spotlight in haze, in 32-bit products.

use super::{
    Haze,
    arc16::{Arc16, Chord, Span16, part, whole},
};
use crate::{
    attenuation::InverseSquare,
    cone::CompiledCone,
    falloff::{Falloff, Soft},
    number::{Fx16, Fx32, Gain, Length, Light16, Versine, fx16::Gain16},
    shade::CompiledSpotLight,
    vec3::Vec3,
};

/// The beam of a spotlight in haze, in 32-bit products. Made by [`CompiledSpotLight::in_haze`].
///
/// On a processor without an FPU this takes a tenth of the instructions of
/// [`BeamScattering`](super::BeamScattering). The light attenuates with the inverse square.
///
/// ```
/// use luminaire::{Angle, Cone, Fx16, SpotLight, Vec3, falloff::Soft, haze::Haze};
/// let cone = Cone::from_field(Soft, Angle::degrees(15.0))?;
/// let spot = SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?.with_intensity(16.0)?;
/// let beam = spot.compile::<Fx16>()?.in_haze(&Haze::new(0.02)?);
///
/// // From the side, through the beam and past it.
/// let eye = Fx16::point([0.0, 2.0, 6.0]);
/// assert!(beam.in_scattering(eye, Fx16::point([0.0, 2.0, -1.0])).to_f32() > 0.0);
/// assert_eq!(beam.in_scattering(eye, Fx16::point([2.0, 2.0, -1.0])).to_f32(), 0.0);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BeamScattering16<P: Falloff = Soft> {
    pub(crate) position: Vec3<Length>,
    pub(crate) axis: Vec3<Fx32>,
    pub(crate) falloff: CompiledCone<Fx16, P>,
    pub(crate) gain: Gain16,
    /// Versines between which the intensity varies: up to the first it is that of the axis, from
    /// the second on it is zero. The scale is that of the falloff.
    pub(crate) cone: [u32; 2],
    /// The radius of the light.
    pub(crate) radius: Length,
    /// The reciprocal of the radius of the light.
    pub(crate) nearest: Gain16,
}

/// Places of the nodes of Gauss-Legendre quadrature with four nodes, with 16 fraction bits.
const PLACES: [u32; 2] = [22_281, 56_435];

/// Weights of these nodes, with 14 fraction bits; all four sum to 2.
const WEIGHTS: [u32; 2] = [10_685, 5_699];

impl<P: Falloff> CompiledSpotLight<Fx16, P, InverseSquare> {
    /// Returns the beam of this light in haze.
    pub fn in_haze(&self, haze: &Haze) -> BeamScattering16<P> {
        let radius = haze.source_radius();
        BeamScattering16 {
            position: self.position,
            axis: self.axis,
            falloff: self.cone,
            gain: self.intensity.times(Gain16::nearest(haze.density() / 4.0)),
            cone: rim(&self.cone),
            radius: Fx16::length(radius),
            nearest: Gain16::nearest(1.0 / radius),
        }
    }
}

impl<P: Falloff> BeamScattering16<P> {
    /// Creates a beam from its fields, as [`codegen`](crate::codegen) writes them.
    ///
    /// `cone` are the versines between which the intensity varies, `nearest` is the reciprocal of
    /// the radius.
    pub const fn from_parts(
        position: Vec3<Length>,
        axis: Vec3<Fx32>,
        falloff: CompiledCone<Fx16, P>,
        gain: Gain16,
        cone: [u32; 2],
        radius: Length,
        nearest: Gain16,
    ) -> Self {
        Self { position, axis, falloff, gain, cone, radius, nearest }
    }

    /// Returns the light that the haze scatters towards the eye between the eye and a surface
    /// point, before the colour.
    ///
    /// 1 is full scale, the light of a white surface with an irradiance of 1. The result saturates.
    /// It is exactly zero in clear air. For a line of sight without an end, pass a point far away.
    ///
    /// The error has no bound. Of random rays and short climbs from them it is at most 0.8 linear codes; the largest
    /// that is known is 4.3, of a ray that passes the light at a thousandth of a unit, with an end hundreds of units
    /// away, and grazes a cone of 3 degrees (`tests/suite/haze16_error.rs`). Both hold under these conditions:
    ///
    /// - The falloff is soft, hard or smooth, with a half angle from 3 to 80 degrees.
    /// - The radius of the light's body is at least 0.001, and both ends of the line of sight are at least one
    ///   radius away from the body.
    /// - The line of sight has at most 1,000 units, and all coordinates are within 16,384: beyond, lengths lose
    ///   a bit.
    /// - The beam is at most at full scale where a line at the angle of the line of sight crosses it, as near to
    ///   the light as the line of sight passes.
    pub fn in_scattering(&self, eye: Vec3<Length>, surface: Vec3<Length>) -> Light16 {
        let zoom = self.falloff.ramp.zoom;
        let chord = Chord::between(self.position, eye, surface);
        let Some(mut arc) = Arc16::new(&chord, self.axis, zoom) else { return Light16::default() };
        if arc.nearness.exceeds(self.nearest) {
            let outside = chord.outside(self.radius).and_then(|chord| Arc16::new(&chord, self.axis, zoom));
            let Some(outside) = outside else { return Light16::default() };
            arc = outside;
        }
        let [inner, outer] = self.cone.map(|versine| match versine {
            0 => 0,
            versine => arc.edge(versine, (1 << 29) - (versine >> (2 * zoom)).min(1 << 29)),
        });
        let (Span16 { from, to }, scale) = arc.span(outer);
        let sum = self.rim(&arc, from, to.min(-inner))
            + middle(&arc, from.max(-inner), to.min(inner))
            + self.rim(&arc, from.max(inner), to);
        scale.times(self.gain).light_of(sum, 28)
    }

    /// Integrates the intensity between two directions, with 28 fraction bits.
    #[inline(never)]
    fn rim(&self, arc: &Arc16, from: i32, to: i32) -> u32 {
        integrate(from, to, |v| {
            let (versine, share) = arc.at(v);
            (share * u32::from(self.falloff.at(versine).to_bits() as u16)) >> 14
        })
    }
}

/// Integrates full intensity between two directions, with 28 fraction bits.
#[inline(never)]
fn middle(arc: &Arc16, from: i32, to: i32) -> u32 {
    integrate(from, to, |v| arc.at(v).1)
}

/// Returns the integral of a function with 16 fraction bits, at most 1, between two limits in
/// `[-2, 2]`; zero unless `from < to`.
#[inline(always)]
fn integrate(from: i32, to: i32, value: impl Fn(i32) -> u32) -> u32 {
    if from >= to {
        return 0;
    }
    let (half, middle) = ((to >> 1) - (from >> 1), (to >> 1) + (from >> 1));
    let mut sum = 0;
    for (place, weight) in PLACES.into_iter().zip(WEIGHTS) {
        let beside = part(half, place);
        for v in [middle - beside, middle + beside] {
            sum += value(v) * weight;
        }
    }
    whole(half, sum)
}

/// Returns the versines between which the intensity of a cone varies, in the scale of the cone.
fn rim<P: Falloff>(falloff: &CompiledCone<Fx16, P>) -> [u32; 2] {
    let limit = falloff.ramp.limit();
    let full = falloff.at(Versine::from_bits(0));
    let at = |versine: u32| falloff.at(Versine::from_bits(versine));
    let part = |i: u32| (u64::from(limit) * u64::from(i) / 256) as u32;
    // A table may fall and rise again: the middle ends where it first falls, the rim where its last
    // light ends.
    let first = (1..256).find(|&i| at(part(i)) != full).unwrap_or(256);
    let end = (1..256).rev().find(|&i| at(part(i)) > Fx16::ZERO).map_or(1, |i| i + 1);
    let inner = if first == 256 { limit } else { last(part(first - 1), part(first), |v| at(v) == full) };
    // The middle of a falloff without a hotspot is too small for an integral of its own.
    [if inner < limit / 64 { 0 } else { inner }, last(part(end - 1), part(end), |v| at(v) > Fx16::ZERO)]
}

/// Returns the largest number below `high` up to which a predicate holds that holds for `low`.
fn last(mut low: u32, mut high: u32, holds: impl Fn(u32) -> bool) -> u32 {
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if holds(middle) { low = middle } else { high = middle }
    }
    low
}
