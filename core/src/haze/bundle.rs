//! Many view rays at once, and whether a beam can meet any of them.

use super::{
    BeamScattering,
    arc::{Extent, cross},
    beam::FARTHEST,
};
use crate::{attenuation::Attenuation, falloff::Falloff, number::float::positive, trig, vec3::Vec3};

/// Every view ray from an eye within an angle of a direction, up to a length: those of a tile of a picture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RayBundle {
    /// Where the eye is.
    pub eye: Vec3<f32>,
    /// The direction in the middle, of unit length.
    pub direction: Vec3<f32>,
    /// The versine of the largest angle of a ray with the direction in the middle.
    pub versine: f32,
    /// The length of the longest ray; infinity where one has no end.
    pub length: f32,
}

/// What the roundings of both sides may add up to, of the distances from the eye to light and surface: some
/// hundred of them.
const MARGIN: f32 = 2e-5;

impl RayBundle {
    /// The least bundle around a direction that has the rays of these others, all of unit length: the
    /// corners of a tile are enough, because a bundle has whatever lies between its rays.
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

    /// The cosine of the least angle of a unit direction with any of the cap.
    fn nearest_to(&self, direction: Vec3<f32>) -> f32 {
        let (along, across) = (direction.dot(self.axis), cross(direction, self.axis));
        let beside = along * self.cosine + trig::sqrt(across.dot(across)) * self.sine;
        if along > self.cosine { 1.0 } else { beside }
    }

    /// The normal of the plane that touches the cap on the side of a direction; it points away from the
    /// cap.
    fn outward(&self, side: Vec3<f32>) -> Vec3<f32> {
        unit(across(side, self.axis)).zip(self.axis, |c, a| self.cosine * c - self.sine * a)
    }
}

/// The part of a vector at a right angle with a unit vector.
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
    /// Whether any ray of a bundle may have [`in_scattering`](Self::in_scattering). Where this says no, each has
    /// exactly none; where it says yes, all may have none.
    ///
    /// The answer is no where a plane through the light has the beam on one side and the rays on the other,
    /// or all rays are beyond a plane at the light's range. The margin is some hundred roundings of the
    /// distances, more than this test and the evaluation have together. The planes that might serve are
    /// those that touch beam or bundle: a ray beside the beam is told by one that touches the beam between where the
    /// ray begins and where it ends, seen along the axis. Each is tried as it has come out of its construction, whose
    /// roundings can lose a no and cannot make one.
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
            // How far the eye and the ends of the rays are from the plane through the light.
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
}
