//! Versines, falloffs and cones.

use glam::DVec3;

/// A falloff by its function of `t`, which is 0 at the edge and 1 on the axis.
pub type Falloff = fn(f64) -> f64;

/// The soft edge: Hast 2004, section 2.
pub fn soft(t: f64) -> f64 {
    t * t
}

/// The hard edge: Hast 2004, section 3.
pub fn hard(t: f64) -> f64 {
    let u = 1.0 - t;
    1.0 - u * u
}

/// Umbra and penumbra.
pub fn linear(t: f64) -> f64 {
    t
}

/// A single umbra.
pub fn step(t: f64) -> f64 {
    if t > 0.0 { 1.0 } else { 0.0 }
}

/// smoothstep of GLSL.
pub fn smooth(t: f64) -> f64 {
    t * t * (3.0 - 2.0 * t)
}

/// A steep monotone cubic, of slopes 1.25 at the edge and 3.5 in the middle, by its coefficients.
pub fn cubic(t: f64) -> f64 {
    1.25 * t - 3.0 * t * t + 2.75 * t * t * t
}

/// The fourth power.
pub fn power_4(t: f64) -> f64 {
    soft(soft(t))
}

/// The fifteenth power.
pub fn power_15(t: f64) -> f64 {
    libm::pow(t, 15.0)
}

/// 1 - cos of a half angle in degrees.
pub fn versine(half_degrees: f64) -> f64 {
    let sine = libm::sin(half_degrees.to_radians() / 2.0);
    2.0 * sine * sine
}

/// The half angle in degrees that has this versine.
pub fn half_degrees(versine: f64) -> f64 {
    2.0 * libm::asin(libm::sqrt(versine / 2.0)).to_degrees()
}

/// The versine of the angle between two directions of any length.
pub fn versine_between(a: DVec3, b: DVec3) -> f64 {
    a.normalize().distance_squared(b.normalize()) / 2.0
}

/// Intensity of a spotlight without a hotspot at a versine off its axis.
pub fn falloff(falloff: Falloff, versine: f64, outer_versine: f64) -> f64 {
    Cone::new(falloff, outer_versine).falloff(versine)
}

/// The intensity over `t`.
#[derive(Clone, Copy, Debug)]
pub enum Curve {
    /// A function of `t`.
    Function(Falloff),
    /// `t` to a power.
    Power(f64),
    /// `t (a + t (b + t c))` with `[a, b, c]`.
    Polynomial([f64; 3]),
}

impl Curve {
    /// Evaluates the falloff.
    pub fn at(self, t: f64) -> f64 {
        match self {
            Self::Function(function) => function(t),
            Self::Power(exponent) => libm::pow(t, exponent),
            Self::Polynomial([a, b, c]) => t * (a + t * (b + t * c)),
        }
    }
}

/// A cone by the versines of its half angles.
#[derive(Clone, Copy, Debug)]
pub struct Cone {
    /// The intensity from `outer` to `inner`.
    pub falloff: Curve,
    /// Full intensity up to here.
    pub inner: f64,
    /// Where the falloff ends.
    pub outer: f64,
    /// Where a cutoff ends the cone; `outer` where there is none.
    pub limit: f64,
}

impl Cone {
    /// Without a hotspot or a cutoff.
    pub fn new(falloff: Falloff, outer: f64) -> Self {
        Self { falloff: Curve::Function(falloff), inner: 0.0, outer, limit: outer }
    }

    /// The cosine of the angle off axis to a power, and nothing from the cutoff on: OpenGL, and with
    /// a cutoff at 90 degrees Warn 1983.
    pub fn opengl(exponent: f64, cutoff: f64) -> Self {
        Self { falloff: Curve::Power(exponent), inner: 0.0, outer: 1.0, limit: cutoff }
    }

    /// Intensity at a versine off the axis.
    pub fn falloff(&self, versine: f64) -> f64 {
        if versine >= self.limit {
            0.0
        } else if versine <= self.inner {
            self.falloff.at(1.0)
        } else {
            self.falloff.at((self.outer - versine) / (self.outer - self.inner))
        }
    }

    /// Whether the intensity jumps within `radians` of this versine: an error there has no meaning.
    pub fn jumps_near(&self, versine: f64, radians: f64) -> bool {
        let jump = self.falloff(self.limit * (1.0 - 1e-12)) > 0.01;
        jump && (half_degrees(versine) - half_degrees(self.limit)).abs().to_radians() < radians
    }
}
