//! Measured lights against the table in f64, in every format and in their whole domain.
//!
//! `cargo test --test suite measured:: -- --nocapture --test-threads 1` prints the largest errors and the derived bounds;
//! `LUMINAIRE_FULL=1` looks 16 times as long.

use fastrand::Rng;
use luminaire::{
    Cone, Error, Fx16, Fx32, HalfAngle, MeasuredLight, SpotLight, Vec3,
    falloff::Soft,
    light::{CompiledMeasuredLight, Distribution, Symmetry},
};
use support::{
    assert_that,
    format::Format,
    in_every_format,
    oracle::{self, Attenuation, DVec3, Octahedron},
    sweep,
};

const SYMMETRIES: [Symmetry; 3] = [Symmetry::None, Symmetry::Bilateral, Symmetry::Quadrant];
const SIZES: [u32; 8] = [3, 5, 9, 17, 33, 65, 129, 257];

/// The samples of a distribution.
struct Table {
    samples: Vec<u16>,
    size: u32,
    symmetry: Symmetry,
}

impl Table {
    /// The table of a function of the direction, which is symmetric.
    fn of(size: u32, symmetry: Symmetry, intensity: impl Fn(DVec3) -> f64) -> Self {
        let folds = folds(symmetry);
        let from = folds.map(|folds| if folds { size / 2 } else { 0 });
        let place = |index: u32| f64::from(index) / f64::from(size - 1) * 2.0 - 1.0;
        let sample = |column, row| {
            let value = intensity(Octahedron::direction([place(column), place(row)]));
            (value.clamp(0.0, 1.0) * 65_535.0).round() as u16
        };
        let rows = from[1]..size;
        let samples = rows.flat_map(|row| (from[0]..size).map(move |column| (column, row)));
        Self { samples: samples.map(|(column, row)| sample(column, row)).collect(), size, symmetry }
    }

    /// Random samples: of any size, or of directions within an angle of the axis alone.
    fn random(rng: &mut Rng, size: u32, symmetry: Symmetry) -> Self {
        let (steep, end) = (rng.bool(), if rng.bool() { -1.0 } else { rng.f64() });
        let values: Vec<u16> = (0..size * size).map(|_| rng.u16(..)).collect();
        let folded = |c: f64, folds| if folds { c.abs() } else { c };
        let [fold_x, fold_y] = folds(symmetry);
        Self::of(size, symmetry, |way| {
            let way = DVec3::new(folded(way.x, fold_x), folded(way.y, fold_y), way.z);
            if way.z < end {
                return 0.0;
            }
            // On an edge, both places of a direction have the magnitudes of one.
            let [x, y] = Octahedron::place(way);
            let on_edge = x.abs().max(y.abs()) > 1.0 - 1e-9;
            let index =
                |c: f64| (((if on_edge { c.abs() } else { c }) + 1.0) / 2.0 * f64::from(size - 1)).round();
            if steep {
                f64::from(values[(index(y) * f64::from(size) + index(x)) as usize]) / 65_535.0
            } else {
                0.5 + 0.3 * (2.0 * way.x + 1.0).sin() * (3.0 * way.y).cos() + 0.2 * way.z
            }
        })
    }

    fn distribution(&self) -> Distribution<'_> {
        Distribution::new(&self.samples, self.size, self.symmetry).expect("a sound table")
    }

    fn exact(&self) -> Octahedron<'_> {
        Octahedron { samples: &self.samples, size: self.size as usize, folds: folds(self.symmetry) }
    }
}

fn folds(symmetry: Symmetry) -> [bool; 2] {
    match symmetry {
        Symmetry::None => [false; 2],
        Symmetry::Bilateral => [false, true],
        Symmetry::Quadrant => [true; 2],
    }
}

/// A light at random, and what the format has stored of it.
fn stored<'a, S: Format>(
    rng: &mut Rng,
    table: &'a Table,
    intensity: f32,
) -> (MeasuredLight<'a>, oracle::MeasuredLight<'a>) {
    let light = loop {
        let axes = [(); 2].map(|()| sweep::single(sweep::direction(rng)));
        let position = sweep::single(sweep::position(rng));
        if let Ok(light) = MeasuredLight::new(position, axes[0], axes[1], table.distribution()) {
            break light.with_intensity(intensity).expect("a sound intensity");
        }
    };
    let exact = |axis: Vec3<f32>| DVec3::new(axis.x.into(), axis.y.into(), axis.z.into());
    let exact = oracle::MeasuredLight {
        position: S::exact_point(light.position().map(S::length)),
        axis: exact(light.given_axis()),
        side: exact(light.given_side()),
        table: table.exact(),
        intensity: intensity.into(),
        attenuation: Attenuation::InverseSquare,
    };
    (light, exact)
}

/// A direction: anywhere, or on a fold, an edge or a corner of the square and beside it.
fn direction(rng: &mut Rng, light: &oracle::MeasuredLight<'_>) -> DVec3 {
    let way = sweep::direction(rng);
    if rng.bool() {
        return way;
    }
    let [axis, side] = [light.axis.normalize(), light.side.reject_from(light.axis).normalize()];
    let mut local = light.local(way);
    let near = 1e-9_f64.powf(rng.f64()) * (rng.f64() - 0.5);
    local[rng.usize(..3)] = near;
    if rng.bool() {
        local[rng.usize(..3)] = near;
    }
    (local.x * side + local.y * side.cross(axis) + local.z * axis).try_normalize().unwrap_or(way)
}

fn clipped(light: f64) -> f64 {
    light.min(1.0)
}

/// The largest error within the bound, in linear codes, and its largest share of the bound: from 2e-4 units to 24,000.
fn errors<S: Format>(seed: u64) -> [f64; 2] {
    let mut rng = Rng::with_seed(seed);
    let mut worst = [0.0_f64; 2];
    for i in 0..240 * sweep::effort() {
        let table = Table::random(&mut rng, SIZES[i % 8], SYMMETRIES[i / 8 % 3]);
        let near = [2e-4, 0.5, 2.0, 8.0, 100.0, 12_000.0][rng.usize(..6)];
        let intensity = (near * near * 64_f32.powf(rng.f32() - 0.5)).min(1e9);
        let (light, exact) = stored::<S>(&mut rng, &table, intensity);
        let bound = f64::from(light.error_bound::<S>(near..=2.0 * near).expect("a bound").light);
        let lit = light.compile::<S>().expect("held");
        for _ in 0..400 {
            let way = direction(&mut rng, &exact);
            let distance = f64::from(near) * (1.01 + 0.98 * rng.f64());
            let point = sweep::single(sweep::on_grid(exact.position + distance * way)).map(S::length);
            let distance = (S::exact_point(point) - exact.position).length() / f64::from(near);
            if !(1.0..=2.0).contains(&distance) {
                continue;
            }
            let normal = if rng.bool() { -way } else { sweep::direction(&mut rng) };
            let normal = sweep::single(normal).map(S::from_f32);
            let found = S::exact_light(lit.irradiance(point, normal));
            let truth = exact.irradiance(S::exact_point(point), S::exact_normal(normal));
            let error = (clipped(found) - clipped(truth)).abs();
            let shape = (S::NAME, table.size, table.symmetry);
            assert!(error <= bound, "{shape:?}: {found}, expected {truth} within {bound}, {way} {near}");
            let unskipped = S::exact_light(lit.irradiance_unskipped(point, normal));
            assert_eq!(unskipped, found, "{shape:?} at {way}");
            worst = [worst[0].max(255.0 * error), worst[1].max(error / bound)];
        }
    }
    worst
}

#[test]
fn every_light_is_within_its_bound() {
    for (name, [codes, share], least) in
        [("f32", errors::<f32>(1), 0.04), ("fx32", errors::<Fx32>(2), 0.04), ("fx16", errors::<Fx16>(3), 0.5)]
    {
        println!("{name}: {codes:.2e} linear codes, at most {share:.2} of the bound");
        assert!((least..=1.0).contains(&share), "{name}: {share} of the bound");
    }
}

/// The model of the library is that of the oracle, which finds a place by other steps.
#[test]
fn the_exact_model_is_that_of_the_oracle() {
    let mut rng = Rng::with_seed(65);
    for i in 0..48 {
        let table = Table::random(&mut rng, SIZES[i % 8], SYMMETRIES[i / 8 % 3]);
        let (light, exact) = stored::<f32>(&mut rng, &table, 2.0);
        for _ in 0..500 {
            let way = direction(&mut rng, &exact);
            let local = exact.local(way);
            let found = table.distribution().exact(local.to_array());
            assert_that!((found - exact.table.at(local)).abs() < 1e-12, found, local);
            let found = light.exact_intensity(Vec3::new(way.x, way.y, way.z));
            assert_that!((found - 2.0 * exact.table.at(local)).abs() < 1e-9, found, local);
        }
        let [nothing, nan] = [[0.0; 3], [0.0, f64::NAN, 1.0]].map(|way| table.distribution().exact(way));
        assert_eq!([nothing, nan], [0.0; 2]);
    }
}

/// A light whose frame is that of the coordinates: side x, front z and axis -y.
fn hung(table: &Table, position: [f32; 3]) -> MeasuredLight<'_> {
    MeasuredLight::new(position, [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], table.distribution()).expect("sound")
}

/// The front of a light that points down, with its side along x, is towards -z: the way that a viewer at the light
/// sees as up.
#[test]
fn the_frame_is_right_handed() {
    let table = Table::of(5, Symmetry::None, |way| way.y.max(0.0));
    let light = hung(&table, [0.0; 3]);
    let close = |found: Vec3<f32>, [x, y, z]: [f32; 3]| {
        (found.x - x).abs() + (found.y - y).abs() + (found.z - z).abs() < 1e-6
    };
    let frame = light.frame();
    assert_that!(close(frame[0], [1.0, 0.0, 0.0]), frame);
    assert_that!(close(frame[1], [0.0, 0.0, -1.0]), frame);
    assert_that!(close(frame[2], [0.0, -1.0, 0.0]), frame);
    let lit = light.compile::<f32>().expect("held");
    let at = |z| lit.irradiance(Vec3::new(0.0, 0.0, z), Vec3::new(0.0, 0.0, -z));
    assert_eq!([at(-1.0), at(1.0)], [1.0, 0.0]);
}

/// On its axes and between two of them, a light has the values of the samples there, within the step of the format.
fn assert_axes<S: Format>() {
    let mut rng = Rng::with_seed(6);
    for symmetry in SYMMETRIES {
        let table = Table::random(&mut rng, 65, symmetry);
        let lit = hung(&table, [0.0; 3]).compile::<S>().expect("held");
        for way in (0..27).map(|i| DVec3::new((i % 3 - 1).into(), (i / 3 % 3 - 1).into(), (i / 9 - 1).into()))
        {
            let square = way.length_squared();
            if square == 0.0 {
                continue;
            }
            let facing = sweep::single(-way.normalize()).map(S::from_f32);
            let found = S::exact_light(lit.irradiance(sweep::single(way).map(S::length), facing));
            let exact = table.exact().at(DVec3::new(way.x, -way.z, -way.y)) / square;
            assert_that!((found - exact).abs() < 4.0 * f64::from(S::STEP).max(2e-7), way, found, exact);
        }
    }
}

#[test]
fn axes_have_their_samples() {
    in_every_format!(assert_axes);
}

/// Next to the light, at it, and with components that are no numbers: zero or some light, and no panic.
fn assert_ends<S: Format>() {
    let mut rng = Rng::with_seed(8);
    for i in 0..48 {
        let table = Table::random(&mut rng, SIZES[i % 8], SYMMETRIES[i / 8 % 3]);
        let farthest = S::FARTHEST.min(1e9);
        let position = [farthest, -farthest, if i % 2 == 0 { farthest } else { 0.0 }];
        let light = hung(&table, position).with_intensity(1e9).expect("sound");
        let lit = light.compile::<S>().expect("held");
        let normals =
            [[0.0, 1.0, 0.0], [0.6, 0.0, 0.8], [-1.0, 0.0, 0.0]].map(|n| Vec3::from(n).map(S::from_f32));
        for normal in normals {
            assert_eq!(S::exact_light(lit.irradiance(light.position().map(S::length), normal)), 0.0);
        }
        // The other end of the coordinates.
        let far = Vec3::from(position).map(|c| S::length(if c > 0.0 { -32_768.0 } else { 32_767.9 }));
        let exact = oracle::MeasuredLight {
            position: S::exact_point(light.position().map(S::length)),
            axis: -DVec3::Y,
            side: DVec3::X,
            table: table.exact(),
            intensity: 1e9,
            attenuation: Attenuation::InverseSquare,
        };
        let way = S::exact_point(far) - exact.position;
        let distance = way.length() as f32;
        let facing = sweep::single(-way.normalize()).map(S::from_f32);
        let found = S::exact_light(lit.irradiance(far, facing));
        let truth = exact.irradiance(S::exact_point(far), S::exact_normal(facing));
        let bound = light.error_bound::<S>(0.999 * distance..=1.001 * distance).expect("a bound").light;
        assert_that!((clipped(found) - clipped(truth)).abs() <= f64::from(bound), found, truth, bound);
    }
    let table = Table::of(9, Symmetry::Bilateral, |_| 1.0);
    let beyond = hung(&table, [0.0, 1.1 * S::FARTHEST.min(1e9), 0.0]).compile::<S>();
    assert_eq!(beyond.is_ok(), S::FARTHEST == f32::MAX);
}

#[test]
fn lights_hold_at_the_ends_of_coordinates() {
    in_every_format!(assert_ends);
}

#[test]
fn no_number_is_no_light() {
    let table = Table::of(9, Symmetry::None, |_| 1.0);
    let lit = hung(&table, [0.0; 3]).with_intensity(1e9).expect("sound").compile::<f32>().expect("held");
    let up = Vec3::new(0.0, 1.0, 0.0);
    for strange in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX] {
        for point in [[strange, -1.0, 0.0], [0.0, -strange.abs(), 0.0], [strange; 3]] {
            assert_eq!(lit.irradiance_unskipped(Vec3::from(point), up), 0.0, "{point:?}");
        }
        if strange != f32::MAX {
            let normal = Vec3::new(0.0, strange, f32::NAN);
            assert_eq!(lit.irradiance_unskipped(Vec3::new(0.0, -1.0, 0.0), normal), 0.0, "{strange}");
        }
    }
    let dark = lit.irradiance_unskipped(Vec3::new(0.0, -1e-20, 0.0), up);
    assert_eq!(dark, 0.0, "its squared distance is no normal number");
}

/// The table of the same light in another frame: its side along the first of these components of the old frame, its
/// front along the second, each with a sign.
fn turned(table: &Table, map: impl Fn(DVec3) -> DVec3) -> Table {
    let exact = table.exact();
    Table::of(table.size, Symmetry::None, |way| exact.at(map(way)))
}

/// A mirrored table is the mirrored light, a table turned by right angles the turned light, and one whose side and
/// front are exchanged the light that is mirrored between them, each within twice the bound.
fn assert_laws<S: Format>() {
    let mut rng = Rng::with_seed(9);
    type Map = fn(DVec3) -> DVec3;
    let maps: [(&str, Map); 5] = [
        ("mirrored front", |d| DVec3::new(d.x, -d.y, d.z)),
        ("mirrored side", |d| DVec3::new(-d.x, d.y, d.z)),
        ("half a turn", |d| DVec3::new(-d.x, -d.y, d.z)),
        ("a quarter", |d| DVec3::new(-d.y, d.x, d.z)),
        ("exchanged", |d| DVec3::new(d.y, d.x, d.z)),
    ];
    for symmetry in SYMMETRIES {
        let table = Table::random(&mut rng, 17, symmetry);
        let light = hung(&table, [0.0; 3]);
        let bound = 2.0 * f64::from(light.error_bound::<S>(1.0..=3.0).expect("a bound").light);
        let lit = light.compile::<S>().expect("held");
        for (name, map) in maps {
            let other = turned(&table, map);
            let other = hung(&other, [0.0; 3]).compile::<S>().expect("held");
            for _ in 0..500 {
                let way = sweep::on_grid(2.0 * sweep::direction(&mut rng));
                let local = map(DVec3::new(way.x, -way.z, -way.y));
                let mapped = DVec3::new(local.x, -local.z, -local.y);
                let at = |lit: &CompiledMeasuredLight<'_, S>, way: DVec3| {
                    let facing = sweep::single(-way.normalize()).map(S::from_f32);
                    S::exact_light(lit.irradiance(sweep::single(way).map(S::length), facing))
                };
                let difference = (at(&other, way) - at(&lit, mapped)).abs();
                assert!(difference <= bound, "{} {symmetry:?}, {name}: {difference} at {way}", S::NAME);
            }
        }
        // A folded table is the whole one, and on the side of its samples fixed point has the same bits.
        let whole = turned(&table, |d| d);
        let whole = hung(&whole, [0.0; 3]).compile::<S>().expect("held");
        for _ in 0..500 {
            let way = sweep::on_grid(2.0 * sweep::direction(&mut rng));
            let point = sweep::single(DVec3::new(way.x.abs(), way.y, -way.z.abs())).map(S::length);
            let facing = sweep::single(-way.normalize()).map(S::from_f32);
            let [whole, folded] = [&whole, &lit].map(|lit| S::exact_light(lit.irradiance(point, facing)));
            let most = if S::NAME == "f32" { bound } else { 0.0 };
            assert!((whole - folded).abs() <= most, "{} {symmetry:?}: {whole} {folded} at {way}", S::NAME);
        }
    }
}

#[test]
fn mirrored_and_turned_tables_are_the_mirrored_and_turned_light() {
    in_every_format!(assert_laws);
}

/// The table of a round light is that light, within both bounds and what the table differs from its curve.
fn assert_round<S: Format>() {
    let cone = Cone::from_outer(Soft, HalfAngle::degrees(80.0)).expect("a cone");
    let exact = oracle::Cone::new(oracle::soft, oracle::versine(80.0));
    let table = Table::of(129, Symmetry::Quadrant, |way| exact.falloff(1.0 - way.z));
    let (position, mut rng) = ([0.0, 1.0, 0.0], Rng::with_seed(10));
    let mut residual = 0.0_f64;
    for _ in 0..100_000 {
        let way = sweep::direction(&mut rng);
        residual = residual.max((table.exact().at(way) - exact.falloff(1.0 - way.z)).abs());
    }
    assert_that!((1e-5..0.5 / 255.0).contains(&residual), residual);
    let spot = SpotLight::new(position, [0.0, -1.0, 0.0], cone).expect("sound");
    let measured = hung(&table, position);
    let bounds = [spot.error_bound::<S>(1.0..=9.0), measured.error_bound::<S>(1.0..=9.0)];
    let bound = bounds.map(|bound| f64::from(bound.expect("a bound").light)).iter().sum::<f64>();
    let (spot, measured) = (spot.compile::<S>().expect("held"), measured.compile::<S>().expect("held"));
    for _ in 0..5_000 {
        let [x, z] = [(); 2].map(|()| 10.0 * rng.f32() - 5.0);
        let (point, up) = (Vec3::new(x, 0.0, z).map(S::length), Vec3::new(0.0, 1.0, 0.0).map(S::from_f32));
        let [a, b] = [spot.irradiance(point, up), measured.irradiance(point, up)].map(S::exact_light);
        assert_that!((a - b).abs() <= bound + residual, a, b, bound, residual);
    }
}

#[test]
fn a_round_table_is_the_round_light() {
    in_every_format!(assert_round);
}

/// A light that is moved, aimed and turned at run time is that which is compiled there.
fn assert_changes<S: Format>(turn: f64) {
    let mut rng = Rng::with_seed(11);
    let table = Table::random(&mut rng, 17, Symmetry::None);
    let mut worst = 0.0_f64;
    for _ in 0..5_000 {
        let lit = stored::<S>(&mut rng, &table, 4.0).0.compile::<S>().expect("held");
        let [position, target, side] =
            [(); 3].map(|()| sweep::single(sweep::position(&mut rng)).map(S::length));
        let aimed = lit.moved_to(position).aimed_at(target).expect("another place");
        let (aimed, wanted) = if rng.bool() {
            (aimed.turned_to(side).expect("another direction"), S::exact_point(side).normalize())
        } else {
            (aimed, S::exact_direction(lit.frame()[0]))
        };
        assert_eq!(aimed.position(), position);
        let [side, front, axis] = aimed.frame().map(S::exact_direction);
        let way = (S::exact_point(target) - S::exact_point(position)).normalize();
        let exact = wanted.reject_from_normalized(way);
        let beside = side.cross(exact.normalize()).length();
        let errors = [beside, side.dot(axis).abs(), front.dot(axis).abs(), front.dot(side).abs()];
        let error = errors.into_iter().fold(0.0, f64::max) * exact.length();
        worst = worst.max(error).max(axis.distance(way));
        assert_that!(side.dot(exact) > 0.0 && side.cross(axis).dot(front) > 0.9, side, front, axis);
        let along = S::exact_point(target) - S::exact_point(position);
        let along = lit.aimed_along(sweep::single(along).map(S::length)).expect("a direction");
        assert_that!((S::exact_direction(along.frame()[2]) - way).length() < 1e-5, way);
    }
    println!("{}: {worst:.2e} radians", S::NAME);
    assert_that!((turn / 10.0..=turn).contains(&worst), worst);
    let lit = hung(&table, [0.0; 3]).compile::<S>().expect("held");
    let nowhere = Vec3::new(0.0, 0.0, 0.0).map(S::length);
    let side = Vec3::new(1.0, 0.0, 0.0).map(S::length);
    let down = Vec3::new(0.0, -2.0, 0.0).map(S::length);
    assert!(lit.aimed_at(nowhere).is_none() && lit.aimed_along(nowhere).is_none());
    assert!(lit.aimed_along(side).is_none() && lit.turned_to(down).is_none(), "{}", S::NAME);
    let dimmed = lit.dimmed(S::from_f32(0.5));
    let at = |lit: &CompiledMeasuredLight<'_, S>| {
        S::exact_light(lit.irradiance(down, Vec3::new(0.0, 1.0, 0.0).map(S::from_f32)))
    };
    assert_that!((2.0 * at(&dimmed) - at(&lit)).abs() < 2e-4, at(&dimmed), at(&lit));
}

#[test]
fn lights_move_aim_and_turn() {
    assert_changes::<f32>(7e-7);
    assert_changes::<Fx32>(2.1e-8);
    assert_changes::<Fx16>(2.1e-8);
}

/// Only what ends within a right angle leaves spheres out, and none of those that it lights.
fn assert_reach<S: Format>() {
    let mut rng = Rng::with_seed(12);
    let (mut skipped, mut everywhere) = (0, 0);
    for i in 0..200 {
        let end = rng.f64() * 1.2 - 0.4;
        let table = Table::of(SIZES[2 + i % 5], SYMMETRIES[i % 3], |way| if way.z > end { 1.0 } else { 0.0 });
        let light = hung(&table, [0.0; 3]);
        if let Some(outer) = light.outer() {
            // All samples up to a cell beyond the end are in the cone.
            let half = f64::from(outer.to_degrees()).to_radians() / 2.0;
            assert_that!(end > -0.01 && half.cos() <= end, end, half);
        }
        let lit = light.compile::<S>().expect("held");
        let center = 4.0 * sweep::direction(&mut rng);
        let radius = 2.0 * rng.f64();
        let reached = lit.can_reach(sweep::single(center).map(S::length), S::length(radius as f32));
        skipped += usize::from(!reached);
        everywhere += usize::from(reached && end < 0.0);
        if reached {
            continue;
        }
        assert_that!(end > -0.05, end);
        for _ in 0..200 {
            let point = center + 0.999 * radius * sweep::direction(&mut rng);
            let facing = sweep::single(-point.normalize()).map(S::from_f32);
            assert_eq!(
                S::exact_light(lit.irradiance_unskipped(sweep::single(point).map(S::length), facing)),
                0.0
            );
        }
    }
    assert!(skipped > 20 && everywhere > 20, "{}: {skipped} {everywhere}", S::NAME);
}

#[test]
fn spheres_without_light_are_told() {
    in_every_format!(assert_reach);
}

#[test]
fn distributions_that_are_none_are_refused() {
    let refused = |result: Result<Distribution<'_>, Error>| result.expect_err("a refusal").to_string();
    let samples = [7; 65 * 65];
    for size in [0, 1, 2, 4, 64, 66, 513, u32::MAX] {
        let found = refused(Distribution::new(&samples, size, Symmetry::None));
        let expected = "expected a power of two and one, from 3 to 257";
        assert!(found.starts_with("size of the distribution = ") && found.ends_with(expected), "{found}");
    }
    for (size, symmetry, count) in [
        (3, Symmetry::None, 9),
        (3, Symmetry::Bilateral, 6),
        (3, Symmetry::Quadrant, 4),
        (17, Symmetry::Bilateral, 17 * 9),
        (65, Symmetry::Quadrant, 33 * 33),
    ] {
        assert!(Distribution::new(&samples[..count], size, symmetry).is_ok());
        for other in [count - 1, count + 1] {
            let found = refused(Distribution::new(&samples[..other], size, symmetry));
            assert_eq!(found, format!("number of samples = {other}: expected {count}"));
        }
    }
    for (symmetry, bytes) in
        [(Symmetry::None, 8_450), (Symmetry::Bilateral, 4_290), (Symmetry::Quadrant, 2_178)]
    {
        let table = Table::of(65, symmetry, |_| 1.0);
        assert_eq!(size_of_val(table.distribution().samples()), bytes);
    }
    // Each sample of an edge has a partner, but for those in the middle.
    for (symmetry, count, edges) in
        [(Symmetry::None, 25, 12), (Symmetry::Bilateral, 15, 4), (Symmetry::Quadrant, 9, 0)]
    {
        let mut wrong = 0;
        for at in 0..count {
            let mut samples = [7; 25];
            samples[at] = 5;
            if let Err(error) = Distribution::new(&samples[..count], 5, symmetry) {
                let found = error.to_string();
                assert!(
                    found.starts_with("sample on the edge = ") && found.ends_with("other half of this edge"),
                    "{found}"
                );
                wrong += 1;
            }
        }
        assert_eq!(wrong, edges, "{symmetry:?}");
    }
}

#[test]
fn axes_of_a_light_are_apart() {
    let table = Table::of(3, Symmetry::Quadrant, |_| 1.0);
    let light = |axis, side| MeasuredLight::new([0.0; 3], axis, side, table.distribution());
    let at = |degrees: f32| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        light([0.0, -1.0, 0.0], [sine, -cosine, 0.0])
    };
    assert!([6.01, 90.0, 173.99, -40.0].into_iter().all(|degrees| at(degrees).is_ok()));
    for (degrees, shown) in [(0.0, "0"), (5.0, "5"), (178.0, "178")] {
        let found = at(degrees).expect_err("a refusal").to_string();
        let [number, expected] =
            ["angle between axis and side = ", ": expected a finite number from 6 to 174 degrees"];
        assert!(found.starts_with(number) && found.ends_with(expected) && found.contains(shown), "{found}");
    }
    let zero = light([0.0, -1.0, 0.0], [0.0; 3]).expect_err("no direction").to_string();
    assert_eq!(zero, "side = 0: expected finite components and a length between 1e-18 and 1e18");
    let zero = light([0.0; 3], [1.0, 0.0, 0.0]).expect_err("no direction").to_string();
    assert!(zero.starts_with("axis = 0: "), "{zero}");
    assert!(
        MeasuredLight::new([f32::NAN, 0.0, 0.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], table.distribution())
            .is_err()
    );
}
