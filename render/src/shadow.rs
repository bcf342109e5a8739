//! The shadow maps of a picture's fixtures.

pub(crate) mod map;

use crate::{error::DrawError, scene::Scene, shadow::map::ShadowMap};
use alloc::vec::Vec;
use luminaire::{
    Scalar,
    projector::{Fixture, Shadow},
};

/// The shadow maps by fixture index; `None` for a fixture without shadows.
#[derive(Clone, Debug)]
pub(crate) struct Shadows<S: Scalar> {
    maps: Vec<Option<ShadowMap<S>>>,
    /// The indices of the fixtures whose shadow map was redrawn since the last lighting pass.
    redrawn: Vec<usize>,
}

impl<S: Scalar> Shadows<S> {
    pub(crate) fn new() -> Self {
        Self { maps: Vec::new(), redrawn: Vec::new() }
    }

    /// Draws the maps whose scene or fixture has changed. Returns whether any map was drawn.
    ///
    /// # Errors
    /// A projection that the format can't hold, or no memory. The maps that were drawn before the
    /// error are kept.
    pub(crate) fn draw<L: Copy + Into<Fixture>>(
        &mut self,
        scene: &Scene,
        lights: &[L],
    ) -> Result<bool, DrawError> {
        self.maps.resize_with(lights.len(), || None);
        let mut is_any = false;
        for (number, (map, &light)) in self.maps.iter_mut().zip(lights).enumerate() {
            let fixture: Fixture = light.into();
            // A dark light casts no shadow. The map of a dark light is drawn once the light is on.
            let Some((side, projection)) = fixture.shadow() else {
                *map = None;
                continue;
            };
            if fixture.light().is_dark() {
                continue;
            }
            let side = side.into();
            if map.as_ref().is_none_or(|map| map.side() != side) {
                *map = Some(ShadowMap::new(side)?);
            }
            let Some(map) = map else { continue };
            if map.draw(scene, &projection)? {
                is_any = true;
                if !self.redrawn.contains(&number) {
                    self.redrawn.push(number);
                }
            }
        }
        Ok(is_any)
    }

    /// Returns the shadow map of a fixture; `None` before the map has been drawn.
    pub(crate) fn of(&self, number: usize) -> Option<Shadow<'_, S>> {
        self.maps.get(number)?.as_ref()?.shadow()
    }

    /// The indices of the fixtures whose shadow map was redrawn since the last lighting pass.
    pub(crate) fn redrawn(&self) -> &[usize] {
        &self.redrawn
    }

    /// Clears the list of redrawn maps, after a lighting pass.
    pub(crate) fn settle(&mut self) {
        self.redrawn.clear();
    }
}
