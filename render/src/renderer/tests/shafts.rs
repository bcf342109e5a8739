//! The error of haze behind a gobo, against quadrature in f64.
//!
//! `LUMINAIRE_FULL=1 cargo test --release -p luminaire-render --lib shafts -- --nocapture` searches
//! longer, and prints the largest errors.

use super::*;
use crate::{
    light::{
        air::{Scattered, Seen, TileAir},
        rig::Rig,
    },
    scenes::{Example, gobos},
};
use core::f32::consts::TAU;
use glam::DVec3;
use luminaire::{
    Angle, Cone, SpotLight, Vec3,
    dynamic::AnyLight,
    falloff::{AnyFalloff, Falloff as _, Hard, Soft, Step},
    haze::Haze,
    projector::{Gobo, ProjectedPoint},
};
use std::{println, vec::Vec};

const BREAKUP: [u8; 64 * 64] = gobos::breakup();

/// A bar, whose edges have the whole slope of a gobo of few texels.
const BAR: [u8; 5 * 5] =
    [0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0];

/// Steps of the quadrature over the directions in the cone.
const STEPS: u32 = 2048;

fn exactly(v: impl Into<glam::Vec3>) -> DVec3 {
    v.into().as_dvec3()
}

/// A spotlight with a gobo in haze, in f64.
struct Exact {
    position: DVec3,
    axis: DVec3,
    right: DVec3,
    down: DVec3,
    versine: f64,
    radius: f64,
    gain: f64,
    falloff: AnyFalloff,
    gobo: Gobo<'static>,
}

impl Exact {
    fn new(fixture: &Fixture, haze: &Haze) -> Self {
        let AnyLight::Spot(spot) = fixture.light() else { panic!("expected a spotlight") };
        let (gobo, square) = fixture.gobo().expect("a gobo");
        let scale = 65_536.0 / (2.0 * f64::from(square.tangent()));
        Self {
            position: exactly(spot.position()),
            axis: exactly(spot.axis()),
            right: scale * exactly(square.right()),
            down: -scale * exactly(square.up()),
            versine: f64::from(spot.cone().outer_versine()),
            radius: f64::from(haze.source_radius()),
            gain: f64::from(spot.color().red) * f64::from(spot.intensity()) * f64::from(haze.density()) / 4.0,
            falloff: spot.cone().falloff(),
            gobo,
        }
    }

    /// Returns the in-scattering along a ray from the eye, and that without the gobo along the whole line
    /// of the ray; `None` if the ray passes through the light.
    ///
    /// The midpoint rule over the angle at the light. The gobo is that of the kernel.
    fn in_scattering(&self, eye: DVec3, direction: DVec3, length: f64) -> Option<[f64; 2]> {
        let offset = eye - self.position;
        let back = offset.dot(direction);
        let foot = offset - back * direction;
        let height = foot.length();
        if height < 1.01 * self.radius {
            return None;
        }
        let foot = foot / height;
        // The cosine of the angle off axis is `aside cos(angle) + along sin(angle)`.
        let (aside, along) = (foot.dot(self.axis), direction.dot(self.axis));
        let cosine = (1.0 - self.versine) / aside.hypot(along);
        if cosine >= 1.0 {
            return Some([0.0; 2]);
        }
        let (middle, half) = (along.atan2(aside), cosine.acos());
        let first = (middle - half).max((back / height).atan());
        let last = (middle + half).min(((back + length) / height).atan());
        if first >= last {
            return Some([0.0; 2]);
        }
        let (mut sum, mut whole) = (0.0, 0.0);
        let lit = |angle: f64| {
            let way = angle.cos() * foot + angle.sin() * direction;
            let t = 1.0 - (way - self.axis).length_squared() / (2.0 * self.versine);
            (way, self.falloff.formula().exact(t))
        };
        for i in 0..STEPS {
            let part = (f64::from(i) + 0.5) / f64::from(STEPS);
            let (way, light) = lit(first + (last - first) * part);
            let depth = way.dot(self.axis);
            let [column, row] =
                [self.right, self.down].map(|across| (way.dot(across) / depth + 32_768.0).floor() as i32);
            let place = ProjectedPoint::<f32> { column, row, depth: 1.0 };
            sum += light * f64::from(self.gobo.transmission(&place)) * (last - first);
            whole += lit(middle + half * (2.0 * part - 1.0)).1 * 2.0 * half;
        }
        Some([sum, whole].map(|sum| sum * self.gain / (f64::from(STEPS) * height)))
    }
}

/// The largest errors of pictures, in linear codes.
#[derive(Clone, Copy, Debug)]
struct Errors {
    shafts: f32,
    samples: f32,
    /// By shafts, relative to the light of the whole line of the ray through the beam without its gobo if
    /// that is over full scale: the lines are as near as this asks.
    relative: f32,
    /// The difference of the errors by shafts and by samples on a ray, relative to the same light.
    more: f32,
    rays: usize,
}

const NONE: Errors = Errors { shafts: 0.0, samples: 0.0, relative: 0.0, more: -255.0, rays: 0 };

impl Errors {
    fn and(self, other: Self) -> Self {
        Self {
            shafts: self.shafts.max(other.shafts),
            samples: self.samples.max(other.samples),
            relative: self.relative.max(other.relative),
            more: self.more.max(other.more),
            rays: self.rays + other.rays,
        }
    }
}

/// Returns the errors of a fixture at one pixel in `every`; none if the fixture is not seen by
/// shafts.
fn errors(renderer: &mut Renderer<f32>, fixture: &Fixture, every: usize) -> Errors {
    let haze = renderer.haze.expect("haze");
    let rig = Rig::<f32>::new(RenderPlan::new(), core::slice::from_ref(fixture), Some(haze)).unwrap();
    let exact = Exact::new(fixture, &haze);
    let (dark, mut scattered) = (Rgb::default().map(|()| [0.0; LANES]), Scattered::none());
    let mut errors = NONE;
    let mut number = 0;
    for tile in 0..renderer.tiles.tiles.len() {
        renderer.sight(tile);
        if !rig.is_seen_in_air(0, renderer.tiles.tiles[tile].sight.as_ref()) {
            continue;
        }
        let view = renderer.view.as_ref().unwrap();
        let eye = exactly(view.eye());
        let (hazy, way, beam) = rig.fixture(0).unwrap().in_air(&renderer.shadows, view.eye()).unwrap();
        if !matches!(beam.seen, Seen::Shafts(_)) {
            return errors;
        }
        let (rows, column) = renderer.tiles.place(tile);
        let columns = LANES.min(renderer.width - column * LANES);
        let found = [false, true].map(|is_each| {
            let place = (rows.clone(), column);
            let mut air = TileAir::new(view, &renderer.fragments, place, columns, &mut scattered);
            if is_each {
                air.add_each(hazy, &way);
            } else {
                air.add(hazy, &way, beam);
            }
            air.finish();
            scattered.rows().map(|row| row.copied().unwrap_or(dark)).collect::<Vec<_>>()
        });
        let (first, across, down) = view.rays(rows.start, column * LANES);
        for (y, x) in (0..rows.len()).flat_map(|y| (0..columns).map(move |x| (y, x))) {
            number += 1;
            if number % every != 0 {
                continue;
            }
            let nearness = f64::from(renderer.fragments.block(rows.start + y, column)[x]);
            let way = first + exactly(across) * x as f64 + exactly(down) * y as f64;
            let unit = way.length();
            let Some([truth, whole]) = exact.in_scattering(eye, way / unit, unit / nearness) else {
                continue;
            };
            let [shafts, samples] = [0, 1].map(|i| {
                let light = f64::from(found[i][y].red[x]);
                assert!(light >= 0.0, "{light}");
                255.0 * (light.min(1.0) - truth.min(1.0)).abs() as f32
            });
            let full = whole.max(1.0) as f32;
            let (relative, more) = (shafts / full, (shafts - samples) / full);
            errors = errors.and(Errors { shafts, samples, relative, more, rays: 1 });
        }
    }
    errors
}

/// The two gobos of the show from several cameras. Their samples err by codes.
#[test]
fn shafts_of_the_show_err_by_at_most_a_quarter_of_a_code() {
    let setup = Example::Show.setup().unwrap();
    let mut renderer = Renderer::<f32>::new(480, 270).unwrap();
    let mut all = NONE;
    for time in 0..if is_full() { 60 } else { 4 } {
        let time = time as f32;
        let mut camera = setup.camera;
        camera.orbit(0.3 * time, 0.05 * (time % 7.0));
        renderer.draw_geometry(&setup.scene, &camera);
        let fixtures = setup.fixtures_at(0.37 * time).unwrap();
        for fixture in fixtures.iter().filter(|fixture| fixture.gobo().is_some()) {
            all = all.and(errors(&mut renderer, fixture, if is_full() { 11 } else { 97 }));
        }
    }
    println!("show: {all:?}");
    assert!(all.shafts <= 0.25 && all.samples > 2.0 && all.rays > 500, "{all:?}");
}

/// Random numbers in [0, 1) that a view and a fixture are built from.
type Genes = [f32; 19];

fn case(genes: &Genes) -> Option<(Camera, Fixture)> {
    let target = Vec3::new(4.0 * genes[0] - 2.0, 0.2 + 2.5 * genes[1], 0.0);
    let distance = 0.3 * 60.0_f32.powf(genes[2]);
    let field_of_view = 0.02 * 60.0_f32.powf(genes[5]);
    let camera =
        Camera::new(target, distance, TAU * genes[3], 1.4 * genes[4] * genes[4] - 0.1, field_of_view);
    let [eye, target] = [camera.eye(), target].map(glam::Vec3::from);
    let offset = |genes: &[f32]| glam::Vec3::new(genes[0], genes[1], genes[2]) * 2.0 - 1.0;
    let position = eye + (target - eye) * 1.2 * genes[6] + offset(&genes[7..]) * 3.0 * genes[9] * genes[9];
    // Half of the fixtures point at something that is seen.
    let aim = if genes[13] < 0.5 { offset(&genes[10..]) } else { target - position + offset(&genes[10..]) };
    // Half of them are of the three kinds of edge, the others any.
    let mut numbers = genes[16..].iter().copied();
    let falloff = match (6.0 * genes[12]) as usize {
        0 => Soft.into(),
        1 => Hard.into(),
        2 => Step.into(),
        _ => {
            let index = (genes[16] * AnyFalloff::COUNT as f32) as usize;
            AnyFalloff::anywhere(index, || numbers.next().unwrap_or_default()).ok()?
        }
    };
    let cone = Cone::from_outer(falloff, Angle::degrees(0.6 * 240.0_f32.powf(genes[14]))).ok()?;
    let spot = SpotLight::new(position, aim, cone).ok()?;
    let spot = spot.with_intensity(2.0 * 500.0_f32.powf(genes[15])).ok()?;
    let gobo = match (4.0 * genes[9]) as usize {
        0 => Gobo::of(&STAR),
        1 => Gobo::of(&BREAKUP),
        2 => Gobo::of(&STRIPES),
        _ => Gobo::of(&BAR),
    };
    let fixture = Fixture::from(AnyLight::from(spot));
    Some((camera, fixture.with_gobo(gobo, Angle::degrees(360.0 * genes[8])).ok()?))
}

/// Random views and beams in pictures of random sizes, and climbs by bits from the worst of them.
#[test]
fn shafts_keep_their_bounds_in_a_search() {
    let (seeds, starts, steps) = if is_full() { (24, 200, 400) } else { (4, 30, 30) };
    let mut all = NONE;
    for seed in 0..seeds {
        let mut renderer = picture(seed);
        let (width, height) = (renderer.width, renderer.height);
        let haze = Haze::new(0.05).unwrap();
        let scene = hazy(if seed % 4 < 3 { haze } else { haze.with_source_radius(1.2).unwrap() });
        let worst = super::worst(seed, (starts, steps), |genes| {
            let Some((camera, fixture)) = case(genes) else { return f64::NEG_INFINITY };
            // Some cones are too narrow to be compiled.
            if fixture.light().compile::<f32>().is_err() {
                return f64::NEG_INFINITY;
            }
            renderer.draw_geometry(&scene, &camera);
            let found = errors(&mut renderer, &fixture, width * height / 31 + 1);
            all = all.and(found);
            // Half of the climbs look for errors, the others for those that samples do not have.
            f64::from(if seed % 2 == 0 { found.relative } else { found.more })
        });
        println!("seed {seed}: {width} x {height}, {worst:?}");
    }
    println!("{seeds} climbs of {} cases: {all:?}", starts + steps);
    assert!(all.relative <= 1.6 && all.more <= 0.95 && all.shafts < 0.2 * all.samples, "{all:?}");
    assert!(all.rays > 500, "{all:?}");
}
