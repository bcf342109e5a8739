//! The scene in metres: a stage seen from the stalls. The program uses these numbers only in
//! constants. The build script compiles the lights and the materials.

/// The position of the camera. It looks along -z. The picture is shifted down, instead of the
/// camera being tilted, so that vertical lines stay vertical.
pub(crate) const EYE: [f32; 3] = [0.0, 1.5, 4.5];
/// The position of the light.
pub(crate) const LIGHT: [f32; 3] = [-1.75, 3.25, 2.5];
/// The direction of the light, of any length.
pub(crate) const AXIS: [f32; 3] = [1.875, -2.875, -2.875];
/// The field angle of the light in degrees.
pub(crate) const FIELD: f32 = 44.0;
/// The intensity of the light on its axis, at a distance of one metre.
pub(crate) const INTENSITY: f32 = 24.0;
/// The linear colour of the light.
pub(crate) const COLOR: [f32; 3] = [1.0, 0.8, 0.55];
/// The linear colour of the ambient light.
pub(crate) const AMBIENT: [f32; 3] = [0.03, 0.04, 0.075];
/// The linear colours of the wall, a light tile, a dark tile, the ball and the column.
pub(crate) const MATERIALS: [[f32; 3]; 5] =
    [[0.5, 0.36, 0.4], [0.62, 0.55, 0.46], [0.3, 0.26, 0.23], [0.72, 0.1, 0.06], [0.66, 0.63, 0.56]];
/// The z coordinate of the back wall.
pub(crate) const WALL: f32 = -1.5;
/// The centre and the radius of the ball, which lies on the floor.
pub(crate) const BALL: [f32; 3] = [0.75, 0.5625, 0.5];
pub(crate) const BALL_RADIUS: f32 = 0.5625;
/// The column: x and z of its axis, its radius and its height.
pub(crate) const COLUMN: [f32; 2] = [-0.75, -0.125];
pub(crate) const COLUMN_RADIUS: f32 = 0.3125;
pub(crate) const COLUMN_HEIGHT: f32 = 1.25;
