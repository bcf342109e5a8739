//! Haze: the visible beam of a spotlight, by single scattering along the view ray.
//!
//! What the haze between the eye and a surface scatters towards the eye is called air light:
//!
//! ```text
//! air light = density phase I ∫ f(w(s)) / d(s)^2 ds
//! ```
//!
//! with the distance `d` of a place of the ray from the light and the falloff `f` at the versine `w` off the
//! axis. The haze is taken as thin: it takes no light away, neither from the beam nor from what is seen
//! through it, and light is scattered once. It scatters alike in all directions, by a phase of `1/(4 pi)`;
//! a surface that receives 1 shows 1, which is a radiance of `1/pi`, so that a quarter of the density is
//! left as the factor.
//!
//! # Directions in place of distances
//!
//! With `h` the distance of the light from the line of sight, `ds / d^2 = d(psi) / h`: the inverse square
//! cancels, and what is left is an integral of `f` over the directions in which the light sees the ray, an
//! arc of a great circle. `psi` counts from the direction of the arc's circle that is nearest to the axis.
//! With `v = tan(psi/2)` there is no trigonometry:
//!
//! ```text
//! w = w0 + 2 r v^2 / (1 + v^2),   d(psi) = 2 dv / (1 + v^2),   w0 = 1 - r
//! ```
//!
//! where `r` is the cosine of the angle between axis and circle. It comes from the cosines of the
//! axis with foot and ray, so that a circle nearly across the axis keeps its bits, and `w0` comes
//! from the sine, so that narrow beams keep theirs. The arc ends where the cone does, at `v^2 =
//! (omega - w0) / (1 - omega + r)`, and is divided where the hotspot begins and ends, or at `v =
//! 0`. In each part `f` is smooth, and Gauss and Legendre's rule of five places is enough.
//! NUMERICS.md has the errors.
//!
//! Light that falls by another distance model is summed over the way along the ray, between the same ends
//! and up to its range; without a range, and without a fall with the square, an endless ray in the beam is
//! as bright as f32 allows.
//!
//! It is `f32` whatever the format of the light: `1/h` has no scale that a fixed format could be given once
//! for a picture, and a renderer with haze has floats for what it does to colours anyway.

mod arc;
mod beam;
mod bundle;
mod parts;
mod quadrature;
mod rays;
mod stretch;

pub use self::{beam::BeamScattering, bundle::RayBundle, parts::TransmittanceFn, rays::ViewRays};

use crate::{
    error::{Error, Parameter, check_between},
    trig,
    vec3::Vec3,
};

/// Thin haze that fills the scene evenly.
///
/// ```
/// use luminaire::{Angle, Cone, SpotLight, Vec3, falloff::Soft, haze::{Haze, ViewRay}};
/// let cone = Cone::from_field(Soft, Angle::degrees(15.0))?;
/// let spot = SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?.with_intensity(16.0)?;
/// let beam = spot.compile::<f32>()?.in_haze(&Haze::new(0.02)?);
///
/// // From the side, through the beam and past it.
/// let eye = Vec3::new(0.0, 2.0, 6.0);
/// assert!(beam.in_scattering(&ViewRay::between(eye, Vec3::new(0.0, 2.0, -1.0))) > 0.0);
/// assert_eq!(beam.in_scattering(&ViewRay::between(eye, Vec3::new(2.0, 2.0, -1.0))), 0.0);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Haze {
    density: f32,
    source_radius: f32,
}

/// The radius of a light until told otherwise: a centimetre where the unit is the metre.
const SOURCE_RADIUS: f32 = 0.01;

impl Haze {
    /// Clear air.
    pub const CLEAR: Self = Self { density: 0.0, source_radius: SOURCE_RADIUS };

    /// Haze of this density: the part of the light that is scattered on a way of one unit of the world's
    /// length. 0 is clear air and gives exactly no air light; beyond some tenths over the size of the scene
    /// haze is no longer thin.
    ///
    /// # Errors
    /// A density outside 0 to 1e9.
    pub fn new(density: f32) -> Result<Self, Error> {
        check_between(Parameter::Density, density, 0.0, 1e9)?;
        Ok(Self { density, source_radius: SOURCE_RADIUS })
    }

    /// The same haze around lights of this radius, 0.01 until told otherwise. There is no haze within it,
    /// and no view through it: a ray that meets the light ends there. Without a body a light would be
    /// infinitely bright where the eye looks straight at it.
    ///
    /// # Errors
    /// A radius outside 0.001 to 1e9.
    pub fn with_source_radius(self, source_radius: f32) -> Result<Self, Error> {
        check_between(Parameter::SourceRadius, source_radius, 1e-3, 1e9)?;
        Ok(Self { source_radius, ..self })
    }

    /// The part of the light that is scattered on a way of one unit.
    pub fn density(&self) -> f32 {
        self.density
    }

    /// The radius of a light.
    pub fn source_radius(&self) -> f32 {
        self.source_radius
    }
}

/// What is seen in one direction: a line from the eye to a surface, or without an end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ViewRay {
    /// Where the eye is.
    pub eye: Vec3<f32>,
    /// Where it looks, of unit length within the roundings of f32.
    pub direction: Vec3<f32>,
    /// How far it sees; infinity where there is no surface.
    pub length: f32,
}

impl ViewRay {
    /// The ray from the eye to a surface point. A point at the eye leaves no ray, and no air light.
    #[inline]
    pub fn between(eye: Vec3<f32>, surface: Vec3<f32>) -> Self {
        let way = surface.zip(eye, |s, e| s - e);
        let squared = way.dot(way);
        let reciprocal = trig::inverse_sqrt(squared);
        Self { eye, direction: way.map(|c| c * reciprocal), length: squared * reciprocal }
    }

    /// The ray from the eye in a direction of unit length, where nothing ends it.
    #[inline]
    pub fn endless(eye: Vec3<f32>, direction: Vec3<f32>) -> Self {
        Self { eye, direction, length: f32::INFINITY }
    }
}
