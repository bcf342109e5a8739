//! The light of a picture: which tiles must be lit again, and by which lamps.

use super::Renderer;
use crate::{account::Account, air, block::LANES, format::Format, lighting::Setting, prepared::Prepared};
use alloc::vec::Vec;
use luminaire::{Error, Haze, Luminaire, Plan};

impl<S: Format> Renderer<S> {
    /// Lights the tiles that have changed, or all where the plan leaves nothing out. Returns whether any had.
    pub(super) fn draw_light_by<L: Copy + Into<Luminaire>>(
        &mut self,
        plan: Plan,
        lights: &[L],
    ) -> Result<bool, Error> {
        let luminaires: Vec<Luminaire> = lights.iter().map(|&light| light.into()).collect();
        if self.lit.as_ref() == Some(&luminaires) && self.shadows.redrawn().is_empty() {
            return Ok(false);
        }
        let haze = if plan.skips() { self.haze } else { Some(self.haze.unwrap_or(Haze::CLEAR)) };
        let prepare = |(number, luminaire)| Prepared::new(number, luminaire, haze, &plan);
        let prepared = luminaires.iter().enumerate().map(prepare).collect::<Result<Vec<_>, _>>()?;
        for reached in [&mut self.reached, &mut self.seen] {
            if reached.make_room(self.tiles.tiles.len(), luminaires.len()) {
                self.lit = None;
            }
        }
        if self.lit.is_none() {
            self.reached.forget();
            self.seen.forget();
        }
        let (is_new, changed) = (self.lit.is_none(), self.changed(&luminaires));
        let kept = prepared.iter().flatten().count();
        self.account = Account::new(self.tiles.tiles.len(), luminaires.len(), kept, self.width * self.height);
        let is_hazy = prepared.iter().flatten().any(|lamp| lamp.is_hazy());
        for tile in 0..self.tiles.tiles.len() {
            if is_hazy {
                self.sight(tile);
            }
            let is_another = self.ask(tile, plan, &changed, &prepared, is_hazy) || is_new;
            self.tiles.tiles[tile].is_relit = is_another;
            if is_another {
                self.light_tile(tile, plan, &prepared);
            }
        }
        self.lit = plan.skips().then_some(luminaires);
        self.shadows.settle();
        Ok(true)
    }

    /// The numbers of the luminaires that are others than those of the picture.
    fn changed(&self, luminaires: &[Luminaire]) -> Vec<usize> {
        let before = self.lit.as_deref().unwrap_or_default();
        let count = luminaires.len().max(before.len());
        let is_another = |&i: &usize| {
            self.lit.is_none() || before.get(i) != luminaires.get(i) || self.shadows.redrawn().contains(&i)
        };
        (0..count).filter(is_another).collect()
    }

    /// Bundles the view rays of a tile, once for a view.
    fn sight(&mut self, tile: usize) {
        let (rows, column) = self.tiles.place(tile);
        let sight = &mut self.tiles.tiles[tile].sight;
        if let Some(view) = self.view.as_ref().filter(|_| sight.is_none()) {
            *sight = Some(air::bundle(view, &self.fragments, rows, column));
        }
    }

    /// Asks anew whether a tile is reached by the luminaires that are others now, on its surfaces or in the air before
    /// them. Returns whether its light is another for it.
    fn ask(
        &mut self,
        tile: usize,
        plan: Plan,
        changed: &[usize],
        prepared: &[Option<Prepared<S>>],
        is_hazy: bool,
    ) -> bool {
        let place = &self.tiles.tiles[tile];
        let reaches = |lamp: &Prepared<S>| {
            !plan.skips() || place.bounds.is_some_and(|bounds| !lamp.reach.misses(&bounds))
        };
        let is_seen = |lamp: &Prepared<S>| !plan.skips() || lamp.is_seen_in_air(place.sight.as_ref());
        let of = |number: usize| prepared.get(number).and_then(Option::as_ref);
        let is_another = self.reached.update(tile, changed, |number| of(number).is_some_and(reaches));
        // In clear air, where no beam was seen before, there is nothing to ask for.
        let may_be_seen = !plan.skips() || is_hazy || self.seen.lamps(tile).next().is_some();
        may_be_seen && self.seen.update(tile, changed, |number| of(number).is_some_and(is_seen)) || is_another
    }

    fn light_tile(&mut self, tile: usize, plan: Plan, prepared: &[Option<Prepared<S>>]) {
        self.tiles.tiles[tile].is_encoded = false;
        self.account.tiles_relit += 1;
        let (finishes, shadows) = (&self.finishes, &self.shadows);
        let viewpoint = self.view.as_ref().map_or(glam::Vec3::ZERO, |view| view.eye());
        let setting = Setting { plan, eye: self.eye, viewpoint, ambient: self.ambient, finishes, shadows };
        let lamps: Vec<_> = self.reached.lamps(tile).filter_map(|lamp| prepared[lamp].as_ref()).collect();
        let seen: Vec<_> = self.seen.lamps(tile).filter_map(|lamp| prepared[lamp].as_ref()).collect();
        let mut reaching = Vec::with_capacity(lamps.len());
        for block in self.tiles.blocks(tile) {
            let geometry = &self.geometry.blocks[block];
            reaching.clear();
            reaching.extend(lamps.iter().filter(|lamp| !(plan.skips() && geometry.is_missed(&lamp.reach))));
            let radiance = &mut self.radiance[block];
            let shining = S::light(&setting, geometry, &reaching, &mut self.workspace, radiance);
            self.evaluated[block] = reaching.len().try_into().unwrap_or(u16::MAX);
            let (row, column) = (block / self.geometry.columns, block % self.geometry.columns);
            let pixels = LANES.min(self.width - column * LANES);
            self.account.enter(pixels, lamps.len(), reaching.len(), shining);
            if let Some(view) = self.view.as_ref().filter(|_| !seen.is_empty()) {
                let rays = air::rays(view, &self.fragments, row, column);
                seen.iter().for_each(|lamp| lamp.scatter(&rays, &self.shadows, radiance));
                self.account.evaluated_in_air += (pixels * seen.len()) as u64;
            }
        }
    }
}
