//! The sites at which the errors of lit points are measured.

use luminaire::Vec3;
use luminaire_kernels::oracle::{Point, Vector, dot, minus, scaled, unit, widened};
use luminaire_kernels::scene::{Population, Site, Sites};

use crate::random::Random;

/// Number of sites.
const COUNT: usize = 1 << 16;
/// As far off axis as this, in outer half angles: the edge and a little beyond.
const REACH: f64 = 1.02;
/// The distances from the light.
const DISTANCES: [f64; 2] = [1.0, 7.0];
/// The least cosine of incidence. Below, a highlight jumps to zero in the model itself, and no
/// format can place the jump.
const LEAST_COSINE: f64 = 0.1;

/// Sites about a light. Those of the lit population reach over the edge, every other one facing so
/// that a highlight is near; those of others are the ones that costs are counted on.
pub(crate) fn about(truth: &Point) -> Vec<Site> {
    if truth.population != Population::Lit {
        return Sites::new(truth.population, truth.falloff.outer as f32).take(COUNT).collect();
    }
    let mut random = Random::new(1983);
    let axis = unit(truth.axis);
    let half_angle = half_angle(truth.falloff.outer);
    let mut sites = Vec::new();
    while sites.len() < COUNT {
        let angle = half_angle * random.between(0.0, REACH);
        let way = turned(axis, perpendicular(&mut random, axis), angle);
        let [least, most] = DISTANCES;
        let way_back = scaled(way, -1.0);
        let distance = random.between(least, most);
        let point = [0, 1, 2].map(|i| on_grid(truth.position[i] + distance * way[i]));
        let (middle, spread) = match truth.highlight {
            Some(highlight) if sites.len() % 2 == 0 => {
                let to_eye = unit(minus(highlight.eye, widened(point_of(point))));
                (unit(minus(way_back, scaled(to_eye, -1.0))), 0.3)
            }
            _ => (way_back, 1.4),
        };
        let across = perpendicular(&mut random, middle);
        let normal = turned(middle, across, random.between(0.0, spread));
        if dot(normal, way_back) >= LEAST_COSINE {
            sites.push(Site { point: point_of(point), normal: point_of(normal) });
        }
    }
    sites
}

/// The half angle in radians that has a versine.
pub(crate) fn half_angle(versine: f64) -> f64 {
    2.0 * (versine / 2.0).sqrt().asin()
}

fn point_of(v: Vector) -> Vec3<f32> {
    Vec3::new(v[0] as f32, v[1] as f32, v[2] as f32)
}

/// The nearest multiple of 2^-16, which every format has.
fn on_grid(value: f64) -> f64 {
    (value * 65_536.0).round() / 65_536.0
}

/// A random direction at right angles to another.
fn perpendicular(random: &mut Random, axis: Vector) -> Vector {
    loop {
        let any = [0; 3].map(|_| random.between(-1.0, 1.0));
        let across = minus(any, scaled(axis, dot(any, axis)));
        if dot(across, across) > 0.01 {
            return unit(across);
        }
    }
}

/// A direction, turned towards another at right angles to it.
fn turned(from: Vector, towards: Vector, angle: f64) -> Vector {
    let (sine, cosine) = angle.sin_cos();
    [0, 1, 2].map(|i| from[i] * cosine + towards[i] * sine)
}
