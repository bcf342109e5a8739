//! Render plans: the effects that a scene requires.
//!
//! A renderer with a plan omits all effects that the scene does not require. The renderer omits
//! only work that does not change any bit of the image: a dark light, a black highlight, a factor
//! of 1. The plan [`RenderPlan::everything`] omits nothing. Its image is the same, so the
//! tests of a renderer can compare the two images.
//!
//! Lights that are constants of the program need no plan: their types state the required effects,
//! and unused code is not linked.

use crate::{
    any_light::{AnyLight, CompiledAnyLight},
    effect::{Effect, Effects},
    error::Error,
    light::AmbientLight,
    material::Material,
    number::Scalar,
    projector::Fixture,
    specular::SpecularLobe,
};

/// The set of effects that a scene requires.
///
/// ```
/// use luminaire::{AmbientLight, Angle, Cone, Material, Rgb, SpotLight, Vec3, dynamic::{Effect, RenderPlan}, falloff::Hard, projector::Fixture};
/// let cone = Cone::from_field(Hard, Angle::degrees(15.0))?;
/// let spot = Fixture::from(SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?);
/// let clay = Material::new(Rgb::new(0.8, 0.4, 0.2))?;
/// let plan = RenderPlan::new().with_fixture(&spot).with_material(&clay);
/// assert_eq!(plan.effects().to_string(), "diffuse, spot, hard, inverse-square");
/// assert!(!plan.requires(Effect::Specular) && RenderPlan::everything().requires(Effect::Specular));
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct RenderPlan {
    effects: Effects,
    leaves_nothing_out: bool,
}

impl RenderPlan {
    /// Creates the plan of an empty scene, which requires no effect.
    pub const fn new() -> Self {
        Self { effects: Effects::NONE, leaves_nothing_out: false }
    }

    /// Creates the plan that evaluates every effect for every light at every point, also effects
    /// that are not required.
    pub const fn everything() -> Self {
        Self { effects: Effects::ALL, leaves_nothing_out: true }
    }

    /// Adds an effect that concerns the whole image, such as haze or dither.
    #[must_use]
    pub const fn with(self, effect: Effect) -> Self {
        Self { effects: self.effects.with(effect), ..self }
    }

    /// Adds ambient light, unless it is black.
    #[must_use]
    pub fn with_ambient(self, ambient: &AmbientLight) -> Self {
        let is_dark = ambient.intensity() == 0.0 || ambient.color().is_black();
        if is_dark { self } else { self.with(Effect::Ambient) }
    }

    /// Adds the effects of a fixture, unless its light is dark.
    #[must_use]
    pub fn with_fixture(self, fixture: &Fixture) -> Self {
        Self { effects: self.effects.union(fixture.effects()), ..self }
    }

    /// Adds the effects of a material.
    #[must_use]
    pub fn with_material<H: SpecularLobe>(self, material: &Material<H>) -> Self {
        let shines = H::SHINES && !material.specular().is_black();
        if shines { self.with(Effect::Specular) } else { self }
    }

    /// Returns the required effects.
    pub const fn effects(&self) -> Effects {
        self.effects
    }

    /// Returns whether an effect is required.
    pub const fn requires(&self, effect: Effect) -> bool {
        self.effects.has(effect)
    }

    /// Returns whether a renderer skips dark lights, and points and tiles without light. The result
    /// is false only for [`everything`](Self::everything).
    pub const fn skips(&self) -> bool {
        !self.leaves_nothing_out
    }

    /// Compiles a light for the format `S`, once for all points. Returns `None` for a dark light if
    /// the plan skips.
    ///
    /// # Errors
    /// A light that the format cannot hold, even if the light is dark.
    pub fn prepare<S: Scalar>(&self, light: &AnyLight) -> Result<Option<CompiledAnyLight<S>>, Error> {
        let compiled = light.compile()?;
        Ok((!(self.skips() && light.is_dark())).then_some(compiled))
    }
}
