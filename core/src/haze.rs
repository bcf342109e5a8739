//! Haze: the visible beam of a spotlight, by single in-scattering along the view ray.
//!
//! The haze is a thin homogeneous medium. Between the eye and a surface, the haze scatters this
//! light towards the eye:
//!
//! ```text
//! in-scattering = density phase I ∫ f(w(s)) / d(s)^2 ds
//! ```
//!
//! Here `I` is the intensity, `d` the distance of a point on the ray from the light, and `f` the
//! falloff at the versine `w` of the point's angle off axis. The medium is thin: its transmittance
//! is taken as 1, so the medium attenuates neither the beam nor the surfaces behind the beam. Light
//! scatters only once. Scattering is isotropic, with a phase function of `1/(4 pi)`. A white
//! surface with an irradiance of 1 shows 1, which is a radiance of `1/pi`. So the constant factor
//! of `I` is the density times `pi / (4 pi)`: a quarter of the density.
//!
//! # Integration over directions
//!
//! The directions from the light to the points of the ray form an arc of a great circle. The angle
//! `psi` of a direction is measured on this circle, from the circle's direction nearest to the axis
//! of the light. Let `h` be the distance of the light from the line of sight. Then
//! `ds / d^2 = d(psi) / h`: the inverse square cancels, and `f` is integrated over `psi`. The
//! substitution `v = tan(psi/2)` avoids trigonometry:
//!
//! ```text
//! w = w0 + 2 r v^2 / (1 + v^2),   d(psi) = 2 dv / (1 + v^2),   w0 = 1 - r
//! ```
//!
//! where `r` is the cosine of the angle between the axis and the circle. The foot is the point of
//! the ray's line that is nearest to the light. `r` is computed from the cosines of two angles:
//! between the axis and the ray, and between the axis and the direction from the light to the foot.
//! So `r` keeps its leading bits if the circle is nearly orthogonal to the axis. `w0` is computed
//! from the sine of the angle between the axis and the circle. So `w0` keeps its leading bits in
//! narrow beams. The arc ends at the edge of the cone, at `v^2 = (omega - w0) / (1 - omega + r)`,
//! where `omega` is the outer versine.
//!
//! For a falloff that is a polynomial of degree 3 or less, or two soft ones, in a cone without a
//! hotspot, the integral has a closed form (`polynomial.rs`). For all others the arc is split at the edges of the hotspot,
//! or where the intensity first falls. In each part of the arc `f` is smooth, so Gauss-Legendre
//! quadrature with five nodes suffices. NUMERICS.md lists the errors.
//!
//! For an attenuation other than the inverse square, the integral runs over the length of the ray,
//! between the same edges of the cone and up to the range of the light. If the light has
//! neither a range nor an attenuation, the integral over an infinite ray in the beam diverges; the
//! result is then `f32::MAX`.
//!
//! [`BeamScattering`] computes in `f32`. [`BeamScattering16`] computes the same integral in 32-bit
//! products, for lights that attenuate with the inverse square. It uses four nodes for each half of
//! the rim. On a Cortex-M0 it takes a tenth of the instructions (`docs/EFFECTS.md`). It errs by at
//! most 0.8 linear codes for nearly all rays (see [`BeamScattering16::in_scattering`]).
//!
//! `1/h` varies too much for one fixed-point scale. In 16 bits it is a mantissa with a shift.

mod arc;
#[cfg(feature = "fixed")]
mod arc16;
mod beam;
#[cfg(feature = "fixed")]
mod beam16;
mod bundle;
mod nodes;
mod parts;
mod polynomial;
mod quadrature;
mod rays;
mod stretch;

#[cfg(feature = "fixed")]
pub use self::beam16::BeamScattering16;
pub(crate) use self::nodes::AtNodes;
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

/// Default radius of a light: one centimetre if the unit is the metre.
const SOURCE_RADIUS: f32 = 0.01;

impl Haze {
    /// Clear air: a density of 0.
    pub const CLEAR: Self = Self { density: 0.0, source_radius: SOURCE_RADIUS };

    /// Creates haze. The density is the share of the light that is scattered per unit of length.
    ///
    /// A density of 0 is clear air and gives exactly no in-scattering. Real haze is no longer thin
    /// if the density times the size of the scene exceeds a few tenths.
    ///
    /// # Errors
    /// A density outside 0 to 1e9.
    pub fn new(density: f32) -> Result<Self, Error> {
        check_between(Parameter::Density, density, 0.0, 1e9)?;
        Ok(Self { density, source_radius: SOURCE_RADIUS })
    }

    /// Returns the same haze for lights that are spheres of this radius; the default is 0.01.
    ///
    /// There is no haze inside the light, and the light is opaque: a view ray that hits the light
    /// ends there. Without a radius, a light would be infinitely bright to an eye that looks
    /// straight at it.
    ///
    /// # Errors
    /// A radius outside 0.001 to 1e9.
    pub fn with_source_radius(self, source_radius: f32) -> Result<Self, Error> {
        check_between(Parameter::SourceRadius, source_radius, 1e-3, 1e9)?;
        Ok(Self { source_radius, ..self })
    }

    /// Returns the share of the light that is scattered per unit of length.
    pub fn density(&self) -> f32 {
        self.density
    }

    /// Returns the radius of the lights, which are spheres.
    pub fn source_radius(&self) -> f32 {
        self.source_radius
    }
}

/// A line of sight from the eye to a surface, or without an end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ViewRay {
    /// The position of the eye.
    pub eye: Vec3<f32>,
    /// The direction of view, of unit length within the rounding of f32.
    pub direction: Vec3<f32>,
    /// The distance to the surface; infinity if there is none.
    pub length: f32,
}

impl ViewRay {
    /// Returns the ray from the eye to a surface point.
    ///
    /// A point at the eye gives an empty ray, without in-scattering.
    #[inline]
    pub fn between(eye: Vec3<f32>, surface: Vec3<f32>) -> Self {
        let way = surface.zip(eye, |s, e| s - e);
        let squared = way.dot(way);
        let reciprocal = trig::inverse_sqrt(squared);
        Self { eye, direction: way.map(|c| c * reciprocal), length: squared * reciprocal }
    }

    /// Returns the infinite ray from the eye in a direction of unit length.
    #[inline]
    pub fn endless(eye: Vec3<f32>, direction: Vec3<f32>) -> Self {
        Self { eye, direction, length: f32::INFINITY }
    }
}
