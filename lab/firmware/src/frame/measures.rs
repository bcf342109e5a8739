//! The scene in metres: a stage seen from the stalls. The program uses these numbers only in
//! constants. The build script also needs the position of the light.

/// The position of the camera. It looks along -z. The picture is shifted down, instead of the
/// camera being tilted, so that vertical lines stay vertical.
pub(crate) const EYE: [f32; 3] = [0.0, 1.5, 4.5];
/// The position of the light.
pub(crate) const LIGHT: [f32; 3] = [-1.75, 3.25, 2.5];
/// The z coordinate of the back wall.
pub(crate) const WALL: f32 = -1.5;
/// The centre and the radius of the ball, which lies on the floor.
pub(crate) const BALL: [f32; 3] = [0.75, 0.5625, 0.5];
pub(crate) const BALL_RADIUS: f32 = 0.5625;
/// The column: x and z of its axis, its radius and its height.
pub(crate) const COLUMN: [f32; 2] = [-0.75, -0.125];
pub(crate) const COLUMN_RADIUS: f32 = 0.3125;
pub(crate) const COLUMN_HEIGHT: f32 = 1.25;
