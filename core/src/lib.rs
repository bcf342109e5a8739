//! A `no_std` lighting kernel.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
extern crate std;

mod angle;
mod color;
mod cone;
mod error;
mod light;
mod profile;
mod scalar;
mod shade;
mod trig;
mod vec3;

pub use angle::{Angle, HalfAngle};
pub use color::{Rgb, decode_srgb, encode_srgb};
pub use cone::{Cone, Falloff};
pub use error::{Accepted, Error, Parameter};
pub use light::Spot;
pub use profile::{Edge, Hard, Profile, Soft};
#[cfg(feature = "fixed")]
pub use scalar::{Fx16, Fx32};
pub use scalar::{Offset, Ray, Scalar};
pub use shade::CompiledSpot;
pub use vec3::Vec3;
