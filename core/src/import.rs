//! Lights of other systems, converted to lights of this crate.
//!
//! Each system has a type whose fields have the system's names, units and defaults. The method
//! `import` of that type takes the light's position and direction. The method returns a light of
//! this crate and the largest difference of this light from the original. The module does not parse
//! files.
//!
//! ```
//! use luminaire::{Vec3, import};
//! let flashlight = import::Godot { spot_angle: 25.0, spot_angle_attenuation: 2.0, ..Default::default() };
//! let imported = flashlight.import(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0))?;
//! // Here the falloff is `1 - sqrt(u)`.
//! assert_eq!(imported.difference, import::Difference::default());
//! let lit = imported.light.compile::<f32>()?;
//! assert!(lit.irradiance(Vec3::new(0.0, 3.0, 0.0), Vec3::new(0.0, 1.0, 0.0)) > 0.9);
//! # Ok::<(), luminaire::Error>(())
//! ```
//!
//! | system | its angles | angular falloff | attenuation |
//! |---|---|---|---|
//! | [`OpenGl`] | half, degrees | `cos^e`, cut off | `1 / (a0 + a1 d + a2 d^2)` |
//! | [`Direct3d`] | full, radians | `t^p` with a hotspot | the same, cut off at a range |
//! | [`Gltf`] | half, radians | `t^2` with a hotspot | `1 / d^2` with glTF's window |
//! | [`Three`] | half, radians | smoothstep with a hotspot | `1 / d^k` with Filament's window |
//! | [`Godot`] | half, degrees | `1 - u^(1/p)` | `1 / d^k` with Filament's window |
//! | [`Penumbra`] | as an [`Angle`] | `t` or smoothstep with a hotspot | `1 / d^2` |
//!
//! `t` and `u = 1 - t` are defined in [`falloff`](crate::falloff): `t` is linear in the cosine of
//! the angle off axis, 0 at the outer angle and 1 at the inner angle.
//!
//! # What is exact, and what is not
//!
//! A light with a [`Difference`] of zero has the other system's formulas, at every angle and at the
//! distances that the difference compares. These are the lights with another difference:
//!
//! | light | its difference |
//! |---|---|
//! | Godot, with an angle attenuation of `1/n` | `angle`: `0.0001^n`, on the axis |
//! | OpenGL, with an exponent in (0, 1) and a cutoff of 90 degrees | `place`: `2^-25` |
//! | Direct3D, with a falloff in (0, 1) | `place`: `2^-25` |
//! | Godot, with an attenuation by over `2^64` at the nearest distance compared | `distance`: what is over it |
//!
//! ```
//! use luminaire::{Vec3, import::{Direct3d, Difference, Godot, OpenGl, Three}};
//! let [from, down] = [Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0)];
//!
//! // A decay of any exponent is exact, with a range and without one.
//! for decay in [0.0, 0.1, 0.5, 1.0, 1.1, 1.5, 2.0, 2.2, 3.0, 8.0, 16.0] {
//!     let godot = Godot { spot_attenuation: decay, spot_angle_attenuation: 0.7, ..Default::default() };
//!     let three = Three { decay, ..Default::default() };
//!     let exact = [godot.import(from, down)?, three.import(from, down)?];
//!     assert!(exact.iter().all(|light| light.difference == Difference::default()));
//! }
//! let root = Godot { spot_angle_attenuation: 0.5, ..Default::default() }.import(from, down)?.difference;
//! assert!(root.angle >= 1e-8 && root.angle < 1.1e-8 && root.distance == 0.0);
//! let wide = OpenGl { spot_cutoff: 90.0, spot_exponent: 0.5, ..Default::default() };
//! let bulging = Direct3d { theta: 0.2, phi: 0.5, falloff: 0.5, attenuation0: 1.0, attenuation1: 0.0,
//!     attenuation2: 0.0, range: 1e18, intensity: 1.0 };
//! for difference in [wide.import(from, down)?.difference, bulging.import(from, down)?.difference] {
//!     assert_eq!((difference.angle, difference.place), (0.0, 0.5_f32.powi(25)));
//! }
//! let blinding = Godot { spot_attenuation: 16.0, spot_range: 0.01, ..Default::default() };
//! assert!(blinding.import(from, down)?.difference.distance > 0.99);
//! # Ok::<(), luminaire::Error>(())
//! ```
//!
//! Nearer than the distances compared, some originals stop growing and their imports do not, or the other
//! way round: the type of each system says where. A falloff with an exponent below 1 has an infinite
//! derivative with respect to the angle at its edge: there a format bounds the error of the position, not
//! of the intensity.
//! `cargo test --test suite import:: -- --nocapture --test-threads 1` compares every import with its
//! system's complete formula, and prints the largest difference of each system.
//!
//! Divisions by zero in the original are not imported: an inner angle equal to the outer angle
//! gives a step. For equal angles, glTF's reference code divides by 0.001 instead;
//! [`Gltf::import_as_recommended`] reproduces this division.
//!
//! # One type
//!
//! The falloff and the attenuation of an imported light are chosen at run time ([`AnyFalloff`],
//! [`AnyAttenuation`]) and cost a branch per point. To branch once per light instead, convert the
//! light into an [`AnyLight`](crate::dynamic::AnyLight).

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

/// An imported light and its largest difference from the original.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Imported<L> {
    /// The light.
    pub light: L,
    /// The largest difference from the original.
    pub difference: Difference,
}

/// The largest difference between an imported light and the original; 0 for an exact import.
///
/// Both lights are computed in exact arithmetic, without the errors of a number format. The
/// differences are upper bounds, at most 0.1 % above the true values.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Difference {
    /// Difference in intensity over the angle, relative to the intensity on the axis, in [0, 1]: at
    /// most 1/510 for every import.
    pub angle: f32,
    /// Difference in position, in outer half angles, where the intensity has an infinite derivative
    /// with respect to the angle. At most 1/510.
    ///
    /// The value is more than 0 only for a light with a [`Direct3d::falloff`] in (0, 1), or with an
    /// [`OpenGl::spot_exponent`] in (0, 1) and a cutoff of 90 degrees. At the edge of such a light,
    /// f32 cannot distinguish angles within 2^-25 of the edge, so no format can represent the
    /// intensity there.
    pub place: f32,
    /// Relative difference in attenuation, in [0, 1]: the difference of the two attenuations divided
    /// by the larger of them.
    ///
    /// Compared are the distances from a sixteenth of the range to the range, and without a range
    /// those from 1 to 16; none below the distance at which the original stops growing. Nearer to
    /// the light and farther from it the difference may be larger.
    pub distance: f32,
}

impl Difference {
    /// Returns an upper bound of the difference in irradiance, relative to the larger of the two
    /// irradiances on the axis at the same distance.
    ///
    /// The bound is the sum of `angle` and `distance`, at most 1. It holds at the distances of
    /// [`distance`](Self::distance), except where the position differs.
    pub fn most(self) -> f32 {
        (self.angle + self.distance).min(1.0)
    }

    const NONE: Self = Self { angle: 0.0, place: 0.0, distance: 0.0 };

    /// The difference of a falloff with an infinite slope at its edge.
    const AT_THE_EDGE: Self = Self { place: 1.0 / 33_554_432.0, ..Self::NONE };

    fn with_distance(self, difference: f64) -> Self {
        Self { distance: (difference * 1.001).min(1.0) as f32, ..self }
    }
}

/// Returns the cone of a falloff between an inner and an outer angle; a step if both angles are
/// equal.
fn ramp(falloff: AnyFalloff, inner: Angle, outer: Angle) -> Result<Cone<AnyFalloff>, Error> {
    if inner >= outer {
        Cone::from_outer(AnyFalloff::Step(Step), outer)
    } else {
        Cone::from_outer(falloff, outer)?.with_inner(inner)
    }
}

/// Returns the imported spotlight, with the difference of its cone and of its attenuation.
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
