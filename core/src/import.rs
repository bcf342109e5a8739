//! Lights of other systems: what their parameters mean, as lights of this crate.
//!
//! Each system has a type whose fields have its names, units and defaults; `import` places the light and says
//! how far it is from the original. Nothing is parsed here.
//!
//! ```
//! use luminaire::{Vec3, import};
//! let flashlight = import::Godot { spot_angle: 25.0, spot_angle_attenuation: 2.0, ..Default::default() };
//! let imported = flashlight.import(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0))?;
//! // Godot's rim is a square root here, which the kernel has not; its distance is held exactly.
//! assert!(imported.difference.angle < 0.05 && imported.difference.distance == 0.0);
//! let lit = imported.light.compile::<f32>()?;
//! assert!(lit.irradiance(Vec3::new(0.0, 3.0, 0.0), Vec3::new(0.0, 1.0, 0.0)) > 0.9);
//! # Ok::<(), luminaire::Error>(())
//! ```
//!
//! | system | its angles | over the angle | over the distance |
//! |---|---|---|---|
//! | [`OpenGl`] | half, degrees | `cos^e`, cut off | `1 / (a0 + a1 d + a2 d^2)` |
//! | [`Direct3d`] | full, radians | `t^p` around a hotspot | the same, cut off at a range |
//! | [`Gltf`] | half, radians | `t^2` around a hotspot | `1 / d^2` in a window |
//! | [`Three`] | half, radians | smoothstep around a hotspot | `1 / d^k` in a squared window |
//! | [`Godot`] | half, degrees | `1 - u^(1/p)` | `1 / d^k` in a squared window |
//! | [`Penumbra`] | as an [`Angle`] | `t` or smoothstep around a hotspot | `1 / d^2` |
//!
//! `t` and `u = 1 - t` are those of the [profiles](crate::Profile): the cosine on the way from the outer to
//! the inner angle.
//!
//! # What is exact, and what is not
//!
//! Everything is held exactly but powers of exponents that are no integers, and distances that light falls
//! with by a power other than 0, 1 and 2. Those become the profile and the distance model of the smallest
//! largest [`Difference`] among mixtures of two integer powers and cubics, and among `1 / (a0 + a1 d)` and
//! `1 / (a1 d + a2 d^2)`. As `cargo test --test import -- --nocapture --test-threads 1` prints them:
//!
//! | exponent | 0.2 | 0.25 | 1/3 | 0.5 | 0.75 | 1.5 | 2.5 | 3.5 | 7.5 | 12.5 | 31.5 |
//! |---|---|---|---|---|---|---|---|---|---|---|---|
//! | falloff of Direct3D, rim of Godot | 0.18 | 0.12 | 0.060 | 0.041 | 0.012 | 3.9e-3 | 5.1e-3 | 2.6e-3 | 5.6e-4 | 2.0e-4 | 3.2e-5 |
//! | OpenGL to a cutoff of 30 degrees | 7.5e-5 | 6.7e-5 | 5.5e-5 | 3.6e-5 | 1.3e-5 | 6.5e-6 | 3.6e-4 | 3.0e-5 | 2.4e-4 | 1.6e-4 | 3.2e-5 |
//!
//! | decay | 0.1 | 0.5 | 0.9 | 1.1 | 1.5 | 1.9 | 2.2 | 3 | 8 |
//! |---|---|---|---|---|---|---|---|---|---|
//! | Godot, to a range of 8 | 0.065 | 0.13 | 0.035 | 0.042 | 0.084 | 0.028 | 0.22 | 0.75 | 1.0 |
//!
//! A root has an infinite slope where it is zero, and a decay over 2 falls faster than any divisor of the
//! kernel grows: those are the numbers to look at before a light is used.
//!
//! What an original makes of numbers that divide by zero in it is not imported: an inner angle at the outer
//! one is a step here. glTF's reference code divides by 0.001 there, which
//! [`Gltf::import_as_recommended`] reproduces.
//!
//! # One type
//!
//! A light that is imported may have any profile and any distance model, so that both are chosen at run time
//! ([`Matched`], [`Distance`]) and cost a branch per point. A renderer that minds makes a [`Lamp`](crate::Lamp) of it,
//! which branches once per light.

mod direct3d;
mod fall;
mod gltf;
mod godot;
mod opengl;
mod penumbra;
mod three;

pub use self::{
    direct3d::Direct3d,
    gltf::Gltf,
    godot::Godot,
    opengl::{Lamp, OpenGl},
    penumbra::{Penumbra, Ramp},
    three::Three,
};

use self::fall::Fall;
use crate::{
    angle::Angle,
    attenuation::Distance,
    cone::Cone,
    error::Error,
    light::Spot,
    profile::{CutOff, Matched},
    vec3::Vec3,
};

/// A light of another system and how far it is from the original.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Imported<L> {
    /// The light.
    pub light: L,
    /// How far it is from the original.
    pub difference: Difference,
}

/// The largest difference between an imported light and the original, each in exact arithmetic: 0 where the
/// light is held exactly. What a number format adds is its own.
///
/// Both are relative to the light on the axis. Found by a search over the curves and rounded up by a
/// thousandth.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Difference {
    /// Of the intensity over the angle, from 0 to 1, at every angle whose place between the edge and the
    /// middle f32 can tell, 2^-24.
    pub angle: f32,
    /// Of the fall with distance, from 0 to 1: relative to the light at distance 1, or to the brighter of the
    /// two where that is more. At distances from 0.1 on, or from where the original stops growing, to the
    /// range or 32,767.
    pub distance: f32,
}

impl Difference {
    /// What the light differs by at most where it arrives: the sum of the two.
    pub fn most(self) -> f32 {
        (self.angle + self.distance).min(1.0)
    }

    fn new(angle: f64, distance: f64) -> Self {
        let rounded_up = |difference: f64| (difference * 1.001).min(1.0) as f32;
        Self { angle: rounded_up(angle), distance: rounded_up(distance) }
    }
}

/// The ramp of a profile from an outer angle to an inner one; a step where the two are one.
fn ramp(profile: Matched, inner: Angle, outer: Angle) -> Result<Cone<Matched>, Error> {
    if inner >= outer {
        Cone::from_outer(Matched::CutOff(CutOff), outer)
    } else {
        Cone::from_outer(profile, outer)?.with_inner(inner)
    }
}

/// The spotlight of what was imported.
fn spot(
    position: Vec3<f32>,
    direction: Vec3<f32>,
    cone: Cone<Matched>,
    angle: f64,
    fall: Fall,
) -> Result<Imported<Spot<Matched, Distance>>, Error> {
    let light = Spot::new(position, direction, cone)?.with_intensity(fall.intensity)?;
    let difference = Difference::new(angle, fall.difference);
    Ok(Imported { light: light.with_attenuation(fall.distance), difference })
}
