//! The light that a visitor adds: in view, at a free place, and seen at once.

use crate::{
    aim::plus, format::Format, light::position_of, refusal::Refusal, rig, setting::Setting, stage::Stage,
    state::SWITCHABLE,
};
use luminaire::{Fx16, Vec3, dynamic::Effect, number::Length, projector::Fixture};
use luminaire_render::{Renderer, Surfaces};
use wasm_bindgen::prelude::*;

/// Places of the picture for lights that are added, as shares of a square picture: see
/// [`rig::place_in_view`]. The first that is free is taken.
const PLACES: [[f32; 2]; 15] = {
    let (across, down) = ([0.5, 0.1, 0.9, 0.3, 0.7], [0.15, 0.3, 0.05]);
    let mut places = [[0.0; 2]; 15];
    let mut i = 0;
    while i < places.len() {
        places[i] = [across[i % across.len()], down[i / across.len()]];
        i += 1;
    }
    places
};

/// Share of the camera's distance that is free around a light.
const ROOM: f32 = 0.1;

/// Places of the picture to aim at, from the middle outwards.
const AIMS: [[f32; 2]; 13] = [
    [0.5, 0.5],
    [0.5, 0.65],
    [0.35, 0.5],
    [0.65, 0.5],
    [0.5, 0.35],
    [0.3, 0.65],
    [0.7, 0.65],
    [0.2, 0.5],
    [0.8, 0.5],
    [0.3, 0.35],
    [0.7, 0.35],
    [0.2, 0.8],
    [0.8, 0.8],
];

/// Columns of the small picture in which it is seen what a light changes.
const WIDTH: usize = 64;

/// The change of a pixel that is seen, in displayed codes, and the share of such pixels that is enough.
const SEEN: u8 = 32;
const ENOUGH: f32 = 0.05;

/// Least cosine of the angle at which the light arrives.
const STEEP: f32 = 0.3;

#[wasm_bindgen]
impl Stage {
    /// Adds a spotlight behind the others, which hangs in view and aims at a surface in view. A white surface is lit to full
    /// scale there.
    #[wasm_bindgen(js_name = addLight)]
    pub fn add_light(&mut self) -> Result<(), Refusal> {
        let added = self.seen_from(self.free_place()?)?;
        self.insert_light(self.state().lights.len(), added)
    }

    /// Returns the first place that no light is near, or else the one that is farthest from all lights.
    fn free_place(&self) -> Result<Vec3<f32>, Refusal> {
        let camera = self.camera();
        let lights = self.rig().fixtures_at(self.state().seconds[0])?;
        let taken: Vec<_> = lights.iter().filter_map(|fixture| position_of(fixture.light())).collect();
        let room = |place: Vec3<f32>| {
            let distances = taken.iter().map(|light| {
                let way = plus(place, -1.0, *light);
                way.dot(way).sqrt()
            });
            distances.fold(ROOM * camera.distance(), f32::min)
        };
        let places = PLACES.map(|place| rig::place_in_view(self.rig().scene(), &camera, place)[0]);
        // The last of equal ones would be returned.
        let freest = places.into_iter().rev().max_by(|one, other| room(*one).total_cmp(&room(*other)));
        Ok(freest.unwrap_or(camera.eye()))
    }

    /// Returns a light at a position that changes a small picture by enough, or else by the most. Shadows
    /// are left out there, but the light is not aimed behind an obstacle.
    fn seen_from(&self, position: Vec3<f32>) -> Result<Setting, Refusal> {
        let (rig, camera) = (self.rig(), self.camera());
        let mut state = self.state().clone();
        for (switch, (effect, _)) in state.switched.iter_mut().zip(SWITCHABLE) {
            if effect == Effect::Shadow {
                *switch = Some(false);
            }
        }
        let fixture = |setting: &Setting| -> Result<Fixture, Refusal> {
            Ok(rig.fixture(&state, setting)?.at(state.seconds[0])?)
        };
        let mut fixtures = state.lights.iter().map(fixture).collect::<Result<Vec<_>, _>>()?;
        // The small picture is drawn in the format that this module has a renderer of.
        fixtures.retain(|fixture| Format::Fx16.check_fixture(fixture).is_ok());
        let (width, height) = state.scene.size();
        let (width, height) = (WIDTH, WIDTH * height / width);
        let mut picture = Renderer::<Fx16>::new(width, height)?;
        picture.draw_geometry(rig.scene(), &camera);
        picture.draw_light(&fixtures)?;
        let before = picture.encode().to_vec();

        let surfaces = Surfaces::of(rig.scene());
        let aimed = |target: Vec3<f32>, cosine: f32| {
            let way = plus(target, -1.0, position);
            let intensity = way.dot(way) / (cosine * state.exposure.exp2());
            Setting {
                position: Some(position),
                target: Some(target),
                intensity: Some(intensity),
                ..Setting::of(rig.lights())
            }
        };
        let mut best = (0.0, aimed(plus(camera.eye(), camera.distance(), camera.toward([0.5; 2], 1.0)), 1.0));
        for [x, y] in AIMS {
            let pixel = ((x * width as f32) as usize, (y * height as f32) as usize);
            let Some((target, normal, _)) = picture.surface(pixel.0, pixel.1) else { continue };
            let (target, normal) = (target.map(Length::to_f32), normal.map(Fx16::to_f32));
            let way = plus(target, -1.0, position);
            let cosine = -normal.dot(way) / way.dot(way).sqrt();
            let is_met = surfaces.first(position, way).is_some_and(|met| met > 0.99);
            if cosine < STEEP || !is_met {
                continue;
            }
            let setting = aimed(target, cosine);
            fixtures.push(fixture(&setting)?);
            picture.draw_light(&fixtures)?;
            fixtures.pop();
            let is_seen = |(one, other): (&[u8], &[u8])| {
                one.iter().zip(other).any(|(one, other)| one.abs_diff(*other) >= SEEN)
            };
            let pixels = before.chunks_exact(4).zip(picture.encode().chunks_exact(4));
            let share = pixels.filter(|pair| is_seen(*pair)).count() as f32 / (width * height) as f32;
            if share > best.0 {
                best = (share, setting);
            }
            if share >= ENOUGH {
                break;
            }
        }
        Ok(best.1)
    }
}
