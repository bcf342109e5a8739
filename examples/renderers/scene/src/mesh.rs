//! Ball and floor as triangles.

use std::f32::consts::PI;

use crate::{CENTER, RADIUS};

/// Triangles, counter-clockwise as seen from outside.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// The points of the vertices.
    pub points: Vec<[f32; 3]>,
    /// The normals of the vertices, of unit length.
    pub normals: Vec<[f32; 3]>,
    /// The vertices of each triangle.
    pub triangles: Vec<[usize; 3]>,
}

/// Returns the floor as a grid of `cells` x `cells` squares: 24 units across and 17 deep.
pub fn floor(cells: usize) -> Mesh {
    let part = |i: usize| i as f32 / cells as f32;
    grid(cells, cells, |column, row| {
        ([24.0 * part(column) - 12.0, 0.0, 17.0 * part(row) - 14.0], [0.0, 1.0, 0.0])
    })
}

/// Returns the ball, from pole to pole in half as many rings as it has segments.
pub fn ball(segments: usize) -> Mesh {
    grid(segments, segments / 2, |column, row| {
        let (longitude, latitude) =
            (2.0 * PI * column as f32 / segments as f32, 2.0 * PI * row as f32 / segments as f32);
        let normal = [latitude.sin() * longitude.sin(), latitude.cos(), latitude.sin() * longitude.cos()];
        let point = std::array::from_fn(|axis| CENTER[axis] + RADIUS * normal[axis]);
        (point, normal)
    })
}

/// Returns a mesh of squares, each of two triangles.
fn grid(columns: usize, rows: usize, vertex: impl Fn(usize, usize) -> ([f32; 3], [f32; 3])) -> Mesh {
    let mut mesh = Mesh::default();
    for row in 0..=rows {
        for column in 0..=columns {
            let (point, normal) = vertex(column, row);
            mesh.points.push(point);
            mesh.normals.push(normal);
        }
    }
    for row in 0..rows {
        for column in 0..columns {
            let [a, b] = [row, row + 1].map(|row| row * (columns + 1) + column);
            mesh.triangles.extend([[a, b, a + 1], [a + 1, b, b + 1]]);
        }
    }
    mesh
}
