//! Adjacency of a mesh: which triangles meet at each edge.

use crate::scene::mesh::Mesh;
use alloc::vec::Vec;
use glam::{Vec3, Vec4};

/// Index in place of a second triangle at the border of a mesh.
const NONE: u32 = u32::MAX;

/// Positions are compared in steps of this part of a metre, because the two ends of a closed outline
/// differ by rounding errors.
const STEPS_PER_METRE: f32 = 65_536.0;

/// Cosine of 0.1 degrees. Between triangles that meet at a smaller angle there is no visible edge.
const FLAT: f32 = 0.999_998_5;

/// The least cosine between normals of a smooth surface. If two triangles have normals that differ by more at
/// both ends of their edge, the shading has a step there.
const SMOOTH: f32 = 0.999;

/// The edges of a mesh that can be visible as edges, and the planes of its triangles.
#[derive(Clone, Debug)]
pub(crate) struct Adjacency {
    /// Unit normal, and negative distance from the origin.
    planes: Vec<Vec4>,
    edges: Vec<MeshEdge>,
}

/// An edge between two triangles, or at the border of a mesh.
#[derive(Clone, Copy, Debug)]
struct MeshEdge {
    /// The vertices, in the order of the first triangle.
    ends: [u32; 2],
    triangles: [u32; 2],
    /// Whether the shading has a step at the edge.
    is_crease: bool,
}

/// An edge that a view shows as an edge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VisibleEdge {
    /// The vertices, in the order of the triangle that faces the eye.
    pub(crate) ends: [u32; 2],
    /// Whether both triangles face the eye.
    pub(crate) is_crease: bool,
}

/// A side of a triangle, from one vertex to the next.
#[derive(Clone, Copy)]
struct Side {
    /// The positions of both ends as numbers, the smaller one first.
    key: [u32; 2],
    is_reversed: bool,
    ends: [u32; 2],
    triangle: u32,
}

impl Adjacency {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let corner = |vertex: u32| mesh.vertices()[vertex as usize].position;
        let plane = |&[a, b, c]: &[u32; 3]| {
            let normal = (corner(b) - corner(a)).cross(corner(c) - corner(a)).normalize_or_zero();
            normal.extend(-normal.dot(corner(a)))
        };
        let planes = mesh.triangles().iter().map(plane).collect();
        let mut adjacency = Self { planes, edges: Vec::new() };
        let sides = sides(mesh);
        for same in sides.chunk_by(|a, b| a.key == b.key) {
            let mut rest = same;
            while let [first, others @ ..] = rest {
                let pair = others.first().filter(|second| second.is_reversed != first.is_reversed);
                adjacency.add(mesh, first, pair);
                rest = if pair.is_some() { &others[1..] } else { others };
            }
        }
        adjacency
    }

    /// Adds the edge at which one or two triangles have a side, unless the surface is flat there.
    fn add(&mut self, mesh: &Mesh, first: &Side, second: Option<&Side>) {
        let normal = |side: &Side| self.planes[side.triangle as usize].truncate();
        let is_crease = second.is_some_and(|second| {
            let normal = |vertex: u32| mesh.vertices()[vertex as usize].normal;
            let [a, b] = first.ends.map(normal);
            let [c, d] = second.ends.map(normal);
            a.dot(d).max(b.dot(c)) < SMOOTH
        });
        let is_flat = second.is_some_and(|second| normal(first).dot(normal(second)) > FLAT);
        if is_crease || !is_flat {
            let triangles = [first.triangle, second.map_or(NONE, |second| second.triangle)];
            self.edges.push(MeshEdge { ends: first.ends, triangles, is_crease });
        }
    }

    /// Calls `show` with each edge that is visible from an eye if nothing hides it: an edge between
    /// a triangle that faces the eye and one that does not, an edge at the border, and a crease.
    /// `faces` is scratch memory.
    pub(crate) fn seen_from(&self, eye: Vec3, faces: &mut Vec<bool>, mut show: impl FnMut(VisibleEdge)) {
        let eye = eye.extend(1.0);
        faces.clear();
        faces.extend(self.planes.iter().map(|plane| plane.dot(eye) > 0.0));
        for &MeshEdge { ends: [a, b], triangles: [first, second], is_crease } in &self.edges {
            let first = faces[first as usize];
            let second = faces.get(second as usize).copied().unwrap_or(false);
            match (first, second) {
                (true, false) => show(VisibleEdge { ends: [a, b], is_crease: false }),
                (false, true) => show(VisibleEdge { ends: [b, a], is_crease: false }),
                (true, true) if is_crease => show(VisibleEdge { ends: [a, b], is_crease }),
                _ => {}
            }
        }
    }
}

/// Returns the sides of all triangles, ordered by their key. Triangles that are as small as a
/// rounding error are left out, as at the poles of a sphere: which side they face is random.
fn sides(mesh: &Mesh) -> Vec<Side> {
    let numbers = numbers(mesh);
    let is_sound = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| numbers[vertex as usize]);
        a != b && b != c && c != a
    };
    let mut sides: Vec<Side> = (0..)
        .zip(mesh.triangles())
        .filter(|(_, triangle)| is_sound(triangle))
        .flat_map(|(triangle, &[a, b, c])| [[a, b], [b, c], [c, a]].map(|ends| (triangle, ends)))
        .map(|(triangle, ends)| {
            let [from, to] = ends.map(|vertex| numbers[vertex as usize]);
            Side { key: [from.min(to), from.max(to)], is_reversed: from > to, ends, triangle }
        })
        .collect();
    sides.sort_unstable_by_key(|side| (side.key, side.triangle));
    sides
}

/// Returns a number for each vertex: the same number for vertices at the same position.
fn numbers(mesh: &Mesh) -> Vec<u32> {
    let steps = |vertex: u32| {
        let place = (mesh.vertices()[vertex as usize].position * STEPS_PER_METRE).round();
        // The sum changes -0 to 0.
        place.to_array().map(|along| (along + 0.0).to_bits())
    };
    let mut order: Vec<([u32; 3], u32)> =
        (0..mesh.vertices().len() as u32).map(|vertex| (steps(vertex), vertex)).collect();
    order.sort_unstable();
    let mut numbers = alloc::vec![0; order.len()];
    for same in order.chunk_by(|(a, _), (b, _)| a == b) {
        same.iter().for_each(|(_, vertex)| numbers[*vertex as usize] = same[0].1);
    }
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::solids::{cone, torus};

    fn edges(mesh: &Mesh) -> Vec<MeshEdge> {
        Adjacency::new(mesh).edges
    }

    #[test]
    fn smooth_surfaces_have_no_crease() {
        assert!(edges(&torus(0.5, 0.2)).iter().all(|edge| !edge.is_crease));
        // The foot of a cone is the only crease; at the apex the shading is smooth around the axis.
        assert_eq!(edges(&cone(0.5, 1.0)).iter().filter(|edge| edge.is_crease).count(), 56);
    }
}
