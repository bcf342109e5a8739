//! The exact model of a lit point.

use luminaire::Vec3;
use luminaire_oracle::{Classic, DVec3, SpotLight};

use crate::scene::{Population, Site};

/// A light, and what it is seen on.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// The light.
    pub light: SpotLight,
    /// The specular lobe, if there is one.
    pub highlight: Option<Highlight>,
    /// The population of its sites.
    pub population: Population,
}

/// A shiny surface, in one channel.
#[derive(Clone, Copy, Debug)]
pub struct Highlight {
    /// Position of the eye.
    pub eye: DVec3,
    /// The surface.
    pub surface: Classic,
}

impl Point {
    /// Returns the irradiance at a site, or the light that it reflects to the eye. Lambert's cosine
    /// uses the normal as it is, of unit length within the rounding of f32.
    pub fn at(&self, site: &Site) -> f64 {
        let (point, normal) = (widened(site.point), widened(site.normal));
        let arriving = self.light.arriving(point);
        let to_light = (self.light.position - point).normalize();
        match self.highlight {
            None => arriving * to_light.dot(normal).max(0.0),
            Some(Highlight { eye, surface }) => {
                surface.light(arriving, to_light, (eye - point).normalize(), normal)
            }
        }
    }
}

/// The vector in f64.
pub fn widened(v: Vec3<f32>) -> DVec3 {
    DVec3::new(v.x.into(), v.y.into(), v.z.into())
}
