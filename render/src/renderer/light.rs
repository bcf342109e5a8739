//! The lighting pass: which tiles must be re-lit, and by which lights.

use super::Renderer;
use crate::{
    buffer::{LANES, Radiance},
    light::{
        Setting,
        air::{self, TileAir},
        prepared::Prepared,
        rig::Rig,
    },
    renderer::{
        account::Account,
        display::CHANNELS,
        format::{Format, Loops},
        reached::Reached,
    },
    scene::strip::Strip,
};
use alloc::vec::Vec;
use luminaire::{Error, Rgb, Scalar, dynamic::RenderPlan, projector::Fixture};

impl<S: Format> Renderer<S> {
    /// Lights the changed tiles, or all tiles if the plan skips nothing. Returns false if nothing
    /// had changed.
    pub(super) fn draw_light_by<L: Copy + Into<Fixture>>(
        &mut self,
        plan: RenderPlan,
        lights: &[L],
    ) -> Result<bool, Error> {
        let clock = self.clock.unwrap_or(|| 0.0);
        let start = clock();
        let fixtures: Vec<Fixture> = lights.iter().map(|&light| light.into()).collect();
        if self.lit.as_ref() == Some(&fixtures) && self.shadows.redrawn().is_empty() {
            return Ok(false);
        }
        let rig = Rig::new(plan, &fixtures, self.haze)?;
        self.light_strip(&fixtures)?;
        self.make_room(fixtures.len());
        let (is_new, changed) = (self.lit.is_none(), self.changed(&fixtures));
        let (tiles, pixels) = (self.tiles.tiles.len(), self.pixels.len() / CHANNELS);
        self.account = Account::new(tiles, fixtures.len(), rig.kept(), pixels);
        if let Some((_, strip)) = &self.strip {
            self.account.leds = self.leds.len() as u32;
            self.account.led_current = Strip::current(&self.leds);
            self.account.led_limit = strip.limit();
        }
        let near = self.approach(&rig, &changed);
        // What is done once for all tiles is shared by them.
        let mut before = clock();
        let share = (before - start) / tiles as f64;
        for tile in 0..tiles {
            let near = near.lights(self.tiles.region(tile));
            let is_another = self.ask(tile, &rig, near, &changed) || is_new;
            self.tiles.tiles[tile].is_relit = is_another;
            if is_another {
                self.light_tile(tile, &rig);
            }
            let after = clock();
            self.tiles.tiles[tile].time = share + (after - before);
            before = after;
        }
        self.lit = plan.skips().then_some(fixtures);
        self.shadows.settle();
        Ok(true)
    }

    /// Computes what the LEDs show. If that has changed, the whole picture is lit again, because an LED
    /// also shows light that does not reach the surfaces of its tile.
    fn light_strip(&mut self, fixtures: &[Fixture]) -> Result<(), Error> {
        let lights = fixtures.iter().map(Fixture::light);
        let leds = self.strip.as_ref().map_or(Ok(Vec::new()), |(_, strip)| strip.frame::<S>(lights))?;
        if self.leds != leds {
            self.leds = leds;
            self.lit = None;
        }
        Ok(())
    }

    /// Resizes the sets of lights that reach each region and each tile to this number of lights. If
    /// a size has changed, all sets are cleared and the whole picture is lit again.
    fn make_room(&mut self, lights: usize) {
        let (regions, tiles) = (self.tiles.regions.len(), self.tiles.tiles.len());
        for (reached, places) in
            [(&mut self.near, regions), (&mut self.reached, tiles), (&mut self.seen, tiles)]
        {
            if reached.make_room(places, lights) {
                self.lit = None;
            }
        }
        if self.lit.is_none() {
            self.near.forget();
            self.reached.forget();
            self.seen.forget();
        }
    }

    /// Returns the indices of the changed fixtures.
    ///
    /// A fixture counts as changed if its shadow map was redrawn, or if the fixture with the same
    /// index in the current picture is different.
    fn changed(&self, fixtures: &[Fixture]) -> Vec<usize> {
        let before = self.lit.as_deref().unwrap_or_default();
        let count = fixtures.len().max(before.len());
        let is_another = |&i: &usize| {
            self.lit.is_none() || before.get(i) != fixtures.get(i) || self.shadows.redrawn().contains(&i)
        };
        (0..count).filter(is_another).collect()
    }

    /// Computes the bundle of view rays of a tile, unless it is already known for this view.
    pub(super) fn sight(&mut self, tile: usize) {
        let (rows, column) = self.tiles.place(tile);
        let sight = &mut self.tiles.tiles[tile].sight;
        if let Some(view) = self.view.as_ref().filter(|_| sight.is_none()) {
            *sight = Some(air::bundle(view, &self.fragments, rows, column));
        }
    }

    /// Tests every region against the changed lights. Returns the (region, light) pairs that
    /// overlap now or overlapped before the change; the caller must test the tiles of these
    /// regions.
    fn approach(&mut self, rig: &Rig<S>, changed: &[usize]) -> Reached {
        let mut near = self.near.clone();
        near.forget();
        for (region, bounds) in self.tiles.regions.iter().enumerate() {
            for &light in changed {
                let is_near = self.near.update(region, light, rig.reaches(light, bounds.as_ref()));
                near.update(region, light, is_near);
            }
        }
        near
    }

    /// Tests one tile against the changed lights. Returns true if the tile must be re-lit.
    ///
    /// The surfaces of the tile are tested against `near`, the changed lights that reach its
    /// region. The air in front of the tile is tested against all changed lights.
    fn ask(
        &mut self,
        tile: usize,
        rig: &Rig<S>,
        near: impl Iterator<Item = usize>,
        changed: &[usize],
    ) -> bool {
        let mut is_another = false;
        let bounds = self.tiles.tiles[tile].bounds;
        for light in near {
            is_another |= self.reached.update(tile, light, rig.reaches(light, bounds.as_ref()));
        }
        // The air needs no test if there is no haze now and no beam was visible before.
        if rig.is_hazy() || self.seen.lights(tile).next().is_some() {
            self.sight(tile);
            let sight = self.tiles.tiles[tile].sight.as_ref();
            for &light in changed {
                is_another |= self.seen.update(tile, light, rig.is_seen_in_air(light, sight));
            }
        }
        is_another
    }

    fn light_tile(&mut self, tile: usize, rig: &Rig<S>) {
        self.tiles.tiles[tile].is_encoded = false;
        self.account.tiles_relit += 1;
        let (finishes, shadows) = (&self.finishes, &self.shadows);
        let viewpoint = self.view.as_ref().map_or(glam::Vec3::ZERO, |view| view.eye());
        let (eye, ambient) = (self.eye, self.ambient);
        let setting = Setting { plan: rig.plan(), eye, viewpoint, ambient, finishes, shadows };
        let reached: Vec<_> = self.reached.lights(tile).collect();
        let seen: Vec<_> = self.seen.lights(tile).filter_map(|light| rig.fixture(light)).collect();
        let mut reaching = Vec::with_capacity(reached.len());
        for block in self.tiles.blocks(tile) {
            let geometry = &self.geometry.blocks[block];
            reaching.clear();
            let lights = reached.iter().filter(|&&light| rig.lights(light, geometry));
            reaching.extend(lights.filter_map(|&light| rig.fixture(light)));
            let radiance = &mut self.radiance[block];
            let shining = Loops::light(&setting, geometry, &reaching, &mut self.workspace, radiance);
            if let Some((first, _)) = &self.strip {
                emit::<S>(*first + 1, &self.leds, &geometry.material, radiance);
            }
            self.evaluated[block] = reaching.len().try_into().unwrap_or(u16::MAX);
            let column = block % self.geometry.columns;
            let pixels = LANES.min(self.width - column * LANES);
            let count =
                |has: fn(&Prepared<S>) -> bool| reaching.iter().filter(|fixture| has(fixture)).count();
            let [gobos, shadows] =
                [count(|fixture| fixture.gobo.is_some()), count(|fixture| fixture.shadow.is_some())];
            self.account.enter(pixels, reached.len(), [reaching.len(), shining, gobos, shadows]);
        }
        if !seen.is_empty() {
            self.add_air(tile, rig.plan(), &seen);
        }
    }

    /// Adds the in-scattered light of the beams of `seen` to a tile.
    fn add_air(&mut self, tile: usize, plan: RenderPlan, seen: &[&Prepared<S>]) {
        let Some(view) = &self.view else { return };
        let (rows, column) = self.tiles.place(tile);
        let columns = LANES.min(self.width - column * LANES);
        let mut air = TileAir::new(view, &self.fragments, (rows, column), columns, &mut self.scattered);
        let (is_all_seen, sight) = (plan.skips(), self.tiles.tiles[tile].sight.as_ref());
        for fixture in seen {
            let Some((hazy, way, beam)) = fixture.in_air(&self.shadows, view.eye()) else { continue };
            if is_all_seen || fixture.is_seen_in_air(sight) {
                air.add(hazy, &way, beam);
            } else {
                air.add_each(hazy, &way);
            }
        }
        self.account.evaluated_in_air += air.finish() as u64;
        for (block, light) in self.tiles.blocks(tile).zip(self.scattered.rows()) {
            if let Some(light) = light {
                S::add_air(&mut self.radiance[block], light);
            }
        }
    }
}

/// Adds what the LEDs show to the pixels of a block. `first` is the number of the first LED's material.
fn emit<S: Scalar>(first: usize, leds: &[Rgb<u8>], material: &[u32; LANES], radiance: &mut Radiance<S>) {
    for (lane, &number) in material.iter().enumerate() {
        let led = (number as usize).checked_sub(first).and_then(|led| leds.get(led));
        let Some(light) = led.map(|led| led.map(|duty| S::light_from_f32(f32::from(duty) / 255.0))) else {
            continue;
        };
        radiance.red[lane] += light.red;
        radiance.green[lane] += light.green;
        radiance.blue[lane] += light.blue;
    }
}
