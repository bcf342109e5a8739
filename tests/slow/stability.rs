//! Stability in time: while a light pans, moves, dims or follows a point by one quantum a frame, or a
//! point moves so, no pixel goes far against its true trend.
//!
//! While the exact light of a pixel rises, the largest fall of the pixel from its highest value so
//! far is a reversal, and so is the largest rise while it falls: in linear codes, clipped at full
//! scale.
//!
//! `cargo test --test slow stability:: -- --nocapture --test-threads 1` prints the rows;
//! `LUMINAIRE_FULL=1` looks 16 times as long.

use std::ops::Range;

use fastrand::Rng;
use luminaire::{
    Cone, Fx16, Fx32, SpotLight, Vec3,
    attenuation::{Attenuation, InverseSquare, NoAttenuation},
    falloff::AnyFalloff,
};
use support::{
    falloffs::{Shape, four},
    format::Format,
    oracle::{self, DVec3},
    sweep,
};

/// Frames of one motion, and pixels that are watched.
const FRAMES: usize = 1_500;
const PIXELS: usize = 4;

/// What changes by a quantum each frame.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Motion {
    /// The axis of the light: a component of it by the smallest step of f32.
    Pan,
    /// The position of the light.
    Light,
    /// The surface points.
    Point,
    /// The intensity falls by 2^-16 of itself.
    Dim,
    /// The position of the light, which is aimed again at a point that stays.
    Follow,
}

const MOTIONS: [Motion; 5] = [Motion::Pan, Motion::Light, Motion::Point, Motion::Dim, Motion::Follow];

/// How far a pixel went against its trend.
#[derive(Clone, Copy)]
struct Trend {
    exact: f64,
    /// The highest value since the exact one fell last, and the lowest since it rose last.
    highest: f64,
    lowest: f64,
}

impl Trend {
    fn new(found: f64, exact: f64) -> Self {
        Self { exact, highest: found, lowest: found }
    }

    /// The reversal in this frame.
    fn reversal(&mut self, found: f64, exact: f64) -> f64 {
        self.highest = if exact < self.exact { found } else { self.highest.max(found) };
        self.lowest = if exact > self.exact { found } else { self.lowest.min(found) };
        self.exact = exact;
        (self.highest - found).max(found - self.lowest)
    }
}

/// A light with surface points that face it, more or less.
#[derive(Clone, Copy)]
struct Scene {
    light: Vec3<f32>,
    axis: Vec3<f32>,
    intensity: f32,
    points: [Vec3<f32>; PIXELS],
    normals: [Vec3<f32>; PIXELS],
    /// Where a light that follows is aimed: a point on its axis.
    target: Vec3<f32>,
}

/// A component of a vector, and a direction along it.
#[derive(Clone, Copy)]
struct Way {
    component: usize,
    is_up: bool,
}

impl Way {
    /// Along any component, half the time the largest of a direction.
    fn random(rng: &mut Rng, toward: DVec3) -> Self {
        let larger = |a: usize, b: usize| if toward[a].abs() > toward[b].abs() { a } else { b };
        let component = if rng.bool() { larger(larger(0, 1), 2) } else { rng.usize(..3) };
        Self { component, is_up: rng.bool() }
    }

    fn changed(self, v: Vec3<f32>, by: impl Fn(f32) -> f32) -> Vec3<f32> {
        match self.component {
            0 => Vec3 { x: by(v.x), ..v },
            1 => Vec3 { y: by(v.y), ..v },
            _ => Vec3 { z: by(v.z), ..v },
        }
    }

    /// The vector after the smallest change of f32.
    fn stepped(self, v: Vec3<f32>) -> Vec3<f32> {
        self.changed(v, |c| if self.is_up { c.next_up() } else { c.next_down() })
    }

    /// The position after the smallest change of the format.
    fn moved<S: Format>(self, v: Vec3<f32>) -> Vec3<f32> {
        if S::NAME == "f32" {
            return self.stepped(v);
        }
        self.changed(v, |c| if self.is_up { c + QUANTUM } else { c - QUANTUM })
    }
}

/// The quantum of the fixed-point lengths.
const QUANTUM: f32 = 1.0 / 65_536.0;

/// A kind of light: its distance model and where its points are.
#[derive(Clone, Copy)]
struct Kind<A> {
    attenuation: A,
    /// The gain at a distance of an intensity of 1.
    gain: fn(f64) -> f64,
    intensity: f32,
    /// The least distance of a point and the ratio of the most to it.
    distances: [f64; 2],
}

/// A direction: anywhere, or along two coordinates at most, where a motion along one of them turns
/// it least.
fn direction(rng: &mut Rng) -> DVec3 {
    if rng.bool() {
        return sweep::direction(rng);
    }
    let mut direction = [1.0, f64::from(rng.i8(-1..=1)), 0.01 * rng.f64()];
    direction.rotate_left(rng.usize(..3));
    DVec3::from_array(direction).normalize()
}

/// Moves a point in one component to where its distance to the light is a power of two there, or so
/// much farther: the evaluation of a format may change there.
fn to_a_seam(point: &mut DVec3, light: DVec3, way: Way, farther: f64) {
    let offset = point[way.component] - light[way.component];
    let seam = offset.abs().log2().round().exp2();
    point[way.component] = light[way.component] + (seam + farther).copysign(offset);
}

impl<A: Attenuation> Kind<A> {
    fn scene(&self, rng: &mut Rng, half_degrees: f64, motion: Motion, way: Way, first: DVec3) -> Scene {
        let off_axis = |rng: &mut Rng| half_degrees.to_radians() * (1.0 - rng.f64().powi(3));
        let light = sweep::position(rng);
        let at_a_seam = rng.bool();
        let path = FRAMES as f64 * f64::from(QUANTUM);
        let mut axis = None;
        let points = [0; PIXELS].map(|_| {
            let toward = match axis {
                None => first,
                Some(axis) => {
                    let radians = off_axis(rng);
                    sweep::direction_off(rng, axis, radians)
                }
            };
            let [least, ratio] = self.distances;
            let distance = least * ratio.powf(rng.f64());
            let mut point = light + distance * toward;
            if at_a_seam {
                to_a_seam(
                    &mut point,
                    light,
                    way,
                    if motion == Motion::Dim { 0.1 } else { path } * (2.0 * rng.f64() - 1.0),
                );
            }
            let point = sweep::on_grid(point);
            // The cone is aimed at the first point: others may miss the narrowest.
            if axis.is_none() {
                let (toward, radians) = ((point - light).normalize(), off_axis(rng));
                axis = Some(sweep::direction_off(rng, toward, radians));
            }
            point
        });
        // A light that dims begins a little over a power of four, where the evaluation of near
        // points changes.
        let intensity = if motion == Motion::Dim {
            let power = 4.0_f32.powf((self.intensity.log2() / 2.0).round());
            power * (1.0 + (path * rng.f64()) as f32)
        } else {
            self.intensity
        };
        let normals = points.map(|point| {
            let back = (light - point).normalize();
            let radians = 1.5 * rng.f64().powi(2);
            sweep::single(sweep::direction_off(rng, back, radians))
        });
        let axis = sweep::single(axis.expect("there is a point"));
        let target = sweep::single(light + self.distances[0] * f32::exact_point(axis));
        Scene {
            light: sweep::single(light),
            axis,
            intensity,
            points: points.map(sweep::single),
            normals,
            target,
        }
    }

    /// The largest reversal of a pixel.
    fn reversal<S: Format>(
        &self,
        rng: &mut Rng,
        shape: &Shape<AnyFalloff>,
        half_degrees: f32,
        motion: Motion,
    ) -> f64 {
        let toward = direction(rng);
        let way = Way::random(rng, toward);
        let mut scene = self.scene(rng, half_degrees.into(), motion, way, toward);
        let (cone, exact) = (shape.at(half_degrees), shape.exactly_at(half_degrees));
        let normals = scene.normals.map(|normal| normal.map(S::from_f32));
        let compile = |scene: &Scene| {
            let spot = SpotLight::new(scene.light, scene.axis, cone)
                .expect("sound")
                .with_attenuation(self.attenuation);
            spot.with_intensity(scene.intensity).expect("sound").compile::<S>().expect("held")
        };
        let (mut spot, mut trends) = (compile(&scene), [None; PIXELS]);
        let mut worst = 0.0_f64;
        for _ in 0..FRAMES {
            let light = S::exact_point(scene.light.map(S::length));
            let axis = f32::exact_direction(scene.axis);
            for (i, trend) in trends.iter_mut().enumerate() {
                let point = scene.points[i].map(S::length);
                let to = S::exact_point(point) - light;
                let distance = to.length();
                let cosine = -to.dot(S::exact_normal(normals[i])) / distance;
                let share = exact.falloff(oracle::versine_between(to, axis)) * cosine.max(0.0);
                let truth = (f64::from(scene.intensity) * (self.gain)(distance) * share).min(1.0);
                let found = S::exact_light(spot.irradiance(point, normals[i]));
                assert!(!found.is_nan());
                let found = found.min(1.0);
                let trend = trend.get_or_insert(Trend::new(found, truth));
                worst = worst.max(trend.reversal(found, truth));
            }
            match motion {
                Motion::Pan => scene.axis = way.stepped(scene.axis),
                Motion::Light => scene.light = way.moved::<S>(scene.light),
                Motion::Point => scene.points = scene.points.map(|point| way.moved::<S>(point)),
                Motion::Dim => scene.intensity *= 1.0 - QUANTUM,
                Motion::Follow => {
                    scene.light = way.moved::<S>(scene.light);
                    let [from, to] = [scene.light, scene.target].map(|place| f32::exact_point(place));
                    scene.axis = sweep::single((to - from).normalize());
                }
            }
            if motion != Motion::Point {
                spot = compile(&scene);
            }
        }
        255.0 * worst
    }

    /// The largest reversals for each motion, in cones of the half angles `degrees` and of the
    /// multiples `narrow` of the narrowest half angle.
    fn largest<S: Format>(&self, name: &str, narrow: &[f32], degrees: &[f32], starts: usize) -> Row {
        let mut largest = Row::default();
        for shape in four() {
            let narrowest = Cone::narrowest::<S>(shape.falloff).to_degrees() / 2.0;
            let held = degrees.iter().copied().filter(|&half| half > narrowest);
            for half_degrees in narrow.iter().map(|times| times * 1.0001 * narrowest).chain(held) {
                let mut rng = Rng::with_seed(24);
                let row = MOTIONS.map(|motion| {
                    let starts = 0..starts * sweep::effort();
                    starts.fold(0.0_f64, |worst, _| {
                        worst.max(self.reversal::<S>(&mut rng, &shape, half_degrees, motion))
                    })
                });
                println!("{} {name}, {} at {half_degrees}: {}", S::NAME, shape.name, shown(row));
                largest = std::array::from_fn(|i| largest[i].max(row[i]));
            }
        }
        println!("{} {name}: {}", S::NAME, shown(largest));
        largest
    }
}

/// A number of linear codes for each of [`MOTIONS`].
type Row = [f64; MOTIONS.len()];

fn shown(row: Row) -> String {
    let shown = MOTIONS.iter().zip(row).map(|(motion, codes)| format!("{motion:?} {codes:.4}"));
    shown.collect::<Vec<_>>().join(", ").to_lowercase()
}

const FULL_SCALE: Kind<NoAttenuation> =
    Kind { attenuation: NoAttenuation, gain: |_| 1.0, intensity: 1.0, distances: [1.0, 100.0] };

/// The largest reversal is within `bounds`, in linear codes: in cones from the multiples `narrow`
/// of the narrowest half angle on, and of lights up to `brightest`, the intensity up to which the
/// format promises half a code.
fn assert_steady<S: Format>(narrow: &[f32], brightest: f32, bounds: Range<f64>) {
    let mut largest = FULL_SCALE.largest::<S>("full scale", narrow, &[1.0, 7.5, 30.0], 8);
    for intensity in [4.0, 10.0, 100.0, 300.0].into_iter().filter(|&intensity| intensity <= brightest) {
        let reach = f64::from(intensity).sqrt();
        let gain = |distance: f64| 1.0 / (distance * distance);
        let bright = Kind { attenuation: InverseSquare, gain, intensity, distances: [0.1 * reach, 20.0] };
        let row = bright.largest::<S>(&format!("intensity {intensity}"), &[], &[3.0, 7.5, 30.0, 60.0], 8);
        largest = std::array::from_fn(|i| largest[i].max(row[i]));
    }
    println!("{}: {}", S::NAME, shown(largest));
    let most = largest.into_iter().fold(0.0, f64::max);
    assert!(bounds.contains(&most), "{}: {}", S::NAME, shown(largest));
}

#[test]
fn f32_follows_its_trend() {
    assert_steady::<f32>(&[1.0, 1.5, 2.0], 10.0, 0.05..0.5);
}

#[test]
fn fx32_follows_its_trend() {
    assert_steady::<Fx32>(&[1.0, 1.5, 2.0], 300.0, 0.02..0.5);
}

#[test]
fn fx16_follows_its_trend() {
    assert_steady::<Fx16>(&[1.0, 1.5, 2.0], 300.0, 0.1..0.5);
}
