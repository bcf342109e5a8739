//! Spotlights in f64 by the formulas of the literature, and the search for the worst error of a
//! kernel against them.
//!
//! Nothing here is fast, and nothing depends on the crate `luminaire`: the truth shares no code with
//! what is tested. Where f64 itself would cancel, the versine is `2 sin^2(angle / 2)` or half the
//! squared difference of two unit vectors. Functions are those of `libm`, so that every target
//! computes the same bits.
//!
//! To test a kernel of your own, describe the light and pass the kernel as a closure from a point
//! and a unit normal to the irradiance:
//!
//! ```
//! use luminaire_oracle::{Cone, SpotLight, kernel, soft, versine};
//!
//! let light = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], Cone::new(soft, versine(2.0)));
//! let errors = kernel::errors(&light, |[x, y, z], [nx, ny, nz]| {
//!     let way = [x, y - 4.0, z]; // f32, straight down, and a cosine subtracted from one
//!     let distance = (way[0] * way[0] + way[1] * way[1] + way[2] * way[2]).sqrt();
//!     let outer = 2_f32.to_radians().cos();
//!     let t = ((-way[1] / distance - outer) / (1.0 - outer)).max(0.0);
//!     let cosine = -(way[0] * nx + way[1] * ny + way[2] * nz) / distance;
//!     f64::from(t * t * cosine.max(0.0) / (distance * distance))
//! });
//! assert!(errors.mean < 0.01); // a mean says little:
//! assert!(errors.climbed.error > 0.2); // in linear codes, at `errors.climbed.input`
//! ```
//!
//! `cargo run -p luminaire-oracle --example own_kernel` prints the errors of the spotlight of a shader.
//!
//! | module | holds |
//! |---|---|
//! | [`mod@falloff`] | versines, falloffs and cones |
//! | [`attenuation`] | intensity over the distance |
//! | [`specular`] | specular lobes and the classic equation |
//! | [`light`] | the spotlight |
//! | [`measured`] | the light of a table over all directions |
//! | [`display`] | sRGB, and errors in linear codes |
//! | [`vector`] | what `glam` does not have |
//! | [`random`] | random numbers for inputs that are on record |
//! | `sweep`, `climb`, `kernel` | with the feature `search`: where to look, the search, the errors |
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(feature = "search", test))]
extern crate std;

pub mod attenuation;
#[cfg(feature = "search")]
pub mod climb;
pub mod display;
pub mod falloff;
#[cfg(feature = "search")]
pub mod kernel;
pub mod light;
pub mod measured;
pub mod random;
pub mod specular;
#[cfg(feature = "search")]
pub mod sweep;
pub mod vector;

pub use attenuation::Attenuation;
pub use display::{counted, linear_codes, srgb_code, srgb_linear};
pub use falloff::*;
pub use glam::DVec3;
pub use light::SpotLight;
pub use measured::{MeasuredLight, Octahedron};
pub use random::SplitMix64;
pub use specular::{Classic, Lobe, blinn_phong, dual_cone, lyon, phong};
pub use vector::{on_grid, turned};
