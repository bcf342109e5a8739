//! How the spotlight moves: its pool of light swings over the floor.

use luminaire::{Vec3, number::Length};

use super::camera::steps;
use super::measures::{AXIS, LIGHT};
use super::paint::Key;

/// Frames of one swing to the left and back.
pub const FRAMES: u32 = 64;

/// Where the axis of the light meets the floor in frame 0.
const TARGET: Vec3<i32> = {
    let fall = LIGHT[1] / -AXIS[1];
    Vec3::new(steps(LIGHT[0] + fall * AXIS[0]), 0, steps(LIGHT[2] + fall * AXIS[2]))
};
/// How far the pool swings, in metres to the right and to the front.
const SWING: [f32; 2] = [-1.5, 0.75];

/// The light of a frame. Frame 0 has the light itself.
pub(super) fn aimed(key: Key, frame: u32) -> Key {
    // The light hangs above the floor, so that the axis always exists.
    if frame.is_multiple_of(FRAMES) { key } else { key.aimed_at(target(frame)).unwrap_or(key) }
}

/// Where the axis of the light meets the floor.
pub(super) fn target(frame: u32) -> Vec3<Length> {
    // The parabola through 0, 1 and 0, in steps of 2^-10: the swing slows down where it turns.
    let phase = (frame % FRAMES).cast_signed();
    let part = phase * (FRAMES.cast_signed() - phase);
    let swung = |length: f32| (steps(length) >> 10) * part;
    Vec3::new(TARGET.x + swung(SWING[0]), TARGET.y, TARGET.z + swung(SWING[1])).map(Length::from_bits)
}
