//! The oracle: the formulas as the literature writes them, in f64, as plainly as they can be
//! written.
//!
//! Nothing here is fast and nothing is shared with the code under test. Where f64 itself would
//! cancel, the versine is `2 sin^2(angle / 2)` or half the squared difference of two unit vectors.

/// An edge profile as a function of t.
pub type Falloff = fn(f64) -> f64;

/// Hast 2004, section 2.
pub fn soft(t: f64) -> f64 {
    t * t
}

/// Hast 2004, section 3.
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

/// The quadratic halfway from soft to linear, by its coefficients.
pub fn quadratic(t: f64) -> f64 {
    0.5 * t + 0.5 * t * t
}

/// A steep monotone cubic, of slopes 1.25 at the edge and 3.5 in the middle, by its coefficients.
pub fn cubic(t: f64) -> f64 {
    1.25 * t - 3.0 * t.powi(2) + 2.75 * t.powi(3)
}

pub fn power_4(t: f64) -> f64 {
    t.powi(4)
}

pub fn power_15(t: f64) -> f64 {
    t.powi(15)
}

/// Godot.
pub fn inverted_power_4(t: f64) -> f64 {
    1.0 - (1.0 - t).powi(4)
}

/// 1 - cos of a half angle in degrees.
pub fn versine(half_degrees: f64) -> f64 {
    let sine = (half_degrees.to_radians() / 2.0).sin();
    2.0 * sine * sine
}

/// The half angle in degrees that has this versine.
pub fn half_degrees(versine: f64) -> f64 {
    2.0 * (versine / 2.0).sqrt().asin().to_degrees()
}

/// Intensity of a spotlight without a hotspot at a versine off its axis.
pub fn falloff(profile: Falloff, versine: f64, outer_versine: f64) -> f64 {
    Cone::new(profile, outer_versine).falloff(versine)
}

/// A cone by the versines of its half angles.
#[derive(Clone, Copy)]
pub struct Cone {
    pub profile: Falloff,
    pub inner: f64,
    pub outer: f64,
    /// Where a cutoff cuts the cone off; `outer` where there is none.
    pub limit: f64,
}

impl Cone {
    /// Without a hotspot or a cutoff.
    pub fn new(profile: Falloff, outer: f64) -> Self {
        Self { profile, inner: 0.0, outer, limit: outer }
    }

    /// The cosine of the angle off axis to an integer power, and nothing from the cutoff on.
    pub fn opengl(power: Falloff, cutoff: f64) -> Self {
        Self { profile: power, inner: 0.0, outer: 1.0, limit: cutoff }
    }

    /// Intensity at a versine off the axis.
    pub fn falloff(&self, versine: f64) -> f64 {
        if versine >= self.limit {
            0.0
        } else if versine <= self.inner {
            (self.profile)(1.0)
        } else {
            (self.profile)((self.outer - versine) / (self.outer - self.inner))
        }
    }

    /// Whether the intensity jumps within `radians` of this versine: an error there has no meaning.
    pub fn jumps_near(&self, versine: f64, radians: f64) -> bool {
        let jump = self.falloff(self.limit * (1.0 - 1e-12)) > 0.01;
        jump && (half_degrees(versine) - half_degrees(self.limit)).abs().to_radians() < radians
    }
}

pub type Vector = [f64; 3];

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn scaled(a: Vector, by: f64) -> Vector {
    [a[0] * by, a[1] * by, a[2] * by]
}

pub fn unit(a: Vector) -> Vector {
    scaled(a, 1.0 / dot(a, a).sqrt())
}

/// The versine of the angle between two directions.
pub fn versine_between(a: Vector, b: Vector) -> f64 {
    let difference = minus(unit(a), unit(b));
    dot(difference, difference) / 2.0
}

/// The attenuation over distance.
pub type Attenuation = fn(f64) -> f64;

/// `1 / (a0 + a1 d + a2 d^2)`, capped at 1.
pub fn polynomial([a0, a1, a2]: [f64; 3], d: f64) -> f64 {
    (1.0 / (a0 + a1 * d + a2 * d * d)).min(1.0)
}

/// GLSL's smoothstep with its edges in rising order, from the range back to 0.
pub fn smooth_range(range: f64, d: f64) -> f64 {
    let t = (1.0 - d / range).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// KHR_lights_punctual of glTF.
pub fn gltf_range(range: f64, d: f64) -> f64 {
    (1.0 - (d / range).powi(4)).clamp(0.0, 1.0) / (d * d)
}

/// Filament, Bevy, three.js.
pub fn filament_range(range: f64, d: f64) -> f64 {
    (1.0 - (d / range).powi(4)).clamp(0.0, 1.0).powi(2) / (d * d)
}

/// The mirror image of a direction in the surface of a unit normal, as GLSL's `reflect`.
pub fn reflect(direction: Vector, normal: Vector) -> Vector {
    minus(direction, scaled(normal, 2.0 * dot(direction, normal)))
}

/// A highlight: from the directions to the light and to the eye, the normal and the shininess.
pub type Lobe = fn(Vector, Vector, Vector, f64) -> f64;

/// `max(0, R.V)^m`.
pub fn phong(to_light: Vector, to_eye: Vector, normal: Vector, shininess: f64) -> f64 {
    let r = reflect(scaled(to_light, -1.0), normal);
    dot(r, to_eye).max(0.0).powf(shininess)
}

/// `max(0, N.H)^m`.
pub fn blinn_phong(to_light: Vector, to_eye: Vector, normal: Vector, shininess: f64) -> f64 {
    dot(normal, halfway(to_light, to_eye)).max(0.0).powf(shininess)
}

/// `clamp(R.H)^m`, as the dual-cone article's shader writes it.
pub fn dual_cone(to_light: Vector, to_eye: Vector, normal: Vector, shininess: f64) -> f64 {
    let r = reflect(scaled(to_light, -1.0), normal);
    dot(r, halfway(to_light, to_eye)).clamp(0.0, 1.0).powf(shininess)
}

/// Lyon's difference form of Phong's lobe by two squarings.
pub fn lyon(to_light: Vector, to_eye: Vector, normal: Vector, shininess: f64) -> f64 {
    let r = reflect(scaled(to_light, -1.0), normal);
    let difference = minus(r, to_eye);
    (1.0 - shininess / 4.0 * dot(difference, difference) / 2.0).max(0.0).powi(4)
}

/// The direction halfway between two.
pub fn halfway(a: Vector, b: Vector) -> Vector {
    unit([a[0] + b[0], a[1] + b[1], a[2] + b[2]])
}

/// One channel of the classic equation for one light:
/// `ma Ia + f(d) spot [md Is max(0, N.L) + ms Is max(0, R.V)^mh]`. A surface that faces away has no
/// highlight.
pub struct Classic {
    pub ambient: [f64; 2],
    pub diffuse: [f64; 2],
    pub specular: [f64; 2],
    pub shininess: f64,
}

impl Classic {
    pub fn light(&self, arriving: f64, to_light: Vector, to_eye: Vector, normal: Vector) -> f64 {
        let [ma, ia] = self.ambient;
        let [md, diffuse] = self.diffuse;
        let [ms, specular] = self.specular;
        let cosine = dot(normal, to_light).max(0.0);
        let lobe = if cosine > 0.0 { phong(to_light, to_eye, normal, self.shininess) } else { 0.0 };
        ma * ia + arriving * (md * diffuse * cosine + ms * specular * lobe)
    }
}

/// A spotlight with inverse-square distance.
#[derive(Clone, Copy)]
pub struct SpotLight {
    pub position: Vector,
    pub axis: Vector,
    pub cone: Cone,
    pub intensity: f64,
}

impl SpotLight {
    /// The falloff of the cone at a point.
    pub fn falloff(&self, point: Vector) -> f64 {
        self.cone.falloff(self.versine(point))
    }

    /// The versine of the angle off axis.
    pub fn versine(&self, point: Vector) -> f64 {
        versine_between(minus(point, self.position), self.axis)
    }

    /// The light that arrives at a surface point: intensity x falloff x Lambert's cosine / squared
    /// distance.
    pub fn irradiance(&self, point: Vector, normal: Vector) -> f64 {
        let way = minus(point, self.position);
        let cosine = -dot(unit(way), normal);
        self.intensity * self.falloff(point) * cosine.clamp(0.0, 1.0) / dot(way, way)
    }
}

/// The sRGB code of a linear value in [0, 1], before it is rounded (IEC 61966-2-1).
pub fn srgb_code(linear: f64) -> f64 {
    let value = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    255.0 * value
}

/// The linear value of an sRGB code.
pub fn srgb_linear(code: f64) -> f64 {
    let value = code / 255.0;
    if value <= 0.040_45 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}
