//! The reference for haze: the light that is scattered along a view ray, integrated over the
//! distance along the ray, in f64 and as plain code.

use super::oracle::{self, DVec3};

/// A view ray of unit direction.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub eye: DVec3,
    pub direction: DVec3,
    pub length: f64,
}

/// A spotlight in haze, with a range.
#[derive(Clone, Copy)]
pub struct Beam {
    pub spot: oracle::SpotLight,
    pub range: f64,
    pub density: f64,
    pub source_radius: f64,
}

/// Parts into which Simpson's rule divides each panel, an even number.
const PARTS: u32 = 64;

impl Ray {
    pub fn at(&self, s: f64) -> DVec3 {
        self.eye + s * self.direction
    }
}

impl Beam {
    /// The in-scattering along a ray.
    pub fn in_scattering(&self, ray: &Ray) -> f64 {
        self.in_scattering_through(ray, |_| 1.0)
    }

    /// The air light of a ray past something that lets only a part through.
    pub fn in_scattering_through(&self, ray: &Ray, transmission: impl Fn(DVec3) -> f64) -> f64 {
        let scattered = |s: f64| {
            let point = ray.at(s);
            self.spot.arriving(point) * transmission(point)
        };
        let sum: f64 = self.panels(ray).windows(2).map(|ends| simpson(ends[0], ends[1], scattered)).sum();
        self.density / 4.0 * sum
    }

    /// The part of the ray within the cone, divided where the ray enters and leaves the hotspot,
    /// and more finely the nearer it is to the light.
    fn panels(&self, ray: &Ray) -> Vec<f64> {
        let Some((first, last)) = self.visible(ray) else { return Vec::new() };
        let way = ray.eye - self.spot.position;
        let foot = -way.dot(ray.direction);
        let height = (way.length_squared() - foot * foot).max(0.0).sqrt().max(1e-3 * self.source_radius);
        let mut places = vec![first, last, foot];
        for exponent in -2..50 {
            let offset = height * 2.0_f64.powi(exponent);
            places.extend([foot - offset, foot + offset]);
        }
        let retain = |places: &mut Vec<f64>, first: f64, last: f64| {
            places.retain(|s| (first..=last).contains(s));
            places.sort_by(f64::total_cmp);
        };
        retain(&mut places, first, last);
        let nearest = self.nearest_to_axis(ray, &places);
        // A cone of up to 180 degrees is convex: from a position inside, the ray leaves the cone
        // once in either direction.
        let ends = |versine: f64| {
            let is_within = |s: f64| self.spot.versine(ray.at(s)) < versine;
            let ends = [first, last].map(|end| boundary(nearest, end, is_within));
            is_within(nearest).then_some(ends)
        };
        let Some([enter, leave]) = ends(self.spot.cone.limit) else { return Vec::new() };
        places.extend([enter, leave]);
        places.extend(ends(self.spot.cone.inner).into_iter().flatten());
        retain(&mut places, enter, leave);
        places
    }

    /// The interval in which the ray is neither in the light nor behind it, and within the range.
    fn visible(&self, ray: &Ray) -> Option<(f64, f64)> {
        let way = ray.eye - self.spot.position;
        let foot = -way.dot(ray.direction);
        let squared = self.source_radius * self.source_radius - (way.length_squared() - foot * foot);
        let half = squared.max(0.0).sqrt();
        let (first, last) = match (squared > 0.0, foot) {
            (true, foot) if foot >= half => (0.0, ray.length.min(foot - half)),
            (true, foot) if foot > -half => (foot + half, ray.length),
            _ => (0.0, ray.length),
        };
        let reach = (self.range * self.range - (way.length_squared() - foot * foot)).max(0.0).sqrt();
        let (first, last) = (first.max(foot - reach), last.min(foot + reach));
        (first < last).then_some((first, last))
    }

    /// The distance along the ray at which the versine is least.
    fn nearest_to_axis(&self, ray: &Ray, places: &[f64]) -> f64 {
        let versine = |s: f64| self.spot.versine(ray.at(s));
        let mut best = (places[0], versine(places[0]));
        for ends in places.windows(2) {
            for part in 0..=16 {
                let s = ends[0] + (ends[1] - ends[0]) * f64::from(part) / 16.0;
                best = if versine(s) < best.1 { (s, versine(s)) } else { best };
            }
        }
        let (least, most) = (places[0], places[places.len() - 1]);
        let mut step = (most - least) / 2.0;
        while step > 1e-15 * best.0.abs().max(1e-3) {
            let sides = [(best.0 - step).max(least), (best.0 + step).min(most)];
            match sides.into_iter().find(|&s| versine(s) < best.1) {
                Some(s) => best = (s, versine(s)),
                None => step /= 2.0,
            }
        }
        best.0
    }
}

/// The last distance from `within` towards `beyond` at which a predicate holds.
fn boundary(within: f64, beyond: f64, holds: impl Fn(f64) -> bool) -> f64 {
    if holds(beyond) {
        return beyond;
    }
    let (mut within, mut beyond) = (within, beyond);
    for _ in 0..200 {
        let middle = (within + beyond) / 2.0;
        if holds(middle) { within = middle } else { beyond = middle }
    }
    within
}

/// Simpson's rule, evaluated just within the ends, because the function may jump at an end.
fn simpson(from: f64, to: f64, value: impl Fn(f64) -> f64) -> f64 {
    let step = (to - from) / f64::from(PARTS);
    let inset = 1e-12 * (to - from);
    let at = |i: u32| value((from + step * f64::from(i)).clamp(from + inset, to - inset));
    let weight = |i: u32| match i {
        0 | PARTS => 1.0,
        _ if i % 2 == 1 => 4.0,
        _ => 2.0,
    };
    step / 3.0 * (0..=PARTS).map(|i| weight(i) * at(i)).sum::<f64>()
}

impl Beam {
    /// The in-scattering along an infinite line that crosses the axis at a right angle and at
    /// distance 1.
    pub fn across(&self) -> f64 {
        const PLACES: u32 = 20_000;
        let outer = oracle::half_degrees(self.spot.cone.limit).to_radians();
        let falloff = |i: u32| {
            let angle = outer * (f64::from(i) + 0.5) / f64::from(PLACES);
            self.spot.cone.falloff(2.0 * (angle / 2.0).sin().powi(2))
        };
        let sum: f64 = (0..PLACES).map(falloff).sum();
        self.density / 4.0 * self.spot.intensity * 2.0 * sum * outer / f64::from(PLACES)
    }
}
