//! Lights of any kind, chosen at run time.

mod each;
mod hazy;

use self::each::Loop;
use crate::{
    attenuation::{AnyAttenuation, Attenuation},
    color::Rgb,
    effect::{Effect, Effects},
    error::Error,
    falloff::{AnyFalloff, Falloff},
    light::{DirectionalLight, MeasuredLight, PointLight, SpotLight},
    number::Scalar,
    points::{SurfacePoint, SurfacePoints},
    shade::{
        CompiledDirectionalLight, CompiledMeasuredLight, CompiledPointLight, CompiledSpotLight, Incident,
        LightModel, sealed::Sealed,
    },
    specular::{NoSpecular, SpecularLobe},
    vec3::Vec3,
};

/// A light of any kind, with any falloff and any attenuation, for scenes that are not known at
/// compile time.
///
/// ```
/// use luminaire::{Angle, Cone, Fx16, PointLight, SpotLight, Vec3, dynamic::AnyLight, falloff::Soft};
/// let cone = Cone::from_field(Soft, Angle::degrees(15.0))?;
/// let spot = SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?;
/// let lights = [AnyLight::from(spot), PointLight::new(Vec3::new(1.0, 2.0, 0.0))?.into()];
/// assert_eq!(lights[0].effects().to_string(), "diffuse, spot, soft, inverse-square");
///
/// let (floor, up) = (Fx16::point([0.0, 0.0, 0.0]), Fx16::normal([0.0, 1.0, 0.0]));
/// let mut sum = 0.0;
/// for light in lights {
///     sum += light.compile()?.irradiance(floor, up).to_f32();
/// }
/// assert!((sum - (1.0 / 16.0 + 2.0 / 5_f32.powf(1.5))).abs() < 1e-3);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum AnyLight {
    /// Light from infinitely far away.
    Directional(DirectionalLight),
    /// Light from a position in all directions.
    Point(PointLight<AnyAttenuation>),
    /// Light from a position within a cone.
    Spot(SpotLight<AnyFalloff, AnyAttenuation>),
    /// Light from a position by a distribution over all directions.
    Measured(MeasuredLight<'static, AnyAttenuation>),
}

/// An [`AnyLight`] compiled for the format `S`. Made by [`AnyLight::compile`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CompiledAnyLight<S: Scalar> {
    /// Light from infinitely far away.
    Directional(CompiledDirectionalLight<S>),
    /// Light from a position in all directions.
    Point(CompiledPointLight<S, AnyAttenuation>),
    /// Light from a position within a cone.
    Spot(CompiledSpotLight<S, AnyFalloff, AnyAttenuation>),
    /// Light from a position by a distribution over all directions.
    Measured(CompiledMeasuredLight<'static, S, AnyAttenuation>),
}

/// Evaluates an expression with the light of the variant.
macro_rules! any {
    ($any:expr, $kind:ident, $light:ident => $answer:expr) => {
        match $any {
            $kind::Directional($light) => $answer,
            $kind::Point($light) => $answer,
            $kind::Spot($light) => $answer,
            $kind::Measured($light) => $answer,
        }
    };
}

impl AnyLight {
    /// Returns the linear colour.
    pub fn color(&self) -> Rgb<f32> {
        any!(self, Self, light => light.color())
    }

    /// Returns the linear colour of the highlights.
    pub fn specular_color(&self) -> Rgb<f32> {
        any!(self, Self, light => light.specular_color())
    }

    /// Returns the intensity.
    pub fn intensity(&self) -> f32 {
        any!(self, Self, light => light.intensity())
    }

    /// Returns the light with this linear colour; its highlights get the same colour.
    ///
    /// # Errors
    /// A channel outside [0, 1].
    pub fn with_color(self, color: Rgb<f32>) -> Result<Self, Error> {
        Ok(any!(self, Self, light => light.with_color(color)?.into()))
    }

    /// Returns the light with highlights in this linear colour.
    ///
    /// # Errors
    /// A channel outside [0, 1].
    pub fn with_specular_color(self, color: Rgb<f32>) -> Result<Self, Error> {
        Ok(any!(self, Self, light => light.with_specular_color(color)?.into()))
    }

    /// Returns the light with this intensity.
    ///
    /// # Errors
    /// An intensity outside [0, 1e9].
    pub fn with_intensity(self, intensity: f32) -> Result<Self, Error> {
        Ok(any!(self, Self, light => light.with_intensity(intensity)?.into()))
    }

    /// Returns the light in white of a correlated colour temperature in kelvin; its luminance stays, and the
    /// intensity is that of the strongest channel, as [`SpotLight::with_kelvin`] has it.
    ///
    /// # Errors
    /// A temperature outside [1000, 25,000], or an intensity that exceeds 1e9.
    pub fn with_kelvin(self, kelvin: f32) -> Result<Self, Error> {
        Ok(any!(self, Self, light => light.with_kelvin(kelvin)?.into()))
    }

    /// Returns whether the light emits nothing: its intensity is 0, or both of its colours are
    /// black.
    pub fn is_dark(&self) -> bool {
        self.intensity() == 0.0 || (self.color().is_black() && self.specular_color().is_black())
    }

    /// Returns the effects that the light requires; no effects if the light is dark.
    pub fn effects(&self) -> Effects {
        if self.is_dark() {
            return Effects::NONE;
        }
        let effects = Effects::NONE.with(Effect::Diffuse);
        match self {
            Self::Directional(_) => effects.with(Effect::Directional),
            Self::Point(point) => effects.with(Effect::Point).union(point.attenuation().effects()),
            Self::Spot(spot) => {
                effects.with(Effect::Spot).union(cone_effects(spot)).union(spot.attenuation().effects())
            }
            Self::Measured(light) => effects.with(Effect::Measured).union(light.attenuation().effects()),
        }
    }

    /// Compiles the light for the format `S`.
    ///
    /// # Errors
    /// A cone that is too narrow, or a position too far away, for the format.
    pub fn compile<S: Scalar>(&self) -> Result<CompiledAnyLight<S>, Error> {
        Ok(match self {
            Self::Directional(light) => CompiledAnyLight::Directional(light.compile()),
            Self::Point(light) => CompiledAnyLight::Point(light.compile()?),
            Self::Spot(light) => CompiledAnyLight::Spot(light.compile()?),
            Self::Measured(light) => CompiledAnyLight::Measured(light.compile()?),
        })
    }
}

fn cone_effects(spot: &SpotLight<AnyFalloff, AnyAttenuation>) -> Effects {
    let cone = spot.cone();
    let mut effects = Effects::NONE.with(cone.falloff().effect());
    if cone.has_hotspot() {
        effects = effects.with(Effect::Hotspot);
    }
    if cone.has_cutoff() {
        effects = effects.with(Effect::Cutoff);
    }
    effects
}

impl From<DirectionalLight> for AnyLight {
    fn from(light: DirectionalLight) -> Self {
        Self::Directional(light)
    }
}

impl<A: Attenuation + Into<AnyAttenuation>> From<PointLight<A>> for AnyLight {
    fn from(light: PointLight<A>) -> Self {
        Self::Point(light.with_attenuation(light.attenuation().into()))
    }
}

impl<P: Falloff + Into<AnyFalloff>, A: Attenuation + Into<AnyAttenuation>> From<SpotLight<P, A>>
    for AnyLight
{
    fn from(light: SpotLight<P, A>) -> Self {
        let cone = light.cone().with_falloff(light.cone().falloff().into());
        Self::Spot(light.with_cone(cone).with_attenuation(light.attenuation().into()))
    }
}

impl<A: Attenuation + Into<AnyAttenuation>> From<MeasuredLight<'static, A>> for AnyLight {
    fn from(light: MeasuredLight<'static, A>) -> Self {
        Self::Measured(light.with_attenuation(light.attenuation().into()))
    }
}

impl<S: Scalar> CompiledAnyLight<S> {
    /// Returns the linear colour.
    pub fn color(&self) -> Rgb<S> {
        any!(self, Self, light => light.color)
    }

    /// Returns the linear colour of the highlights.
    pub fn specular_color(&self) -> Rgb<S> {
        any!(self, Self, light => light.specular_color)
    }

    /// Returns the irradiance at a surface point, before the light's colour.
    ///
    /// See [`CompiledSpotLight::irradiance`].
    /// [`CompiledMaterial::reflect`](crate::light::CompiledMaterial::reflect) returns the light
    /// that a surface reflects.
    ///
    /// This function branches per point; in `f32`, [`LightModel::evaluate_each`] branches once for many points.
    pub fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), true).diffuse
    }

    /// Returns the irradiance of a surface that faces the light at a point, before the light's colour: what a small
    /// body without a normal receives, such as an LED. See [`CompiledSpotLight::irradiance_facing`].
    pub fn irradiance_facing(&self, point: Vec3<S::Length>) -> S::Irradiance {
        match self {
            Self::Directional(light) => light.irradiance_facing(),
            Self::Point(light) => light.irradiance_facing(point),
            Self::Spot(light) => light.irradiance_facing(point),
            Self::Measured(light) => light.irradiance_facing(point),
        }
    }

    /// Evaluates the light at a surface point with the specular lobe `H`, before the light's
    /// colours.
    ///
    /// If `skips` is true, the function returns 0 before the square root for points that the light
    /// cannot reach. The result is bit-identical with and without `skips`. The function branches
    /// per point.
    pub fn evaluate<H: SpecularLobe>(
        &self,
        surface: &SurfacePoint<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance> {
        any!(self, Self, light => light.evaluate::<H>(surface, highlight, skips))
    }
}

impl<S: Scalar> Sealed for CompiledAnyLight<S> {}

impl<S: Scalar> LightModel<S> for CompiledAnyLight<S> {
    #[inline]
    fn colors(&self) -> [Rgb<S>; 2] {
        any!(self, Self, light => light.colors())
    }

    fn evaluate<H: SpecularLobe>(
        &self,
        surface: &SurfacePoint<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance> {
        Self::evaluate::<H>(self, surface, highlight, skips)
    }

    fn evaluate_each<H: SpecularLobe, const N: usize>(
        &self,
        surfaces: &SurfacePoints<'_, S, N>,
        highlight: &H::Constants<S>,
        arrivals: &mut Incident<[S::Irradiance; N]>,
    ) {
        let mut each = Loop::<S, H, N> { surfaces, highlight, arrivals };
        match self {
            Self::Directional(light) => each.light(light),
            Self::Point(light) => each.point(light),
            Self::Spot(light) => each.spot(light),
            Self::Measured(light) => each.measured(light),
        }
    }

    fn can_reach(&self, center: Vec3<S::Length>, radius: S::Length) -> bool {
        any!(self, Self, light => LightModel::can_reach(light, center, radius))
    }
}
