//! Drawables for two dimensions: gradients, pools of light, lit sprites.
//!
//! | drawable | shows |
//! |---|---|
//! | [`Gradient`] | sRGB colours between two places or around one, without bands |
//! | [`Pool`] | the screen as a wall that a light shines on |
//! | [`Sprite`] | a picture of normals, lit by any number of lights |
//!
//! Each writes a row of pixels from `(x, y)` on to a buffer of the program, so that no picture is in
//! memory, and one can be drawn over another. `interop::embedded_graphics::Area` draws such rows on a
//! display of `embedded-graphics`. Every y, every x and every length of a row is defined.
//!
//! A pool and a sprite are in the plane z = 0 of the scene. The centre of the pixel `(x, y)` is `x` times
//! the length of a pixel to the right of the origin, and `y` times this length in the direction of y,
//! which points down on a screen; z points to the viewer. A pixel of 1/32 unit is
//! `Length::from_bits(1 << (16 - 5))`. Coordinates past the range of a fixed-point format wrap.

mod gradient;
mod normals;
mod pool;
mod sprite;

pub use self::{
    gradient::{Gradient, Shape},
    normals::{normals_from_directx, normals_from_opengl},
    pool::Pool,
    sprite::Sprite,
};

use crate::{number::Scalar, points::Points, row::Row, vec3::Vec3};

/// The number of pixels whose light is in memory at a time.
const BLOCK: usize = 64;

/// Returns the points of the pixels from `(x, y)` on, on a plane that faces the viewer.
#[inline(always)]
fn row<S: Scalar>(pixel: S::Length, y: i32, x: i32) -> Row<S, impl Points<S>> {
    let facing = Vec3::new(S::ZERO, S::ZERO, S::ONE);
    Row::along_x(facing, [S::length_times(pixel, y), S::Length::default()], move |i| {
        S::length_times(pixel, x.wrapping_add(i as i32))
    })
}
