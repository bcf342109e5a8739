//! Counts of lighting work: evaluated and skipped (light, pixel) pairs.

/// Counts of the last geometry pass and the last lighting pass. A pair is one light and one pixel:
/// each light in the slice makes one pair with each pixel of the picture.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[non_exhaustive]
pub struct Account {
    /// Triangles drawn; 0 if the geometry was kept.
    pub triangles: usize,
    /// The tiles of the picture.
    pub tiles: u32,
    /// The tiles that were lit again.
    pub tiles_relit: u32,
    /// The lights in the slice that was passed.
    pub lights: u32,
    /// The LEDs of the scene's strip; 0 without one.
    pub leds: u32,
    /// The current of the LEDs in milliamperes.
    pub led_current: u32,
    /// The limit of that current.
    pub led_limit: u32,
    /// The number of dark lights, which were dropped.
    pub lights_dropped: u32,
    /// The pairs that were evaluated.
    pub evaluated: u64,
    /// The pairs of `evaluated` that were evaluated with a highlight.
    pub evaluated_shining: u64,
    /// The pairs of `evaluated` whose light has a gobo.
    pub evaluated_through_gobos: u64,
    /// The pairs of `evaluated` whose light has a shadow map.
    pub evaluated_in_shadows: u64,
    /// The view rays along which the in-scattering of a beam was evaluated: those between the two
    /// planes through the eye that touch the beam.
    pub evaluated_in_air: u64,
    /// The pairs of a dropped light.
    pub dropped: u64,
    /// The pairs in tiles that were not re-lit.
    pub kept: u64,
    /// The pairs skipped because the light does not reach the tile.
    pub missed_by_tile: u64,
    /// The pairs skipped in rows of 32 pixels, within tiles that the light may reach. The light
    /// does not reach such a row, or the surfaces of the row face away from the light.
    pub missed_by_row: u64,
}

impl Account {
    /// Returns the counts before lighting a picture of `pixels` pixels. `kept` of the lights were
    /// not dropped.
    pub(crate) fn new(tiles: usize, lights: usize, kept: usize, pixels: usize) -> Self {
        let [tiles, lights, kept] = [tiles, lights, kept].map(|count| count as u32);
        let lights_dropped = lights - kept;
        let dropped = u64::from(lights_dropped) * pixels as u64;
        // All pairs of the kept lights start in `kept`; `enter` moves the pairs of re-lit tiles
        // from `kept` to other counts.
        let kept = u64::from(kept) * pixels as u64;
        Self { tiles, lights, lights_dropped, dropped, kept, ..Self::default() }
    }

    /// Adds one row of a re-lit tile.
    ///
    /// `reached` is the number of lights that may reach the tile; `evaluated` the number of evaluated
    /// lights, of those with a highlight, with a gobo and with a shadow map.
    pub(crate) fn enter(&mut self, pixels: usize, reached: usize, evaluated: [usize; 4]) {
        let [pixels, reached] = [pixels, reached].map(|count| count as u64);
        let [evaluated, shining, gobos, shadows] = evaluated.map(|count| count as u64);
        let missed = u64::from(self.lights - self.lights_dropped) - reached;
        self.evaluated += evaluated * pixels;
        self.evaluated_shining += shining * pixels;
        self.evaluated_through_gobos += gobos * pixels;
        self.evaluated_in_shadows += shadows * pixels;
        self.missed_by_row += (reached - evaluated) * pixels;
        self.missed_by_tile += missed * pixels;
        self.kept -= (reached + missed) * pixels;
    }

    /// Returns the number of all pairs of a light and a pixel.
    pub fn pairs(&self) -> u64 {
        self.evaluated + self.dropped + self.kept + self.missed_by_tile + self.missed_by_row
    }
}
