//! Clipping of triangles against the view frustum.

use crate::{
    raster::view::{Corner, NEAR, Seen, View},
    scene::mesh::{Mesh, Vertex},
};
use alloc::vec::Vec;

/// The planes of the frustum: near, left, right, bottom, top.
const PLANES: usize = 5;

/// A vertex in camera space and its projection, computed once for all triangles that share the
/// vertex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sighting {
    seen: Seen,
    /// Outcode: one bit for each frustum plane. The bit is 1 if the vertex is outside the plane.
    beyond: u32,
    /// Screen position; the default if the vertex is outside the frustum.
    corner: Corner,
}

impl Sighting {
    pub(crate) fn new(view: &View, vertex: &Vertex) -> Self {
        let seen = view.see(vertex);
        let is_beyond = |plane| u32::from(!matches!(inside(&seen, plane), 0.0..));
        let beyond = (0..PLANES).fold(0, |bits, plane| bits | is_beyond(plane) << plane);
        Self { seen, beyond, corner: if beyond == 0 { view.project(&seen) } else { Corner::default() } }
    }

    /// The vertex in camera space. The vertex may be outside the frustum.
    pub(crate) fn seen(&self) -> &Seen {
        &self.seen
    }
}

/// Clips the triangles of a mesh and calls `draw` with each visible triangle.
///
/// `draw` also gets the vertices of the unclipped triangle. `sightings` is scratch memory.
#[inline(always)]
pub(crate) fn clip_mesh(
    view: &View,
    mesh: &Mesh,
    sightings: &mut Vec<Sighting>,
    mut draw: impl FnMut([&Sighting; 3], [Corner; 3]),
) {
    sightings.clear();
    sightings.extend(mesh.vertices().iter().map(|vertex| Sighting::new(view, vertex)));
    for triangle in mesh.triangles() {
        let corners = triangle.map(|corner| &sightings[corner as usize]);
        clip(view, corners, |visible| draw(corners, visible));
    }
}

/// Clips a triangle and calls `draw` with each visible part, a triangle with the same winding.
fn clip(view: &View, [a, b, c]: [&Sighting; 3], mut draw: impl FnMut([Corner; 3])) {
    if a.beyond & b.beyond & c.beyond != 0 {
        return;
    }
    let cut = a.beyond | b.beyond | c.beyond;
    if cut == 0 {
        return draw([a.corner, b.corner, c.corner]);
    }
    let mut polygon = Polygon::new([a.seen, b.seen, c.seen]);
    for plane in (0..PLANES).filter(|plane| cut >> plane & 1 == 1) {
        polygon = polygon.cut(plane);
    }
    if let [first, rest @ ..] = polygon.vertices() {
        let first = view.project(first);
        rest.windows(2).for_each(|edge| draw([first, view.project(&edge[0]), view.project(&edge[1])]));
    }
}

/// Returns the projected ends of the part of an edge that is inside the frustum, if any.
pub(crate) fn clip_edge(view: &View, [a, b]: [&Sighting; 2]) -> Option<[Corner; 2]> {
    if a.beyond | b.beyond == 0 {
        return Some([a.corner, b.corner]);
    }
    let mut ends = [a.seen, b.seen];
    for plane in (0..PLANES).filter(|plane| (a.beyond | b.beyond) >> plane & 1 == 1) {
        let [from, to] = [inside(&ends[0], plane), inside(&ends[1], plane)];
        match (from >= 0.0, to >= 0.0) {
            (true, true) => {}
            (true, false) => ends[1] = crossing((&ends[0], from), (&ends[1], to)),
            (false, true) => ends[0] = crossing((&ends[1], to), (&ends[0], from)),
            (false, false) => return None,
        }
    }
    Some(ends.map(|end| view.project(&end)))
}

/// Returns the signed distance of a vertex from a frustum plane, unnormalised: positive inside.
fn inside(vertex: &Seen, plane: usize) -> f32 {
    match plane {
        0 => vertex.depth - NEAR,
        1 => vertex.depth + vertex.x,
        2 => vertex.depth - vertex.x,
        3 => vertex.depth + vertex.y,
        _ => vertex.depth - vertex.y,
    }
}

/// A convex polygon. A triangle gains at most one vertex at each plane.
struct Polygon {
    vertices: [Seen; 3 + PLANES],
    count: usize,
}

impl Polygon {
    fn new([a, b, c]: [Seen; 3]) -> Self {
        Self { vertices: [a, b, c, a, a, a, a, a], count: 3 }
    }

    fn vertices(&self) -> &[Seen] {
        &self.vertices[..self.count]
    }

    fn push(&mut self, vertex: Seen) {
        if let Some(place) = self.vertices.get_mut(self.count) {
            *place = vertex;
            self.count += 1;
        }
    }

    /// Returns the polygon on the visible side of a plane.
    fn cut(&self, plane: usize) -> Self {
        let mut kept = Self { vertices: self.vertices, count: 0 };
        let last = self.vertices().last();
        for (before, vertex) in last.into_iter().chain(self.vertices()).zip(self.vertices()) {
            let (from, to) = (inside(before, plane), inside(vertex, plane));
            match (from >= 0.0, to >= 0.0) {
                (true, true) => kept.push(*vertex),
                (true, false) => kept.push(crossing((before, from), (vertex, to))),
                (false, true) => {
                    kept.push(crossing((vertex, to), (before, from)));
                    kept.push(*vertex);
                }
                (false, false) => {}
            }
        }
        kept
    }
}

/// Returns the intersection of an edge with a plane. The intersection is always computed from the
/// visible end of the edge. So two triangles with a common edge get bit-identical intersections,
/// and there is no crack between the triangles.
fn crossing((visible, inside): (&Seen, f32), (hidden, outside): (&Seen, f32)) -> Seen {
    let t = inside / (inside - outside);
    let mix = |a: f32, b: f32| a + t * (b - a);
    Seen {
        x: mix(visible.x, hidden.x),
        y: mix(visible.y, hidden.y),
        depth: mix(visible.depth, hidden.depth),
        normal: visible.normal + t * (hidden.normal - visible.normal),
    }
}
