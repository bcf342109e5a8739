//! Outlines: plane curves from which surfaces are swept.

use alloc::vec::Vec;
use glam::Vec2;
use luminaire::{
    Error,
    error::{Expected, Parameter},
};

/// Cosine of 45 degrees, the largest turn of an outline with smooth shading. A turn by a larger
/// angle is a crease.
const CREASE: f32 = core::f32::consts::FRAC_1_SQRT_2;

/// Distance in metres under which two points coincide.
const JOINED: f32 = 1e-6;

/// A plane curve, drawn as with a pen: from a start point, along lines and curves.
///
/// For a [lathe](crate::Mesh::lathe) the coordinates are radius and height. The front of the
/// surface is on the right of the pen's direction: the surface of an outline drawn upwards, from
/// the foot to the top, faces outwards. The surface is smooth where the outline turns by less than
/// 45 degrees, and creased where the outline turns by more.
#[derive(Clone, PartialEq, Debug)]
pub struct Outline {
    points: Vec<Vec2>,
    /// The error of the first call whose number of lines was out of range.
    refused: Option<Error>,
}

/// A point of an outline, and the normal of the swept surface at this point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Station {
    pub(crate) point: Vec2,
    pub(crate) normal: Vec2,
}

impl Outline {
    /// The largest number of lines in one curve.
    pub const MOST_LINES: u32 = 65_536;

    /// Starts an outline at a point, in metres.
    pub fn start(x: f32, y: f32) -> Self {
        Self { points: [Vec2::new(x, y)].into(), refused: None }
    }

    /// Adds a straight line to a point, in metres.
    pub fn line_to(mut self, x: f32, y: f32) -> Self {
        self.points.push(Vec2::new(x, y));
        self
    }

    /// Adds a cubic Bézier curve with two control points, to an end point, in metres. `lines` lines
    /// approximate the curve; with more than [`MOST_LINES`](Self::MOST_LINES),
    /// [`Scene::add`](crate::Scene::add) rejects the surface.
    pub fn curve_to(mut self, controls: [(f32, f32); 2], x: f32, y: f32, lines: usize) -> Self {
        let lines = self.accepted(lines);
        let [a, b] = controls.map(Vec2::from);
        let (from, to) = (self.pen(), Vec2::new(x, y));
        self.points.extend((1..=lines).map(|line| {
            let t = line as f32 / lines as f32;
            let u = 1.0 - t;
            u * u * u * from + 3.0 * u * u * t * a + 3.0 * u * t * t * b + t * t * t * to
        }));
        self
    }

    /// Adds an arc around a centre, in metres, from the current point by an angle in radians. A
    /// positive angle turns left: from the x axis towards the y axis. `lines` lines approximate the
    /// arc; with more than [`MOST_LINES`](Self::MOST_LINES), [`Scene::add`](crate::Scene::add)
    /// rejects the surface.
    pub fn arc(mut self, x: f32, y: f32, angle: f32, lines: usize) -> Self {
        let lines = self.accepted(lines);
        let center = Vec2::new(x, y);
        let from = self.pen() - center;
        self.points.extend(
            (1..=lines)
                .map(|line| center + Vec2::from_angle(angle * line as f32 / lines as f32).rotate(from)),
        );
        self
    }

    /// Returns whether the surface that a lathe makes from the outline has no border.
    ///
    /// The surface has no border if the outline ends where it began, or begins and ends on the
    /// axis.
    pub(crate) fn encloses(&self) -> bool {
        let Some((first, last)) = self.points.first().zip(self.points.last()) else { return false };
        first.distance(*last) < JOINED || (first.x.abs() < JOINED && last.x.abs() < JOINED)
    }

    /// Returns a number of lines; 0 if the number was rejected.
    fn accepted(&mut self, lines: usize) -> usize {
        let is_accepted = lines <= Self::MOST_LINES as usize;
        if !is_accepted {
            let accepted = Expected::WholeBetween(0, Self::MOST_LINES);
            let error = Error { parameter: Parameter::Segments, value: lines as f32, accepted };
            self.refused = self.refused.or(Some(error));
        }
        if is_accepted { lines } else { 0 }
    }

    /// Returns the error for which no surface can be swept from the outline, if any.
    pub(crate) fn refused(&self) -> Option<Error> {
        self.refused
    }

    /// Returns the number of lines.
    pub(crate) fn line_count(&self) -> usize {
        self.points.len() - 1
    }

    /// Returns the position of the pen.
    fn pen(&self) -> Vec2 {
        self.points.last().copied().unwrap_or_default()
    }

    /// Returns the strips of surface along the outline, each with a station at both ends.
    ///
    /// If two neighbouring strips join smoothly, the normals of both stations at the joint are
    /// bit-identical. A `mirrored` outline continues as its mirror image behind the axis x = 0, so
    /// that a sphere is smooth at its poles.
    pub(crate) fn strips(&self, mirrored: bool) -> impl Iterator<Item = [Station; 2]> + '_ {
        let normals = self.normals();
        let count = normals.len();
        let closed =
            self.points.first().zip(self.points.last()).is_some_and(|(a, b)| a.distance(*b) < JOINED);
        (0..count).map(move |strip| {
            let normal = normals[strip];
            let beyond = |point: Vec2, end: usize| {
                if mirrored && point.x.abs() < JOINED {
                    Vec2::new(-normal.x, normal.y)
                } else if closed {
                    normals[end]
                } else {
                    normal
                }
            };
            let (a, b) = (self.points[strip], self.points[strip + 1]);
            let before = if strip > 0 { normals[strip - 1] } else { beyond(a, count - 1) };
            let after = if strip + 1 < count { normals[strip + 1] } else { beyond(b, 0) };
            [
                Station { point: a, normal: smooth(normal, before) },
                Station { point: b, normal: smooth(normal, after) },
            ]
        })
    }

    /// Computes the normal of each line, which points to the right of the line.
    fn normals(&self) -> Vec<Vec2> {
        self.points.windows(2).map(|line| -(line[1] - line[0]).perp().normalize_or_zero()).collect()
    }
}

/// Returns the mean normal of two lines, or the normal of the first if the lines meet in a crease.
fn smooth(normal: Vec2, neighbor: Vec2) -> Vec2 {
    if normal.dot(neighbor) > CREASE { (normal + neighbor).normalize_or_zero() } else { normal }
}
