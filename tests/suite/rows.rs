//! Rows of pixels: the same bits as point by point, and no lit point is skipped.

use fastrand::Rng;
use luminaire::{
    Angle, Cone, Fx16, Fx32, SpotLight,
    falloff::{AnyFalloff, Cubic, Falloff, Hard, RealPower, Soft, Step},
    light::{CompiledSpotLight, Row},
};
use support::{
    assert_that,
    format::Format,
    in_every_format,
    oracle::{
        self, DVec3,
        climb::{self, Search},
    },
    sweep::{self, half},
};

/// A light with a step of this half angle in degrees.
fn step<S: Format>(rng: &mut Rng, degrees: f32) -> Option<CompiledSpotLight<S, Step>> {
    let cone = Cone::from_outer(Step, half(degrees)).expect("a sound angle");
    sweep::spot(rng, cone).compile().ok()
}

/// A unit vector orthogonal to another one.
fn orthogonal(rng: &mut Rng, axis: DVec3) -> DVec3 {
    axis.cross(sweep::direction(rng)).normalize()
}

/// The gap to a cone with a half angle from 4 to 80 degrees, as a share of the distance, from which
/// on a sphere is always skipped.
fn gap<S: Format>() -> f64 {
    let mut rng = Rng::with_seed(22);
    let mut largest = 0.0_f64;
    for _ in 0..200_000 {
        let degrees = 4.0 * 20.0_f32.powf(rng.f32());
        let Some(light) = step::<S>(&mut rng, degrees) else { continue };
        let (position, axis) = (S::exact_point(light.position()), S::exact_direction(light.axis()));
        let off = (f64::from(degrees) + 90.0 * rng.f64()).to_radians();
        let distance = 0.5 * 40.0_f64.powf(rng.f64());
        let right = orthogonal(&mut rng, axis);
        let center = sweep::single(position + distance * (off.cos() * axis + off.sin() * right));
        let share = (off - f64::from(degrees).to_radians()).sin();
        let touching = rng.f64() * share;
        if light.can_reach(center.map(S::length), S::length((distance * touching) as f32)) {
            largest = largest.max(share - touching);
        }
    }
    largest
}

#[test]
fn spheres_clear_of_the_cone_are_skipped() {
    let gaps = [gap::<Fx16>(), gap::<Fx32>(), gap::<f32>()];
    println!("{gaps:.5?}");
    for (gap, bound) in gaps.into_iter().zip([0.12, 0.12, 3e-4]) {
        assert_that!((bound / 10.0..=bound).contains(&gap), gaps);
    }
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
