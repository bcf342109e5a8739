//! The exact models in f64: the formulas as the literature writes them, as plain code.
//!
//! Nothing here is fast, and no code is shared with the kernels. Where f64 itself would cancel,
//! a versine is half the squared difference of two unit vectors.

use crate::scene::{Population, Site};

/// A vector of f64.
pub type Vector = [f64; 3];

/// The exact model of a falloff.
#[derive(Clone, Copy, Debug)]
pub struct Falloff {
    /// The versine from which on there is no light.
    pub outer: f64,
    /// The intensity at a versine less than `outer`.
    pub model: Model,
    /// Whether the intensity jumps at the outer versine. There only the position of the jump is
    /// tested, so that no intensity error is measured next to it.
    pub jumps: bool,
}

/// A model of intensities.
#[derive(Clone, Copy, Debug)]
pub enum Model {
    /// A profile: a function of `t = (outer - versine) / outer`.
    Profile(fn(f64) -> f64),
    /// The power of the cosine: Warn 1983, and OpenGL. It has no edge.
    CosinePower(f64),
}

impl Falloff {
    /// The intensity at a versine off the axis.
    pub fn at(&self, versine: f64) -> f64 {
        match self.model {
            Model::CosinePower(exponent) => libm::pow(1.0 - versine, exponent),
            Model::Profile(_) if versine >= self.outer => 0.0,
            Model::Profile(profile) => profile((self.outer - versine) / self.outer),
        }
    }

    /// Whether a versine is so near a jump that a kernel may evaluate either side of it: within
    /// 1/510 of the half angle.
    pub fn is_at_jump(&self, versine: f64) -> bool {
        self.jumps && (libm::sqrt(versine / self.outer) - 1.0).abs() < 1.0 / 510.0
    }
}

/// The exact model of a lit point.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Position of the light.
    pub position: Vector,
    /// Axis of the light, of any length.
    pub axis: Vector,
    /// The cone.
    pub falloff: Falloff,
    /// Intensity on the axis.
    pub intensity: f64,
    /// Whether the light has the inverse square.
    pub falls: bool,
    /// The specular lobe, if there is one.
    pub highlight: Option<Highlight>,
    /// The population of its sites.
    pub population: Population,
}

/// Phong's specular lobe and a diffuse reflection, in one channel.
#[derive(Clone, Copy, Debug)]
pub struct Highlight {
    /// Position of the eye.
    pub eye: Vector,
    /// The diffuse reflectance.
    pub diffuse: f64,
    /// The specular reflectance.
    pub specular: f64,
    /// The exponent.
    pub shininess: f64,
}

impl Point {
    /// Returns the irradiance at a site, or the light that it reflects to the eye. Lambert's cosine
    /// uses the normal as it is, of unit length within the rounding of f32; the mirror direction
    /// uses the normalised one.
    pub fn at(&self, site: &Site) -> f64 {
        let (point, normal) = (widened(site.point), widened(site.normal));
        let way = minus(point, self.position);
        let (direction, axis) = (unit(way), unit(self.axis));
        let difference = minus(direction, axis);
        let falloff = self.falloff.at(dot(difference, difference) / 2.0);
        let arriving = self.intensity * falloff / if self.falls { dot(way, way) } else { 1.0 };
        let cosine = -dot(direction, normal);
        if cosine <= 0.0 {
            return 0.0;
        }
        match self.highlight {
            None => arriving * cosine,
            Some(highlight) => {
                let upright = unit(normal);
                let mirror = minus(direction, scaled(upright, 2.0 * dot(direction, upright)));
                let to_eye = unit(minus(highlight.eye, point));
                let lobe = libm::pow(dot(mirror, to_eye).max(0.0), highlight.shininess);
                arriving * (highlight.diffuse * cosine + highlight.specular * lobe)
            }
        }
    }
}

/// The vector in f64.
pub fn widened(v: luminaire::Vec3<f32>) -> Vector {
    [v.x.into(), v.y.into(), v.z.into()]
}

/// The inner product.
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The difference.
pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The multiple.
pub fn scaled(a: Vector, by: f64) -> Vector {
    a.map(|c| c * by)
}

/// The direction, of unit length.
pub fn unit(a: Vector) -> Vector {
    scaled(a, 1.0 / libm::sqrt(dot(a, a)))
}
