//! What a ray from a light hits, in f64: every triangle of a scene, one after the other.

use crate::{bounds::Bounds, scene::Scene};
use alloc::vec::Vec;
extern crate std;
use luminaire::{Projection, Vec3};

pub(super) type Vector = [f64; 3];

/// The triangles of a mesh, from whichever side they are seen.
struct Body {
    center: Vector,
    radius: f64,
    triangles: Vec<[Vector; 3]>,
}

/// A light above a scene.
pub(super) struct Light {
    position: Vector,
    right: Vector,
    down: Vector,
    axis: Vector,
    tangent: f64,
    bodies: Vec<Body>,
}

/// Where a point is on the map, in parts of its side, and at what depth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) column: f64,
    pub(super) row: f64,
    pub(super) depth: f64,
}

pub(super) fn double(v: Vec3<f32>) -> Vector {
    [v.x, v.y, v.z].map(f64::from)
}

fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl Body {
    fn is_missed(&self, from: Vector, way: Vector) -> bool {
        let across = cross(minus(self.center, from), way);
        dot(across, across) > self.radius * self.radius * dot(way, way)
    }
}

/// The parameter along a way at which it meets a triangle.
fn hit(from: Vector, way: Vector, [a, b, c]: [Vector; 3]) -> Option<f64> {
    let (u, v) = (minus(b, a), minus(c, a));
    let normal = cross(u, v);
    let along = dot(normal, way);
    if along == 0.0 {
        return None;
    }
    let t = dot(normal, minus(a, from)) / along;
    let inside = minus([0, 1, 2].map(|i| from[i] + t * way[i]), a);
    let area = dot(normal, normal);
    let (beta, gamma) = (dot(cross(inside, v), normal) / area, dot(cross(u, inside), normal) / area);
    (beta >= -1e-9 && gamma >= -1e-9 && beta + gamma <= 1.0 + 1e-9 && t > 0.0).then_some(t)
}

impl Light {
    pub(super) fn new(scene: &Scene, projection: &Projection) -> Self {
        let bodies = scene.objects().iter().map(|object| {
            let vertices = object.mesh.vertices();
            let place = |i: u32| double(vertices[i as usize].position.into());
            let bounds = Bounds::of(vertices.iter().map(|vertex| vertex.position));
            Body {
                center: double(bounds.center.into()),
                radius: 1.001 * f64::from(bounds.radius),
                triangles: object.mesh.triangles().iter().map(|triangle| triangle.map(place)).collect(),
            }
        });
        Self {
            position: double(projection.position()),
            right: double(projection.right()),
            down: double(projection.up().map(|c| -c)),
            axis: double(projection.axis()),
            tangent: projection.tangent().into(),
            bodies: bodies.collect(),
        }
    }

    pub(super) fn place(&self, point: Vector) -> Place {
        let way = minus(point, self.position);
        let depth = dot(way, self.axis);
        let part = |across| 0.5 + 0.5 * dot(way, across) / (depth * self.tangent);
        Place { column: part(self.right), row: part(self.down), depth }
    }

    fn way(&self, column: f64, row: f64) -> Vector {
        let (x, y) = ((2.0 * column - 1.0) * self.tangent, (2.0 * row - 1.0) * self.tangent);
        [0, 1, 2].map(|i| self.axis[i] + x * self.right[i] + y * self.down[i])
    }

    /// Everything in a direction that is farther than a map begins to see: the depths, and the triangles.
    fn hits(&self, way: Vector) -> Vec<(f64, [Vector; 3])> {
        let bodies = self.bodies.iter().filter(|body| !body.is_missed(self.position, way));
        let triangles = bodies.flat_map(|body| &body.triangles);
        let hits = triangles.filter_map(|&triangle| Some((hit(self.position, way, triangle)?, triangle)));
        hits.filter(|&(depth, _)| depth > 0.05).collect()
    }

    /// The surface that is nearest to a depth in a direction: its depth, its triangle, and whether it is the first that the
    /// light meets.
    fn nearest(&self, way: Vector, depth: f64) -> Option<(f64, [Vector; 3], bool)> {
        let hits = self.hits(way);
        let off = |hit: &(f64, _)| (hit.0 - depth).abs();
        let &(own, triangle) = hits.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
        Some((own, triangle, hits.iter().all(|&(depth, _)| depth >= own - 1e-3)))
    }

    /// Whether light arrives at a place.
    pub(super) fn sees(&self, place: Place) -> bool {
        self.nearest(self.way(place.column, place.row), place.depth).is_none_or(|(_, _, sees)| sees)
    }

    /// Whether a place is farther than so many texels from the edge of a shadow and from that of its surface, beyond which
    /// that is in its own shadow.
    pub(super) fn is_inside(&self, place: Place, texels: f64, side: usize) -> bool {
        const STEPS: i32 = 8;
        let Some((own, [a, b, c], sees)) = self.nearest(self.way(place.column, place.row), place.depth)
        else {
            return false;
        };
        let normal = cross(minus(b, a), minus(c, a));
        let reach = texels / side as f64 / f64::from(STEPS);
        // What is farther off the plane than this is another surface.
        let far = 8.0 * texels * 2.0 * self.tangent / side as f64 * own;
        (own - place.depth).abs() < 1e-3 * own
            && (-STEPS..=STEPS).all(|row| {
                (-STEPS..=STEPS).all(|column| {
                    let (column, row) = (f64::from(column) * reach, f64::from(row) * reach);
                    let way = self.way(place.column + column, place.row + row);
                    let depth = dot(normal, minus(a, self.position)) / dot(normal, way);
                    self.nearest(way, depth)
                        .is_some_and(|(next, _, other)| other == sees && (next - depth).abs() < far)
                })
            })
    }

    /// temp
    pub(super) fn facing(&self, place: Place) -> std::string::String {
        let way = self.way(place.column, place.row);
        let mut list: Vec<_> = self
            .hits(way)
            .into_iter()
            .map(|(t, [a, b, c])| {
                let n = cross(minus(b, a), minus(c, a));
                (t, -dot(n, way) / (dot(n, n) * dot(way, way)).sqrt())
            })
            .collect();
        list.sort_by(|a, b| a.0.total_cmp(&b.0));
        std::format!("{list:.3?}")
    }
}
