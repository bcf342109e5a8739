//! The camera: it looks at the origin, four units along and three down, from five units away.

use crate::{CENTER, HEIGHT, RADIUS, WIDTH};

/// The position of the camera.
pub const EYE: [f32; 3] = [0.0, 3.0, 4.0];
/// What the camera sees across at distance 1, from the middle to the right edge of the picture.
const RIGHT: f64 = 2.0 / 3.0;
/// The same from the middle to the upper edge.
const UP: f64 = 0.5;
/// A renderer draws from this distance on.
const NEAR: f32 = 0.1;
/// A renderer draws up to this distance.
const FAR: f32 = 100.0;

/// What a pixel sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Object {
    /// The floor.
    Floor,
    /// The ball.
    Ball,
}

/// The point that a pixel sees.
#[derive(Clone, Copy, Debug)]
pub struct Site {
    /// What the point is on.
    pub object: Object,
    /// The point.
    pub point: [f64; 3],
    /// The normal, of unit length.
    pub normal: [f64; 3],
}

/// Returns the matrix from the world to clip space, by rows: x to the right, y up, and z from -w to w.
pub fn to_clip() -> [[f32; 4]; 4] {
    let [_, y, z] = EYE;
    // Down the picture: the camera's own upward and forward axes are (0, 0.8, -0.6) and (0, -0.6, -0.8).
    let (up, forward) = ([0.0, 0.8, -0.6, 0.6 * z - 0.8 * y], [0.0, -0.6, -0.8, 0.6 * y + 0.8 * z]);
    let (scale, shift) = ((FAR + NEAR) / (FAR - NEAR), -2.0 * FAR * NEAR / (FAR - NEAR));
    let mut depth = forward.map(|part: f32| part * scale);
    depth[3] += shift;
    [[1.0 / RIGHT as f32, 0.0, 0.0, 0.0], up.map(|part: f32| part / UP as f32), depth, forward]
}

/// Returns the direction of the view ray at a place of the picture, of any length. The middle of the
/// upper left pixel is at (0.5, 0.5).
pub fn ray(x: f64, y: f64) -> [f64; 3] {
    let across = (2.0 * x / WIDTH as f64 - 1.0) * RIGHT;
    let up = (1.0 - 2.0 * y / HEIGHT as f64) * UP;
    [across, 0.8 * up - 0.6, -0.6 * up - 0.8]
}

/// Returns what is seen at a place of the picture, computed without triangles.
pub fn seen(x: f64, y: f64) -> Site {
    let (ray, eye, center) = (ray(x, y), EYE.map(f64::from), CENTER.map(f64::from));
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let at = |t: f64| [eye[0] + t * ray[0], eye[1] + t * ray[1], eye[2] + t * ray[2]];
    let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let radius = f64::from(RADIUS);
    let from_center = minus(eye, center);
    let (a, b) = (dot(ray, ray), dot(ray, from_center));
    let inside = b * b - a * (dot(from_center, from_center) - radius * radius);
    if inside > 0.0 {
        let point = at((-b - inside.sqrt()) / a);
        let normal = minus(point, center).map(|part| part / radius);
        return Site { object: Object::Ball, point, normal };
    }
    Site { object: Object::Floor, point: at(-eye[1] / ray[1]), normal: [0.0, 1.0, 0.0] }
}
