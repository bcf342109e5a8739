//! The directions of a beam in coordinates of the eye and the light.

use super::{
    hazy::Hazy,
    rays::{COLUMNS, Fan, ROWS},
};
use crate::space::vector;
use glam::{DVec2, DVec3, Vec2, Vec3, Vec3Swizzles as _};

/// Pixels of a row whose light is computed together: two vector registers on most targets.
pub(super) const WIDTH: usize = 8;

/// The number of each of these pixels.
const LANE: [f32; WIDTH] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// The directions of a beam, as seen from the light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// The direction to the eye, the direction orthogonal to it on whose side the axis is, and the one
    /// orthogonal to both.
    eye: DVec3,
    toward: DVec3,
    beside: DVec3,
    /// The distance of the eye.
    pub(super) distance: f32,
    /// The coordinates of the axis along `eye` and along `toward`.
    pub(super) axis: [f32; 2],
    /// The versine and the sine of the outer angle.
    pub(super) versine: f32,
    pub(super) sine: f32,
    /// Whether the eye is neither in the cone nor in the opposite cone.
    pub(super) is_outside: bool,
    /// The squared radius of the light, and the reciprocal of what the squared distance exceeds it by.
    radius_squared: f32,
    per_excess: f32,
}

/// The rays through the pixels of a tile in the coordinates of a [`Frame`], as vectors to depth 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheaf {
    /// The vector to the pixel `origin`, which is the nearest to the light's image: so the first two
    /// coordinates of pixels close to it keep their bits.
    first: Vec3,
    column: Vec3,
    row: Vec3,
    origin: Vec2,
    /// Whether a ray may hit the light's body.
    pub(super) is_near: bool,
}

/// Sine of the angle between the axis and the line from the light to the eye, relative to the sine of
/// the outer angle, up to which the eye counts as in the cone or in the opposite cone.
pub(super) const OUTSIDE: f32 = 1.01;

/// Least distance of the eye, in radii of the light.
const CLEARANCE: f32 = 1.5;

impl Frame {
    /// Returns the frame of a beam; `None` if the eye is in the light, or nearly so.
    ///
    /// Computed in f64, as the vectors of a [`Sheaf`].
    pub(super) fn new(hazy: &Hazy, eye: Vec3) -> Option<Self> {
        let offset = eye.as_dvec3() - hazy.position.as_dvec3();
        let (long, eye, axis) = (offset.length(), offset.normalize(), hazy.axis.as_dvec3().normalize());
        let (distance, radius) = (Some(long as f32), hazy.radius);
        let distance = distance.filter(|&distance| distance > CLEARANCE * radius)?;
        let along = eye.dot(axis);
        let across = axis - along * eye;
        let aside = across.length() as f32;
        let toward = if aside > 0.0 { across.normalize() } else { eye.any_orthonormal_vector() };
        let versine = hazy.beam.outer_versine();
        let sine = vector::sqrt(versine * (2.0 - versine));
        Some(Self {
            eye,
            toward,
            beside: eye.cross(toward),
            distance,
            axis: [along as f32, aside],
            versine,
            sine,
            is_outside: versine < 1.0 && aside > OUTSIDE * sine,
            radius_squared: radius * radius,
            per_excess: 1.0 / (distance * distance - radius * radius),
        })
    }

    /// Returns the direction to the eye, and the two orthogonal to it.
    pub(super) fn directions(&self) -> [Vec3; 3] {
        [self.eye, self.toward, self.beside].map(|v| v.as_vec3())
    }

    /// Returns the rays through a tile.
    pub(super) fn sheaf(&self, fan: &Fan) -> Sheaf {
        let local = |way: DVec3| DVec3::new(way.dot(self.toward), way.dot(self.beside), way.dot(self.eye));
        let [first, column, row] = fan.vectors().map(local);
        let [x, y, z] = [first, column, row].map(|way| way.xy());
        // The light's image is where the first two coordinates are 0.
        let image = DVec2::new(z.perp_dot(x), x.perp_dot(y)) / y.perp_dot(z);
        let origin = image.round().max(DVec2::ZERO).min(DVec2::new(COLUMNS as f64, ROWS as f64));
        let first = (first + column * origin.x + row * origin.y).as_vec3();
        let (column, row) = (column.as_vec3(), row.as_vec3());
        // A bound of the distance of the other pixels from the first.
        let reach = vector::length(column) * COLUMNS as f32 + vector::length(row) * ROWS as f32;
        let body = 1.01 * vector::sqrt(self.radius_squared * self.per_excess);
        let is_near = vector::length(first.with_z(0.0)) < reach + body * (vector::length(first) + reach);
        Sheaf { first, column, row, origin: origin.as_vec2(), is_near }
    }

    /// Returns the coordinate along `eye` of the end of a ray, times the nearness of the end: at the
    /// surface, or at the light's body if the ray hits it before. `squared` is the squared distance of
    /// `way` from the line to the light, and `whole` its squared length.
    #[inline(always)]
    pub(super) fn far(&self, is_near: bool, way: Vec3, [squared, whole]: [f32; 2], nearness: f32) -> f32 {
        let Self { distance, radius_squared, per_excess, .. } = *self;
        let surface = distance * nearness + way.z;
        if !is_near {
            return surface;
        }
        let inside = radius_squared * whole - distance * distance * squared;
        let is_hit = (inside > 0.0) & (way.z < 0.0);
        let root = vector::sqrt(if inside > 0.0 { inside } else { 0.0 });
        // Without the difference of `distance` times the nearness of the body, and `way.z`.
        let body = (distance * root - radius_squared * way.z) * per_excess;
        if is_hit & (body > surface) { body } else { surface }
    }
}

impl Sheaf {
    /// Returns the vectors to the pixels from `(x, y)` to the right, by their number.
    #[inline(always)]
    pub(super) fn row(&self, x: usize, y: usize) -> impl Fn(usize) -> Vec3 {
        let start = self.first + self.row * (y as f32 - self.origin.y);
        let (first, column) = (x as f32 - self.origin.x, self.column);
        move |i| start + column * (first + LANE[i])
    }
}
