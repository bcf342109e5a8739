//! The plan of a picture: which effects its lights and materials call for, and so what is left out.
//!
//! Left out is only what changes no bit of the picture: a light that can light nothing, a highlight of no colour, a
//! factor of one. [`RenderPlan::everything`] leaves nothing out, and gives the same picture: that is how a renderer is tested.
//!
//! Where lights are constants of the program there is nothing to plan: their types say what is called for, and what no type
//! names is not linked.

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

/// Which effects a picture calls for.
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
    /// The plan of an empty picture, which calls for nothing.
    pub const fn new() -> Self {
        Self { effects: Effects::NONE, leaves_nothing_out: false }
    }

    /// The plan that evaluates every effect for every light at every point, called for or not.
    pub const fn everything() -> Self {
        Self { effects: Effects::ALL, leaves_nothing_out: true }
    }

    /// The plan with an effect of the picture as a whole, as haze or dither are.
    #[must_use]
    pub const fn with(self, effect: Effect) -> Self {
        Self { effects: self.effects.with(effect), ..self }
    }

    /// The plan with ambient light, unless it is black.
    #[must_use]
    pub fn with_ambient(self, ambient: &AmbientLight) -> Self {
        let is_dark = ambient.intensity() == 0.0 || ambient.color().is_black();
        if is_dark { self } else { self.with(Effect::Ambient) }
    }

    /// The plan with a fixture, unless it is dark.
    #[must_use]
    pub fn with_fixture(self, fixture: &Fixture) -> Self {
        Self { effects: self.effects.union(fixture.effects()), ..self }
    }

    /// The plan with a material.
    #[must_use]
    pub fn with_material<H: SpecularLobe>(self, material: &Material<H>) -> Self {
        let shines = H::SHINES && !material.specular().is_black();
        if shines { self.with(Effect::Specular) } else { self }
    }

    /// The effects that are called for.
    pub const fn effects(&self) -> Effects {
        self.effects
    }

    /// Whether an effect is called for.
    pub const fn requires(&self, effect: Effect) -> bool {
        self.effects.has(effect)
    }

    /// Whether points, tiles and lights are skipped where nothing can arrive: all but [`everything`](Self::everything)
    /// do.
    pub const fn skips(&self) -> bool {
        !self.leaves_nothing_out
    }

    /// Compiles a light for the format `S`, once for all points; nothing if it is dark, and so dropped.
    ///
    /// # Errors
    /// A light that the format can't hold, dark or not.
    pub fn prepare<S: Scalar>(&self, light: &AnyLight) -> Result<Option<CompiledAnyLight<S>>, Error> {
        let compiled = light.compile()?;
        Ok((!(self.skips() && light.is_dark())).then_some(compiled))
    }
}
