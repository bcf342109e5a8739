//! Light has no preferred direction: a scene that is turned by right angles or mirrored is lit as
//! before. A falloff has no preferred distance.

use super::format::Format;
use super::reach::nearest;
use super::scene;
use super::words::Words;
use luminaire::{
    Cone, HalfAngle, PointLight, SpotLight, Vec3,
    attenuation::NoAttenuation,
    falloff::{Falloff, Quadratic},
};

/// A permutation of the axes, and which of them are mirrored.
#[derive(Clone, Copy, Debug)]
struct Turn {
    order: [usize; 3],
    mirrored: [bool; 3],
}

impl Turn {
    fn of(words: &mut Words<'_>) -> Self {
        const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
        let signs = words.choice(8);
        Self {
            order: ORDERS[words.choice(6) as usize],
            mirrored: [0, 1, 2].map(|axis| signs >> axis & 1 == 1),
        }
    }

    /// Every input is on a grid that is symmetric about zero, so a turned input is exact.
    fn turned(self, v: Vec3<f32>) -> Vec3<f32> {
        let all = [v.x, v.y, v.z];
        let [x, y, z] = [0, 1, 2].map(|axis| {
            let component = all[self.order[axis]];
            if self.mirrored[axis] { -component } else { component }
        });
        Vec3::new(x, y, z)
    }

    fn is_mirror_alone(self) -> bool {
        self.order == [0, 1, 2]
    }
}

/// In f32 a mirrored scene is bit-identical, whereas a turned scene sums in a different order.
/// Fixed point rounds halves upwards, so there a mirrored scene may differ as much as a turned one.
/// Each scene is within the error of the format, so two differ by at most twice that error.
pub fn turned_scenes_are_the_same<S: Format>(words: &[u32]) {
    let _: Option<()> = turned::<S>(&mut Words::tame(words));
}

fn turned<S: Format>(words: &mut Words<'_>) -> Option<()> {
    let turn = Turn::of(words);
    let falloff = Quadratic::new(words.between(0.0, 2.0)).ok()?;
    let mut half = words.between(-10.0, 6.49).exp2();
    if words.is_end() {
        half = words.one_of([scene::narrowest::<S, _>(falloff).to_degrees() / 2.0, 90.0]);
    }
    let cone = Cone::from_outer(falloff, HalfAngle::degrees(half)).ok()?;
    let ([position, _], normal) = (scene::places::<S>(words), words.direction());
    let on_grid = |c: f32| if c.abs() < 32_768.0 { (c * 65_536.0).round() / 65_536.0 } else { c };
    let position = position.map(on_grid);
    let off = words.numbers(-1.0, 1.0).map(|c| c * half.to_radians());
    // The components have so few bits that the squared length is exact in any order of summation.
    // Both lights then have the same axis.
    let axis = words.direction().map(|c| (c * 1_000.0).round());
    let distance = if words.is_end() { 32_768.0 } else { words.between(0.5, 16.0) };
    let point = axis.map(|c| c / 1_000.0).zip(off, |axis, off| distance * (axis + off));
    let point = point.zip(position, |w, p| ((w + p) * 65_536.0).round() / 65_536.0);
    // Lengths end one step earlier above zero than below.
    let point = point.map(|c| if S::NAME == "f32" { c } else { c.clamp(-32_767.0, 32_767.0) });

    let spot = |turn: &dyn Fn(Vec3<f32>) -> Vec3<f32>| {
        let light = SpotLight::new(turn(position), turn(axis), cone).ok()?.compile::<S>().ok()?;
        Some(light.falloff_at(turn(point).map(S::length)).exact())
    };
    let point_light = |turn: &dyn Fn(Vec3<f32>) -> Vec3<f32>| {
        let light =
            PointLight::new(turn(position)).ok()?.with_attenuation(NoAttenuation).compile::<S>().ok()?;
        let light = light.irradiance(turn(point).map(S::length), turn(normal).map(S::from_f32));
        Some(S::exact_light(light))
    };
    let exact = S::NAME == "f32" && turn.is_mirror_alone();
    let steepness = f64::from(falloff.steepness(0.0) / half.to_radians());
    let cone_error = f64::from(S::DIRECTION_ERROR) * steepness;
    // The lengths of the directions of `Fx32` have an error of 26 steps.
    let step = if S::NAME == "fx32" { 26.0 } else { 1.0 } * f64::from(S::STEP);
    let any_error = 2.0 * (cone_error + 3.0 * step);
    let within = if exact { 0.0 } else { any_error };
    let (straight, turned) = (spot(&|v| v)?, spot(&|v| turn.turned(v))?);
    assert!((straight - turned).abs() <= within, "{turn:?} {half}: {straight} and {turned}, not {within}");
    // A place on the way to the point, rounded to the format. Half of the way would have the same
    // bits as the way.
    let [from, to] = [position, point].map(|place| S::exact_point(place.map(S::length)));
    let middle = from.lerp(to, 0.6);
    let nearer = nearest::<S>(middle);
    let off = middle.distance(S::exact_point(nearer)) / from.distance(middle);
    if off.is_finite() {
        let light = SpotLight::new(position, axis, cone).ok()?.compile::<S>().ok()?;
        // The steepness is that of a narrow cone; a wide one is up to 1.24 times as steep.
        let (nearer, within) = (light.falloff_at(nearer).exact(), 1.25 * (any_error + off * steepness));
        assert!((straight - nearer).abs() <= within, "{half}: {straight} and {nearer}, not {within}");
    }
    let within = if exact { 0.0 } else { 2.0 * 3.0 * step };
    let (straight, turned) = (point_light(&|v| v)?, point_light(&|v| turn.turned(v))?);
    assert!((straight - turned).abs() <= within, "{turn:?}: {straight} and {turned}, not {within}");
    Some(())
}
