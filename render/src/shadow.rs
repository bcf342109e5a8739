//! The shadow maps of a picture's fixtures.

pub(crate) mod map;

use crate::{error::DrawError, scene::Scene, shadow::map::ShadowMap, size::SizeError, stripes::Stripes};
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

    /// Draws the maps whose scene or fixture has changed, of those that are dealt to a share of the
    /// picture. Returns the indices of their fixtures.
    ///
    /// # Errors
    /// A projection that the format can't hold, or no memory. The maps that were drawn before the
    /// error are kept.
    pub(crate) fn draw<L: Copy + Into<Fixture>>(
        &mut self,
        scene: &Scene,
        lights: &[L],
        share: Stripes,
    ) -> Result<Vec<usize>, DrawError> {
        self.maps.resize_with(lights.len(), || None);
        let (mut drawn, mut dealt) = (Vec::new(), 0);
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
            dealt += 1;
            if !share.has(dealt - 1) {
                continue;
            }
            if sized(map, side.into())?.draw(scene, &projection)? {
                drawn.push(number);
                if !self.redrawn.contains(&number) {
                    self.redrawn.push(number);
                }
            }
        }
        Ok(drawn)
    }

    /// Takes the map of a fixture from a renderer that has drawn it.
    ///
    /// # Errors
    /// A projection that the format can't hold, no memory, or another number of depths than the
    /// fixture's map has. The map stays as it was.
    pub(crate) fn take(
        &mut self,
        scene: &Scene,
        fixture: Option<&Fixture>,
        number: usize,
        depths: impl ExactSizeIterator<Item = S::Length>,
    ) -> Result<(), DrawError> {
        let (side, square) = fixture
            .and_then(Fixture::shadow)
            .map_or((0, None), |(side, square)| (usize::from(side), Some(square)));
        let (Some(map), Some(square)) = (self.maps.get_mut(number), square) else {
            return Err(SizeError::Depths(depths.len(), 0).into());
        };
        if depths.len() != side * side {
            return Err(SizeError::Depths(depths.len(), side * side).into());
        }
        sized(map, side)?.take(scene, &square, depths)?;
        if !self.redrawn.contains(&number) {
            self.redrawn.push(number);
        }
        Ok(())
    }

    /// Returns the depths of a fixture's map; `None` without a map.
    pub(crate) fn depths(&self, number: usize) -> Option<&[S::Length]> {
        Some(self.maps.get(number)?.as_ref()?.depths())
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

/// Returns the map of a fixture, which is a new one if there was none of this side in texels.
fn sized<S: Scalar>(map: &mut Option<ShadowMap<S>>, side: usize) -> Result<&mut ShadowMap<S>, SizeError> {
    let kept = map.take().filter(|map| map.side() == side);
    Ok(map.insert(kept.map_or_else(|| ShadowMap::new(side), Ok)?))
}
