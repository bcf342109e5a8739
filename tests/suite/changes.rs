//! Compiled lights that change at run time, compared with the lights that are compiled after the
//! change.

use fastrand::Rng;
use luminaire::{
    Angle, Cone, DirectionalLight, Fx16, Fx32, PointLight, Rgb, Scalar, SpotLight, Vec3, falloff::Soft,
    number::Quick,
};
use support::{
    arbitrary::vector, assert_that, format::Format, in_every_format, oracle::DVec3, sweep, views::exact,
};

fn spot(rng: &mut Rng) -> SpotLight<Soft> {
    let cone = Cone::from_field(Soft, Angle::degrees(30.0)).expect("a sound cone");
    sweep::spot(rng, cone).with_intensity(8.0).expect("a sound intensity")
}

/// The largest angle between an axis and the exact one, in radians, and the largest error of its
/// length. The vectors are of many lengths, down to the steps of the format.
fn errors_of_axis<S: Format>() -> [f64; 2] {
    let mut rng = Rng::with_seed(4);
    let mut errors = [0.0_f64; 2];
    for i in 0..40_000 {
        let light = spot(&mut rng).compile::<S>().expect("held");
        let position = S::exact_point(light.position());
        let way = 0.5_f64.powi(i % 24) * sweep::direction(&mut rng);
        let (aimed, exact) = if i % 2 == 0 {
            let point = sweep::single(position + 64.0 * way).map(S::length);
            (light.aimed_at(point), S::exact_point(point) - position)
        } else {
            let direction = sweep::single(way).map(S::length);
            (light.aimed_along(direction), S::exact_point(direction))
        };
        let Some(aimed) = aimed else {
            assert_that!(exact == DVec3::ZERO, exact);
            continue;
        };
        let axis = S::exact_direction(aimed.axis());
        assert_that!(axis.dot(exact) > 0.0, axis, exact);
        let found = [axis.cross(exact.normalize()).length(), (axis.length() - 1.0).abs()];
        errors = [0, 1].map(|k| errors[k].max(found[k]));
    }
    errors
}

#[test]
fn an_axis_keeps_its_stated_error() {
    for (name, [turn, length], bound) in [
        ("Fx16", errors_of_axis::<Fx16>(), [2e-9, 2.5e-8]),
        ("Fx32", errors_of_axis::<Fx32>(), [2e-9, 2.5e-8]),
        ("f32", errors_of_axis::<f32>(), [1.2e-7, 2e-7]),
    ] {
        println!("{name}: {turn:.2e}, {length:.2e}");
        for (error, bound) in [(turn, bound[0]), (length, bound[1])] {
            assert_that!((bound / 2.0..=bound).contains(&error), name, turn, length);
        }
    }
}

/// The largest difference of a component from that of the exact unit vector, in steps of the
/// format, over vectors of many lengths and of all bytes.
fn error_of_normals<S: Format>() -> f64 {
    let mut rng = Rng::with_seed(7);
    let mut largest = 0.0_f64;
    let mut compare = |found: Vec3<S>, vector: DVec3| {
        let difference = (S::exact_normal(found) - vector.normalize()).abs().max_element();
        largest = largest.max(difference / f64::from(S::STEP));
    };
    for i in 0..100_000 {
        let length = 1.9 * 0.5_f64.powf(f64::from(i % 8));
        let short = sweep::single(length * sweep::direction(&mut rng)).map(S::from_f32);
        compare(S::normalize(short), S::exact_normal(short));
        let bytes = [(); 3].map(|()| rng.i8(..));
        if bytes != [0; 3] {
            compare(S::normal_from_bytes(bytes), DVec3::from(bytes.map(f64::from)));
        }
    }
    largest
}

/// The bytes nearest to a unit vector have a length within half the diagonal of a cube of 127.
#[test]
fn unit_bytes_are_scaled_to_unit_length() {
    let mut largest = 0.0_f64;
    for (x, y) in (-128..=127_i8).flat_map(|x| (-128..=127_i8).map(move |y| (x, y))) {
        for z in -128..=127_i8 {
            let exact = DVec3::new(x.into(), y.into(), z.into());
            if (exact.length() - 127.0).abs() <= 0.75_f64.sqrt() {
                let found = Fx16::exact_normal(Fx16::normal_from_unit_bytes([x, y, z]));
                largest = largest.max((found - exact.normalize()).abs().max_element());
            }
        }
    }
    println!("{largest:.3e}");
    assert_that!((1e-4..=1.3e-4).contains(&largest), largest);
    let other = [
        Fx32::normal_from_unit_bytes([-90, 3, 89]).map(Fx32::to_f32),
        f32::normal_from_unit_bytes([-90, 3, 89]),
    ];
    assert_eq!(other, [Fx16::normal_from_unit_bytes([-90, 3, 89]).map(Fx16::to_f32); 2]);
}

#[test]
fn a_normal_is_the_nearest_unit_vector() {
    let errors = [error_of_normals::<Fx16>(), error_of_normals::<Fx32>(), error_of_normals::<f32>()];
    println!("{errors:.3?}");
    for (error, bound) in errors.into_iter().zip([0.501, 24.0, 1.0]) {
        assert_that!((bound / 2.0..=bound).contains(&error), errors);
    }
    fn zeros<S: Format>() {
        assert_eq!(S::normalize(Vec3::default()), Vec3::default());
        assert_eq!(S::normal_from_bytes([0; 3]), Vec3::default());
        let mut rng = Rng::with_seed(8);
        for _ in 0..10_000 {
            let normal = S::exact_normal(S::normalize(vector(&mut rng, S::scalar_from_bits)));
            assert!(
                normal == DVec3::ZERO || (normal.length() - 1.0).abs() < 2e-4,
                "{normal}, expected normal == DVec3::ZERO or (normal.length() - 1.0).abs() < 2e-4"
            );
        }
    }
    in_every_format!(zeros);
}

/// Two lights, a part of the first one's intensity, and a point that the second one may light.
struct Change<S: Format> {
    before: SpotLight<Soft>,
    /// The light that `before` becomes.
    after: SpotLight<Soft>,
    part: S,
    along: Vec3<S::Length>,
    site: sweep::Site<S>,
}

/// A light that was changed lights like one that is compiled with these properties, within half a
/// linear code. The two functions change a light, and compile it as it then is.
fn assert_changes<S: Format>(
    changed: impl Fn(&Change<S>) -> S::Irradiance,
    compiled: impl Fn(&Change<S>) -> S::Irradiance,
) {
    let mut rng = Rng::with_seed(5);
    let mut lit = 0;
    for _ in 0..2_000 {
        let [before, after] = [(); 2].map(|()| spot(&mut rng));
        let part = S::from_f32(rng.f32());
        let along = after.axis().map(|c| S::length(0.7 * c));
        let site = sweep::site::<S>(&mut rng, exact(after.position()), exact(after.axis()), 15.0, 3.0);
        let after = after.with_intensity(8.0 * part.to_f32()).expect("a sound intensity");
        let change = Change { before, after, part, along, site };
        let of = |light| 255.0 * S::exact_light(light).min(1.0);
        let (changed, compiled) = (changed(&change), compiled(&change));
        assert!((of(changed) - of(compiled)).abs() < 0.5, "{changed:?}, not {compiled:?}");
        lit += i32::from(of(compiled) > 1.0);
    }
    assert_that!(lit > 400, lit);
}

/// Calls [`assert_changes`] with a function that compiles.
macro_rules! assert_changes {
    ($format:ty, $compile:ident) => {
        assert_changes::<$format>(
            |Change { before, after, part, along, site }| {
                let light = before.$compile::<$format>().expect("held").dimmed(*part);
                let light = light.moved_to(after.position().map(<$format>::length));
                light.aimed_along(*along).expect("a direction").irradiance(site.point, site.normal)
            },
            |Change { after, site, .. }| {
                after.$compile::<$format>().expect("held").irradiance(site.point, site.normal)
            },
        )
    };
}

#[test]
fn a_changed_light_is_like_a_compiled_one() {
    assert_changes!(Fx16, compile);
    assert_changes!(Fx32, compile);
    assert_changes!(f32, compile);
    assert_changes!(Fx16, compile_quick);
}

/// What one change leaves, and what all do with any bits.
fn assert_total<S: Format>() {
    let mut rng = Rng::with_seed(6);
    let black = Rgb::new(S::ZERO, S::ZERO, S::ZERO);
    for _ in 0..20_000 {
        let spot = spot(&mut rng);
        let full = spot.compile::<S>().expect("held");
        let point = vector(&mut rng, S::length_from_bits);
        let direction = vector(&mut rng, S::length_from_bits);
        let part = S::scalar_from_bits(rng.u64(..));
        let site = sweep::site::<S>(&mut rng, exact(spot.position()), exact(spot.axis()), 15.0, 3.0);

        assert_eq!(full.dimmed(S::ONE), full);
        assert_eq!(full.moved_to(full.position()), full);
        assert_eq!(full.aimed_at(full.position()), None);
        assert_eq!(full.aimed_along(Vec3::default()), None);
        assert_eq!(full.dimmed(S::ZERO).irradiance(site.point, site.normal), S::Irradiance::default());
        assert_eq!(full.with_color(black).color(), black);
        assert_eq!(full.with_color(black).specular_color(), full.specular_color());
        assert_eq!(full.with_specular_color(black).specular_color(), black);
        assert_eq!(full.with_specular_color(black).color(), full.color());

        let brightest = full.irradiance(site.point, site.normal);
        assert_that!(full.dimmed(part).irradiance(site.point, site.normal) <= brightest, part);
        for light in [full.aimed_at(point), full.aimed_along(direction)].into_iter().flatten() {
            let light = S::exact_light(light.moved_to(point).irradiance(site.point, site.normal));
            assert_that!(light >= 0.0, light);
        }
    }
}

/// The same of a quick light.
fn assert_quick_total<S: Format + Quick>() {
    let mut rng = Rng::with_seed(6);
    for _ in 0..20_000 {
        let spot = spot(&mut rng);
        let quick = spot.compile_quick::<S>().expect("held");
        let [point, direction] = [(); 2].map(|()| vector(&mut rng, S::length_from_bits));
        let site = sweep::site::<S>(&mut rng, exact(spot.position()), exact(spot.axis()), 15.0, 3.0);
        assert_eq!(quick.aimed_at(spot.position().map(S::length)), None);
        assert_eq!(quick.aimed_along(Vec3::default()), None);
        for light in [quick.aimed_at(point), quick.aimed_along(direction)].into_iter().flatten() {
            let light = S::exact_light(light.moved_to(point).irradiance(site.point, site.normal));
            assert_that!(light >= 0.0, light);
        }
    }
}

#[test]
fn changes_of_any_bits_are_defined() {
    assert_quick_total::<Fx16>();
    in_every_format!(assert_total);
}

#[test]
fn other_lights_change_too() {
    let point =
        PointLight::new([1.0, 2.0, 3.0]).and_then(|light| light.compile::<Fx16>()).expect("a sound light");
    let there =
        PointLight::new([-1.0, 2.5, 0.0]).and_then(|light| light.compile::<Fx16>()).expect("a sound light");
    assert_eq!(point.moved_to(Fx16::point([-1.0, 2.5, 0.0])), there);
    let sun = DirectionalLight::new([0.0, -1.0, 0.0]).expect("a sound direction").compile::<Fx16>();
    let low = sun.aimed_along(Fx16::point([-0.25, 0.0, 0.0])).expect("a direction");
    assert_eq!(Fx16::light_to_f32(low.irradiance(Vec3::new(Fx16::ONE, Fx16::ZERO, Fx16::ZERO))), 1.0);
    assert_eq!(sun.aimed_along(Vec3::default()), None);
    let half = sun.dimmed(Fx16::from_f32(0.5)).irradiance(Vec3::new(Fx16::ZERO, Fx16::ONE, Fx16::ZERO));
    assert_eq!(Fx16::light_to_f32(half), 0.5);
}
