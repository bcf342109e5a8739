//! The error of haze as the renderer computes it, against a ray of the kernel through every pixel, and
//! against quadrature in f64 where the two differ.
//!
//! `LUMINAIRE_FULL=1 cargo test --release -p luminaire-render --lib haze -- --nocapture` searches
//! longer, and prints the largest errors.

use super::*;
use crate::{
    light::{
        air::{Scattered, Seen, TileAir},
        rig::Rig,
    },
    scenes::Example,
};
use core::{f32::consts::TAU, f64::consts::TAU as TAU64};
use glam::DVec3;
use luminaire::{
    Angle, Cone, HalfAngle, SpotLight, Vec3,
    attenuation::AnyAttenuation,
    dynamic::AnyLight,
    falloff::{AnyFalloff, Cubic, Falloff as _, IntegerPower, InvertedIntegerPower},
    haze::Haze,
    projector::Gobo,
};
use std::{println, vec, vec::Vec};

/// Largest error in linear codes: 1/255 of full scale, clipped at 1.
const BOUND: f64 = 0.5;

/// Difference from the kernel in linear codes from which on quadrature in f64 decides.
const DOUBTED: f64 = 0.02;

/// Distance of a ray from the silhouette of a light's body, in radii of the body, up to which it has no
/// error: the light jumps there.
const SILHOUETTE: f64 = 1e-4;

/// Nodes and weights of Gauss-Legendre quadrature with eight nodes.
const NODES: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_27),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// The light of a pass over all tiles, and the number of its rays.
type Air = (Vec<Radiance<f32>>, usize);

/// Returns the light of the beams that are seen by their formula, or of those with a ray of the kernel
/// through every pixel: as the renderer computes it, and by rays that no beam's sides cull.
fn air(renderer: &mut Renderer<f32>, fixtures: &[Fixture], is_open: bool) -> [Air; 2] {
    let rig = Rig::<f32>::new(RenderPlan::new(), fixtures, renderer.haze).unwrap();
    let stride = renderer.geometry.columns;
    let dark = Rgb::default().map(|()| [0.0; LANES]);
    let mut scattered = Scattered::none();
    let mut found = [(); 2].map(|()| (vec![dark; renderer.radiance.len()], 0));
    for tile in 0..renderer.tiles.tiles.len() {
        renderer.sight(tile);
        let sight = renderer.tiles.tiles[tile].sight.as_ref();
        let view = renderer.view.as_ref().unwrap();
        let (rows, column) = renderer.tiles.place(tile);
        let columns = LANES.min(renderer.width - column * LANES);
        for (is_each, (radiance, rays)) in found.iter_mut().enumerate() {
            let place = (rows.clone(), column);
            let mut air = TileAir::new(view, &renderer.fragments, place, columns, &mut scattered);
            for light in (0..fixtures.len()).filter(|&light| rig.is_seen_in_air(light, sight)) {
                let (hazy, way, beam) =
                    rig.fixture(light).unwrap().in_air(&renderer.shadows, view.eye()).unwrap();
                match (&beam.seen, is_each) {
                    (Seen::Open(_), _) if !is_open => {}
                    (Seen::Rays, _) if is_open => {}
                    (Seen::Shafts(_), _) => {}
                    (_, 0) => air.add(hazy, &way, beam),
                    _ => air.add_each(hazy, &way),
                }
            }
            *rays += air.finish();
            for (row, light) in rows.clone().zip(scattered.rows()) {
                radiance[row * stride + column] = light.copied().unwrap_or(dark);
            }
        }
    }
    found
}

/// The in-scattering in f64 of a fixture along a ray with a vector `way` to depth 1, by quadrature over
/// the angle at the light; `None` at the silhouette of the light's body.
fn exact(fixture: &Fixture, haze: &Haze, eye: DVec3, way: DVec3, nearness: f64) -> Option<f64> {
    let AnyLight::Spot(spot) = fixture.light() else { return Some(0.0) };
    let [position, axis] = [spot.position(), spot.axis()].map(|v| glam::Vec3::from(v).as_dvec3());
    let (offset, unit, axis) = (eye - position, way.normalize(), axis.normalize());
    let back = offset.dot(unit);
    let foot = offset - back * unit;
    let (height, radius) = (foot.length(), f64::from(haze.source_radius()));
    if (height - radius).abs() < SILHOUETTE * radius {
        return None;
    }
    let last = back + way.length() / nearness;
    let is_hit = height < radius && back < 0.0;
    let last = if is_hit { last.min(-(radius * radius - height * height).sqrt()) } else { last };
    let (across, along) = (foot.dot(axis) / height, unit.dot(axis));
    let (middle, cosine) = (along.atan2(across), across.hypot(along));
    let [inner, outer, _] = spot.cone().versines().map(f64::from);
    let (falloff, range) = (spot.cone().falloff(), back.atan2(height)..last.atan2(height));
    let intensity = |angle: f64| {
        let t = (outer - (1.0 - cosine * (angle - middle).cos())) / (outer - inner);
        falloff.formula().exact(t.clamp(0.0, 1.0))
    };
    let mut places = vec![range.start, range.end];
    for half in [inner, outer].map(|versine| ((1.0 - versine) / cosine).min(1.0).acos()) {
        places.extend(
            [-TAU64, 0.0, TAU64].iter().flat_map(|turn| [middle - half + turn, middle + half + turn]),
        );
    }
    places.iter_mut().for_each(|place| *place = place.max(range.start).min(range.end));
    places.sort_by(f64::total_cmp);
    let panel = |from: f64, to: f64| {
        let (half, middle) = (0.5 * (to - from), 0.5 * (to + from));
        let pair = |place: f64| intensity(middle - half * place) + intensity(middle + half * place);
        half * NODES.iter().map(|(place, weight)| weight * pair(*place)).sum::<f64>()
    };
    let part = |from: f64, to: f64| {
        let at = |i: i32| from + (to - from) * f64::from(i) / 8.0;
        (0..8).map(|i| panel(at(i), at(i + 1))).sum::<f64>()
    };
    let parts = places.windows(2).filter(|ends| ends[0] < ends[1]);
    let sum: f64 = parts.map(|ends| part(ends[0], ends[1])).sum();
    Some(sum * f64::from(spot.intensity()) * f64::from(haze.density()) / (4.0 * height))
}

/// Returns the light of a pixel in f64, of the beams that are seen by their formula; `None` at the
/// silhouette of a body.
fn exact_pixel(renderer: &Renderer<f32>, open: &[&Fixture], (x, y): (usize, usize)) -> Option<[f64; 3]> {
    let (view, haze) = (renderer.view.as_ref()?, renderer.haze?);
    let nearness = f64::from(renderer.fragments.block(y, x / LANES)[x % LANES]);
    let mut sum = [0.0; 3];
    for fixture in open {
        let light = exact(fixture, &haze, view.eye().as_dvec3(), view.rays(y, x).0, nearness)?;
        let Rgb { red, green, blue } = fixture.light().color();
        sum = [
            sum[0] + light * f64::from(red),
            sum[1] + light * f64::from(green),
            sum[2] + light * f64::from(blue),
        ];
    }
    Some(sum)
}

/// Returns the fixtures whose beams are seen by their formula.
fn open<'a>(renderer: &Renderer<f32>, fixtures: &'a [Fixture]) -> Vec<&'a Fixture> {
    let rig = Rig::<f32>::new(RenderPlan::new(), fixtures, renderer.haze).unwrap();
    let Some(view) = &renderer.view else { return Vec::new() };
    let is_open = |light: usize| {
        let (_, _, beam) = rig.fixture(light)?.in_air(&renderer.shadows, view.eye())?;
        matches!(beam.seen, Seen::Open(_)).then_some(&fixtures[light])
    };
    (0..fixtures.len()).filter_map(is_open).collect()
}

/// Returns the largest error in linear codes of beams by their formula, and the numbers of their rays per
/// pixel, with and without the beams' sides. All other beams must have the light of rays that no side
/// culls.
fn error(renderer: &mut Renderer<f32>, fixtures: &[Fixture]) -> (f64, [f32; 2]) {
    let pixels = (renderer.width * renderer.height) as f32;
    let [(culled, _), (each, _)] = air(renderer, fixtures, false);
    let [(found, few_rays), (kernel, each_rays)] = air(renderer, fixtures, true);
    let open = open(renderer, fixtures);
    let mut worst = 0.0_f64;
    for (x, y) in (0..renderer.width * renderer.height).map(|i| (i % renderer.width, i / renderer.width)) {
        let block = y * renderer.geometry.columns + x / LANES;
        let [culled, each, found, kernel] = [&culled, &each, &found, &kernel].map(|light| {
            let Rgb { red, green, blue } = &light[block];
            [red, green, blue].map(|channel| f64::from(channel[x % LANES]))
        });
        assert_eq!(culled, each, "at {x} {y}");
        assert!(found.iter().all(|&light| light >= 0.0), "{found:?} at {x} {y}");
        let off = |truth: [f64; 3]| {
            let off = (0..3).map(|i| 255.0 * (found[i].min(1.0) - truth[i].min(1.0)).abs());
            off.fold(0.0, |most, off| if off.is_nan() { f64::INFINITY } else { off.max(most) })
        };
        let error = off(kernel);
        let is_doubted = error > DOUBTED;
        let exact = is_doubted.then(|| exact_pixel(renderer, &open, (x, y)).map_or(0.0, off));
        worst = worst.max(exact.unwrap_or(error));
    }
    (worst, [few_rays, each_rays].map(|rays| rays as f32 / pixels))
}

/// Every hazy example from several cameras, at several times, with and without shadow maps, with its own
/// falloffs and with powers.
#[test]
fn haze_of_examples_errs_by_at_most_half_a_code() {
    let (width, height) = if is_full() { (960, 540) } else { (300, 170) };
    let [steep, steepest] = [12, 128].map(|exponent| IntegerPower::new(exponent).unwrap().into());
    let flat: AnyFalloff = InvertedIntegerPower::new(4).unwrap().into();
    let falloffs = [None, Some(steep), Some(steepest), Some(flat)];
    for (&example, falloff) in
        Example::ALL.iter().flat_map(|example| falloffs.map(|falloff| (example, falloff)))
    {
        let setup = example.setup().unwrap();
        if setup.scene.haze().is_none() {
            continue;
        }
        let (mut worst, mut count, mut sums) = (0.0_f64, 0.0, [0.0; 2]);
        let mut renderer = Renderer::<f32>::new(width, height).unwrap();
        for time in 0..if is_full() { 60 } else { 6 } {
            let time = time as f32;
            let mut camera = setup.camera;
            camera.orbit(0.7 * time, 0.05 * (time % 7.0) - 0.1);
            camera.zoom(1.0 - 0.08 * (time % 8.0));
            let mut fixtures = setup.fixtures_at(0.37 * time).unwrap();
            for fixture in &mut fixtures {
                if let (AnyLight::Spot(spot), Some(falloff)) = (*fixture.light(), falloff) {
                    *fixture = AnyLight::from(spot.with_cone(spot.cone().with_falloff(falloff))).into();
                }
                if time % 3.0 == 1.0 {
                    *fixture = fixture.with_shadow(64).unwrap();
                }
            }
            renderer.draw_geometry(&setup.scene, &camera);
            renderer.draw_shadows(&setup.scene, &fixtures).unwrap();
            let (error, rays) = error(&mut renderer, &fixtures);
            worst = worst.max(error);
            count += 1.0;
            sums = [sums[0] + rays[0], sums[1] + rays[1]];
        }
        let rays = sums.map(|sum| sum / count);
        println!("{} {falloff:?}: {worst:.3} linear codes, rays per pixel {rays:.3?}", example.name());
        assert!(worst <= BOUND, "{}: {worst} linear codes", example.name());
        assert!(rays[0] < 0.6 * rays[1] && rays[0] > 0.1, "{}: {rays:?} rays per pixel", example.name());
    }
}

/// Random numbers in [0, 1) that a [`Case`] is built from.
type Genes = [f32; GENES];

const GENES: usize = 8 + 2 * LIGHT;

/// Genes per light, of which the last are the numbers of its falloff and of its attenuation.
const LIGHT: usize = 14 + 8;

/// The view of a scene with a floor, a wall and round things, and one or two beams.
struct Case {
    camera: Camera,
    fixtures: Vec<Fixture>,
}

impl Case {
    /// The lights are in the scene, at the eye or behind it, and point anywhere, past the eye, away
    /// from it or across the line of sight.
    fn new(genes: &Genes) -> Option<Self> {
        let (view, lights) = genes.split_at(8);
        let target = Vec3::new(4.0 * view[0] - 2.0, 0.2 + 2.5 * view[1], 3.0 * view[2] - 1.5);
        let distance = 0.3 * 60.0_f32.powf(view[3]);
        let field_of_view = 0.02 * 60.0_f32.powf(view[6]);
        let camera =
            Camera::new(target, distance, TAU * view[4], 1.4 * view[5] * view[5] - 0.1, field_of_view);
        let count = if view[7] < 0.7 { 1 } else { 2 };
        let fixtures = lights.chunks(LIGHT).take(count).map(|genes| Self::fixture(genes, &camera, target));
        let fixtures: Vec<Fixture> = fixtures.collect::<Option<_>>()?;
        // Some cones are too narrow to be compiled.
        Rig::<f32>::new(RenderPlan::new(), &fixtures, None).ok()?;
        Some(Self { camera, fixtures })
    }

    fn fixture(genes: &[f32], camera: &Camera, target: Vec3<f32>) -> Option<Fixture> {
        let (eye, target) = (glam::Vec3::from(camera.eye()), glam::Vec3::from(target));
        let offset = |genes: &[f32]| glam::Vec3::new(genes[0], genes[1], genes[2]) * 2.0 - 1.0;
        let along = eye + (target - eye) * (2.0 * genes[1] - 0.4);
        let scale = 0.01 * 400.0_f32.powf(genes[2]);
        let position = match (4.0 * genes[0]) as usize {
            0 => glam::Vec3::new(0.0, 2.5, 0.0) + offset(&genes[3..]) * glam::Vec3::new(4.0, 2.0, 4.0),
            1 => eye + offset(&genes[3..]) * scale,
            _ => along + offset(&genes[3..]) * scale,
        };
        let aim = match (5.0 * genes[6]) as usize {
            0 => offset(&genes[7..]),
            1 => eye - position + offset(&genes[7..]) * scale,
            2 => position - eye + offset(&genes[7..]) * scale,
            3 => target - position + offset(&genes[7..]) * scale,
            _ => target - eye + offset(&genes[7..]) * 0.3,
        };
        let mut numbers = genes[14..].iter().copied();
        let mut number = || numbers.next().unwrap_or_default();
        let falloff = (genes[10] * AnyFalloff::COUNT as f32) as usize;
        let falloff = AnyFalloff::anywhere(falloff, &mut number).ok()?;
        let outer = 0.3 * 500.0_f32.powf(genes[11]);
        let mut cone = Cone::from_outer(falloff, Angle::degrees(outer)).ok()?;
        if genes[13] > 0.6 {
            cone = cone.with_inner(Angle::degrees(outer * (2.4 * genes[13] - 1.44))).ok()?;
        }
        let mut spot = SpotLight::new(Vec3::from(position), Vec3::from(aim), cone).ok()?;
        spot = spot.with_intensity(0.5 * 2000.0_f32.powf(genes[12])).ok()?;
        let dyed = Rgb::new(1.0, genes[9], genes[8]);
        let spot = spot.with_color(dyed).ok()?;
        let light = if genes[9] > 0.7 {
            let attenuation = (genes[8] * AnyAttenuation::COUNT as f32) as usize;
            AnyLight::from(spot.with_attenuation(AnyAttenuation::anywhere(attenuation, number).ok()?))
        } else {
            AnyLight::from(spot)
        };
        let fixture = Fixture::from(light);
        match (10.0 * genes[7]) as usize {
            0 => fixture.with_gobo(Gobo::of(&STAR), Angle::degrees(360.0 * genes[8])).ok(),
            1 => fixture.with_gobo(Gobo::of(&STRIPES), Angle::degrees(360.0 * genes[8])).ok(),
            2 => fixture.with_shadow(64).ok(),
            _ => Some(fixture),
        }
    }
}

/// Random views and beams in pictures of random sizes, and climbs by bits from the worst of them.
#[test]
fn haze_keeps_its_bound_in_a_search() {
    let (seeds, starts, steps) = if is_full() { (60, 400, 600) } else { (5, 60, 60) };
    let mut worst = 0.0_f64;
    for seed in 0..seeds {
        let mut renderer = picture(seed);
        let body = 0.001 * 500.0_f32.powf(Rng::with_seed(!seed).f32());
        let scene = hazy(Haze::new(0.05).and_then(|haze| haze.with_source_radius(body)).unwrap());
        let (found, genes) = super::worst(seed, (starts, steps), |genes| {
            let Some(case) = Case::new(genes) else { return 0.0 };
            renderer.draw_geometry(&scene, &case.camera);
            renderer.draw_shadows(&scene, &case.fixtures).unwrap();
            error(&mut renderer, &case.fixtures).0
        });
        if found > worst {
            worst = found;
            println!("seed {seed}: {worst:.3} linear codes at {genes:?}");
        }
    }
    println!("{seeds} climbs of {} cases: {worst:.3} linear codes", starts + steps);
    assert!(worst <= BOUND, "{worst} linear codes");
}

/// An arc much shorter than the beam is wide that still crosses a thin rim: the eye is in the cone, and some
/// rays pass close to the light.
#[test]
fn a_short_arc_through_a_thin_rim_keeps_the_bound() {
    let camera = Camera::new(Vec3::new(-0.2499, 2.6533, -0.8819), 0.4931673, 1.3406106, -0.04656, 0.9307208);
    let falloff = AnyFalloff::from(Cubic::with_slopes(2.872, 2.872).unwrap());
    let cone = Cone::from_outer(falloff, HalfAngle::degrees(54.056)).unwrap();
    let cone = cone.with_inner(HalfAngle::degrees(51.896)).unwrap();
    let position = Vec3::new(1.0262799, 2.4779537, 2.808998);
    let spot = SpotLight::new(position, Vec3::new(-0.7915, 0.42658, -0.43766), cone).unwrap();
    let fixtures = [Fixture::from(AnyLight::from(spot.with_intensity(999.99).unwrap()))];
    let scene = hazy(Haze::new(0.05).and_then(|haze| haze.with_source_radius(0.007_164_541)).unwrap());
    let mut renderer = Renderer::<f32>::new(126, 29).unwrap();
    renderer.draw_geometry(&scene, &camera);
    let (worst, _) = error(&mut renderer, &fixtures);
    assert!(worst <= BOUND, "{worst} linear codes");
}
