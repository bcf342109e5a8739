//! What the sprite and its lights are.

/// The side of the sprite in pixels.
pub const SIDE: usize = 64;
/// Pixels to a unit of the scene: 8, so that all offsets from a light have the 18 to 24 bits of the kernel's common
/// path, which spans 2 to 256 units.
pub const PIXEL_BITS: i32 = 1 << (16 - 3);
/// The levels of a light in the table of pixels.
pub const LIGHT_LEVELS: usize = 32;
/// The most materials.
pub const MATERIALS: usize = 32;
/// The steps of light in the table of levels: 2,048 to full scale.
pub const STEPS: usize = 4_096;
/// The linear colours of the two lights.
pub const COLORS: [[f32; 3]; 2] = [[1.0, 0.62, 0.26], [0.3, 0.6, 1.0]];
/// The intensity of each light: full scale at a distance of 3.5 units.
pub const INTENSITY: f32 = 12.0;
/// The ambient light.
pub const AMBIENT: [f32; 3] = [0.012, 0.012, 0.02];
/// The nearest that a light comes to the plane of the sprite, in units.
pub const NEAREST: f32 = 2.75;
