//! Fixtures of the examples, with names and motions.

use core::f32::consts::TAU;
use glam::{Vec2, Vec2Swizzles as _, Vec3};
use luminaire::{
    Angle, Error, SpotLight,
    attenuation::AnyAttenuation,
    dynamic::AnyLight,
    falloff::AnyFalloff,
    projector::{Fixture, Gobo},
};

/// A fixture of a scene that may change over time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MovingLight {
    /// The stage-lighting name of this kind of fixture.
    pub name: &'static str,
    /// The light before it moves.
    light: AnyLight,
    motion: Motion,
    gobo: Option<Wheel>,
    shadow: Option<u16>,
}

/// How a light changes.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Motion {
    Still,
    Sweep(Sweep),
    Chase(Chase),
}

/// Moves the target of a spotlight around an ellipse, once in `period` seconds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Sweep {
    pub(super) center: Vec3,
    /// Half the width, height and depth of the ellipse, in metres.
    pub(super) radii: [f32; 3],
    pub(super) period: f32,
    /// Where the target starts on the ellipse, as a share of a full turn around the ellipse.
    pub(super) start: f32,
}

/// Raises the intensity of a spotlight during its turn, in a group of spotlights that take turns.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Chase {
    pub(super) turn: usize,
    pub(super) turns: usize,
    /// Duration of each spotlight's turn, in seconds.
    pub(super) step: f32,
    /// Ratio of the intensity during the turn to the intensity at other times.
    pub(super) bump: f32,
}

/// A gobo that rotates.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Wheel {
    gobo: Gobo<'static>,
    /// The speed of rotation, in degrees per second.
    speed: f32,
}

impl MovingLight {
    /// Creates a fixture that does not change.
    pub fn new(name: &'static str, light: impl Into<AnyLight>) -> Self {
        Self { name, light: light.into(), motion: Motion::Still, gobo: None, shadow: None }
    }

    pub(super) fn sweeping(self, sweep: Sweep) -> Self {
        Self { motion: Motion::Sweep(sweep), ..self }
    }

    pub(super) fn chased(self, chase: Chase) -> Self {
        Self { motion: Motion::Chase(chase), ..self }
    }

    /// Returns the same fixture with a gobo that rotates at `speed` degrees per second.
    pub(super) fn with_gobo(self, gobo: Gobo<'static>, speed: f32) -> Self {
        Self { gobo: Some(Wheel { gobo, speed }), ..self }
    }

    /// Returns the same fixture with a shadow map of `side` texels per side: see
    /// [`Fixture::with_shadow`].
    #[must_use]
    pub fn with_shadow(self, side: u16) -> Self {
        Self { shadow: Some(side), ..self }
    }

    /// Returns the light before it moves.
    pub fn light(&self) -> &AnyLight {
        &self.light
    }

    /// Returns the same fixture with another light, which moves in the same way.
    #[must_use]
    pub fn with_light(self, light: impl Into<AnyLight>) -> Self {
        Self { light: light.into(), ..self }
    }

    /// Returns the same fixture with a light that keeps its aim. A gobo still rotates, and a light
    /// that takes turns still does.
    #[must_use]
    pub fn aimed(self) -> Self {
        let motion = if self.sweeps() { Motion::Still } else { self.motion };
        Self { motion, ..self }
    }

    /// Returns whether the aim of the light moves.
    pub fn sweeps(&self) -> bool {
        matches!(self.motion, Motion::Sweep(_))
    }

    /// Returns the same fixture without a gobo.
    #[must_use]
    pub fn without_gobo(self) -> Self {
        Self { gobo: None, ..self }
    }

    /// Returns the same fixture without shadows.
    #[must_use]
    pub fn without_shadow(self) -> Self {
        Self { shadow: None, ..self }
    }

    /// Returns the fixture at a time in seconds.
    ///
    /// # Errors
    /// A time that is not finite, if the fixture moves. Shadows that the fixture can't have.
    pub fn at(&self, seconds: f32) -> Result<Fixture, Error> {
        let mut fixture = Fixture::from(self.light_at(seconds)?);
        if let Some(Wheel { gobo, speed }) = self.gobo {
            fixture = fixture.with_gobo(gobo, Angle::degrees(speed * seconds % 360.0))?;
        }
        if let Some(side) = self.shadow {
            fixture = fixture.with_shadow(side)?;
        }
        Ok(fixture)
    }

    fn light_at(&self, seconds: f32) -> Result<AnyLight, Error> {
        match (&self.light, &self.motion) {
            (AnyLight::Spot(spot), Motion::Sweep(sweep)) => Ok(sweep.turned(spot, seconds)?.into()),
            (AnyLight::Spot(spot), Motion::Chase(chase)) => Ok(chase.bumped(spot, seconds)?.into()),
            _ => Ok(self.light),
        }
    }
}

/// A spotlight of any kind.
type AnySpot = SpotLight<AnyFalloff, AnyAttenuation>;

impl Sweep {
    fn turned(&self, spot: &AnySpot, seconds: f32) -> Result<AnySpot, Error> {
        let around = Vec2::from_angle(TAU * (seconds / self.period + self.start));
        let target = self.center + Vec3::from(self.radii) * around.xxy();
        spot.with_axis((target - Vec3::from(spot.position())).into())
    }
}

impl Chase {
    fn bumped(&self, spot: &AnySpot, seconds: f32) -> Result<AnySpot, Error> {
        let now = (seconds / self.step) as usize % self.turns;
        if now == self.turn { spot.with_intensity(self.bump * spot.intensity()) } else { Ok(*spot) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::Example;

    #[test]
    fn another_light_moves_like_the_first() {
        let setup = Example::Show.setup().unwrap();
        let beam = setup.fixtures[0];
        let AnyLight::Spot(spot) = *beam.light() else { panic!("no spot") };
        let dimmed = beam.with_light(spot.with_intensity(1.0).unwrap());
        let (AnyLight::Spot(before), AnyLight::Spot(after)) =
            (*beam.at(2.0).unwrap().light(), *dimmed.at(2.0).unwrap().light())
        else {
            panic!("no spot")
        };
        assert!(before.axis() == after.axis() && after.intensity() == 1.0);
        assert!(beam.sweeps() && !beam.aimed().sweeps());
        assert_eq!(beam.aimed().at(2.0).unwrap().light(), beam.light());
        assert_ne!(beam.at(2.0).unwrap().light(), beam.light());
    }
}
