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
    Error, Scalar,
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
    /// Every plan refuses the same fixtures, dark ones too.
    ///
    /// # Errors
    /// A light, gobo or projection that the format can't hold; in haze, a light that `f32` can't
    /// hold.
    pub(crate) fn new(
        number: usize,
        fixture: &Fixture,
        haze: Option<Haze>,
        plan: &RenderPlan,
    ) -> Result<Option<Self>, Error> {
        let light = plan.prepare(fixture.light())?;
        let hazy = haze.map(|haze| Hazy::new(fixture, &haze)).transpose()?.flatten();
        let gobo = fixture.compile_gobo()?;
        let shadow = fixture.shadow().map(|(_, square)| square.compile()).transpose()?;
        let Some(light) = light else { return Ok(None) };
        let (is_patterned, casts_shadow) = (gobo.is_some(), shadow.is_some());
        let (beam, reach) = (OnceCell::new(), Reach::new(fixture.light()));
        let mut prepared =
            Self { number, light, gobo, shadow, hazy, beam, is_patterned, casts_shadow, reach };
        if !plan.skips() {
            prepared.equip(fixture);
        }
        Ok(Some(prepared))
    }

    /// Adds a fully transparent gobo, an empty shadow map and a beam in clear air to a fixture
    /// without them, where the format can hold them. The light of the result is the same.
    fn equip(&mut self, fixture: &Fixture) {
        let square = fixture.with_shadow(16).ok().and_then(|fixture| fixture.shadow());
        let square = square.and_then(|(_, square)| square.compile().ok());
        self.gobo = self.gobo.take().or_else(|| square.map(|square| CLEAR.on(square)));
        // No shadow map is drawn for this fixture, so the map stays empty.
        self.shadow = self.shadow.take().or(square);
        self.hazy = self.hazy.take().or_else(|| Hazy::new(fixture, &Haze::CLEAR).ok().flatten());
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
