//! A fixture, ready to light blocks of pixels.

use crate::{
    air::{Hazy, Way},
    lanes::LANES,
    lanes::Radiance,
    reach::Reach,
    shadows::Shadows,
};
use luminaire::{
    Angle, Error, Scalar,
    dynamic::{CompiledAnyLight, RenderPlan},
    haze::{Haze, RayBundle, ViewRays},
    projector::{CompiledGobo, CompiledProjection, Fixture, Gobo},
};

/// A fixture compiled for a format, and where its light may be.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<S: Scalar> {
    pub(crate) number: usize,
    pub(crate) light: CompiledAnyLight<S>,
    pub(crate) gobo: Option<CompiledGobo<'static, S>>,
    /// The square that the shadow map lies on.
    pub(crate) shadow: Option<CompiledProjection<S>>,
    hazy: Option<Hazy>,
    /// Whether the beam has anything in its way but clear glass.
    is_patterned: bool,
    casts_shadow: bool,
    pub(crate) reach: Reach,
}

/// Clear glass: what there is in the gate of a spotlight where nothing is left out.
const CLEAR: Gobo<'static> = Gobo::of(&[u8::MAX]);

impl<S: Scalar> Prepared<S> {
    /// The fixture of this number, if the plan keeps it.
    ///
    /// # Errors
    /// What the format can't hold.
    pub(crate) fn new(
        number: usize,
        fixture: &Fixture,
        haze: Option<Haze>,
        plan: &RenderPlan,
    ) -> Result<Option<Self>, Error> {
        let Some(light) = plan.prepare(fixture.light())? else { return Ok(None) };
        let (is_patterned, casts_shadow) = (fixture.gobo().is_some(), fixture.shadow().is_some());
        let mut fixture = *fixture;
        if !plan.skips() {
            fixture = equipped(fixture).unwrap_or(fixture);
        }
        let shadow = fixture.shadow().map(|(_, square)| square.compile()).transpose()?;
        let (gobo, reach) = (fixture.compile_gobo()?, Reach::new(fixture.light()));
        let hazy = haze.map(|haze| Hazy::new(fixture.light(), &haze)).transpose()?.flatten();
        Ok(Some(Self { number, light, gobo, shadow, hazy, is_patterned, casts_shadow, reach }))
    }

    /// Whether there is anything in the way of the light.
    pub(crate) fn is_filtered(&self) -> bool {
        self.gobo.is_some() || self.shadow.is_some()
    }

    /// Whether there is a beam in haze.
    pub(crate) fn is_hazy(&self) -> bool {
        self.hazy.is_some()
    }

    /// Whether the beam may be seen in the air of a bundle of view rays.
    pub(crate) fn is_seen_in_air(&self, sight: Option<&RayBundle>) -> bool {
        matches!((&self.hazy, sight), (Some(hazy), Some(sight)) if hazy.may_be_seen(sight))
    }

    /// Adds what the beam shows of itself along view rays.
    pub(crate) fn scatter(&self, rays: &ViewRays<LANES>, shadows: &Shadows<S>, radiance: &mut Radiance) {
        if let Some(hazy) = &self.hazy {
            let gobo = self.gobo.as_ref().filter(|_| self.is_patterned);
            let shadow = shadows.of(self.number).filter(|_| self.casts_shadow);
            hazy.add(rays, &Way { gobo, shadow }, radiance);
        }
    }
}

/// A fixture with everything that it may have and has not: none of it changes its light.
///
/// # Errors
/// A light that projects no square.
fn equipped(mut fixture: Fixture) -> Result<Fixture, Error> {
    if fixture.gobo().is_none() {
        fixture = fixture.with_gobo(CLEAR, Angle::degrees(0.0))?;
    }
    // There is no map of it.
    if fixture.shadow().is_none() { fixture.with_shadow(16) } else { Ok(fixture) }
}
