//! Lights of other systems: what their parameters mean, as lights of this crate.
//!
//! Each system has a type whose fields have its names, units and defaults; `import` places the
//! light and says how far it is from the original. Nothing is parsed here.
//!
//! ```
//! use luminaire::{Vec3, import};
//! let flashlight = import::Godot { spot_angle: 25.0, spot_angle_attenuation: 2.0, ..Default::default() };
//! let imported = flashlight.import(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0))?;
//! // Godot's rim is a square root here.
//! assert_eq!(imported.difference, import::Difference::default());
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
//! | [`Three`] | half, radians | smoothstep around a hotspot | `1 / d^k` in Filament's window |
//! | [`Godot`] | half, degrees | `1 - u^(1/p)` | `1 / d^k` in Filament's window |
//! | [`Penumbra`] | as an [`Angle`] | `t` or smoothstep around a hotspot | `1 / d^2` |
//!
//! `t` and `u = 1 - t` are those of the [profiles](crate::falloff::Falloff): the cosine on the way from the
//! outer to the inner angle.
//!
//! # What is exact, and what is not
//!
//! All is exact but two things. A light of Godot with a whole exponent lacks up to 0.0001 of its
//! intensity on the axis. And an attenuation by a power other than 0, 1 and 2 becomes `1 / (a0 + a1 d)` under 1
//! and `1 / (a1 d + a2 d^2)` over it, with coefficients that are searched for a small largest
//! [`Difference`]. The largest differences over the lights of each system, as `cargo test --test
//! import -- --nocapture --test-threads 1` prints them:
//!
//! | system | intensity over the angle | place of a boundless slope, half angles | distance |
//! |---|---|---|---|
//! | OpenGL, exponents 0 to 128 and between | 0 | 3.0e-8 | 0 |
//! | Direct3D, falloffs 0 to 127.5 | 0 | 3.0e-8 | 0 |
//! | glTF, umbra and penumbra | 0 | 0 | 0 |
//! | three.js, decays 0 to 16 | 0 | 0 | 0.99 |
//! | Godot, angle attenuations 1/127.5 to 128, decays 0 to 16 | 1.0e-4 | 0 | 1.0 |
//!
//! | decay | 0.1 | 0.5 | 0.9 | 1.1 | 1.5 | 1.9 | 2.2 | 3 | 8 |
//! |---|---|---|---|---|---|---|---|---|---|
//! | Godot, to a range of 8 | 0.065 | 0.13 | 0.035 | 0.042 | 0.084 | 0.028 | 0.22 | 0.75 | 1.0 |
//!
//! A decay over 2 falls faster than any divisor of the kernel grows: those are the numbers to look
//! at before a light is used. A falloff under 1 has a slope without bound at its edge, which no
//! format follows: it holds the place there.
//!
//! What an original makes of numbers that divide by zero in it is not imported: an inner angle at
//! the outer one is a step here. glTF's reference code divides by 0.001 there, which
//! [`Gltf::import_as_recommended`] reproduces.
//!
//! # One type
//!
//! A light that is imported may have any profile and any distance model, so that both are chosen at
//! run time ([`AnyFalloff`], [`AnyAttenuation`]) and cost a branch per point. A renderer that minds makes a
//! [`AnyLight`](crate::dynamic::AnyLight) of it, which branches once per light.

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
    opengl::{OpenGl, OpenGlLight},
    penumbra::{Penumbra, Ramp},
    three::Three,
};

use self::fall::Fall;
use crate::{
    angle::Angle,
    attenuation::AnyAttenuation,
    cone::Cone,
    error::Error,
    falloff::{AnyFalloff, Step},
    light::SpotLight,
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

/// The largest difference between an imported light and the original, each in exact arithmetic: 0
/// where the light is held exactly. What a number format adds is its own.
///
/// Intensities are relative to the light on the axis. The differences are upper bounds, at most a
/// thousandth over the true ones.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Difference {
    /// Of the intensity over the angle, from 0 to 1: at most 1/510 for every light that is
    /// imported.
    pub angle: f32,
    /// Of the place, in outer half angles, where the slope over the angle has no bound: at the edge
    /// of a
    /// [`Direct3d::falloff`] between 0 and 1, and of such an [`OpenGl::spot_exponent`] with a cutoff of 90 degrees. There an
    /// f32 tells no angle that is nearer to the edge than 2^-25, so that no format holds an
    /// intensity. 0 for every other light, and at most 1/510.
    pub place: f32,
    /// Of the fall with distance, from 0 to 1: relative to the light at distance 1, or to the
    /// brighter of the two where that is more. At distances from 0.1 on, or from where the original
    /// stops growing, to the range or 32,767.
    pub distance: f32,
}

impl Difference {
    /// What the light differs by at most where it arrives, but for a difference of the place: the
    /// sum of the other two.
    pub fn most(self) -> f32 {
        (self.angle + self.distance).min(1.0)
    }

    const NONE: Self = Self { angle: 0.0, place: 0.0, distance: 0.0 };

    /// Of a profile whose slope has no bound at its edge.
    const AT_THE_EDGE: Self = Self { place: 1.0 / 33_554_432.0, ..Self::NONE };

    fn with_distance(self, difference: f64) -> Self {
        Self { distance: (difference * 1.001).min(1.0) as f32, ..self }
    }
}

/// The ramp of a profile from an outer angle to an inner one; a step where the two are one.
fn ramp(profile: AnyFalloff, inner: Angle, outer: Angle) -> Result<Cone<AnyFalloff>, Error> {
    if inner >= outer {
        Cone::from_outer(AnyFalloff::Step(Step), outer)
    } else {
        Cone::from_outer(profile, outer)?.with_inner(inner)
    }
}

/// The spotlight of what was imported, with the difference of its cone.
fn spot(
    position: Vec3<f32>,
    direction: Vec3<f32>,
    cone: Cone<AnyFalloff>,
    difference: Difference,
    fall: Fall,
) -> Result<Imported<SpotLight<AnyFalloff, AnyAttenuation>>, Error> {
    let light = SpotLight::new(position, direction, cone)?.with_intensity(fall.intensity)?;
    let difference = difference.with_distance(fall.difference);
    Ok(Imported { light: light.with_attenuation(fall.distance), difference })
}
