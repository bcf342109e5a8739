//! Attenuation of light by gobos and shadow maps.

use crate::{
    buffer::{LANES, Lights},
    light::{block::Block, places::Places, prepared::Prepared},
    shadow::Shadows,
};
use luminaire::{
    Scalar,
    projector::{ProjectedPoint, Shadow},
};

/// Attenuates the light of a block by a fixture's gobo and shadow map.
///
/// The projected positions of the points are scratch memory.
#[derive(Clone, Debug)]
pub(crate) struct Filter<S: Scalar> {
    places: Places<S, LANES>,
}

impl<S: Scalar> Default for Filter<S> {
    fn default() -> Self {
        Self { places: Places::default() }
    }
}

impl<S: Scalar> Filter<S> {
    /// Multiplies a fixture's light on a block by the transmittance of the fixture's gobo and
    /// shadow map.
    ///
    /// The highlights are multiplied, too.
    #[inline(never)]
    pub(crate) fn apply(
        &mut self,
        fixture: &Prepared<S>,
        shadows: &Shadows<S>,
        block: &Block<S>,
        [diffuse, specular]: [&mut Lights<S>; 2],
    ) {
        if let Some(gobo) = &fixture.gobo {
            self.places.find(gobo.projection(), &block.point);
            self.leave([&mut *diffuse, &mut *specular], |place| gobo.gobo().transmission(&place));
        }
        if let Some(square) = &fixture.shadow {
            self.places.find(square, &block.point);
            let none = Shadow::from_parts(*square, 0, &[]);
            let shadow = shadows.of(fixture.number).unwrap_or(none);
            self.leave([diffuse, specular], |place| shadow.at(&place));
        }
    }

    /// Multiplies the light of each pixel by the transmittance `part` at the pixel. Pixels without
    /// light are skipped.
    #[inline(always)]
    fn leave(&self, [diffuse, specular]: [&mut Lights<S>; 2], part: impl Fn(ProjectedPoint<S>) -> S) {
        let dark = S::Irradiance::default();
        for lane in 0..LANES {
            if diffuse[lane] > dark || specular[lane] > dark {
                let part = part(self.places.at(lane));
                diffuse[lane] = S::filter(diffuse[lane], part);
                specular[lane] = S::filter(specular[lane], part);
            }
        }
    }
}
