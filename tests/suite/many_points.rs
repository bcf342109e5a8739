//! Results of one call with many points are bit-identical to those of one call per point.

use fastrand::Rng;
use luminaire::{
    Cone, DirectionalLight, Fx16, Fx32, PointLight, Scalar, SpotLight, Vec3,
    attenuation::{AnyAttenuation, InverseSquare},
    dynamic::AnyLight,
    falloff::{AnyFalloff, Soft},
    light::{LightModel, Row},
    number::Quick,
};
use support::{
    arbitrary::{bits, vector},
    falloffs::AnyShape,
    format::Format,
    in_every_format, sweep,
};

/// Lengths with every remainder of any machine's vectors and of the kernel's blocks, with and
/// without whole blocks before.
const LENGTHS: std::ops::RangeInclusive<usize> = 0..=67;
const LONG: usize = 3 * 64 + 5;

/// Surface points, structure of arrays.
struct Sites<S: Scalar> {
    points: Vec3<Vec<S::Length>>,
    normals: Vec3<Vec<S>>,
}

fn column<T: Copy, U>(rows: &[Vec3<T>], component: impl Fn(Vec3<T>) -> U) -> Vec<U> {
    rows.iter().map(|&row| component(row)).collect()
}

fn columns<T: Copy>(rows: &[Vec3<T>]) -> Vec3<Vec<T>> {
    Vec3::new(column(rows, |v| v.x), column(rows, |v| v.y), column(rows, |v| v.z))
}

fn slices<T>(columns: &Vec3<Vec<T>>, length: usize) -> Vec3<&[T]> {
    Vec3::new(&columns.x[..length], &columns.y[..length], &columns.z[..length])
}

fn row<T: Copy>(columns: &Vec3<Vec<T>>, i: usize) -> Vec3<T> {
    Vec3::new(columns.x[i], columns.y[i], columns.z[i])
}

impl<S: Format> Sites<S> {
    /// Points in and around a cone, points at and next to the light, and points and normals of any
    /// bits, mixed so that neighbours differ in kind.
    fn about(rng: &mut Rng, position: Vec3<f32>, axis: Vec3<f32>, half_degrees: f32, count: usize) -> Self {
        let stored = S::exact_point(position.map(S::length));
        let axis = S::exact_direction(S::axis(axis)).normalize();
        let (mut points, mut normals) = (Vec::new(), Vec::new());
        for _ in 0..count {
            let distance = sweep::distance(rng);
            let mut site = sweep::site::<S>(rng, stored, axis, half_degrees.into(), distance);
            match rng.u8(..8) {
                0 => site.point = vector(rng, S::length_from_bits),
                1 => site.normal = vector(rng, S::scalar_from_bits),
                2 => site.point = position.map(S::length),
                3 => site.point = position.map(|c| S::length(c + 1e-19 * (rng.f32() - 0.5))),
                _ => {}
            }
            points.push(site.point);
            normals.push(site.normal);
        }
        Self { points: columns(&points), normals: columns(&normals) }
    }
}

/// All bits of a light, NaN and the sign of zero included.
fn light_bits<S: Format>(light: S::Irradiance) -> u64 {
    S::exact_light(light).to_bits()
}

/// Light that a call replaces, different for each point.
fn before<S: Format>(rng: &mut Rng, count: usize) -> Vec<S::Irradiance> {
    (0..count).map(|_| S::from_f32(rng.f32()).light(S::gain(4.0))).collect()
}

/// Returns how many of the points were lit.
fn assert_each<S: Format>(
    light: impl LightModel<S>,
    sites: &Sites<S>,
    length: usize,
    rng: &mut Rng,
) -> usize {
    let mut lights = before::<S>(rng, length);
    light.irradiance_each(slices(&sites.points, length), slices(&sites.normals, length), &mut lights);
    let mut lit = 0;
    for (i, found) in lights.into_iter().enumerate() {
        let (point, normal) = (row(&sites.points, i), row(&sites.normals, i));
        let expected = light.irradiance(point, normal);
        assert_eq!(
            light_bits::<S>(found),
            light_bits::<S>(expected),
            "{i} of {length}: {point:?} {normal:?}"
        );
        lit += usize::from(expected != S::Irradiance::default());
    }
    lit
}

/// Spotlights of every shape.
fn assert_shapes<S: Format>() {
    for shape in AnyShape::all() {
        let mut rng = Rng::with_seed(4096);
        let (mut lit, mut all) = (0, 0);
        for half_degrees in [4.0, 20.0, 60.0, 90.0] {
            let spot = sweep::spot(&mut rng, shape.at(half_degrees))
                .with_intensity(100.0)
                .expect("a sound light")
                .with_attenuation(AnyAttenuation::from(InverseSquare));
            let compiled = spot.compile::<S>().expect("held");
            for length in LENGTHS.chain([LONG; 20]) {
                let sites = Sites::about(&mut rng, spot.position(), spot.axis(), half_degrees, length);
                lit += assert_each::<S>(compiled, &sites, length, &mut rng);
                all += length;
            }
        }
        assert!(lit > all / 20 && lit < all / 2, "{}: {lit} of {all} points are lit", shape.name);
    }
}

/// Lights of every kind with every attenuation.
fn assert_attenuations<S: Format>() {
    let mut rng = Rng::with_seed(17);
    let cone = Cone::from_outer(AnyFalloff::from(Soft), sweep::half(40.0)).expect("a sound cone");
    let attenuations = (0..AnyAttenuation::COUNT).map(|index| AnyAttenuation::drawn(index, || 0.5));
    let attenuations: Vec<_> = attenuations.map(|drawn| drawn.expect("sound")).collect();
    for length in LENGTHS.chain([LONG; 20]) {
        let spot = sweep::spot(&mut rng, cone).with_intensity(100.0).expect("a sound light");
        let sites = Sites::about(&mut rng, spot.position(), spot.axis(), 40.0, length);
        let point = PointLight::new(spot.position()).and_then(|point| point.with_intensity(100.0));
        let sun = DirectionalLight::new(spot.axis()).expect("a sound light");
        let compiled = sun.compile::<S>();
        assert_each::<S>(compiled, &sites, length, &mut rng);
        for &attenuation in &attenuations {
            let spot = spot.with_attenuation(attenuation);
            let point = point.expect("a sound light").with_attenuation(attenuation);
            assert_each::<S>(spot.compile::<S>().expect("held"), &sites, length, &mut rng);
            assert_each::<S>(point.compile::<S>().expect("held"), &sites, length, &mut rng);
            if length % 9 == 1 {
                for light in [AnyLight::from(spot), point.into(), sun.into()] {
                    assert_each::<S>(light.compile::<S>().expect("held"), &sites, length, &mut rng);
                }
            }
        }
    }
}

#[test]
fn many_points_are_lit_as_each_in_f32() {
    assert_shapes::<f32>();
    assert_attenuations::<f32>();
}

#[test]
fn many_points_are_lit_as_each_in_fx32() {
    assert_shapes::<Fx32>();
    assert_attenuations::<Fx32>();
}

#[test]
fn many_points_are_lit_as_each_in_fx16() {
    assert_shapes::<Fx16>();
    assert_attenuations::<Fx16>();
}

#[test]
fn a_quick_light_lights_many_points_as_it_lights_one() {
    fn assert_quick<S: Format + Quick>() {
        let mut rng = Rng::with_seed(23);
        for length in [0, 1, 63, 64, 65, LONG] {
            let spot = sweep::spot(&mut rng, soft_cone()).with_intensity(100.0).expect("a sound light");
            let sites = Sites::about(&mut rng, spot.position(), spot.axis(), 40.0, length);
            assert_each::<S>(spot.compile_quick::<S>().expect("held"), &sites, length, &mut rng);
        }
    }
    assert_quick::<Fx16>();
}

/// Points at every bit length of an offset, in cones of every zoom and in light of every shift: with both sides of
/// each limit of what fixed point evaluates in vectors.
#[test]
fn many_points_are_lit_as_each_at_every_distance() {
    /// Checks 32 points of a light, and the same points as a row. Returns how many are lit, and of how many.
    fn assert_row<S: Format, L: LightModel<S>>(light: L, sites: &Sites<S>, rng: &mut Rng) -> [usize; 2] {
        let lit = assert_each::<S>(light, sites, 32, rng);
        let mut lights = before::<S>(rng, 32);
        let (at, normal) = (|i| row(&sites.points, i), |i| row(&sites.normals, i));
        Row::new(Vec3::default(), at).fill_facing(&light, normal, 0, &mut lights);
        for (i, found) in lights.into_iter().enumerate() {
            assert_eq!(found, light.irradiance(at(i), normal(i)), "{i} of a row");
        }
        [lit, 32]
    }
    fn assert_distances<S: Format>(
        quick: impl Fn(&SpotLight<AnyFalloff>, &Sites<S>, &mut Rng) -> [usize; 2],
    ) {
        let mut rng = Rng::with_seed(62);
        let mut counts = [0; 2];
        for shape in AnyShape::all() {
            for half_degrees in [0.5, 2.0, 7.5, 30.0, 89.0] {
                let spot = sweep::spot(&mut rng, shape.at(half_degrees));
                for power in -17..14 {
                    let distance = f64::from(power).exp2() * (1.0 + rng.f64());
                    let intensity = distance * distance * (18.0 * rng.f64() - 4.0).exp2();
                    let Ok(spot) = spot.with_intensity(intensity.min(1e9) as f32) else { continue };
                    let stored = S::exact_point(spot.position().map(S::length));
                    let axis = S::exact_direction(S::axis(spot.axis())).normalize();
                    let sites: [_; 32] = std::array::from_fn(|_| {
                        let distance = distance * (0.5 + rng.f64());
                        sweep::site::<S>(&mut rng, stored, axis, half_degrees.into(), distance)
                    });
                    let sites = Sites::<S> {
                        points: columns(&sites.each_ref().map(|site| site.point)),
                        normals: columns(&sites.each_ref().map(|site| site.normal)),
                    };
                    let mut count = |[lit, all]: [usize; 2]| {
                        counts = [counts[0] + lit, counts[1] + all];
                    };
                    if let Ok(light) = spot.compile::<S>() {
                        count(assert_row::<S, _>(light, &sites, &mut rng));
                        let any = AnyLight::from(spot).compile::<S>().expect("held");
                        assert_each::<S>(any, &sites, 32, &mut rng);
                    }
                    count(quick(&spot, &sites, &mut rng));
                }
            }
        }
        let [lit, all] = counts;
        assert!(lit > all / 5, "{lit} of {all} points are lit");
    }
    assert_distances::<Fx16>(|spot, sites, rng| match spot.compile_quick::<Fx16>() {
        Ok(light) => assert_row::<Fx16, _>(light, sites, rng),
        Err(_) => [0; 2],
    });
    assert_distances::<Fx32>(|_, _, _| [0; 2]);
}

/// Slices of different lengths: the shortest one determines the number of points, whichever
/// argument it is.
#[test]
fn the_shortest_slice_counts() {
    fn assert_shortest<S: Format>() {
        let mut rng = Rng::with_seed(8);
        let spot = sweep::spot(&mut rng, soft_cone()).with_intensity(100.0).expect("a sound light");
        let compiled = spot.compile::<S>().expect("held");
        let sites = Sites::<S>::about(&mut rng, spot.position(), spot.axis(), 40.0, LONG);
        let stale = before::<S>(&mut rng, LONG);
        for short in [0, 1, 63, 64, 65, 128, LONG - 1] {
            for which in 0..7 {
                let length = |index: usize| if index == which { short } else { LONG };
                let points = Vec3::new(
                    &sites.points.x[..length(0)],
                    &sites.points.y[..length(1)],
                    &sites.points.z[..length(2)],
                );
                let normals = Vec3::new(
                    &sites.normals.x[..length(3)],
                    &sites.normals.y[..length(4)],
                    &sites.normals.z[..length(5)],
                );
                let mut lights = stale.clone();
                compiled.irradiance_each(points, normals, &mut lights[..length(6)]);
                for i in 0..LONG {
                    let light = compiled.irradiance(row(&sites.points, i), row(&sites.normals, i));
                    let expected = if i < short { light } else { stale[i] };
                    assert_eq!(lights[i], expected, "{i} of {short}, slice {which}");
                }
            }
        }
    }
    in_every_format!(assert_shortest);
}

fn soft_cone() -> Cone<Soft> {
    Cone::from_outer(Soft, sweep::half(40.0)).expect("a sound cone")
}

fn assert_falloff<S: Format>(shape: &AnyShape) {
    let mut rng = Rng::with_seed(2);
    let cone = shape.at(30.0);
    let falloff = cone.compile::<S>().expect("held");
    let designed = sweep::versines(cone.outer_versine().into(), 50).map(|versine| falloff.versine(versine));
    let mut versines: Vec<_> = designed.collect();
    versines.extend((0..50).map(|_| S::versine_from_bits(bits(&mut rng))));
    versines.push(falloff.versine(f32::NAN));
    rng.shuffle(&mut versines);
    for length in (0..=versines.len()).rev() {
        let mut intensities = vec![S::from_f32(0.25); versines.len()];
        falloff.at_each(&versines[..length], &mut intensities);
        for (i, (&intensity, &versine)) in intensities.iter().zip(&versines).enumerate() {
            let expected = if i < length { falloff.at(versine) } else { S::from_f32(0.25) };
            assert_eq!(intensity.exact().to_bits(), expected.exact().to_bits(), "{} {versine:?}", shape.name);
        }
        let mut fewer = vec![S::ZERO; length];
        falloff.at_each(&versines, &mut fewer);
        assert_eq!(fewer, intensities[..length]);
    }
}

#[test]
fn a_falloff_of_many_versines_is_that_of_each() {
    for shape in AnyShape::all() {
        in_every_format!(assert_falloff(&shape));
    }
}
