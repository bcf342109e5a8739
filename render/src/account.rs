//! What a picture has cost: how often a light was evaluated at a pixel, and how often that was spared.

/// The account of the last time that geometry was drawn, and light. A pair is a light and a pixel: each light that was
/// given makes one with each pixel of the picture.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[non_exhaustive]
pub struct Account {
    /// The triangles that were drawn: none where the geometry could stay as it was.
    pub triangles: usize,
    /// The tiles of the picture.
    pub tiles: u32,
    /// The tiles that were lit again.
    pub tiles_relit: u32,
    /// The lights that were given.
    pub lights: u32,
    /// The lights that can light nothing, and were dropped.
    pub lights_dropped: u32,
    /// The pairs that were evaluated.
    pub evaluated: u64,
    /// Those of them that were evaluated with a highlight.
    pub evaluated_shining: u64,
    /// The pairs of a beam and a pixel through whose haze it may be seen, which were evaluated besides.
    pub evaluated_in_air: u64,
    /// The pairs of a dropped light.
    pub dropped: u64,
    /// The pairs in tiles whose light could stay as it was.
    pub kept: u64,
    /// The pairs of a light and a tile that it does not reach.
    pub missed_by_tile: u64,
    /// The pairs of a light and a row of 32 pixels that it does not reach or that faces away from it, within a tile that it may
    /// reach.
    pub missed_by_row: u64,
}

impl Account {
    /// The account of a picture of so many pixels, before anything is lit: `kept` of the lights are not dropped.
    pub(crate) fn new(tiles: usize, lights: usize, kept: usize, pixels: usize) -> Self {
        let [tiles, lights, kept] = [tiles, lights, kept].map(|count| count as u32);
        let lights_dropped = lights - kept;
        let dropped = u64::from(lights_dropped) * pixels as u64;
        // What is lit is taken from what is kept.
        let kept = u64::from(kept) * pixels as u64;
        Self { tiles, lights, lights_dropped, dropped, kept, ..Self::default() }
    }

    /// Enters a row of pixels of a tile that is lit, of which so many lights may reach the tile, and so many are
    /// evaluated, and so many of those with a highlight.
    pub(crate) fn enter(&mut self, pixels: usize, reached: usize, evaluated: usize, shining: usize) {
        let [pixels, reached, evaluated, shining] =
            [pixels, reached, evaluated, shining].map(|count| count as u64);
        let missed = u64::from(self.lights - self.lights_dropped) - reached;
        self.evaluated += evaluated * pixels;
        self.evaluated_shining += shining * pixels;
        self.missed_by_row += (reached - evaluated) * pixels;
        self.missed_by_tile += missed * pixels;
        self.kept -= (reached + missed) * pixels;
    }

    /// All pairs of a light and a pixel.
    pub fn pairs(&self) -> u64 {
        self.evaluated + self.dropped + self.kept + self.missed_by_tile + self.missed_by_row
    }
}
