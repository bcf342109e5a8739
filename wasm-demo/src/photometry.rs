//! Photometric units: how many lux a scene shows as full scale.
//!
//! The scenes state intensities relative to full scale: a light of intensity 1 lights a surface that
//! faces it at 1 metre to full scale. A number of lux for full scale converts them to candela and
//! leaves the pictures as they are. The number is chosen so that a scene's lights have the
//! intensities of such fixtures: the key light of the still life, for one, has the 90,000 candela of
//! a 26 degree profile spot of 575 watts.

use luminaire_render::scenes::Example;

/// Returns the illuminance in lux that a scene shows as full scale at an exposure of 0 stops, on a
/// white surface.
pub(crate) fn full_scale(scene: Example) -> f32 {
    match scene {
        // What museums light pictures with.
        Example::Gallery => 200.0,
        // What a stage is lit with.
        _ => 1000.0,
    }
}
