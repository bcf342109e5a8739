//! The error of highlights: a bound that follows from the stages of each format, lights, points, eyes and normals
//! of the whole domain, and from the worst of them a climb by bits.
//!
//! `cargo test --test slow highlights:: -- --nocapture --test-threads 1` prints the bounds and what comes nearest
//! to them; `LUMINAIRE_FULL=1` searches 20 times as long.

use fastrand::Rng;
use luminaire::{
    Fx16, Fx32, Vec3,
    light::SurfacePoint,
    number::{Offset as _, Ray as _, Stages},
    specular::{BlinnPhong, DifferenceForm, DualConeLobe, Phong, SpecularLobe},
};
use std::f64::consts::FRAC_PI_2;
use support::{
    bounds,
    every::is_full,
    format::Format,
    oracle::{
        self, DVec3, Lobe,
        climb::{self, Search, Worst},
    },
    sweep,
};

/// Half a unit in the last place of 1 in f32.
const UNIT: f64 = f32::EPSILON as f64 / 2.0;

/// The roundings of a format that only highlights have.
trait Shining: Format {
    /// How far the mirror direction is off. It is twice the error of a cosine: the roundings of the components of a
    /// direction and of the sum in `Fx16`, of the sum and of the products in `Fx32`, of three products, two sums, and
    /// again a product and a difference in `f32`.
    const MIRRORED: f64;
    /// Of the half vector before it is normalised: what the components lose as they are halved.
    const HALVED: f64;
    /// Of the cosine `1 - y`, and of its power as a scalar. A product of less than any normal number counts as 0.
    const ENDS: [f64; 2];

    /// How far the product of two powers may be off, the least and the largest that each may be.
    fn product(least: [f64; 2], most: [f64; 2]) -> f64;
}

impl Shining for f32 {
    const MIRRORED: f64 = 9.0 * UNIT;
    const HALVED: f64 = 0.0;
    const ENDS: [f64; 2] = [UNIT, f32::MIN_POSITIVE as f64];

    fn product(_: [f64; 2], [a, b]: [f64; 2]) -> f64 {
        UNIT * a * b
    }
}

impl Shining for Fx32 {
    const MIRRORED: f64 = 3.733 / (1_u64 << 31) as f64;
    const HALVED: f64 = 0.867 / (1 << 30) as f64;
    const ENDS: [f64; 2] = [0.0, 0.75 / (1 << 30) as f64];

    fn product(_: [f64; 2], _: [f64; 2]) -> f64 {
        1.0 / (1_u64 << 32) as f64
    }
}

impl Shining for Fx16 {
    const MIRRORED: f64 = 5.465 / 65_536.0;
    const HALVED: f64 = 0.867 / (1 << 30) as f64;
    const ENDS: [f64; 2] = [0.0, 1.0 / 32_768.0];

    /// The lacks of both factors to 1 lose their lower 16 bits.
    fn product([a, b]: [f64; 2], _: [f64; 2]) -> f64 {
        (2.0 - a - b) / 65_536.0
    }
}

/// The errors of a direction: of its length, and across it.
#[derive(Clone, Copy)]
struct Bent {
    length: f64,
    turn: f64,
}

impl Bent {
    fn of(stages: &Stages) -> Self {
        Self { length: stages.length, turn: stages.turn }
    }

    /// The mirror direction of this one. A normal that is too long by `longer` moves it along itself by
    /// four times that times the cosine, which turns it by up to half of that.
    fn mirrored<S: Shining>(self, longer: f64) -> Self {
        Self {
            length: self.length + 4.01 * longer + S::MIRRORED,
            turn: self.turn + 2.01 * longer + S::MIRRORED,
        }
    }

    /// The half vector of two directions, of which `half` is half of their sum. The longer one of the two is too near
    /// to it. What turns a vector of a given length shortens it, too.
    fn half<S: Shining>(self, other: Self, half: f64) -> Self {
        let stages = S::stages(1e4);
        let across = (1.0 - half * half).max(0.0).sqrt();
        let off = (self.turn + other.turn + (self.length + other.length) * across) / 2.0;
        let turn = (off + S::HALVED) / half;
        Self { length: stages.length + turn * turn, turn: stages.turn + turn }
    }
}

/// A lobe, and where its bound comes from.
trait Bounded: SpecularLobe {
    const NAME: &'static str;
    const ORACLE: Lobe;
    /// Squarings of a difference form, 0 of a power.
    const SQUARINGS: u32 = 0;

    /// The errors of the two directions, from those to the light and to the eye.
    fn directions<S: Shining>(ways: [Bent; 2], longer: f64, half: f64) -> [Bent; 2];
}

impl Bounded for Phong {
    const NAME: &'static str = "Phong";
    const ORACLE: Lobe = oracle::phong;

    fn directions<S: Shining>([light, eye]: [Bent; 2], longer: f64, _: f64) -> [Bent; 2] {
        [light.mirrored::<S>(longer), eye]
    }
}

impl Bounded for BlinnPhong {
    const NAME: &'static str = "Blinn-Phong";
    const ORACLE: Lobe = oracle::blinn_phong;

    fn directions<S: Shining>([light, eye]: [Bent; 2], longer: f64, half: f64) -> [Bent; 2] {
        [Bent { length: longer, turn: 0.0 }, light.half::<S>(eye, half)]
    }
}

impl Bounded for DualConeLobe {
    const NAME: &'static str = "dual cone";
    const ORACLE: Lobe = oracle::dual_cone;

    fn directions<S: Shining>([light, eye]: [Bent; 2], longer: f64, half: f64) -> [Bent; 2] {
        [light.mirrored::<S>(longer), light.half::<S>(eye, half)]
    }
}

impl Bounded for DifferenceForm<Phong, 2> {
    const NAME: &'static str = "difference form";
    const ORACLE: Lobe = oracle::lyon;
    const SQUARINGS: u32 = 2;

    fn directions<S: Shining>(ways: [Bent; 2], longer: f64, half: f64) -> [Bent; 2] {
        Phong::directions::<S>(ways, longer, half)
    }
}

/// The bound of the error of a lobe where the versine of its two directions is `versine`.
fn bound<S: Shining, H: Bounded>(shininess: u32, directions: [Bent; 2], versine: f64) -> f64 {
    let stages = S::stages(1.0);
    let end = H::end(shininess);
    let zoom = S::magnification(end);
    let [length, turn] =
        [directions[0].length + directions[1].length, directions[0].turn + directions[1].turn];
    let turn = turn + stages.difference / zoom;
    let moved = (length + stages.versine.relative) * versine
        + turn * (2.0 * versine).sqrt()
        + (length + turn).powi(2) / 2.0
        + (stages.versine.absolute + 2.0 * stages.set_up) / (zoom * zoom);
    let [_, last] = S::ENDS;
    // At the least and the largest versine, and at the exact one.
    let versines = [versine + moved, (versine - moved).max(0.0), versine];
    if H::SQUARINGS > 0 {
        let [least, most, exact] = versines.map(|versine| (1.0 - versine / f64::from(end)).max(0.0));
        let off = stages.ramp.of(1.0) + stages.value.of(1.0);
        let squared = |[least, most, exact]: [f64; 3], _| {
            let off = stages.share.of(1.0);
            [(least * least - off).max(0.0), most * most + off, exact * exact]
        };
        let [least, most, exact] =
            (0..H::SQUARINGS).fold([(least - off).max(0.0), most + off, exact], squared);
        return (most - exact).max(exact - least);
    }
    let cosines = versines.map(|versine| (1.0 - versine).max(0.0));
    let [least, most, exact] = cosines.map(|cosine| cosine.powi(shininess as i32));
    let [least_cosine, most_cosine, _] = cosines;
    (most - exact).max(exact - least) + power_error::<S>([least_cosine, most_cosine], shininess) + last
}

/// The error of a power by repeated squaring, of a cosine between two.
fn power_error<S: Shining>(cosine: [f64; 2], shininess: u32) -> f64 {
    type Power = ([f64; 2], f64);
    let times = |([least_a, a], off_a): Power, ([least_b, b], off_b): Power| {
        let off = a * off_b + b * off_a + off_a * off_b + S::product([least_a, least_b], [a, b]);
        ([least_a * least_b, a * b], off)
    };
    let ((mut power, mut square), mut rest) = ((([1.0; 2], 0.0), (cosine, S::ENDS[0])), shininess);
    while rest > 0 {
        if rest % 2 == 1 {
            power = times(power, square);
        }
        square = times(square, square);
        rest /= 2;
    }
    power.1
}

/// The least half of the sum of the directions to the light and to the eye: 177 degrees apart.
const OPPOSITE: f64 = 0.026;

/// A light, a point that it lights, an eye and the point's normal.
#[derive(Clone, Copy, Debug)]
struct Sight {
    light: Vec3<f32>,
    point: Vec3<f32>,
    eye: Vec3<f32>,
    normal: Vec3<f32>,
    shininess: u32,
}

impl Sight {
    /// The largest coordinate and the distances of a format.
    fn domain<S: Format>() -> (f64, [f64; 2]) {
        if S::NAME == "f32" {
            (1e9, [1e-9, 1e9])
        } else {
            (f64::from(S::FARTHEST), [1.0 / 65_536.0, 50_000.0])
        }
    }

    /// Anywhere, more often where the lobe is, at grazing light, and near the point or far from it.
    fn somewhere<S: Format, H: SpecularLobe>(rng: &mut Rng) -> Self {
        let (farthest, [near, far]) = Self::domain::<S>();
        let least = H::LEAST_SHININESS;
        let shininess = match rng.u8(..4) {
            0 => least,
            1 => 1_024,
            _ => (f64::from(least) * (1_024.0 / f64::from(least)).powf(rng.f64())) as u32,
        };
        let width = 3.0 / f64::from(shininess).sqrt();
        let normal = sweep::direction(rng);
        let incidence = FRAC_PI_2 * if rng.bool() { rng.f64() } else { 1.0 - 1e-4_f64.powf(rng.f64()) };
        let to_light = sweep::direction_off(rng, normal, incidence);
        let mirror = (-to_light).reflect(normal);
        let middle = match rng.u8(..4) {
            0 => sweep::direction(rng),
            1 => (-to_light).reflect(mirror),
            _ => mirror,
        };
        let off = width * rng.f64();
        let to_eye = sweep::direction_off(rng, middle, off);
        let reach = farthest * 1e-8_f64.powf(rng.f64());
        let point = DVec3::from_array([0; 3].map(|_| match rng.u8(..8) {
            0 => reach,
            _ => reach * (2.0 * rng.f64() - 1.0),
        }));
        let distance = |rng: &mut Rng| near * (far / near).powf(rng.f64());
        let all = DVec3::splat(farthest);
        let [light, eye] =
            [to_light, to_eye].map(|way| sweep::single((point + distance(rng) * way).clamp(-all, all)));
        Self { light, point: sweep::single(point), eye, normal: sweep::single(normal), shininess }
    }

    fn moved<S: Format, H: SpecularLobe>(self, rng: &mut Rng) -> Self {
        let (farthest, _) = Self::domain::<S>();
        let size = climb::size(rng);
        let (mut sight, step) = (self, climb::grid_step(rng, size));
        let place = |c: f32| step(c).clamp(-farthest as f32, farthest as f32);
        match rng.u8(..8) {
            0 | 1 => {
                let bent = climb::one_of(rng, self.normal, |c| c + size);
                sight.normal = sweep::single(f32::exact_normal(bent).normalize_or_zero());
            }
            2 => {
                let more = (f64::from(self.shininess) * f64::from(1.0 + size)) as u32;
                sight.shininess = more.clamp(H::LEAST_SHININESS, 1_024);
            }
            3 | 4 => sight.light = climb::one_of(rng, self.light, place),
            5 | 6 => sight.eye = climb::one_of(rng, self.eye, place),
            _ => sight.point = climb::one_of(rng, self.point, place),
        }
        sight
    }

    /// The error of the lobe, and its bound; none where the surface faces away from the light or the eye, or
    /// where they are nearly opposite.
    fn errors<S: Shining, H: Bounded>(&self) -> Option<[f64; 2]> {
        let [light, point, eye] = [self.light, self.point, self.eye].map(S::point);
        let normal = S::normal(self.normal);
        let exact_normal = S::exact_normal(normal);
        let (longer, exact_normal) = ((exact_normal.length() - 1.0).abs(), exact_normal.normalize_or_zero());
        let ways = [light, eye].map(|place| S::exact_point(place) - S::exact_point(point));
        let distances = ways.map(DVec3::length);
        let [to_light, to_eye] = ways.map(DVec3::normalize_or_zero);
        let (_, [near, far]) = Self::domain::<S>();
        let is_near = distances.iter().any(|distance| !(0.99 * near..2.0 * far).contains(distance));
        let half = (to_light + to_eye).length() / 2.0;
        if is_near || to_light.dot(exact_normal) <= 0.0 || to_eye.dot(exact_normal) <= 0.0 || half < OPPOSITE
        {
            return None;
        }
        let incoming = S::Offset::between(light, point).ray().direction();
        let SurfacePoint { view, .. } = SurfacePoint::<S>::seen_from(eye, point, normal);
        let found = H::lobe::<S>(&H::constants::<S>(self.shininess), incoming, normal, view).exact();
        let exact = (H::ORACLE)(to_light, to_eye, exact_normal, self.shininess.into());
        let ways = distances.map(|distance| Bent::of(&S::stages(distance)));
        // The versine of a lobe of exponent 1.
        let versine = match H::SQUARINGS {
            0 => 1.0 - exact.powf(1.0 / f64::from(self.shininess)),
            n => (1.0 - exact.powf(0.5_f64.powi(n as i32))) * f64::from(H::end(self.shininess)),
        };
        let bound = bound::<S, H>(self.shininess, H::directions::<S>(ways, longer, half), versine);
        Some([oracle::counted((found - exact).abs()), bound])
    }
}

/// The largest bound of a shininess at any distance, of a normal that is rounded to the format, where the directions to
/// light and eye are up to 120 degrees apart.
fn largest<S: Shining, H: Bounded>(shininess: u32) -> f64 {
    let longer = if S::NAME == "fx16" { 0.867 / 16_384.0 } else { 1.001 * UNIT };
    let (_, [_, far]) = Sight::domain::<S>();
    let directions = H::directions::<S>([Bent::of(&S::stages(far)); 2], longer, 0.5);
    let versines = (0..=10_000).map(|i| (f64::from(i) / 10_000.0).powi(4));
    versines.map(|versine| bound::<S, H>(shininess, directions, versine)).fold(0.0, f64::max)
}

/// No highlight exceeds its bound, and the nearest one reaches 0.3 of it. The bounds of four exponents are those stated.
fn assert_bound<S: Shining, H: Bounded>(stated: [f64; 4]) {
    let search = if is_full() {
        Search { starts: 1_000_000, climbs: 400, steps: 20_000, seed: 1975 }
    } else {
        Search { starts: 20_000, climbs: 8, steps: 10_000, seed: 1975 }
    };
    let part = |sight: Sight| sight.errors::<S, H>().map_or(0.0, |[error, bound]| error / bound);
    let found = search.worst(Sight::somewhere::<S, H>, |rng, sight| sight.moved::<S, H>(rng), part);
    let Worst { input, error } = found.expect("an error");
    let bounds = [2, 32, 256, 1_024].map(|shininess| largest::<S, H>(shininess.max(H::LEAST_SHININESS)));
    println!("{} {}: {} ({error:.3} at {input:?})", H::NAME, S::NAME, bounds::shown(&bounds));
    assert!((0.3..=1.0).contains(&error), "{} {}: {error:.3} of the bound at {input:?}", H::NAME, S::NAME);
    for (bound, stated) in bounds.into_iter().zip(stated) {
        assert!((0.9 * stated..=stated).contains(&bound), "{} {}: {bound:.3e}", H::NAME, S::NAME);
    }
}

#[test]
fn phong_keeps_its_bound() {
    assert_bound::<f32, Phong>([2.2e-6, 6.7e-6, 3.5e-5, 1.3e-4]);
    assert_bound::<Fx32, Phong>([2.9e-7, 6.9e-7, 2.8e-6, 8.9e-6]);
    assert_bound::<Fx16, Phong>([7.3e-4, 1.3e-3, 3.1e-3, 6.0e-3]);
}

#[test]
fn blinn_phong_keeps_its_bound() {
    assert_bound::<f32, BlinnPhong>([2.0e-6, 7.5e-6, 3.7e-5, 1.3e-4]);
    assert_bound::<Fx32, BlinnPhong>([1.2e-7, 3.9e-7, 2.2e-6, 8.1e-6]);
    assert_bound::<Fx16, BlinnPhong>([7.6e-4, 2.0e-3, 5.3e-3, 1.1e-2]);
}

#[test]
fn the_dual_cone_keeps_its_bound() {
    assert_bound::<f32, DualConeLobe>([3.5e-6, 1.1e-5, 4.4e-5, 1.4e-4]);
    assert_bound::<Fx32, DualConeLobe>([3.5e-7, 8.7e-7, 3.2e-6, 9.6e-6]);
    assert_bound::<Fx16, DualConeLobe>([1.3e-3, 2.9e-3, 7.6e-3, 1.6e-2]);
}

#[test]
fn the_difference_form_keeps_its_bound() {
    assert_bound::<f32, DifferenceForm<Phong, 2>>([3.0e-6, 5.5e-6, 1.3e-5, 2.4e-5]);
    assert_bound::<Fx32, DifferenceForm<Phong, 2>>([3.2e-7, 6.2e-7, 1.6e-6, 2.9e-6]);
    assert_bound::<Fx16, DifferenceForm<Phong, 2>>([9.8e-4, 1.6e-3, 3.2e-3, 5.8e-3]);
}
