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

/// Godot's cone with an exponent of 4.
pub fn inverted_power_4(t: f64) -> f64 {
    1.0 - power_4(1.0 - t)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versine_near_zero_keeps_its_digits() {
        // x^2 / 2 - x^4 / 24, where 1 - cos has half of the digits at 0.01 degrees and none at 1e-7.
        for degrees in [0.01_f64, 1e-4, 1e-7] {
            let x = degrees.to_radians();
            let exact = x * x / 2.0 * (1.0 - x * x / 12.0);
            assert!((versine(degrees) / exact - 1.0).abs() < 1e-15, "{degrees}");
            assert!((half_degrees(exact) / degrees - 1.0).abs() < 1e-15, "{degrees}");
            let (sine, cosine) = libm::sincos(x);
            let between = versine_between(3.0 * DVec3::X, DVec3::new(cosine, sine, 0.0));
            assert!((between / exact - 1.0).abs() < 1e-9, "{degrees}: {between}");
        }
        assert!((versine(60.0) - 0.5).abs() < 1e-15 && versine(180.0) == 2.0);
        assert_eq!(versine_between(DVec3::X, -2.0 * DVec3::X), 2.0);
    }

    #[test]
    fn profiles_have_their_values() {
        let at_a_quarter = [
            (soft as Falloff, 0.0625),
            (hard, 0.4375),
            (linear, 0.25),
            (step, 1.0),
            (smooth, 0.156_25),
            (cubic, 0.167_968_75),
            (power_4, 0.003_906_25),
            (power_15, 9.313_225_746_154_785e-10),
            (inverted_power_4, 0.683_593_75),
        ];
        for (index, (falloff, value)) in at_a_quarter.into_iter().enumerate() {
            assert!((falloff(0.25) - value).abs() < 1e-16, "{index}: {} is not {value}", falloff(0.25));
            assert_eq!((falloff(0.0), falloff(1.0)), (0.0, 1.0), "{index}");
        }
    }

    #[test]
    fn cone_ends_at_its_limit_and_jumps_only_there() {
        let cone = Cone { inner: 0.1, ..Cone::new(linear, 0.5) };
        assert_eq!([0.0, 0.1, 0.3, 0.5, 2.0].map(|v| cone.falloff(v)), [1.0, 1.0, 0.5, 0.0, 0.0]);
        // Warn's light at 60 degrees, by the square; OpenGL's cutoff at 45 degrees.
        assert_eq!(Cone::opengl(2.0, 1.0).falloff(0.5), 0.25);
        let cut = Cone::opengl(1.0, versine(45.0));
        assert!(cut.falloff(versine(44.9)) > 0.7 && cut.falloff(versine(45.1)) == 0.0);
        assert!(cut.jumps_near(versine(45.1), 0.01) && !cut.jumps_near(versine(46.0), 0.01));
        assert!(!cone.jumps_near(0.5, 0.01));
    }
}
