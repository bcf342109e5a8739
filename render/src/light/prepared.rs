//! A fixture, prepared to light blocks of pixels.

use crate::{
    light::{
        air::{Beam, Hazy, Way},
        reach::Reach,
    },
    shadow::Shadows,
};
use core::cell::OnceCell;
use glam::Vec3;
use luminaire::{
    Angle, Error, Scalar,
    dynamic::{CompiledAnyLight, RenderPlan},
    haze::{Haze, RayBundle},
    projector::{CompiledGobo, CompiledProjection, Fixture, Gobo},
};

/// A fixture compiled for a number format, and the bounds of its light.
#[derive(Clone, Debug)]
pub struct Prepared<S: Scalar> {
    pub(crate) number: usize,
    pub(crate) light: CompiledAnyLight<S>,
    pub(crate) gobo: Option<CompiledGobo<'static, S>>,
    /// The projection of the shadow map.
    pub(crate) shadow: Option<CompiledProjection<S>>,
    hazy: Option<Hazy>,
    /// The beam as seen from the eye, computed where it is first needed.
    beam: OnceCell<Beam>,
    /// Whether the fixture has a gobo of its own, other than [`CLEAR`].
    is_patterned: bool,
    casts_shadow: bool,
    pub(crate) reach: Reach,
}

/// A fully transparent gobo, for spotlights without a gobo where the plan skips nothing.
const CLEAR: Gobo<'static> = Gobo::of(&[u8::MAX]);

impl<S: Scalar> Prepared<S> {
    /// Compiles the fixture with this index; `None` if the plan drops the fixture.
    ///
    /// # Errors
    /// A light, gobo or projection that the format can't hold.
    pub(crate) fn new(
        number: usize,
        fixture: &Fixture,
        haze: Option<Haze>,
        plan: &RenderPlan,
    ) -> Result<Option<Self>, Error> {
        let Some(light) = plan.prepare(fixture.light())? else { return Ok(None) };
        let (is_patterned, casts_shadow) = (fixture.gobo().is_some(), fixture.shadow().is_some());
        let hazy = haze.map(|haze| Hazy::new(fixture, &haze)).transpose()?.flatten();
        let mut fixture = *fixture;
        if !plan.skips() {
            fixture = equipped(fixture).unwrap_or(fixture);
        }
        let shadow = fixture.shadow().map(|(_, square)| square.compile()).transpose()?;
        let (gobo, reach) = (fixture.compile_gobo()?, Reach::new(fixture.light()));
        let beam = OnceCell::new();
        Ok(Some(Self { number, light, gobo, shadow, hazy, beam, is_patterned, casts_shadow, reach }))
    }

    /// Returns whether the light has a gobo or a shadow map.
    pub(crate) fn is_filtered(&self) -> bool {
        self.gobo.is_some() || self.shadow.is_some()
    }

    /// Returns whether the fixture has a beam in haze.
    pub(crate) fn is_hazy(&self) -> bool {
        self.hazy.is_some()
    }

    /// Returns whether the beam may be visible along a bundle of view rays.
    pub(crate) fn is_seen_in_air(&self, sight: Option<&RayBundle>) -> bool {
        matches!((&self.hazy, sight), (Some(hazy), Some(sight)) if hazy.may_be_seen(sight))
    }

    /// Returns the beam in haze, its gobo and shadow map, and the beam as seen from the eye; `None` if the
    /// fixture has no beam in haze.
    pub(crate) fn in_air<'a>(
        &'a self,
        shadows: &'a Shadows<S>,
        eye: Vec3,
    ) -> Option<(&'a Hazy, Way<'a, S>, &'a Beam)> {
        let gobo = self.gobo.as_ref().filter(|_| self.is_patterned);
        let shadow = shadows.of(self.number).filter(|_| self.casts_shadow);
        let hazy = self.hazy.as_ref()?;
        let beam = self.beam.get_or_init(|| Beam::new(hazy, eye, gobo.is_some(), shadow.is_some()));
        Some((hazy, Way { gobo, shadow }, beam))
    }
}

/// Adds a fully transparent gobo and an empty shadow map to a fixture without gobo or shadow map.
/// The light of the result is the same.
///
/// # Errors
/// A light that projects no square.
fn equipped(mut fixture: Fixture) -> Result<Fixture, Error> {
    if fixture.gobo().is_none() {
        fixture = fixture.with_gobo(CLEAR, Angle::degrees(0.0))?;
    }
    // No shadow map is drawn for this fixture, so the map stays empty.
    if fixture.shadow().is_none() { fixture.with_shadow(16) } else { Ok(fixture) }
}
