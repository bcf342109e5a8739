//! A beam with a gobo as seen from the eye: its in-scattering by look-ups instead of samples.
//!
//! All view rays in a plane through the eye and the light show the same directions from the light,
//! in the same order: those of a half circle that begins at the eye. They differ only in where they
//! end, and in their distance `h` from the light. With the inverse square, the in-scattering of a
//! ray is the gain, divided by `h`, times the integral of falloff and gobo over these directions, up
//! to the direction of the ray's end (`luminaire::haze`). So one integral per half circle serves
//! all of its rays. Such half circles are the lines of epipolar sampling (Engelhardt and
//! Dachsbacher, "Epipolar sampling for shadows and crepuscular rays in participating media with
//! single scattering", 2010); here they are few, and a ray is interpolated between two of them.
//!
//! A line has two coordinates. `across` is the sine of the angle between the axis of the light and
//! the plane of the line, relative to the edge of the cone: -1 and 1 are the planes that touch the
//! cone. `along` is `tan(psi/2)`, with the angle `psi` from the direction of the line that is
//! nearest to the axis, also relative to the edge of the cone: the line enters the cone at -1 and
//! leaves it at 1.
//!
//! The lines are as near to each other as the gobo needs, and a ray takes a small part of the
//! instructions of samples along it. NUMERICS.md has the errors.

mod lines;
mod pattern;

use self::lines::Lines;
use super::{
    frame::{Frame, Sheaf, WIDTH},
    hazy::Hazy,
};
use crate::space::vector;
use glam::Vec3;

/// The beam of a spotlight with a gobo, prepared for one eye.
#[derive(Clone, Debug)]
pub(crate) struct Shafts {
    pub(super) frame: Frame,
    /// The in-scattering at `h = 1` of a line whose integral is 1.
    gain: f32,
    lines: Lines,
}

impl Shafts {
    /// Integrates along the lines of a beam; `None` if the beam must be sampled.
    ///
    /// Lines need a gobo and the inverse square, and an eye that is neither in the cone nor in the
    /// opposite cone nor in the light.
    pub(crate) fn new(hazy: &Hazy, eye: Vec3) -> Option<Self> {
        let gobo = hazy.gobo.as_ref().filter(|_| hazy.beam.is_inverse_square())?;
        let frame = Frame::new(hazy, eye).filter(|frame| frame.is_outside)?;
        let lines = Lines::new(hazy, &frame, gobo);
        let gain = hazy.gain / frame.distance;
        Some(Self { frame, gain, lines })
    }

    /// Returns the light of the rays through the pixels from `(x, y)` to the right, up to surfaces of
    /// this nearness.
    #[inline(always)]
    pub(super) fn light(&self, sheaf: &Sheaf, at: (usize, usize), nearness: &[f32; WIDTH]) -> [f32; WIDTH] {
        if sheaf.is_near {
            self.run::<true>(sheaf, at, nearness)
        } else {
            self.run::<false>(sheaf, at, nearness)
        }
    }

    /// Computes [`light`](Self::light) of rays that may hit the light's body, or not.
    #[inline(never)]
    fn run<const IS_NEAR: bool>(
        &self,
        sheaf: &Sheaf,
        (x, y): (usize, usize),
        nearness: &[f32; WIDTH],
    ) -> [f32; WIDTH] {
        let Frame { axis: [ahead, aside], versine, sine, .. } = self.frame;
        let row = sheaf.row(x, y);
        let (mut weight, mut across, mut along) = ([0.0; WIDTH], [0.0; WIDTH], [0.0; WIDTH]);
        let per_sine = aside / sine;
        for i in 0..WIDTH {
            let way = row(i);
            let squared = way.x * way.x + way.y * way.y;
            let whole = squared + way.z * way.z;
            let height = vector::sqrt(squared);
            let reciprocal = 1.0 / height;
            let (cos, sin) = (aside * (way.x * reciprocal), way.y * reciprocal);
            across[i] = per_sine * sin;
            let off = aside * sin;
            let radius = vector::sqrt(ahead * ahead + cos * cos);
            let square = (versine - off * off / (1.0 + radius)) / ((1.0 - versine) + radius);
            let edge = vector::sqrt(if square > 0.0 { square } else { 0.0 });
            // The coordinate of the ray's end on the line from the light to the eye, times the
            // nearness.
            let far = self.frame.far(IS_NEAR, way, [squared, whole], nearness[i]);
            let length = vector::sqrt(squared + far * far);
            // `sin psi` and `1 + cos psi` at the end, both times `length * radius`.
            let turn = height * ahead - far * cos;
            let one_plus_cosine = length * radius + (far * ahead + height * cos);
            along[i] = turn / (one_plus_cosine * edge);
            let light = self.gain * vector::sqrt(whole) * reciprocal * edge;
            let is_lit = (cos > 0.0) & (across[i].abs() < 1.0) & (along[i] > -1.0);
            weight[i] = if is_lit { light } else { 0.0 };
        }
        let mut light = [0.0; WIDTH];
        self.lines.integrals(&across, &along, &mut light);
        for i in 0..WIDTH {
            light[i] *= weight[i];
        }
        light
    }
}
