//! The fixtures of a picture, prepared for lighting.

use crate::{
    light::{block::Block, prepared::Prepared, reach::Reach},
    space::bounds::Bounds,
};
use alloc::vec::Vec;
use luminaire::{
    Error, Scalar,
    dynamic::RenderPlan,
    haze::{Haze, RayBundle},
    projector::Fixture,
};

/// All fixtures by index, prepared; `None` for fixtures that the plan drops.
pub(crate) struct Rig<S: Scalar> {
    plan: RenderPlan,
    fixtures: Vec<Option<Prepared<S>>>,
    /// The bounds of each light, in one array, because the passes over tiles and blocks test all
    /// bounds.
    reaches: Vec<Option<Reach>>,
    is_hazy: bool,
}

impl<S: Scalar> Rig<S> {
    /// # Errors
    /// A fixture that the format can't hold; in haze, one that `f32` can't hold.
    pub(crate) fn new(plan: RenderPlan, fixtures: &[Fixture], haze: Option<Haze>) -> Result<Self, Error> {
        let prepare = |(number, fixture)| Prepared::new(number, fixture, haze, &plan);
        let fixtures = fixtures.iter().enumerate().map(prepare).collect::<Result<Vec<_>, _>>()?;
        let reaches = fixtures.iter().map(|fixture| fixture.as_ref().map(|fixture| fixture.reach)).collect();
        let is_hazy = !plan.skips() || fixtures.iter().flatten().any(Prepared::is_hazy);
        Ok(Self { plan, fixtures, reaches, is_hazy })
    }

    pub(crate) fn plan(&self) -> RenderPlan {
        self.plan
    }

    /// Returns the number of fixtures that the plan keeps.
    pub(crate) fn kept(&self) -> usize {
        self.fixtures.iter().flatten().count()
    }

    /// Returns whether any fixture has a beam in haze. If the plan skips nothing, clear air counts
    /// as haze.
    pub(crate) fn is_hazy(&self) -> bool {
        self.is_hazy
    }

    /// Returns whether the light of a fixture may arrive within bounds.
    pub(crate) fn reaches(&self, number: usize, bounds: Option<&Bounds>) -> bool {
        self.reach(number)
            .is_some_and(|reach| !self.plan.skips() || bounds.is_some_and(|bounds| !reach.misses(bounds)))
    }

    /// Returns whether the light of a fixture may arrive at a pixel of a block.
    pub(crate) fn lights(&self, number: usize, block: &Block<S>) -> bool {
        self.reach(number).is_some_and(|reach| !(self.plan.skips() && block.is_missed(reach)))
    }

    /// Returns whether the beam of a fixture may be visible along a bundle of view rays.
    pub(crate) fn is_seen_in_air(&self, number: usize, sight: Option<&RayBundle>) -> bool {
        self.fixture(number).is_some_and(|fixture| !self.plan.skips() || fixture.is_seen_in_air(sight))
    }

    /// Returns the fixture at an index; `None` if the plan dropped the fixture or the index is out
    /// of range.
    pub(crate) fn fixture(&self, number: usize) -> Option<&Prepared<S>> {
        self.fixtures.get(number)?.as_ref()
    }

    fn reach(&self, number: usize) -> Option<&Reach> {
        self.reaches.get(number)?.as_ref()
    }
}
