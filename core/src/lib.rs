//! A lighting kernel for renderers on targets without a GPU: a microcontroller, a software renderer
//! or a browser canvas.
//!
//! A spotlight is described by the two angles of a stage light's data sheet. At the beam angle the
//! intensity is 50 % of the intensity on the axis, at the field angle 10 %. The angular falloff
//! from the axis to the edge is a polynomial of one to three multiplies instead of a power
//! function. The polynomial is one of the two quadratics of Hast 2004, with a soft or a hard edge,
//! or a cubic with a given beam and field angle. [`falloff`] lists all falloffs. The same generic
//! code runs in `f32`, in 32-bit fixed point and in 16-bit fixed point.
//!
//! "Hast 2004" is A. Hast, T. Barrera and E. Bengtsson, *Fast Intensity Distribution Functions for
//! Soft and Hard Edged Spotlights*, WSCG 2004 Short Communications, pages 95 to 100.
//!
//! ```
//! use luminaire::{Angle, Cone, Fx16, SpotLight};
//!
//! // A soft-edged stage light with a field angle of 15 degrees, four metres above the origin, pointing down.
//! let cone = Cone::soft(Angle::degrees(15.0))?;
//! let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_intensity(16.0)?;
//!
//! // Converts angles to coefficients: from here on there is no trigonometry and, in fixed point, no
//! // division and no float. The type of the normal selects the number format.
//! let lit = spot.compile()?;
//!
//! // A point on the floor where the beam angle meets it, 34 cm from the middle, facing up.
//! const POINT: luminaire::Vec3<luminaire::Length> = Fx16::point([0.343, 0.0, 0.0]);
//! let light = lit.irradiance(POINT, Fx16::normal([0.0, 1.0, 0.0]));
//! assert!((light.to_f32() - 0.5).abs() < 0.01);
//! # Ok::<(), luminaire::Error>(())
//! ```
//!
//! The next example adds the light of several spotlights and converts the sum to a pixel, also without floats:
//!
//! ```
//! use luminaire::{Fx16, Rgb, display::{Rgb565, clip}};
//! # use luminaire::{Angle, Cone, SpotLight};
//! # let cone = Cone::soft(Angle::degrees(15.0))?;
//! # let amber = Rgb::new(1.0, 0.62, 0.1);
//! # let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_color(amber)?.with_intensity(16.0)?;
//! # let lights = [spot.compile::<Fx16>()?; 2];
//! # let (point, normal) = (Fx16::point([0.343, 0.0, 0.0]), Fx16::normal([0.0, 1.0, 0.0]));
//!
//! let mut sum = Rgb::default();
//! for lit in &lights {
//!     sum += Rgb::lit(lit.irradiance(point, normal), lit.color());
//! }
//! let pixel = Rgb565::from_linear(clip(sum));
//! # assert_eq!(pixel.to_codes().red, 255);
//! # Ok::<(), luminaire::Error>(())
//! ```
//!
//! The [`guide`] has chapters with code: choose a format and an edge, start from a data sheet, light
//! pixels on a microcontroller, move lights, port them from other systems, test your own kernel.
//!
//! # Choosing a format
//!
//! | evaluation | `f32` | [`Fx32`] | [`Fx16`] | [`Fx16`], quick |
//! |---|---|---|---|---|
//! | choose it for | a processor with a floating-point unit, a browser, a desktop | beams under one degree or minimal error, without a floating-point unit | everything else without a floating-point unit | the same, where a display hides the error |
//! | largest error of a lit point of a soft spotlight of 36 degrees, linear codes (searched) | 3.6e-4 | 5.1e-5 | 0.29 | 0.80 |
//! | a bound of that error, linear codes (derived) | 0.0040 | 3.1e-4 | 0.92 | 2.3 |
//! | instructions of a lit point, Cortex-M0 (counted) | 5,338 | 485 | 211 | 141 |
//! | instructions, Cortex-M4F | 76.0 | 167 | 147 | 93.0 |
//! | instructions, RV32IMC | 2,720 | 186 | 153 | 96.1 |
//! | instructions, Cortex-M33 (RP2350) | 57.0 | 180 | 146 | 96.0 |
//! | instructions, Hazard3 (RP2350) | 2,551 | 181 | 140 | 94.1 |
//! | narrowest soft cone, half angle in degrees (half of [`Cone::narrowest`]) | 0.0050 | 0.00012 | 0.70 | 0.70 |
//!
//! [`SpotLight::compile`] compiles a light for a format, [`SpotLight::compile_quick`] for the quick
//! evaluation of [`Fx16`]. Points, normals and irradiances have the types of the format, so that one
//! scene can have lights of both.
//!
//! A *linear code* is 1/255 of full scale in linear light, clipped at 1. A lit point has Lambert's
//! cosine and the inverse square, the default, at distances from 1 to 7 from a light of intensity 16:
//! row `lit-inverse-square` of `docs/PRICES.md`. *Searched* means the largest error of very many random
//! points, here at incidences up to 80 degrees; *derived* means from the errors of the stages of the
//! evaluation, at all points: [`SpotLight::error_bound`] returns such a bound for any light. *Counted*
//! means counted by an emulator. That document lists more kernels, more processors and other libraries.
//! Without a floating-point unit, `f32` takes the software floats of Rust, the slowest of three.
//!
//! # What it has
//!
//! | | |
//! |---|---|
//! | lights | [`light`]: spot, point, directional and ambient lights, and measured ones that are not round, with a diffuse and a specular colour; they move, turn, zoom, dim and change their colour at run time, also in integers |
//! | edges | [`falloff`]: the soft and the hard quadratic of Hast 2004; linear, smoothstep, step; any quadratic or monotone cubic; powers up to 1,024; measured tables |
//! | distance | [`attenuation`]: the inverse square, real powers, and the range models of glTF, Filament and OpenGL |
//! | surfaces | [`specular`]: Lambert with a highlight of Phong, Blinn-Phong or a dual cone |
//! | projectors | [`projector`]: gobos and shadow maps, in integers |
//! | haze | [`haze`]: the visible beam of a spotlight |
//! | control | [`dmx`]: pan, tilt, zoom, dimmer and colours by the slots of a universe, in integers |
//! | outputs | [`display`]: exposure; light over full scale clipped, or scaled to keep the hue; sRGB, grey of 1 to 8 bits, RGB332 to RGB888 and palettes, to the nearest code or dithered; LEDs of 1 to 16 bits, dithered in time, and strips of LEDs within a limit of their current |
//! | drawables | [`draw`]: gradients without bands, pools of light on a wall, sprites lit by their normals, row by row |
//! | choice at run time | [`dynamic`]: any light with any edge and attenuation, and a plan of the effects that a scene requires |
//!
//! # Units
//!
//! Light has no unit: 1 is full scale. An intensity of 1 gives an irradiance of 1 at a surface that
//! faces the light, on the axis at distance 1. A matte surface of albedo 1 shows its whole
//! irradiance, without the factor `1/pi` of a radiance. Lengths may have any unit, if all lengths
//! of a scene have the same unit.
//!
//! # Data flow
//!
//! [`Angle`] → [`Cone`] (from its outer, beam or field angle, or from beam and field angle) →
//! [`SpotLight`] (placed, coloured, validated) → [`CompiledSpotLight`](light::CompiledSpotLight)
//! (constants of one number format) → irradiance at a point. Construction validates and returns an
//! [`Error`] that names the parameter. Evaluation is defined for every bit pattern and never fails.
//!
//! # Domain
//!
//! Within the ranges of the table, the error of the falloff of a compiled cone is at most half a linear
//! code, 1/510 of full scale (searched). Where the falloff jumps or its slope is infinite, the error of the angle is
//! at most 1/510 of the outer half angle. `tests/suite/domain.rs` tests the ends of each range, and
//! `tests/slow` those of the angles and exponents.
//!
//! | | `f32` | [`Fx32`] | [`Fx16`] | outside |
//! |---|---|---|---|---|
//! | coordinate of a light | any finite | ±32,639 | ±16,383 | refused |
//! | coordinate of a point | any finite | -32,768 to 32,768 | -32,768 to 32,768 | [`Scalar::length`] saturates; infinite or NaN is dark in `f32` |
//! | distance | 1.1e-19 to 1.8e19 | 2^-16 to 113,000, see below | 2^-16 to 85,000 | zero light: it counts as at the light, or as out of reach |
//! | outer half angle | half of [`Cone::narrowest`] to 90° | the same | the same | refused |
//! | hotspot | up to the steepest edge that the format can hold | the same | the same | refused, with the widest inner angle |
//! | exponent | 1 to 1,024; non-integer exponents more than 0 | the same | the same | refused |
//! | intensity | 0 to 1e9 | the same | the same | refused |
//!
//! Where a component of the vector from a light to a point exceeds 32,768 units, `Fx32` drops one
//! bit of the vector, and the narrowest cones of `Fx32` are a quarter wider.
//!
//! The error of the light at a surface grows with the intensity and towards the light:
//! [`SpotLight::error_bound`] derives a bound of it for the distances of the surfaces. If the bound is
//! too large, divide the intensity and multiply the sum of all lights by an
//! [`Exposure`](display::Exposure), or keep the surfaces in regions where the irradiance is at most
//! full scale. The bound is that of diffuse light. A highlight adds the error of its lobe, times the light that a
//! facing surface would receive: for exponents up to 256 in `Fx16` at most 3.1e-3 of Phong's lobe, and 5.3e-3 of
//! Blinn-Phong's with light and eye up to 120 degrees apart (derived). Nearly opposite of each other, at grazing incidence,
//! they make the direction halfway between them uncertain.
//!
//! # Half or full angle
//!
//! An [`Angle`] is a full angle, from edge to edge through the axis. A [`HalfAngle`] goes from the
//! axis to the edge. Each of the two types converts into the other, and constructors take either
//! type.
//!
//! | source | its angles | as |
//! |---|---|---|
//! | Hast 2004, data sheets of stage lights | beam and field: full, degrees | [`Angle::degrees`] |
//! | GDTF | `BeamAngle`, `FieldAngle`: full, degrees | [`Angle::degrees`] |
//! | Direct3D 9 | `Theta` (inner), `Phi` (outer): full, radians | [`Angle::radians`] |
//! | OpenGL | `GL_SPOT_CUTOFF`: half, degrees | [`HalfAngle::degrees`] |
//! | glTF `KHR_lights_punctual` | `innerConeAngle`, `outerConeAngle`: half, radians | [`HalfAngle::radians`] |
//! | three.js | `SpotLight.angle`: half, radians | [`HalfAngle::radians`] |
//! | Godot | `spot_angle`: half, degrees | [`HalfAngle::degrees`] |
//!
//! The [porting guide](guide::porting) has their complete formulas; the repository's `luminaire import` converts
//! lights of these tools and of a dozen others from their files and numbers.
//!
//! # Features
//!
//! All features are additive, and any set of features compiles. Without `libm`, `std` and
//! `micromath`, set-up uses series of this crate for sine and arc sine, and the error of its angles
//! is at most a relative 1e-6.
//!
//! | feature | adds |
//! |---|---|
//! | `fixed` (default) | [`Fx16`] and [`Fx32`], on the types of the crate `fixed` |
//! | `libm` (default) | trigonometry for set-up and a square root, bit-identical on every target |
//! | `native` (default) | the square root of an Arm floating point unit, bit-identical, by the unsafe code of the crate `luminaire-native` |
//! | `std` | the processor's square root, bit-identical to that of `libm` |
//! | `micromath` | square roots and sines without `libm` and `std`: angles within 0.13 %, so results differ from those of the other features |
//! | `bytemuck` | [`Vec3`], [`Rgb`], pixels and fixed-point numbers cast to bytes; the only unsafe code |
//! | `defmt` | `Format` for errors, lights, cones, angles, vectors, colours and numbers, for logs of a microcontroller |
//! | `embedded-graphics-core04` | conversions between [`Rgb`]`<u8>` or pixels and its RGB and BGR colours; a `Drawable` of the drawables of [`draw`] |
//! | `glam034` | conversions between [`Vec3`]`<f32>` or [`Rgb`]`<f32>` and `glam::Vec3` |
//! | `mint05` | conversions between [`Vec3`] or [`Rgb`] and `mint::Vector3`, [`Vec3`] and `mint::Point3` |
//! | `serde` | serialisation of lights and cones, checked when they are read; of angles, vectors, colours, pixels and numbers |
//! | `arithmetic` | the arithmetic of the number formats, for tests and cost measurements: may change in any version |

// Modules, lowest first: `error`, `search`, `source`, `stored`, `model`, `models`, `trig`, `vec3`, `angle`, `effect`,
// `distribution`, `number`, `attenuation`, `color`, `falloff`, `specular`, `cone`, `display`, `points`, `interop`, `shade`,
// `haze`, `material`, `row`, `draw`, `light`, `dmx`, `any_light`, `bound`, `projector`, `codegen`, `plan`, `dynamic`,
// `guide`.

#![no_std]
// With `bytemuck`, one file contains unsafe code; without it the crate contains none.
#![cfg_attr(not(feature = "bytemuck"), forbid(unsafe_code))]
#![cfg_attr(feature = "bytemuck", deny(unsafe_code))]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "std")]
extern crate std;

// Cones and lights before what extends them: rustdoc shows methods in this order.
mod cone;
pub mod light;
mod shade;

mod angle;
mod any_light;
pub mod attenuation;
pub mod bound;
pub mod codegen;
mod color;
pub mod display;
mod distribution;
pub mod dmx;
pub mod draw;
pub mod dynamic;
mod effect;
pub mod error;
pub mod falloff;
#[cfg(any(doc, doctest))]
pub mod guide;
pub mod haze;
pub mod interop;
mod material;
mod model;
#[cfg(feature = "arithmetic")]
pub mod models;
#[cfg(not(feature = "arithmetic"))]
mod models;
pub mod number;
mod plan;
mod points;
pub mod projector;
mod row;
mod search;
mod source;
pub mod specular;
mod stored;
mod trig;
mod vec3;

pub use angle::{Angle, HalfAngle, IntoAngle};
pub use color::Rgb;
pub use cone::Cone;
#[doc(inline)]
pub use error::Error;
#[doc(inline)]
pub use light::{AmbientLight, DirectionalLight, MeasuredLight, PointLight, SpotLight};
pub use material::Material;
#[doc(inline)]
pub use number::Scalar;
#[cfg(feature = "fixed")]
#[doc(inline)]
pub use number::{Fx16, Fx32, Length};
pub use vec3::Vec3;
