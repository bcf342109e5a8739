//! What a light does not reach is dark: spheres, and the points of rows.

use super::format::Format;
use super::scene;
use super::words::Words;
use luminaire::{
    Fx16, Rgb, SpotLight, Vec3,
    attenuation::AnyAttenuation,
    falloff::AnyFalloff,
    light::{LightModel, Row, SurfacePoint},
    specular::NoSpecular,
};
use luminaire_oracle::DVec3;

/// A light reaches every sphere that contains a lit point. The point is near the edge of the cone,
/// and the sphere touches the cone there from outside.
pub fn lit_spheres_are_reached<S: Format>(words: &[u32]) {
    let _: Option<()> = sphere::<S>(&mut Words::new(words));
}

fn sphere<S: Format>(words: &mut Words<'_>) -> Option<()> {
    let falloff = scene::falloff(words)?;
    let cone = scene::cone::<S, _>(words, falloff)?;
    let places = scene::places::<S>(words);
    let spot = scene::spot(words, cone, places)?;
    let light = spot.compile::<S>().ok()?;
    let [from, to] = places.map(|place| S::exact_point(place.map(S::length)));
    let axis = S::exact_direction(light.axis()).normalize();
    let across = axis.cross(double(words.direction())).normalize();
    let half = f64::from(cone.outer().to_radians()) / 2.0;
    let (sine, cosine) = (half * (1.0 - f64::from(words.between(-24.0, 0.0).exp2()))).sin_cos();
    let distance = from.distance(to) * f64::from(words.between(-12.0, 0.0).exp2());
    let point = nearest::<S>(from + distance * (cosine * axis + sine * across));
    let exact = S::exact_point(point);
    let size = distance * f64::from(words.between(-14.0, 7.0).exp2());
    let center = nearest::<S>(exact + size * (cosine * across - sine * axis));
    // More than the distance by less than two steps.
    let radius = exact.distance(S::exact_point(center)) * (1.0 + f64::from(f32::EPSILON));
    let radius = S::nearest_length(radius + 0.5_f64.powi(17));
    if exact.distance(S::exact_point(center)) <= S::exact_length(radius) {
        let is_lit = light.falloff_at(point) != S::ZERO;
        assert!(!is_lit || light.can_reach(center, radius), "{spot:?} {point:?} in {center:?} {radius:?}");
    }
    Some(())
}

/// The pixels of a row have the light of single calls without early-outs, or of the means of such calls.
pub fn rows_have_the_light_of_their_points<S: Format>(words: &[u32]) {
    let _: Option<()> = row::<S, _>(&mut Words::new(words), |spot| spot.compile::<S>().ok());
}

/// The same law for the quick evaluation.
pub fn quick_rows_have_the_light_of_their_points(words: &[u32]) {
    let _: Option<()> = row::<Fx16, _>(&mut Words::new(words), |spot| spot.compile_quick::<Fx16>().ok());
}

fn row<S: Format, L: LightModel<S>>(
    words: &mut Words<'_>,
    compile: impl Fn(SpotLight<AnyFalloff, AnyAttenuation>) -> Option<L>,
) -> Option<()> {
    let falloff = scene::falloff(words)?;
    let cone = scene::cone::<S, _>(words, falloff)?;
    let [position, first] = scene::places::<S>(words);
    let [_, last] = scene::places::<S>(words);
    let length = f64::from(words.between(-12.0, 0.0).exp2());
    let at = |part: f64| double(first).lerp(double(last), part * length);
    let aim = at(words.between(0.0, 1.0).into()).as_vec3();
    let spot = scene::spot(words, cone, [position, Vec3::new(aim.x, aim.y, aim.z)])?;
    let light = compile(spot.with_attenuation(scene::attenuation(words)?))?;
    let normal = words.direction();
    let normal = normal.map(|c| S::from_f32(-c * normal.dot(spot.axis()).signum()));
    let count = words.choice(96) as usize;
    let point = |i: usize| nearest::<S>(at(i as f64 / 96.0));
    let mut pixels = vec![Rgb::default(); count];
    let mut shown = Vec::new();
    Row::new(normal, point).light(&[light; 2], &mut pixels, |pixel, i, light| {
        *pixel = light;
        shown.push(i);
    });
    let lit = pixels.iter().enumerate().filter(|(_, pixel)| **pixel != Rgb::default()).map(|(i, _)| i);
    assert!(lit.eq(shown.iter().copied()), "{light:?} shows {shown:?} of {count}");
    for (i, pixel) in pixels.into_iter().enumerate() {
        let arrived =
            light.evaluate::<NoSpecular>(&SurfacePoint::matte(point(i), normal), &(), false).diffuse;
        let single = Rgb::lit::<S>(arrived, light.colors()[0]);
        assert_eq!(
            pixel,
            Rgb::default() + single + single,
            "{light:?} at {:?}, point {i} of {count}",
            point(i)
        );
    }
    // The same places along x.
    let start = point(0);
    let along = Row::along_x(normal, [start.y, start.z], |i| point(i).x);
    let reach = along.reach(&light, count);
    let [mut arrived, mut facing] = [(); 2].map(|()| vec![S::Irradiance::default(); count]);
    along.fill(&light, reach.start, &mut arrived[reach.clone()]);
    let other = words.direction().map(S::from_f32);
    let normal_of = |i: usize| if i.is_multiple_of(3) { other } else { normal };
    along.fill_facing(&light, normal_of, reach.start, &mut facing[reach]);
    for (i, (arrived, facing)) in arrived.into_iter().zip(facing).enumerate() {
        let single = |normal| {
            let surface = SurfacePoint::matte(Vec3 { x: point(i).x, ..start }, normal);
            light.evaluate::<NoSpecular>(&surface, &(), false).diffuse
        };
        let expected = [normal, normal_of(i)].map(single);
        assert_eq!([arrived, facing], expected, "{light:?} at {:?} along x, point {i} of {count}", point(i));
    }
    let line = Row::new(normal, point);
    let single =
        |point| light.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), false).diffuse;
    // Every block of a row may begin at the first lit point.
    let is_dark = |&i: &usize| single(point(i)) == S::Irradiance::default();
    let lit: Vec<usize> = (0..count).filter(|i| !is_dark(i)).collect();
    for first in 0..count.min(16) {
        let reach = Row::new(normal, |i| point(first + i)).reach(&light, count - first);
        let is_reached = |i: &usize| *i < first || reach.contains(&(i - first));
        assert!(lit.iter().all(is_reached), "{light:?} reaches {reach:?} from {first}, lit {lit:?}");
    }
    let on_line = |i| single(point(3 + i));
    let along_x = |i| single(Vec3 { x: point(3 + i).x, ..start });
    interpolated::<S, 2>(count, |arrived| line.fill_interpolated::<_, 2>(&light, 3, arrived), on_line);
    interpolated::<S, 4>(count, |arrived| along.fill_interpolated::<_, 4>(&light, 3, arrived), along_x);
    interpolated::<S, 8>(count, |arrived| along.fill_interpolated::<_, 8>(&light, 3, arrived), along_x);
    Some(())
}

/// Every `N`-th value is that of a single call, and the values between differ from the exact means by the
/// rounding of the format.
fn interpolated<S: Format, const N: usize>(
    count: usize,
    fill: impl Fn(&mut [S::Irradiance]),
    single: impl Fn(usize) -> S::Irradiance,
) {
    let mut filled = vec![S::Irradiance::default(); count];
    fill(&mut filled);
    for (i, filled) in filled.into_iter().enumerate() {
        let (run, part) = (i / N * N, (i % N) as f64 / N as f64);
        if i == run {
            assert_eq!(filled, single(i), "point {i} of {count}");
            continue;
        }
        let [from, to] = [run, run + N].map(|i| S::exact_light(single(i)));
        let exact = from + part * (to - from);
        // A mean is rounded by half a step, and that of two means carries half of their errors. In f32 a step is
        // that of the smallest numbers, and the halves of two of them are rounded one by one.
        let steps = [0.5, 0.75, 1.125][N.ilog2() as usize - 1] * if S::NAME == "f32" { 2.0 } else { 1.0 };
        let bound = steps * S::exact(S::scalar_from_bits(1)) + exact * f64::from(f32::EPSILON);
        let error = (S::exact_light(filled) - exact).abs();
        assert!(error <= bound, "point {i} of {count}, every {N}: {error} from {exact}, expected {bound}");
    }
}

fn double(v: Vec3<f32>) -> DVec3 {
    let Vec3 { x, y, z } = v.map(f64::from);
    DVec3::new(x, y, z)
}

pub fn nearest<S: Format>(place: DVec3) -> Vec3<S::Length> {
    Vec3::new(place.x, place.y, place.z).map(S::nearest_length)
}
