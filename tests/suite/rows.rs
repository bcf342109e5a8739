//! Rows of pixels: the same bits as point by point, and no lit point is skipped.

use fastrand::Rng;
use luminaire::{
    Angle, Cone, Fx16, Fx32, SpotLight, Vec3,
    falloff::{AnyFalloff, Cubic, Falloff, Hard, RealPower, Soft, Step},
    light::Row,
};
use std::f64::consts::PI;
use support::{
    assert_in,
    every::is_full,
    format::Format,
    in_every_format,
    oracle::{
        self, DVec3,
        climb::{self, Search},
    },
    sweep::{self, half},
};

/// A light with a step, and a sphere: the position, the axis, the half angle in degrees, the centre and the radius.
#[derive(Clone, Copy, Debug)]
struct Sphere {
    light: Vec3<f32>,
    axis: Vec3<f32>,
    half: f32,
    center: Vec3<f32>,
    radius: f32,
}

impl Sphere {
    /// Near the cone, at any distance, in front of the light or behind it, and of any size.
    fn somewhere<S: Format>(rng: &mut Rng) -> Self {
        let farthest = f64::from(S::FARTHEST).min(1e6);
        let reach = farthest * 1e-6_f64.powf(rng.f64());
        let light = DVec3::from_array([0; 3].map(|_| reach * (2.0 * rng.f64() - 1.0)));
        let (axis, half) = (sweep::direction(rng), 2.0 * 43.5_f32.powf(rng.f32()));
        let edge = f64::from(half).to_radians();
        let off = if rng.bool() { edge + (PI - edge) * rng.f64() } else { edge + 1e-3_f64.powf(rng.f64()) };
        let distance = 1e-4 * (farthest * 1e4).powf(rng.f64());
        let center = light + distance * sweep::direction_off(rng, axis, off.min(PI));
        let radius = distance * if rng.bool() { rng.f64() } else { (off - edge).sin() * 0.99 };
        let [light, axis, center] = [light, axis, center].map(sweep::single);
        Self { light, axis, half, center, radius: radius as f32 }
    }

    fn moved<S: Format>(self, rng: &mut Rng) -> Self {
        let (size, farthest) = (climb::size(rng), S::FARTHEST.min(1e6));
        let step = climb::grid_step(rng, size);
        let place = |c: f32| step(c).clamp(-farthest, farthest);
        let mut sphere = self;
        match rng.u8(..6) {
            0 => sphere.light = climb::one_of(rng, self.light, place),
            1 => sphere.axis = climb::one_of(rng, self.axis, |c| c + size),
            2 => sphere.half = (self.half * (1.0 + size)).clamp(2.0, 87.0),
            3 => sphere.radius = step(self.radius).max(0.0),
            _ => sphere.center = climb::one_of(rng, self.center, place),
        }
        sphere
    }

    /// The gap between the sphere and a plane that touches the cone, where the sphere is not skipped, and its bound.
    fn gap<S: Format>(&self) -> Option<[f64; 2]> {
        let cone = Cone::from_outer(Step, half(self.half)).ok()?;
        let spot = SpotLight::new(self.light, self.axis, cone).ok()?;
        let light = spot.compile::<S>().ok()?;
        let (center, radius) = (self.center.map(S::length), S::length(self.radius));
        let (tip, axis) = (S::exact_point(light.position()), S::exact_direction(light.axis()).normalize());
        let (way, exact_radius) = (S::exact_point(center) - tip, S::exact_length(radius));
        let edge = f64::from(self.half).to_radians();
        let (sine, cosine) = edge.sin_cos();
        let (along, across) = (way.dot(axis), way.reject_from(axis).length());
        let [bound, back] = gap_bound::<S>(sine, cosine, way.length(), exact_radius, tip.abs().element_sum());
        // In fixed point a tip does not move so far, and not beyond the coordinates.
        let is_far = S::NAME != "f32" && (back > 8_000.0 || tip.abs().max_element() + back > 32_000.0);
        let gap = across * cosine - along * sine - exact_radius;
        (!is_far && gap > 0.0 && light.can_reach(center, radius)).then_some([gap, bound])
    }
}

/// The gap from which on a sphere is always skipped, and how far the tip of the cone is moved back for the radius.
///
/// The tip moves by the radius over the sine. The squared sine lacks up to 2.6 steps of 2^-14 (5 of 2^-23 in `f32`), the
/// reciprocal root is up to 5.8e-4 too large, and the radius has 12 quanta more, 4.1e-7 of the coordinates in
/// `f32`. Then the centre is outside if its squared cosine is less than that of the cone by 24.1 steps: 18 of the
/// bound, one of the squared length, twice `sqrt(3)` steps of a truncated axis, and 1.58 by which a truncated offset
/// turns; in `f32` 26, of which the roundings are ten. A difference of squared cosines is the sine of the difference of
/// the angles times that of their sum.
fn gap_bound<S: Format>(sine: f64, cosine: f64, distance: f64, radius: f64, size: f64) -> [f64; 2] {
    let is_float = S::NAME == "f32";
    let step = f64::from(S::OUTSIDE_STEP);
    let [least, margin] = if is_float { [5.0, 26.0] } else { [2.6, 24.1] };
    let moved_sine = (sine * sine - least * step).sqrt();
    let (back, rounded) = if is_float {
        let more = 4.1e-7 * (size + radius / moved_sine);
        ((radius * (1.0 + 4.0 * step) + more) / moved_sine, more)
    } else {
        ((radius + 12.0 / 65_536.0) * (1.0 + 5.8e-4) / moved_sine, 8.0 / 65_536.0)
    };
    let touching = (2.0 * sine * cosine).min(cosine);
    [margin * step * (distance + back) / touching + back * sine - radius + rounded, back]
}

#[test]
fn spheres_clear_of_the_cone_are_skipped() {
    fn assert_skipped<S: Format>(of_distance: f64, more: f64) {
        let (starts, climbs, steps) = if is_full() { (1_000_000, 600, 50_000) } else { (20_000, 8, 3_000) };
        let search = Search { starts, climbs, steps, ..Search::default() };
        let part = |sphere: Sphere| sphere.gap::<S>().map_or(0.0, |[gap, bound]| gap / bound);
        let worst = search.worst(Sphere::somewhere::<S>, |rng, sphere| sphere.moved::<S>(rng), part);
        let worst = worst.expect("a gap");
        println!("{}: {:.3} of the bound at {:?}", S::NAME, worst.error, worst.input);
        assert!((0.4..=1.0).contains(&worst.error), "{}: {worst:?}", S::NAME);
        // Of half angles from 4 to 80 degrees: of a sphere that nearly has the light in it, and of a point at the light.
        let bounds = (40..=800).map(|tenths| {
            let (sine, cosine) = (f64::from(tenths) / 10.0).to_radians().sin_cos();
            [1e6, 0.0].map(|far| gap_bound::<S>(sine, cosine, far, far, 1.0)[0])
        });
        let most = bounds.reduce(|a, b| [a[0].max(b[0]), a[1].max(b[1])]).expect("some angles");
        assert_in(&S::NAME, most[0], 0.9e6 * of_distance..=1e6 * of_distance);
        assert_in(&S::NAME, most[1], 0.9 * more..=more);
    }
    assert_skipped::<Fx16>(0.19, 3.5e-4);
    assert_skipped::<Fx32>(0.19, 3.5e-4);
    assert_skipped::<f32>(4.2e-4, 9e-7);
}

/// A light at the ends of a format lights all pixels of a wall.
#[test]
fn rows_at_the_ends_of_a_format_have_the_light_of_their_points() {
    fn assert_rows<S: Format>() {
        let cone = Cone::soft(Angle::degrees(10.0)).expect("a sound cone");
        for (x, back) in [(32_000.0, -1.0), (-32_000.0, 1.0), (32_767.0, -1.0)] {
            let spot = SpotLight::new([0.0; 3], [back, 0.0, 0.0], cone).expect("a sound light");
            let spot =
                spot.with_intensity(10_000.0).expect("a sound intensity").compile::<S>().expect("held");
            let (light, normal) = (spot.moved_to(S::point([x, 0.0, 0.0])), S::normal([-back, 0.0, 0.0]));
            let point = |i: usize| S::point([x + 100.0 * back, 4.0 * i as f32 - 128.0, 0.0]);
            let (mut lit, mut shown) = (0, 0);
            Row::new(normal, point).light(&[light], &mut [(); 64], |(), _, _| shown += 1);
            for i in 0..64 {
                lit += i32::from(light.irradiance(point(i), normal) != S::Irradiance::default());
            }
            assert!(lit > 0 && shown == lit, "{} at {x}: {shown} pixels of a row, expected {lit}", S::NAME);
        }
    }
    in_every_format!(assert_rows);
}

/// A light 1 from the nearest point of a segment of a flat surface, and the length of the segment. The four
/// numbers are the cosine between the segment and the direction to that point, two coordinates of the
/// axis relative to that direction, and the length.
type Segment = [f64; 4];

/// The error of linear interpolation over a segment, in the middle and at quarters, in units of the bound.
fn interpolation_error(light: &SpotLight<AnyFalloff>, [s, x, y, length]: Segment) -> f64 {
    let (cone, intensity) = (light.cone(), f64::from(light.intensity()));
    let falloff = cone.falloff();
    let [inner, outer, _] = cone.versines().map(f64::from);
    // The light is at the origin, and the line along x passes it at the depth c.
    let c = (1.0 - s * s).sqrt();
    let nearest = DVec3::new(s, -c, 0.0);
    let axis = (nearest + x * DVec3::new(c, s, 0.0) + y * DVec3::Z).normalize();
    let lit = |t: f64| {
        let way = nearest + t * length * DVec3::X;
        let distance = way.length();
        let versine = oracle::versine_between(way, axis);
        let argument = ((outer - versine) / (outer - inner)).clamp(0.0, 1.0);
        intensity * falloff.formula().exact(argument) * c / distance.powi(3)
    };
    let [from, to] = [0.0, 1.0].map(lit);
    let error = |t: f64| (lit(t) - from - t * (to - from)).abs();
    let bound = light.interpolation_bound(length as f32, 1.0).expect("a bound");
    [0.25, 0.5, 0.75].map(error).into_iter().fold(0.0, f64::max) / f64::from(bound)
}

/// Interpolation between points of a flat surface keeps its bound, and half of the bound is found.
#[test]
fn interpolation_keeps_its_bound() {
    let mut rng = Rng::with_seed(25);
    // Of falloffs without and with a kink at the edge of the cone.
    let mut most = [0.0_f64; 2];
    let falloffs = [
        Soft.into(),
        Hard.into(),
        Cubic::with_slopes(0.3, 0.5).unwrap().into(),
        RealPower::new(2.5).unwrap().into(),
    ];
    for falloff in falloffs.into_iter().cycle().take(60) {
        let falloff: AnyFalloff = falloff;
        let half_angle = 1.0 * 89.0_f32.powf(rng.f32());
        let cone = Cone::from_outer(falloff, half(half_angle)).expect("a sound angle");
        let cone =
            if rng.bool() { cone.with_inner(half(half_angle * rng.f32())).expect("less") } else { cone };
        let light = SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone).expect("a sound light");
        let size = f64::from(half_angle).to_radians().sin();
        let somewhere = |rng: &mut Rng| {
            let signed = |rng: &mut Rng| 2.0 * rng.f64() - 1.0;
            [
                signed(rng).abs() * 0.999,
                2.0 * size * signed(rng),
                2.0 * size * signed(rng),
                size * 0.01_f64.powf(rng.f64()),
            ]
        };
        let moved = |rng: &mut Rng, mut at: Segment| {
            let size = f64::from(climb::size(rng));
            match rng.u8(..4) {
                0 => at[0] = (at[0] + size).clamp(0.0, 0.9999),
                1 => at[1] += at[3] * size,
                2 => at[2] += at[3] * size,
                _ => at[3] *= 1.0 + 0.5 * size,
            }
            at
        };
        let search = Search { starts: 500, climbs: 3, steps: 500, seed: rng.u64(..) };
        let worst = search.worst(somewhere, moved, |at| interpolation_error(&light, at)).expect("an error");
        assert!(worst.error <= 1.0, "{light:?}: {worst:?}");
        let most = &mut most[usize::from(
            cone.versines()[0] > 0.0 || matches!(falloff, AnyFalloff::Hard(_) | AnyFalloff::Cubic(_)),
        )];
        *most = most.max(worst.error);
    }
    println!("{most:.3?} of the bound");
    assert!(most[0] > 0.5 && most[1] > 0.8, "{most:?}");
}
