//! What is in the way of light: its pattern, and what throws shadows.

use crate::{
    block::Block, lanes::LANES, lanes::Lights, places::Places, prepared::Prepared, shadows::Shadows,
};
use luminaire::{
    Scalar,
    projector::{ProjectedPoint, Shadow},
};

/// Leaves of light what its way leaves of it. It keeps where the points of a block are on the square of a light.
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
    /// Leaves of a fixture's light on a block, and of its highlights, what the fixture's pattern and shadow let through.
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

    /// Leaves a part of the light at each place: where none arrives there is nothing to leave.
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
