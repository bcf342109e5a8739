//! Ray casting from a light in f64, over every triangle of a scene.

use crate::{scene::Scene, space::bounds::Bounds};
use alloc::vec::Vec;
use glam::DVec3;
use luminaire::{Vec3, projector::Projection};

pub(super) type Triangle = [DVec3; 3];

/// The triangles of a mesh, front and back, with their bounding sphere.
struct Body {
    center: DVec3,
    radius: f64,
    triangles: Vec<Triangle>,
}

/// A light in a scene, and the square that it projects.
pub(super) struct Light {
    position: DVec3,
    right: DVec3,
    down: DVec3,
    axis: DVec3,
    tangent: f64,
    bodies: Vec<Body>,
}

/// Position of a point on the square, in sides, and its depth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    column: f64,
    row: f64,
    pub(super) depth: f64,
}

/// Hit of a ray: its depth, the triangle, and whether nothing is in front of the hit.
struct Hit {
    depth: f64,
    triangle: Triangle,
    is_first: bool,
}

fn double(v: Vec3<f32>) -> DVec3 {
    glam::Vec3::from(v).as_dvec3()
}

fn normal([a, b, c]: Triangle) -> DVec3 {
    (b - a).cross(c - a)
}

/// Returns the parameter along a ray at which the ray meets the plane of a triangle.
fn plane(from: DVec3, way: DVec3, triangle: Triangle) -> f64 {
    let normal = normal(triangle);
    normal.dot(triangle[0] - from) / normal.dot(way)
}

/// Returns the parameter along a ray at which the ray meets a triangle; `None` if the ray misses
/// it.
fn hit(from: DVec3, way: DVec3, triangle: Triangle) -> Option<f64> {
    let t = plane(from, way, triangle);
    let (normal, [a, b, c]) = (normal(triangle), triangle);
    let inside = from + t * way - a;
    let part = |edge: DVec3| edge.dot(normal) / normal.length_squared();
    let (to_b, to_c) = (part(inside.cross(c - a)), part((b - a).cross(inside)));
    // The tolerance is negative, because a ray along the common edge of two triangles must hit one
    // triangle.
    let least = -1e-9;
    (to_b >= least && to_c >= least && to_b + to_c <= 1.0 - least).then_some(t)
}

/// Returns the triangles of each object of a scene.
pub(super) fn triangles(scene: &Scene) -> impl Iterator<Item = Vec<Triangle>> {
    scene.objects().iter().map(|object| {
        let place = |corner: u32| double(object.mesh.vertices()[corner as usize].position.into());
        object.mesh.triangles().iter().map(|triangle| triangle.map(place)).collect()
    })
}

impl Light {
    pub(super) fn new(scene: &Scene, projection: &Projection) -> Self {
        let bodies = scene.objects().iter().zip(triangles(scene)).map(|(object, triangles)| {
            let bounds = Bounds::of(object.mesh.vertices().iter().map(|vertex| vertex.position));
            let (center, radius) = (double(bounds.center.into()), 1.001 * f64::from(bounds.radius));
            Body { center, radius, triangles }
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

    pub(super) fn place(&self, point: DVec3) -> Place {
        let way = point - self.position;
        let depth = way.dot(self.axis);
        let part = |across| 0.5 + 0.5 * way.dot(across) / (depth * self.tangent);
        Place { column: part(self.right), row: part(self.down), depth }
    }

    /// Returns the height of the light above the plane of a triangle, and `|nx| + |ny|` of its unit
    /// normal on the square.
    pub(super) fn slope(&self, triangle: Triangle) -> (f64, f64) {
        let normal = normal(triangle).normalize();
        let across = normal.dot(self.right).abs() + normal.dot(self.down).abs();
        (normal.dot(self.position - triangle[0]), across)
    }

    /// Returns whether a point is on the plane of a triangle.
    pub(super) fn is_on(&self, triangle: Triangle, point: DVec3) -> bool {
        let normal = normal(triangle).normalize();
        normal.dot(point - triangle[0]).abs() < 1e-6 * (point - self.position).length()
    }

    /// Returns the point at `depth` times the distance of a point from the light.
    pub(super) fn beyond(&self, point: DVec3, depth: f64) -> DVec3 {
        self.position + depth * (point - self.position)
    }

    /// Returns whether a position is on the square.
    pub(super) fn has(&self, place: Place) -> bool {
        place.depth > 0.0 && [place.column, place.row].iter().all(|part| (0.0..1.0).contains(part))
    }

    /// Returns the vector from the light to a position on the square at depth 1.
    fn way(&self, column: f64, row: f64) -> DVec3 {
        let (x, y) = ((2.0 * column - 1.0) * self.tangent, (2.0 * row - 1.0) * self.tangent);
        self.axis + x * self.right + y * self.down
    }

    /// Returns the hit of a ray whose depth is nearest to `depth`, beyond the near plane of a map.
    fn nearest(&self, way: DVec3, depth: f64) -> Option<Hit> {
        let is_met = |body: &&Body| {
            let across = (body.center - self.position).cross(way);
            across.length_squared() <= body.radius * body.radius * way.length_squared()
        };
        let triangles = self.bodies.iter().filter(is_met).flat_map(|body| &body.triangles);
        let hits = triangles.filter_map(|&triangle| Some((hit(self.position, way, triangle)?, triangle)));
        let hits: Vec<_> = hits.filter(|(hit, _)| *hit > 0.05).collect();
        let off = |hit: &(f64, Triangle)| (hit.0 - depth).abs();
        let &(own, triangle) = hits.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
        // Hits within a millimetre count as the same hit.
        Some(Hit { depth: own, triangle, is_first: hits.iter().all(|&(depth, _)| depth >= own - 1e-3) })
    }

    /// Returns whether light arrives at a position.
    pub(super) fn sees(&self, place: Place) -> bool {
        self.nearest(self.way(place.column, place.row), place.depth).is_none_or(|hit| hit.is_first)
    }

    /// Returns what the rays to the corners of a square meet first: a square of twice `texels`
    /// around a position. `None` for a ray that meets nothing or is off the map.
    pub(super) fn around(&self, place: Place, texels: f64, side: usize) -> [Option<DVec3>; 4] {
        let step = texels / side as f64;
        [(-step, -step), (-step, step), (step, -step), (step, step)].map(|(right, down)| {
            let corner = Place { column: place.column + right, row: place.row + down, ..place };
            let way = self.way(corner.column, corner.row);
            let hit = self.nearest(way, 0.0).filter(|_| self.has(corner));
            hit.map(|hit| self.position + hit.depth * way)
        })
    }

    /// Returns whether a position is farther than `texels` from any shadow edge and from the end of
    /// its surface.
    ///
    /// The surface ends where it disappears as seen from the light: beyond this end the surface is
    /// in its own shadow.
    pub(super) fn is_clear(&self, place: Place, texels: f64, side: usize) -> bool {
        const STEPS: i32 = 8;
        let Some(own) = self.nearest(self.way(place.column, place.row), place.depth) else { return false };
        let step = texels / side as f64 / f64::from(STEPS);
        let width = 2.0 * self.tangent / side as f64 * own.depth;
        let is_same = |row: i32, column: i32| {
            let way = self.way(place.column + f64::from(column) * step, place.row + f64::from(row) * step);
            let depth = plane(self.position, way, own.triangle);
            let next = self.nearest(way, depth);
            next.is_some_and(|next| {
                next.is_first == own.is_first && (next.depth - depth).abs() < 8.0 * texels * width
            })
        };
        (own.depth - place.depth).abs() < 1e-3 * own.depth
            && (-STEPS..=STEPS).all(|row| (-STEPS..=STEPS).all(|column| is_same(row, column)))
    }
}
