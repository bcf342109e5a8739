//! Triangle meshes with a normal at each vertex, and surfaces swept from outlines.

use crate::scene::outline::Outline;
use alloc::vec::Vec;
use glam::{Quat, Vec3};
use luminaire::{
    Error,
    error::{Expected, Parameter},
};

/// A mesh of triangles with smooth shading. Back faces are not drawn: a closed mesh shows its
/// outside.
///
/// The world is right-handed, in metres, and y points up. Construction accepts any numbers;
/// [`Scene::add`](crate::Scene::add) rejects a mesh with a number out of range.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Mesh {
    vertices: Vec<Vertex>,
    triangles: Vec<[u32; 3]>,
    /// Whether the mesh is known to enclose the volume behind its triangles.
    is_closed: bool,
    /// The first error of construction, which [`Scene::add`](crate::Scene::add) returns.
    refused: Option<Error>,
}

/// A vertex. Several triangles may share a vertex.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Vertex {
    pub(crate) position: Vec3,
    pub(crate) normal: Vec3,
}

impl Mesh {
    /// The largest vertex count of a mesh.
    pub const MOST_VERTICES: u32 = 1 << 20;
    /// The largest coordinate of a vertex, in metres.
    pub const FARTHEST: f32 = 1e6;

    /// Sweeps an outline of radius and height around the y axis, in this many segments.
    ///
    /// ```
    /// use luminaire_render::{Mesh, Outline};
    /// let cone = Mesh::lathe(&Outline::start(0.0, 0.0).line_to(0.5, 0.0).line_to(0.0, 1.0), 48);
    /// assert_eq!(cone.triangle_count(), 2 * 48);
    /// ```
    pub fn lathe(outline: &Outline, segments: usize) -> Self {
        let (mut mesh, segments) = Self::swept(outline, segments);
        for strip in outline.strips(true) {
            mesh.sweep(segments, true, |segment| {
                let angle = core::f32::consts::TAU * segment as f32 / segments as f32;
                let around = glam::Vec2::from_angle(angle);
                strip.map(|station| Vertex {
                    position: Vec3::new(
                        station.point.x * around.x,
                        station.point.y,
                        station.point.x * -around.y,
                    ),
                    normal: Vec3::new(
                        station.normal.x * around.x,
                        station.normal.y,
                        station.normal.x * -around.y,
                    ),
                })
            });
        }
        mesh.is_closed = outline.encloses() && mesh.is_outwards();
        mesh
    }

    /// Sweeps an outline in x and y along the z axis, from z = 0 to z = `depth` metres.
    pub fn extrude(outline: &Outline, depth: f32, segments: usize) -> Self {
        let (mut mesh, segments) = Self::swept(outline, segments);
        for strip in outline.strips(false) {
            mesh.sweep(segments, false, |segment| {
                let z = depth * (1.0 - segment as f32 / segments as f32);
                strip.map(|station| Vertex {
                    position: station.point.extend(z),
                    normal: station.normal.extend(0.0),
                })
            });
        }
        mesh
    }

    /// Creates a box of this width, height and depth in metres, on y = 0 and around the y axis.
    pub fn cuboid(width: f32, height: f32, depth: f32) -> Self {
        let (x, z) = (width / 2.0, depth / 2.0);
        let mut mesh = Self::default();
        let corner = Vec3::new(-x, 0.0, -z);
        let (wide, high, deep) = (width * Vec3::X, height * Vec3::Y, depth * Vec3::Z);
        for (corner, u, v) in [
            (corner, wide, deep),
            (corner, deep, high),
            (corner, high, wide),
            (corner + wide, high, deep),
            (corner + high, deep, wide),
            (corner + deep, wide, high),
        ] {
            mesh.parallelogram(corner, u, v);
        }
        mesh.is_closed = mesh.is_outwards();
        mesh
    }

    /// Returns the same mesh, moved by an offset in metres.
    #[must_use]
    pub fn moved(self, offset: luminaire::Vec3<f32>) -> Self {
        let offset = Vec3::from(offset);
        self.mapped(|v| Vertex { position: v.position + offset, ..v })
    }

    /// Returns the same mesh, rotated about an axis through the origin by an angle in radians. The
    /// rotation is counter-clockwise as seen from the tip of the axis.
    #[must_use]
    pub fn turned(self, axis: luminaire::Vec3<f32>, angle: f32) -> Self {
        let rotation = Quat::from_scaled_axis(Vec3::from(axis).normalize_or_zero() * angle);
        self.mapped(|v| Vertex { position: rotation * v.position, normal: rotation * v.normal })
    }

    /// Merges two meshes into one.
    pub fn and(mut self, other: Self) -> Self {
        let first = self.vertices.len() as u32;
        self.is_closed &= other.is_closed;
        self.refused = self.refused.or(other.refused);
        let count = self.vertices.len() + other.vertices.len();
        if count > Self::MOST_VERTICES as usize {
            let accepted = Expected::WholeBetween(0, Self::MOST_VERTICES);
            let error = Error { parameter: Parameter::VertexCount, value: count as f32, accepted };
            return Self { refused: self.refused.or(Some(error)), ..Self::default() };
        }
        self.vertices.extend(other.vertices);
        self.triangles.extend(other.triangles.into_iter().map(|triangle| triangle.map(|v| v + first)));
        self
    }

    /// Returns the number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Returns the positions, in metres, and the unit normals of the corners of each triangle,
    /// counter-clockwise as seen from the front.
    pub fn corners(&self) -> impl Iterator<Item = [[luminaire::Vec3<f32>; 2]; 3]> {
        let corner = |&number: &u32| {
            let Vertex { position, normal } = self.vertices[number as usize];
            [position.into(), normal.into()]
        };
        self.triangles.iter().map(move |triangle| triangle.each_ref().map(corner))
    }

    /// Returns an error if a number of the mesh is out of range.
    pub(crate) fn check(&self) -> Result<(), Error> {
        if let Some(error) = self.refused {
            return Err(error);
        }
        for &Vertex { position, normal } in &self.vertices {
            // Normals have unit length within rounding, or are zero.
            for (vector, most) in [(position, Self::FARTHEST), (normal, 2.0)] {
                check_channels(Parameter::Vertex, vector.to_array(), -most, most)?;
            }
        }
        Ok(())
    }

    /// Returns an empty mesh for the surface swept from an outline, and the number of segments. The
    /// number is 0 if the number of segments or the outline was rejected.
    fn swept(outline: &Outline, segments: usize) -> (Self, usize) {
        // A strip has a pair of vertices at both ends of each segment.
        let pairs = Self::MOST_VERTICES / 2 / (outline.line_count() as u32).max(1);
        let most = pairs.saturating_sub(1);
        let is_accepted = segments <= most as usize;
        let accepted = Expected::WholeBetween(0, most);
        let error = Error { parameter: Parameter::Segments, value: segments as f32, accepted };
        let refused = outline.refused().or((!is_accepted).then_some(error));
        (Self { refused, ..Self::default() }, if refused.is_none() { segments } else { 0 })
    }

    /// Returns the vertices.
    pub(crate) fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Returns the triangles as vertex indices, counter-clockwise as seen from the front.
    pub(crate) fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Returns whether the mesh encloses the volume behind its triangles. From outside such a mesh,
    /// every back face is hidden by a front face.
    pub(crate) fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// Returns whether a mesh without gaps encloses the volume behind its triangles. Each triangle
    /// forms a tetrahedron with the first vertex. The mesh encloses the volume behind its triangles
    /// if the sum of the signed volumes of all tetrahedra is positive.
    fn is_outwards(&self) -> bool {
        let corner = |corner: u32| self.vertices[corner as usize].position;
        let volume = |&[a, b, c]: &[u32; 3]| {
            (corner(a) - corner(0)).dot((corner(b) - corner(0)).cross(corner(c) - corner(0)))
        };
        self.triangles.iter().map(volume).sum::<f32>() > 0.0
    }

    /// Adds a parallelogram at a corner, with the edges `u` and `v`. Its front is the side from
    /// which `u` turns counter-clockwise to `v`.
    fn parallelogram(&mut self, corner: Vec3, u: Vec3, v: Vec3) {
        let normal = u.cross(v).normalize_or_zero();
        let vertex = |position| Vertex { position, normal };
        self.sweep(1, false, |side| {
            let corner = corner + side as f32 * u;
            [vertex(corner), vertex(corner + v)]
        });
    }

    /// Adds a strip of quadrilaterals between pairs of vertices. A closed strip ends at its first
    /// pair of vertices.
    fn sweep(&mut self, segments: usize, closed: bool, pair: impl Fn(usize) -> [Vertex; 2]) {
        let first = self.vertices.len() as u32;
        let pairs = if closed { segments } else { segments + 1 };
        self.vertices.extend((0..pairs).flat_map(pair));
        for segment in 0..segments {
            let near = first + 2 * segment as u32;
            let far = first + 2 * ((segment + 1) % pairs) as u32;
            self.triangle([near, far, near + 1]);
            self.triangle([far, far + 1, near + 1]);
        }
    }

    /// Adds a triangle, unless two of its corners coincide, as at the poles of a sphere.
    fn triangle(&mut self, corners: [u32; 3]) {
        let [a, b, c] = corners.map(|corner| self.vertices[corner as usize].position);
        if a != b && b != c && c != a {
            self.triangles.push(corners);
        }
    }

    fn mapped(mut self, f: impl Fn(Vertex) -> Vertex) -> Self {
        self.vertices.iter_mut().for_each(|vertex| *vertex = f(*vertex));
        self
    }
}

/// Returns an error if a number is outside a closed range. The error contains the first number
/// outside the range; NaN is outside every range.
pub(crate) fn check_channels(
    parameter: Parameter,
    channels: [f32; 3],
    least: f32,
    most: f32,
) -> Result<(), Error> {
    match channels.into_iter().find(|channel| !(least..=most).contains(channel)) {
        Some(value) => Err(Error { parameter, value, accepted: Expected::Between(least, most) }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::solids::{capsule, column, cone, sphere, torus, vase};

    #[test]
    fn solids_are_closed() {
        let solids = [sphere(0.5), torus(0.5, 0.2), cone(0.5, 1.0), capsule(0.2, 0.5), vase(), column()];
        for solid in solids.into_iter().chain([Mesh::cuboid(1.0, 2.0, 3.0)]) {
            assert!(solid.is_closed());
            let turned = solid.turned(luminaire::Vec3::new(1.0, 0.0, 0.0), 1.0);
            assert!(turned.moved(luminaire::Vec3::new(9.0, 0.0, 0.0)).is_closed());
        }
        assert!(sphere(0.5).and(cone(0.5, 1.0)).is_closed());
    }

    #[test]
    fn what_has_a_border_or_shows_its_inside_is_open() {
        let wall = Mesh::extrude(&Outline::start(0.0, 0.0).line_to(1.0, 0.0), 1.0, 1);
        let tube = Mesh::lathe(&Outline::start(0.5, 0.0).line_to(0.5, 1.0), 48);
        let hollow = Mesh::lathe(&Outline::start(0.0, 1.0).line_to(0.5, 0.0).line_to(0.0, 0.0), 48);
        for open in [wall.clone(), tube, hollow, sphere(0.5).and(wall), Mesh::default()] {
            assert!(!open.is_closed());
        }
    }
}
