//! A sprite of 64 x 64 pixels with a normal map, lit again in every picture by two moving lights: point by point, or
//! interpolated between the corners of cells. No float and, but for two a picture, no division is computed.
//!
//! The lights are the kernel's, in 16 bits. [`points`] lights every pixel by them. [`cells`] lights the corners of
//! cells alone, on the flat plane of the sprite, and interpolates this light; the tilt of each pixel's normal towards
//! the light stays exact. Both have the same pixels of 15 bits from the light on: [`shown`].
#![no_std]

pub mod cells;
pub mod measures;
pub mod points;
mod scene;
pub mod shown;
mod sprite;
mod word;

pub use self::{
    scene::{Lights, place},
    sprite::{SPANS, Span, Sprite, WORDS},
    word::Word,
};
