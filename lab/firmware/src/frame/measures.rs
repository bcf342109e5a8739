//! The scene in metres: a stage seen from the stalls. The program uses these numbers only in
//! constants. The build script also needs the position of the light.

/// Where the camera stands. It looks along -z, and the picture is shifted down instead of tilted,
/// so that verticals stay vertical.
pub(crate) const EYE: [f32; 3] = [0.0, 1.5, 4.5];
/// Where the light hangs.
pub(crate) const LIGHT: [f32; 3] = [-1.75, 3.25, 2.5];
/// Where the back wall stands.
pub(crate) const WALL: f32 = -1.5;
/// The ball on the floor.
pub(crate) const BALL: [f32; 3] = [0.75, 0.5625, 0.5];
pub(crate) const BALL_RADIUS: f32 = 0.5625;
/// The column: where it stands on the floor, and how high it is.
pub(crate) const COLUMN: [f32; 2] = [-0.75, -0.125];
pub(crate) const COLUMN_RADIUS: f32 = 0.3125;
pub(crate) const COLUMN_HEIGHT: f32 = 1.25;
