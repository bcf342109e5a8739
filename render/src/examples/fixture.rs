//! Luminaires that hang in a scene, each with a name, and with a movement if it has one.

use core::f32::consts::TAU;
use glam::{Vec2, Vec3};
use luminaire::{Distance, Error, Lamp, Luminaire, Matched, Spot};

/// A luminaire of a scene.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Fixture {
    /// What the trade calls it.
    pub name: &'static str,
    /// The luminaire, before it moves.
    pub luminaire: Luminaire,
    motion: Motion,
}

/// What changes with the seconds.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Motion {
    Still,
    Sweep(Sweep),
    Chase(Chase),
}

/// A spotlight follows a point that goes round an ellipse on the level, once in so many seconds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Sweep {
    pub(super) center: Vec3,
    /// Half the width and half the depth of the ellipse, in metres.
    pub(super) radii: Vec2,
    pub(super) period: f32,
    /// Where on its way the point begins, as a fraction of the whole.
    pub(super) start: f32,
}

/// A spotlight is brighter when its turn has come, among so many that take turns.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Chase {
    pub(super) turn: usize,
    pub(super) turns: usize,
    /// Seconds of a turn.
    pub(super) step: f32,
    /// The intensity in its turn over that before and after.
    pub(super) bump: f32,
}

impl Fixture {
    /// A luminaire that stays as it is.
    pub(super) fn new(name: &'static str, luminaire: impl Into<Luminaire>) -> Self {
        Self { name, luminaire: luminaire.into(), motion: Motion::Still }
    }

    pub(super) fn sweeping(self, sweep: Sweep) -> Self {
        Self { motion: Motion::Sweep(sweep), ..self }
    }

    pub(super) fn chased(self, chase: Chase) -> Self {
        Self { motion: Motion::Chase(chase), ..self }
    }

    /// The luminaire after so many seconds.
    ///
    /// # Errors
    /// Seconds that are not finite, where it moves.
    pub fn at(&self, seconds: f32) -> Result<Luminaire, Error> {
        let Lamp::Spot(spot) = self.luminaire.lamp() else { return Ok(self.luminaire) };
        match &self.motion {
            Motion::Still => Ok(self.luminaire),
            Motion::Sweep(sweep) => Ok(self.luminaire.with_lamp(sweep.turned(spot, seconds)?)),
            Motion::Chase(chase) => Ok(self.luminaire.with_lamp(chase.bumped(spot, seconds)?)),
        }
    }
}

impl Sweep {
    fn turned(&self, spot: &Spot<Matched, Distance>, seconds: f32) -> Result<Spot<Matched, Distance>, Error> {
        let around = self.radii * Vec2::from_angle(TAU * (seconds / self.period + self.start));
        let target = self.center + Vec3::new(around.x, 0.0, around.y);
        spot.with_axis((target - Vec3::from(spot.position())).into())
    }
}

impl Chase {
    fn bumped(&self, spot: &Spot<Matched, Distance>, seconds: f32) -> Result<Spot<Matched, Distance>, Error> {
        let now = (seconds / self.step) as usize % self.turns;
        if now == self.turn { spot.with_intensity(self.bump * spot.intensity()) } else { Ok(*spot) }
    }
}
