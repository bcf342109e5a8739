//! The sites at which the errors of lit points are measured.

use fastrand::Rng;
use luminaire::Vec3;
use luminaire_kernels::scene::{Population, Site, Sites};
use luminaire_kernels::truth::{Highlight, Point, widened};
use luminaire_oracle::climb::{grid_step, one_of, size};
use luminaire_oracle::{DVec3, SplitMix64, half_degrees, on_grid, turned};

/// Number of sites.
const COUNT: usize = 1 << 16;
/// As far off axis as this, in outer half angles: the edge and a little beyond.
const REACH: f64 = 1.02;
/// The distances from the light.
const DISTANCES: [f64; 2] = [1.0, 7.0];
/// The least cosine of incidence with a highlight. Below, a highlight jumps to zero in the model itself, and
/// no format can place the jump.
const LEAST_COSINE: f64 = 0.1;

/// Sites about a light. Those of the lit population reach over the edge, every other one facing so
/// that a highlight is near; those of others are the ones that costs are counted on.
pub(crate) fn about(truth: &Point) -> Vec<Site> {
    if truth.population != Population::Lit {
        return Sites::new(truth.population, truth.light.cone.outer as f32).take(COUNT).collect();
    }
    let mut random = SplitMix64(1983);
    let axis = truth.light.axis.normalize();
    let half_angle = half_degrees(truth.light.cone.outer).to_radians();
    let mut sites = Vec::new();
    while sites.len() < COUNT {
        let angle = half_angle * random.between(0.0, REACH);
        let way = turned(axis, perpendicular(&mut random, axis), angle);
        let [least, most] = DISTANCES;
        let distance = random.between(least, most);
        let point = on_grid(truth.light.position + distance * way);
        let (middle, spread) = match truth.highlight {
            Some(Highlight { eye, .. }) if sites.len() % 2 == 0 => {
                let to_eye = (eye - point.as_vec3().as_dvec3()).normalize();
                ((to_eye - way).normalize(), 0.3)
            }
            _ => (-way, 1.4),
        };
        let across = perpendicular(&mut random, middle);
        let normal = turned(middle, across, random.between(0.0, spread));
        let site = Site { point: point_of(point), normal: point_of(normal) };
        if is_counted(truth, &site) {
            sites.push(site);
        }
    }
    sites
}

/// Whether a site is within the distances and angles of the sites about a light.
pub(crate) fn is_counted(truth: &Point, site: &Site) -> bool {
    let to_light = truth.light.position - widened(site.point);
    let distance = to_light.length();
    let least = if truth.highlight.is_some() { LEAST_COSINE } else { 0.0 };
    let angle = half_degrees(truth.light.versine(widened(site.point)));
    // A site is on a grid: it may be nearer or farther by a quantum.
    (DISTANCES[0] - 1e-4..=DISTANCES[1] + 1e-4).contains(&distance)
        && angle <= half_degrees(truth.light.cone.outer) * REACH + 1e-2
        && widened(site.normal).dot(to_light) >= least * distance
}

/// A site of which a coordinate of the point or a component of the normal differs.
pub(crate) fn moved(rng: &mut Rng, mut site: Site) -> Site {
    let size = size(rng);
    if rng.bool() {
        let step = grid_step(rng, size);
        site.point = one_of(rng, site.point, step);
    } else {
        let bent = one_of(rng, site.normal, |c| c + size);
        site.normal = point_of(widened(bent).normalize());
    }
    site
}

fn point_of(v: DVec3) -> Vec3<f32> {
    let [x, y, z] = v.as_vec3().to_array();
    Vec3::new(x, y, z)
}

/// A random direction at right angles to another.
fn perpendicular(random: &mut SplitMix64, axis: DVec3) -> DVec3 {
    loop {
        let any = random.vector(-1.0, 1.0);
        let across = any - any.dot(axis) * axis;
        if across.length_squared() > 0.01 {
            return across.normalize();
        }
    }
}
