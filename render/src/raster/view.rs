//! Projection from the world to the screen, and rays through pixels.

use crate::{
    scene::{
        camera::{Camera, Pose},
        mesh::Vertex,
    },
    space::bounds::Bounds,
    stripes::Stripes,
};
use glam::{DVec3, Vec2, Vec3};
use luminaire::projector::Projection;

pub(crate) use crate::scene::camera::NEAR;

/// Binary logarithm of the number of screen coordinate units per pixel.
pub(crate) const SUBPIXEL_BITS: u32 = 8;

/// The projection of a camera for a picture of one size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    eye: Vec3,
    ahead: Vec3,
    /// The scaled right and up vectors. At the border of the picture, the absolute value of the
    /// coordinate `x` or `y` of a point equals its depth.
    right: Vec3,
    up: Vec3,
    /// Vectors at depth 1. `column` points from a pixel to its right neighbour, `row` from a pixel
    /// to its lower neighbour, and `first` from the eye to the centre of the first pixel.
    column: Vec3,
    row: Vec3,
    first: Vec3,
    /// Half the width and half the height of the picture, in screen coordinate units.
    half: Vec2,
    /// The rows that are drawn.
    stripes: Stripes,
}

/// A vertex in camera space. The vertex is in view if x and y are in [-depth, depth] and depth >=
/// [`NEAR`].
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Seen {
    pub(crate) x: f32,
    pub(crate) y: f32,
    pub(crate) depth: f32,
    pub(crate) normal: Vec3,
}

/// A projected corner of a triangle, with the values to interpolate.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Corner {
    /// Distance from the left and from the top border, in 256ths of a pixel.
    pub(crate) x: i32,
    pub(crate) y: i32,
    /// The reciprocal of the depth. This reciprocal is linear on the screen.
    pub(crate) nearness: f32,
    /// The normal times the nearness. This product is linear on the screen.
    pub(crate) normal: Vec3,
}

impl View {
    /// Returns the view of a camera for a picture of this width and height, of which these stripes
    /// are drawn.
    pub(crate) fn new(camera: &Camera, width: usize, height: usize, stripes: Stripes) -> Self {
        let half_angle = Vec2::from_angle(camera.field_of_view() / 2.0);
        Self { stripes, ..Self::of_pose(camera.pose(), half_angle.y / half_angle.x, width, height) }
    }

    /// Returns the view from a light onto the square that it projects, with `side` texels per side.
    pub(crate) fn of_light(projection: &Projection, side: usize) -> Self {
        let pose = Pose {
            eye: projection.position().into(),
            right: projection.right().into(),
            up: projection.up().into(),
            ahead: projection.axis().into(),
        };
        Self::of_pose(pose, projection.tangent(), side, side)
    }

    /// Returns the view from a pose. `tall` is the tangent of half the vertical field of view.
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
            stripes: Stripes::ALL,
        }
    }

    /// Transforms a vertex to camera space.
    pub(crate) fn see(&self, vertex: &Vertex) -> Seen {
        let way = vertex.position - self.eye;
        let (x, y, depth) = (way.dot(self.right), way.dot(self.up), way.dot(self.ahead));
        Seen { x, y, depth, normal: vertex.normal }
    }

    /// Projects a vertex in view to the screen.
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

    /// Returns true only if nothing within the bounds is in view. The margin of this test is a
    /// thousandth of the distance.
    pub(crate) fn misses(&self, bounds: &Bounds) -> bool {
        let way = bounds.center - self.eye;
        let reach = bounds.radius + 1e-3 * (bounds.radius + way.length());
        let is_beyond = |inwards: Vec3| way.dot(inwards) < -reach * inwards.length();
        let (ahead, right, up) = (self.ahead, self.right, self.up);
        way.dot(ahead) + reach < NEAR
            || [ahead + right, ahead - right, ahead + up, ahead - up].into_iter().any(is_beyond)
    }

    /// Returns whether the bounding sphere is entirely beyond the near plane.
    pub(crate) fn is_before(&self, bounds: &Bounds) -> bool {
        (bounds.center - self.eye).dot(self.ahead) > NEAR + bounds.radius
    }

    /// The eye.
    pub(crate) fn eye(&self) -> Vec3 {
        self.eye
    }

    /// Returns the vectors to a row's first pixel and from one pixel to the next. Rows are numbered
    /// among those that are drawn.
    ///
    /// Both vectors are at depth 1. The first vector is from the eye to the centre of the pixel.
    pub(crate) fn ray(&self, row: usize) -> (Vec3, Vec3) {
        (self.first + self.row * self.stripes.row(row) as f32, self.column)
    }

    /// Returns the vector from the eye to the centre of a pixel, of a row numbered as for
    /// [`ray`](Self::ray), and those from the pixel to its right and to its lower neighbour. All are at
    /// depth 1.
    pub(crate) fn rays(&self, row: usize, column: usize) -> (DVec3, Vec3, Vec3) {
        let [first, across, down] = [self.first, self.column, self.row].map(|way| way.as_dvec3());
        let first = first + down * self.stripes.row(row) as f64 + across * column as f64;
        (first, self.column, self.row)
    }
}
