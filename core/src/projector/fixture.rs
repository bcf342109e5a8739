//! Fixtures: lights with a gobo and shadows.

use core::ops::RangeInclusive;

use super::{CompiledGobo, Gobo, Projection};
use crate::{
    angle::Angle,
    any_light::AnyLight,
    effect::{Effect, Effects},
    error::{Error, Expected, Parameter},
    number::Scalar,
};

/// A light with its accessories: an optional gobo and an optional shadow map.
///
/// ```
/// use luminaire::{Angle, Cone, SpotLight, Vec3, falloff::Soft, projector::{Fixture, Gobo}};
/// const MULLION: Gobo<'static> = Gobo::of(&[255, 0, 255, 255, 0, 255, 255, 0, 255]);
/// let cone = Cone::from_field(Soft, Angle::degrees(15.0))?;
/// let spot = SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?;
/// let key = Fixture::from(spot).with_gobo(MULLION, Angle::degrees(0.0))?.with_shadow(512)?;
/// assert_eq!(key.effects().to_string(), "diffuse, spot, soft, inverse-square, gobo, shadow");
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Fixture {
    light: AnyLight,
    gobo: Option<(Gobo<'static>, Projection)>,
    shadow: Option<(u16, Projection)>,
}

impl Fixture {
    /// Range of the side length of a shadow map, in texels.
    pub const SHADOW_SIDES: RangeInclusive<u16> = 16..=2048;

    /// Returns the same fixture with a gobo, rolled about the axis as by [`Projection::turned`].
    ///
    /// # Errors
    /// A light without a projection: a light without a cone, or with a cone over 160 degrees. A
    /// roll outside -360 to 360 degrees.
    pub fn with_gobo(self, gobo: Gobo<'static>, roll: Angle) -> Result<Self, Error> {
        let projection = self.project()?.turned(roll)?;
        Ok(Self { gobo: Some((gobo, projection)), ..self })
    }

    /// Returns the same fixture with shadows from a map of `side` by `side` texels.
    ///
    /// # Errors
    /// A side outside 16 to 2048; a light without a projection: a light without a cone, or with a
    /// cone over 160 degrees.
    pub fn with_shadow(self, side: u16) -> Result<Self, Error> {
        let sides = Self::SHADOW_SIDES;
        if !sides.contains(&side) {
            let accepted = Expected::WholeBetween((*sides.start()).into(), (*sides.end()).into());
            return Err(Error { parameter: Parameter::ShadowSide, value: side.into(), accepted });
        }
        Ok(Self { shadow: Some((side, self.project()?)), ..self })
    }

    /// Returns the square around the cone of the light, on which a gobo or a shadow map lies.
    ///
    /// In the error, a point light and a measured light count as a cone of 360 degrees and a directional light as a
    /// cone of 0 degrees.
    fn project(&self) -> Result<Projection, Error> {
        let refused = |value| {
            let accepted = Expected::AngleUpTo(Projection::WIDEST.to_degrees());
            Err(Error { parameter: Parameter::OuterAngle, value, accepted })
        };
        match &self.light {
            AnyLight::Spot(spot) => Projection::of(spot),
            AnyLight::Point(_) | AnyLight::Measured(_) => refused(360.0),
            AnyLight::Directional(_) => refused(0.0),
        }
    }

    /// Returns the light.
    pub fn light(&self) -> &AnyLight {
        &self.light
    }

    /// Returns the gobo and the square it lies on; `None` without a gobo.
    pub fn gobo(&self) -> Option<(Gobo<'static>, Projection)> {
        self.gobo
    }

    /// Returns the side of the shadow map in texels and the square it lies on; `None` without a
    /// shadow map.
    pub fn shadow(&self) -> Option<(u16, Projection)> {
        self.shadow
    }

    /// Returns the effects that the fixture requires; no effects if its light is dark.
    pub fn effects(&self) -> Effects {
        let mut effects = self.light.effects();
        if effects == Effects::NONE {
            return effects;
        }
        if self.gobo.is_some() {
            effects = effects.with(Effect::Gobo);
        }
        if self.shadow.is_some() {
            effects = effects.with(Effect::Shadow);
        }
        effects
    }

    /// Compiles the gobo for the format `S`; `None` without a gobo.
    ///
    /// # Errors
    /// A projection that the format cannot represent: see [`Projection::compile`].
    pub fn compile_gobo<S: Scalar>(&self) -> Result<Option<CompiledGobo<'static, S>>, Error> {
        let on = |(gobo, projection): (Gobo<'static>, Projection)| Ok(gobo.on(projection.compile()?));
        self.gobo.map(on).transpose()
    }
}

impl<L: Into<AnyLight>> From<L> for Fixture {
    fn from(light: L) -> Self {
        Self { light: light.into(), gobo: None, shadow: None }
    }
}
