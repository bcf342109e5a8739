//! From the world to the screen, and from a pixel back along its ray.

use crate::{
    bounds::Bounds,
    camera::{Camera, Pose},
    mesh::Vertex,
};
use glam::{Vec2, Vec3};
use luminaire::projector::Projection;

/// Nothing nearer to the eye than this is drawn, in metres along the line of sight.
pub(crate) const NEAR: f32 = 0.05;

/// Steps of a screen coordinate to a pixel, as a power of two.
pub(crate) const SUBPIXEL_BITS: u32 = 8;

/// A camera's view on a picture of a certain size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    eye: Vec3,
    ahead: Vec3,
    /// Right and up, scaled so that what is on the border of the picture is as far off axis as it is deep.
    right: Vec3,
    up: Vec3,
    /// Steps to a pixel's right and lower neighbour at depth 1, and the way to the centre of the first pixel.
    column: Vec3,
    row: Vec3,
    first: Vec3,
    /// Half the picture in steps of a screen coordinate.
    half: Vec2,
}

/// A vertex seen by a camera: in view where -depth <= x, y <= depth and depth >= [`NEAR`].
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Seen {
    pub(crate) x: f32,
    pub(crate) y: f32,
    pub(crate) depth: f32,
    pub(crate) normal: Vec3,
}

/// A corner of a triangle on the screen, and what is interpolated from it.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Corner {
    /// From the left and top border, in 256ths of a pixel.
    pub(crate) x: i32,
    pub(crate) y: i32,
    /// The reciprocal of the depth, which is linear on the screen.
    pub(crate) nearness: f32,
    /// The normal times the nearness, which is linear on the screen too.
    pub(crate) normal: Vec3,
}

impl View {
    pub(crate) fn new(camera: &Camera, width: usize, height: usize) -> Self {
        let half_angle = Vec2::from_angle(camera.field_of_view() / 2.0);
        Self::of_pose(camera.pose(), half_angle.y / half_angle.x, width, height)
    }

    /// What a light sees on the square that it projects, with so many texels on a side.
    pub(crate) fn of_light(projection: &Projection, side: usize) -> Self {
        let pose = Pose {
            eye: projection.position().into(),
            right: projection.right().into(),
            up: projection.up().into(),
            ahead: projection.axis().into(),
        };
        Self::of_pose(pose, projection.tangent(), side, side)
    }

    /// The view of an eye, with the tangent of half its vertical angle.
    fn of_pose(pose: Pose, tall: f32, width: usize, height: usize) -> Self {
        let (width, height) = (width as f32, height as f32);
        let wide = tall * width / height;
        let column = pose.right * (2.0 * wide / width);
        let row = pose.up * (-2.0 * tall / height);
        Self {
            eye: pose.eye,
            ahead: pose.ahead,
            right: pose.right / wide,
            up: pose.up / tall,
            column,
            row,
            first: pose.ahead + column * (0.5 - 0.5 * width) + row * (0.5 - 0.5 * height),
            half: Vec2::new(width, height) * (0.5 * (1 << SUBPIXEL_BITS) as f32),
        }
    }

    /// What the camera sees of a vertex.
    pub(crate) fn see(&self, vertex: &Vertex) -> Seen {
        let way = vertex.position - self.eye;
        let (x, y, depth) = (way.dot(self.right), way.dot(self.up), way.dot(self.ahead));
        Seen { x, y, depth, normal: vertex.normal }
    }

    /// Where on the screen a vertex in view is.
    pub(crate) fn project(&self, seen: &Seen) -> Corner {
        let nearness = 1.0 / seen.depth;
        let snapped = |along: f32, half: f32| (half + half * along * nearness).clamp(0.0, 2.0 * half) as i32;
        Corner {
            x: snapped(seen.x, self.half.x),
            y: snapped(-seen.y, self.half.y),
            nearness,
            normal: seen.normal * nearness,
        }
    }

    /// Whether nothing within the bounds is in view, for certain: by a thousandth of the distance more than
    /// touching.
    pub(crate) fn misses(&self, bounds: &Bounds) -> bool {
        let way = bounds.center - self.eye;
        let reach = bounds.radius + 1e-3 * (bounds.radius + way.length());
        let is_beyond = |inwards: Vec3| way.dot(inwards) < -reach * inwards.length();
        let (ahead, right, up) = (self.ahead, self.right, self.up);
        way.dot(ahead) + reach < NEAR
            || [ahead + right, ahead - right, ahead + up, ahead - up].into_iter().any(is_beyond)
    }

    /// Whether all within the bounds is before the eye, and none of it too near to be drawn.
    pub(crate) fn is_before(&self, bounds: &Bounds) -> bool {
        (bounds.center - self.eye).dot(self.ahead) > NEAR + bounds.radius
    }

    /// The eye.
    pub(crate) fn eye(&self) -> Vec3 {
        self.eye
    }

    /// The direction of sight, of unit length.
    pub(crate) fn ahead(&self) -> Vec3 {
        self.ahead
    }

    /// The way along the ray through a pixel's centre to depth 1, for the first pixel of a row, and the step
    /// to the next.
    pub(crate) fn ray(&self, row: usize) -> (Vec3, Vec3) {
        (self.first + self.row * row as f32, self.column)
    }
}
