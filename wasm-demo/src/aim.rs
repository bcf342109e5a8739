//! Lights in the picture: where they hang, where they aim, and what a pointer moves.
//!
//! Places of the picture are shares of its width and of its height, from the left and from the top.

use crate::{
    design::Both,
    light::{LightState, hex_of, lumens_of, position_of},
    model::Chosen,
    photometry::full_scale,
    refusal::Refusal,
    rig::FARTHEST,
    setting::Setting,
    stage::Stage,
    state::{EXPOSURE_STEP, EXPOSURES},
};
use libm::sincosf;
use luminaire::{Vec3, attenuation::Attenuation, dynamic::AnyLight, projector::Fixture};
use luminaire_render::Surfaces;
use wasm_bindgen::prelude::*;

/// Number of rays around the axis of a light, at the same angle off it.
const RAYS: usize = 96;

/// Number of such rings of rays that look for the surfaces that a light reaches.
const RINGS: u8 = 8;

/// Ratio of the distances of neighbouring rays over which they are taken to meet different surfaces.
const GAP: f32 = 1.15;

/// Number of neighbouring rays below which a surface that they meet is left out of the outline.
const FEWEST: usize = 20;

/// Returns `point + factor * direction`.
pub(crate) fn plus(point: Vec3<f32>, factor: f32, direction: Vec3<f32>) -> Vec3<f32> {
    point.zip(direction, |point, along| point + factor * along)
}

/// The directions at this angle off an axis, in radians.
fn rays(axis: Vec3<f32>, off: f32) -> impl Iterator<Item = Vec3<f32>> {
    let across = perpendicular(axis);
    let beside = axis.cross(across);
    let (radius, ahead) = sincosf(off);
    (0..RAYS).map(move |i| {
        let (sine, cosine) = sincosf(std::f32::consts::TAU / RAYS as f32 * i as f32);
        let direction = plus(axis.map(|along| ahead * along), radius * cosine, across);
        plus(direction, radius * sine, beside)
    })
}

/// Returns x, y and z, or nothing.
fn coordinates(point: Option<Vec3<f32>>) -> Vec<f32> {
    point.map(|Vec3 { x, y, z }| vec![x, y, z]).unwrap_or_default()
}

#[wasm_bindgen]
impl Stage {
    /// Returns the point that each light aims at: its target, or else the surface that its axis meets.
    /// `None` unless it is a spotlight.
    fn aims(&self) -> Result<Vec<Option<Vec3<f32>>>, Refusal> {
        let surfaces = Surfaces::of(self.rig().scene());
        let fixtures = self.rig().fixtures_at(self.state().seconds[0])?;
        let aim = |(setting, fixture): (&Setting, &Fixture)| match fixture.light() {
            AnyLight::Spot(spot) => {
                let met = || {
                    let throw = surfaces.first(spot.position(), spot.axis());
                    plus(spot.position(), throw.unwrap_or(FARTHEST), spot.axis())
                };
                Some(setting.target.unwrap_or_else(met))
            }
            _ => None,
        };
        Ok(self.state().lights.iter().zip(&fixtures).map(aim).collect())
    }

    /// Returns the light as it is at this time.
    fn lit(&self, light: usize) -> Result<AnyLight, Refusal> {
        let count = self.state().lights.len();
        let fixtures = self.rig().fixtures_at(self.state().seconds[0])?;
        let fixture = fixtures.get(light).ok_or_else(|| Refusal::light(light, count))?;
        Ok(*fixture.light())
    }

    /// The lights, each with its name, its colour, its position and whether it is on: what a list of
    /// lights shows. Nothing else is computed.
    #[wasm_bindgen(js_name = lights)]
    pub fn listed_lights(&self) -> Result<Vec<LightState>, Refusal> {
        let fixtures = self.rig().fixtures_at(self.state().seconds[0])?;
        let listed = self.state().lights.iter().zip(&fixtures).map(|(setting, fixture)| {
            Ok(LightState {
                name: setting.name_of(&self.rig().original(setting)?),
                on: setting.is_on,
                color: hex_of(fixture.light().color()),
                position: coordinates(position_of(fixture.light())),
                ..LightState::default()
            })
        });
        listed.collect()
    }

    /// Returns the state of a light.
    #[wasm_bindgen(js_name = light)]
    pub fn light_state(&self, light: usize) -> Result<LightState, Refusal> {
        let (setting, full_scale) = (self.setting(light)?, full_scale(self.state().scene));
        let (original, on) = (self.rig().original(setting)?, self.rig().on(setting)?);
        let on = on.light();
        let own_edge = match original.light() {
            AnyLight::Spot(spot) => {
                let cone = setting.own.unwrap_or(spot.cone());
                let hotspot = if cone.versines()[0] > 0.0 { " with a hotspot" } else { "" };
                cone.falloff().effect().name().to_owned() + hotspot
            }
            _ => String::new(),
        };
        // The aim of a light that the scene moves is that at this time.
        let now = self.lit(light)?;
        let surfaces = Surfaces::of(self.rig().scene());
        let strongest = full_scale * on.intensity();
        let candela = setting.kelvin.map_or(strongest, |_| strongest * on.color().luminance());
        let mut state = LightState {
            name: setting.name_of(&original),
            on: setting.is_on,
            kind: setting.kind.map_or("own", |kind| kind.name()).to_owned(),
            law: setting.law.map_or("own", |law| law.name()).to_owned(),
            law_numbers: setting.law.map_or(Vec::new(), |law| law.values()),
            fixture: setting.fixture.map(|fixture| fixture.name.to_owned()).unwrap_or_default(),
            reading: setting.reading().name().to_owned(),
            zoom: setting.fixture.and(setting.design.one()).map(|(_, degrees)| degrees),
            edge: setting.edge_name().to_owned(),
            edge_numbers: setting.chosen_edge().map_or(Vec::new(), |edge| edge.values()),
            own_edge,
            intensity: candela,
            strongest,
            kelvin: setting.kelvin,
            unit: if matches!(on, AnyLight::Directional(_)) { "lx" } else { "cd" }.to_owned(),
            lumens: lumens_of(on, candela),
            color: hex_of(on.color()),
            position: coordinates(position_of(&now)),
            sweeps: original.sweeps() && setting.target.is_none(),
            moved: setting.position.is_some() || setting.target.is_some(),
            ..LightState::default()
        };
        if let AnyLight::Spot(spot) = on {
            let [beam, field, outer] = [spot.cone().beam(), spot.cone().field(), spot.cone().outer()]
                .map(|angle| angle.to_degrees());
            let edge = Both::of(setting.edge);
            let reach = edge.beams(field).zip(edge.fields(beam));
            state.reach = reach.map_or(Vec::new(), |(beams, fields)| [beams, fields].concat());
            (state.is_spot, state.beam, state.field, state.outer) = (true, beam, field, outer);
        }
        if let AnyLight::Spot(spot) = now {
            state.throw = surfaces.first(spot.position(), spot.axis());
            let point = plus(spot.position(), state.throw.unwrap_or(FARTHEST), spot.axis());
            state.lux = state.throw.map(|throw| candela * spot.attenuation().exact(throw.into()) as f32);
            state.aim = coordinates(setting.target.or(Some(point)));
        }
        Ok(state)
    }

    /// The distances in metres of the nearest and of the farthest surface that a light reaches at this
    /// time, by rays within its outer angle. Empty unless it is a spotlight and reaches any.
    #[wasm_bindgen(js_name = distances)]
    pub fn distances(&self, light: usize) -> Result<Vec<f32>, Refusal> {
        let AnyLight::Spot(spot) = self.lit(light)? else { return Ok(Vec::new()) };
        let surfaces = Surfaces::of(self.rig().scene());
        let half = spot.cone().outer().to_radians() / 2.0;
        let rings = (1..=RINGS).map(|ring| half * f32::from(ring) / f32::from(RINGS));
        let within = rings.flat_map(|off| rays(spot.axis(), off)).chain([spot.axis()]);
        let met = within.filter_map(|ray| surfaces.first(spot.position(), ray));
        let ends = met.fold(None, |ends: Option<[f32; 2]>, distance| {
            let [near, far] = ends.unwrap_or([distance; 2]);
            Some([near.min(distance), far.max(distance)])
        });
        Ok(ends.map_or(Vec::new(), Vec::from))
    }

    /// Returns where each light and the point that it aims at are in a picture whose width is
    /// `aspect` times its height; `None` if they are not before the camera.
    pub(crate) fn places(&self, aspect: f32) -> Result<Vec<[Option<[f32; 2]>; 2]>, Refusal> {
        let (camera, fixtures) = (self.camera(), self.rig().fixtures_at(self.state().seconds[0])?);
        let place = |point: Vec3<f32>| camera.project(point, aspect).map(|[x, y, _]| [x, y]);
        let places = fixtures
            .iter()
            .zip(self.aims()?)
            .map(|(fixture, aim)| [position_of(fixture.light()).and_then(place), aim.and_then(place)]);
        Ok(places.collect())
    }

    /// Returns the pool of a light: where its field angle meets the surfaces. The first two places are
    /// the ends of the lines from the light that enclose the pool, and the others the corners of its
    /// outline, which leaves out small objects. It is closed, or it has `None` after each piece: where it
    /// goes from one surface to another. Empty unless the light is a spotlight.
    pub(crate) fn pool(&self, light: usize, aspect: f32) -> Result<Vec<Option<[f32; 2]>>, Refusal> {
        let AnyLight::Spot(spot) = self.lit(light)? else { return Ok(Vec::new()) };
        let (camera, surfaces) = (self.camera(), Surfaces::of(self.rig().scene()));
        let (axis, position) = (spot.axis(), spot.position());
        let place = |point: Vec3<f32>| camera.project(point, aspect).map(|[x, y, _]| [x, y]);
        let half = (spot.cone().field().to_degrees() / 2.0).min(85.0).to_radians();
        let meet = |direction| {
            let distance = surfaces.first(position, direction).unwrap_or(FARTHEST);
            (distance, plus(position, distance, direction))
        };
        let (distances, points): (Vec<_>, Vec<_>) = rays(axis, half).map(meet).unzip();
        let kept = on_large_surfaces(&distances);
        let outline: Vec<_> = points
            .iter()
            .zip(kept)
            .zip(&distances)
            .filter(|&((_, is_kept), _)| is_kept)
            .filter_map(|((&point, _), &distance)| Some((distance, place(point)?)))
            .collect();
        let points: Vec<_> = outline.iter().map(|(_, point)| *point).collect();
        let sides = place(position).map_or([None; 2], |start| sides(start, &points, aspect));
        Ok(sides.into_iter().chain(pieces(outline)).collect())
    }

    /// Moves a light to a place of the picture, whose width is `aspect` times its height: in the plane
    /// through the light that is parallel to the screen, or in the horizontal plane. `x` and `y` are
    /// shares of the width and of the height. A light whose aim the scene does not move keeps its aim.
    #[wasm_bindgen(js_name = dragLight)]
    pub fn drag_light(
        &mut self,
        light: usize,
        x: f32,
        y: f32,
        aspect: f32,
        is_level: bool,
    ) -> Result<(), Refusal> {
        self.within_gesture(|stage| {
            let camera = stage.camera();
            let position = position_of(&stage.lit(light)?);
            let Some((position, [_, _, depth])) =
                position.and_then(|p| Some((p, camera.project(p, aspect)?)))
            else {
                return Ok(());
            };
            let (eye, toward) = (camera.eye(), camera.toward([x, y], aspect));
            let level = (position.y - eye.y) / toward.y;
            let depth = if is_level && level > 0.0 && level < 3.0 * depth { level } else { depth };
            stage.place(light, plus(eye, depth, toward))
        })
    }

    /// Moves a light to a position.
    pub(crate) fn place(&mut self, light: usize, position: Vec3<f32>) -> Result<(), Refusal> {
        let original = self.rig().original(self.setting(light)?)?;
        let aim = if original.sweeps() { None } else { self.aims()?.get(light).copied().flatten() };
        self.change_light(light, |setting| {
            setting.position = Some(position);
            setting.target = setting.target.or(aim);
        })
    }

    /// Aims a light at what is seen at a place of the picture. Where nothing is seen, the point is as
    /// far from the eye as the point that the light aims at. This ends a sweep.
    #[wasm_bindgen(js_name = dragAim)]
    pub fn drag_aim(&mut self, light: usize, x: f32, y: f32, aspect: f32) -> Result<(), Refusal> {
        self.within_gesture(|stage| {
            let Some(aim) = stage.aims()?.get(light).copied().flatten() else { return Ok(()) };
            let camera = stage.camera();
            let (eye, toward) = (camera.eye(), camera.toward([x, y], aspect));
            let depth = Surfaces::of(stage.rig().scene()).first(eye, toward);
            let depth = depth.or_else(|| camera.project(aim, aspect).map(|[_, _, depth]| depth));
            let Some(depth) = depth else { return Ok(()) };
            stage.aim(light, plus(eye, depth, toward))
        })
    }

    /// Aims a light at a point. This ends a sweep.
    pub(crate) fn aim(&mut self, light: usize, target: Vec3<f32>) -> Result<(), Refusal> {
        self.change_light(light, |setting| setting.target = Some(target))
    }

    /// Sets the exposure, within its range, so that the middle of a light's pool is shown as full
    /// scale on a white surface.
    #[wasm_bindgen(js_name = exposeFor)]
    pub fn expose_for(&mut self, light: usize) -> Result<(), Refusal> {
        let state = self.light_state(light)?;
        let lux = state
            .lux
            .filter(|lux| *lux > 0.0)
            .ok_or_else(|| Refusal::name("light", &state.name, "a lit spotlight that aims at a surface"))?;
        let [least, most] = EXPOSURES;
        // In the steps of the slider.
        let stops = (full_scale(self.state().scene) / lux).log2();
        self.put("exposure", ((stops / EXPOSURE_STEP).round() * EXPOSURE_STEP).max(least).min(most))
    }

    /// Moves a light and its aim back to where the scene has them.
    #[wasm_bindgen(js_name = putBack)]
    pub fn put_back(&mut self, light: usize) -> Result<(), Refusal> {
        self.change_light(light, |setting| (setting.position, setting.target) = (None, None))
    }
}

/// Returns a unit vector perpendicular to a unit vector.
fn perpendicular(axis: Vec3<f32>) -> Vec3<f32> {
    let helper = if axis.y.abs() < 0.9 { Vec3::new(0.0, 1.0, 0.0) } else { Vec3::new(1.0, 0.0, 0.0) };
    let across = axis.cross(helper);
    let length = across.dot(across).sqrt();
    across.map(|along| along / length)
}

/// Tells which of the rays, a closed ring, meet a surface that many of their neighbours meet too; all
/// if none does.
fn on_large_surfaces(distances: &[f32]) -> Vec<bool> {
    let count = distances.len();
    let parts = |i: usize| is_step(distances[i], distances[(i + 1) % count]);
    let Some(last) = (0..count).rfind(|&i| parts(i)) else { return vec![true; count] };
    let ring: Vec<usize> = (last + 1..=last + count).map(|i| i % count).collect();
    let mut kept = vec![false; count];
    for piece in ring.chunk_by(|&i, _| !parts(i)).filter(|piece| piece.len() >= FEWEST) {
        piece.iter().for_each(|&i| kept[i] = true);
    }
    if kept.contains(&true) { kept } else { vec![true; count] }
}

/// Whether two neighbouring rays meet different surfaces.
fn is_step(one: f32, next: f32) -> bool {
    one.max(next) > GAP * one.min(next)
}

/// Returns a ring of distances and points as points, with `None` after each of its pieces; without it, if the
/// ring has no step.
fn pieces<T: Copy>(mut ring: Vec<(f32, T)>) -> Vec<Option<T>> {
    let steps = |ring: &[(f32, T)], i: usize| is_step(ring[i].0, ring[(i + 1) % ring.len()].0);
    let last = (0..ring.len()).rfind(|&i| steps(&ring, i));
    let first = last.map_or(0, |last| (last + 1) % ring.len());
    ring.rotate_left(first);
    let with_ends = |i: usize| [Some(Some(ring[i].1)), steps(&ring, i).then_some(None)];
    (0..ring.len()).flat_map(with_ends).flatten().collect()
}

/// Returns the two points of an outline that lie farthest to either side, as seen from `start`.
fn sides(start: [f32; 2], outline: &[[f32; 2]], aspect: f32) -> [Option<[f32; 2]>; 2] {
    let way = |[x, y]: [f32; 2]| [aspect * (x - start[0]), y - start[1]];
    let turn = |[x, y]: [f32; 2], [u, v]: [f32; 2]| x * v - y * u;
    let mut ends = [None; 2];
    for &point in outline {
        for (end, sign) in ends.iter_mut().zip([-1.0, 1.0]) {
            if end.is_none_or(|end| sign * turn(way(end), way(point)) > 0.0) {
                *end = Some(point);
            }
        }
    }
    ends
}

#[cfg(test)]
mod tests;
