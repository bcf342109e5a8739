//! Bundles of view rays, and a conservative test of whether a beam can meet any ray of a bundle.

use super::{BeamScattering, arc::Extent, beam::FARTHEST};
use crate::{attenuation::Attenuation, falloff::Falloff, number::float::positive, trig, vec3::Vec3};

/// All view rays from an eye within an angle of a direction, up to a length.
///
/// An example is the set of view rays of a screen tile.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RayBundle {
    /// The position of the eye.
    pub eye: Vec3<f32>,
    /// The axis of the bundle: the direction of its central ray, of unit length.
    pub direction: Vec3<f32>,
    /// The versine of the largest angle between a ray and the axis.
    pub versine: f32,
    /// The length of the longest ray; infinity if a ray is infinite.
    pub length: f32,
}

/// Bound of the rounding errors of [`can_meet`](BeamScattering::can_meet) and of the evaluation:
/// about a hundred rounding errors of a distance.
///
/// The bound is relative to the distances from the eye to the light and to the surface.
const MARGIN: f32 = 2e-5;

impl RayBundle {
    /// Returns the smallest bundle around a direction that contains these other directions.
    ///
    /// All directions have unit length. For a screen tile, the rays through the corners of the tile
    /// suffice, because a bundle contains all directions between its rays.
    pub fn around(eye: Vec3<f32>, direction: Vec3<f32>, others: &[Vec3<f32>], length: f32) -> Self {
        let versine = |&other: &Vec3<f32>| {
            let difference = other.zip(direction, |o, d| o - d);
            0.5 * difference.dot(difference)
        };
        let versine = others.iter().map(versine).fold(0.0, |most, one| if one > most { one } else { most });
        Self { eye, direction, versine, length }
    }
}

/// The directions within an angle of an axis.
struct Cap {
    axis: Vec3<f32>,
    sine: f32,
    cosine: f32,
}

impl Cap {
    fn new(axis: Vec3<f32>, versine: f32) -> Self {
        Self { axis, sine: trig::sqrt(positive(versine * (2.0 - versine))), cosine: 1.0 - versine }
    }

    /// Returns the cosine of the smallest angle between a unit direction and the cap.
    fn nearest_to(&self, direction: Vec3<f32>) -> f32 {
        let (along, across) = (direction.dot(self.axis), direction.cross(self.axis));
        let beside = along * self.cosine + trig::sqrt(across.dot(across)) * self.sine;
        if along > self.cosine { 1.0 } else { beside }
    }

    /// Returns the outward normal of the plane that touches the cap on the side of the direction
    /// `side`.
    fn outward(&self, side: Vec3<f32>) -> Vec3<f32> {
        unit(across(side, self.axis)).zip(self.axis, |c, a| self.cosine * c - self.sine * a)
    }
}

/// Returns the component of a vector orthogonal to a unit vector.
fn across(v: Vec3<f32>, axis: Vec3<f32>) -> Vec3<f32> {
    let along = v.dot(axis);
    v.zip(axis, |v, a| v - along * a)
}

fn unit(v: Vec3<f32>) -> Vec3<f32> {
    let reciprocal = trig::inverse_sqrt(v.dot(v));
    v.map(|c| c * reciprocal)
}

fn reversed(v: Vec3<f32>) -> Vec3<f32> {
    v.map(|c| -c)
}

impl<P: Falloff, A: Attenuation> BeamScattering<P, A> {
    /// Returns whether [`in_scattering`](Self::in_scattering) may be more than 0 for any ray of a
    /// bundle.
    ///
    /// In a beam of a half angle of at least 0.1 degrees, up to its [`outer_versine`](Self::outer_versine), the
    /// in-scattering of every ray is exactly 0 if the result is `false`. If the result is `true`, the in-scattering may
    /// still be 0.
    ///
    /// The result is `false` if a plane through the light separates the beam from the rays, or if
    /// all rays are beyond a plane at the light's range. A plane counts only if the distances of
    /// the rays' ends from the plane exceed a margin of about a hundred rounding errors of a
    /// distance. From 0.1 degrees on this margin is more than six times the rounding errors of this test and of the
    /// evaluation (searched); rays at the rim of a narrower beam may be missed. The candidate planes touch
    /// the beam or the bundle. For a ray beside the beam, one candidate plane touches the beam between the
    /// ray's ends, as seen along the axis. The test uses the rounded normal of each plane. So a rounding
    /// error can miss a separating plane, but `false` remains correct.
    pub fn can_meet(&self, bundle: &RayBundle) -> bool {
        let Extent { position, axis, reach_squared, .. } = self.extent();
        let eye = bundle.eye.zip(position, |e, p| e - p);
        let (back, distance) = (unit(eye), trig::sqrt(eye.dot(eye)));
        let [_, outer] = self.cone;
        let beam = Cap::new(axis, outer);
        let rays = Cap::new(bundle.direction, bundle.versine);
        let length = bundle.length.min(FARTHEST);
        let reach = trig::sqrt(reach_squared);
        let separates = |normal: Vec3<f32>| {
            let normal = unit(normal);
            // Distances of the eye and of the ends of the rays from the plane through the light.
            let near = normal.dot(eye);
            let far = near - length * rays.nearest_to(reversed(normal));
            let slack = MARGIN + positive(beam.nearest_to(normal));
            let beyond = reach + MARGIN * reach;
            (near > slack * distance && far > slack * (distance + length))
                || (near > beyond + MARGIN * distance && far > beyond + MARGIN * (distance + length))
        };
        let end = eye.zip(bundle.direction, |e, d| e + length * d);
        let [first, last] = [eye, end].map(|v| unit(across(v, axis)));
        let middle = first.zip(last, |f, l| f + l);
        let normals = [
            back,
            beam.outward(first),
            beam.outward(middle),
            beam.outward(last),
            reversed(rays.outward(axis)),
            reversed(rays.outward(reversed(back))),
        ];
        self.gain > 0.0 && !normals.into_iter().any(separates)
    }

    /// Returns the versine of the angle off axis from which on there is no in-scattering.
    ///
    /// It is the outer versine of the cone, or less if the intensity falls below 2^-16 before.
    pub fn outer_versine(&self) -> f32 {
        self.cone[1]
    }

    /// Returns the normals of the two planes through an eye and the light that touch the beam.
    ///
    /// The planes are the sides of the beam as seen from the eye. The in-scattering of a view ray is
    /// more than 0 only if the scalar products of its direction with both normals are at least 0,
    /// within the rounding of the directions. The normals have unit length. Both are zero if the eye
    /// is in the cone of the beam or in the opposite cone, or nearly so: then no plane through the
    /// eye and the light touches the beam.
    pub fn sides(&self, eye: Vec3<f32>) -> [Vec3<f32>; 2] {
        let light = unit(self.position.zip(eye, |p, e| p - e));
        // Near the axis the difference is short, and its rounding errors have a part along `light`.
        let beside = across(across(self.axis, light), light);
        let [_, outer] = self.cone;
        let (length, cone) = (trig::sqrt(beside.dot(beside)), Cap::new(self.axis, outer));
        // The sine of the angle between each plane and the axis is that of the outer angle, so it
        // is `cosine * length` for a normal at this angle from `beside`. Near a cosine of 1 the
        // angle would lose half its bits.
        let cosine = cone.sine / length;
        if !(cosine < 0.999 && cone.cosine > 0.0) {
            return [Vec3::new(0.0, 0.0, 0.0); 2];
        }
        let beside = beside.map(|c| c / length);
        let (sine, other) = (trig::sqrt(1.0 - cosine * cosine), light.cross(beside));
        [sine, -sine].map(|sine| beside.zip(other, |b, o| cosine * b + sine * o))
    }
}
