//! Accuracy of distance models, highlights and the complete lit point in all three formats against
//! the f64 reference, row by row of `tests/bounds.csv`.
//!
//! `cargo test --test suite lit:: -- --nocapture` prints the measured rows.

use fastrand::Rng;
use luminaire::{
    AmbientLight, Cone, Fx16, Fx32, Material, PointLight, Rgb, Vec3,
    attenuation::{
        Attenuation, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
    },
    display::{clip, encode_srgb},
    falloff::Soft,
    light::SurfacePoint,
    specular::{BlinnPhong, DifferenceForm, DualConeLobe, NoSpecular, Phong, SpecularLobe},
};
use support::{
    bounds,
    format::Format,
    oracle::{self, Classic, DVec3, Lobe},
    sweep,
};

/// A random direction less than an angle off an axis.
fn direction_within(rng: &mut Rng, axis: DVec3, radians: f64) -> DVec3 {
    let angle = radians * rng.f64();
    sweep::direction_off(rng, axis, angle)
}

/// A random range that is the same number in every format.
fn range(rng: &mut Rng) -> f32 {
    (1.0 + 63.0 * rng.f32()).round()
}

fn distance_error<S: Format, A: Attenuation>(
    model: impl Fn(f32) -> A,
    oracle: fn(f64) -> oracle::Attenuation,
) -> f64 {
    let mut rng = Rng::with_seed(20);
    let mut worst = 0.0_f64;
    for _ in 0..400 * sweep::effort() {
        let (place, range) = (sweep::position(&mut rng), range(&mut rng));
        let model = model(range);
        // Full scale at half the range for what falls with the square, at the light itself for what
        // does not.
        let falls = oracle(range.into()).at(0.01) > 1.0;
        let intensity = if falls { range * range / 4.0 } else { 1.0 };
        let point = PointLight::new(sweep::single(place)).and_then(|point| point.with_intensity(intensity));
        let lit = point.expect("a sound light").with_attenuation(model).compile::<S>().expect("held");
        for _ in 0..1_000 {
            let way = sweep::direction(&mut rng);
            let distance = f64::from(range) * (0.02 + 1.08 * rng.f64());
            let site = sweep::on_grid(place + distance * way);
            let normal = sweep::single(-way).map(S::from_f32);
            let offset = site - place;
            let distance = offset.length();
            let cosine = (-offset.normalize().dot(S::exact_normal(normal))).clamp(0.0, 1.0);
            let exact = f64::from(intensity) * oracle(range.into()).at(distance) * cosine;
            let light = S::exact_light(lit.irradiance(sweep::single(site).map(S::length), normal));
            let unwindowed = if falls { f64::from(intensity) / (distance * distance) } else { 1.0 };
            worst = worst.max((light - exact).abs() / unwindowed.max(1.0));
        }
    }
    worst
}

fn assert_distance<A: Attenuation>(
    name: &str,
    model: impl Fn(f32) -> A + Copy,
    oracle: fn(f64) -> oracle::Attenuation,
) {
    let measured = [
        distance_error::<f32, A>(model, oracle),
        distance_error::<Fx32, A>(model, oracle),
        distance_error::<Fx16, A>(model, oracle),
    ];
    bounds::assert_row("attenuation", name, measured);
}

#[test]
fn no_fall_keeps_its_row() {
    assert_distance("unattenuated", |_| NoAttenuation, |_| oracle::Attenuation::None);
}

#[test]
fn inverse_square_keeps_its_row() {
    assert_distance("inverse square", |_| InverseSquare, |_| oracle::Attenuation::InverseSquare);
}

#[test]
fn polynomial_keeps_its_row() {
    let model = |range: f32| Polynomial::new(0.5, 0.25, 4.0 / (range * range)).expect("sound");
    assert_distance("polynomial", model, |r| {
        oracle::Attenuation::Polynomial([0.5, 0.25, f64::from(4.0_f32 / (r * r) as f32)])
    });
}

#[test]
fn smooth_range_keeps_its_row() {
    assert_distance(
        "smooth range",
        |r| SmoothRange::new(r).expect("sound"),
        oracle::Attenuation::SmoothRange,
    );
}

#[test]
fn gltf_range_keeps_its_row() {
    assert_distance(
        "glTF range",
        |r| GltfRange::new(InverseSquare, Some(r)).expect("sound"),
        oracle::Attenuation::GltfRange,
    );
}

#[test]
fn filament_range_keeps_its_row() {
    let model = |r| FilamentRange::new(InverseSquare, Some(r)).expect("sound");
    assert_distance("Filament range", model, oracle::Attenuation::FilamentRange);
}

/// A specular lobe against its reference, near the mirror direction and far from it.
fn highlight_error<S: Format, H: SpecularLobe>(oracle: Lobe, shininess: u32) -> f64 {
    let mut rng = Rng::with_seed(75);
    let constants = H::constants::<S>(shininess);
    let mut worst = 0.0_f64;
    for _ in 0..200_000 * sweep::effort() {
        let normal = sweep::single(sweep::direction(&mut rng)).map(S::from_f32);
        let exact_normal = S::exact_normal(normal).normalize();
        let to_light = direction_within(&mut rng, exact_normal, 1.5);
        let mirror = (-to_light).reflect(exact_normal);
        let to_eye = direction_within(&mut rng, mirror, (4.0 / f64::from(shininess).sqrt()).min(3.0));
        // An eye below the surface does not see it, and one just above it may have no direction
        // halfway to the light.
        if to_eye.dot(exact_normal) < 0.1 {
            continue;
        }
        let incoming = S::axis(sweep::single(-to_light));
        let view = S::axis(sweep::single(to_eye));
        let exact = oracle(
            -S::exact_direction(incoming).normalize(),
            S::exact_direction(view).normalize(),
            exact_normal,
            shininess.into(),
        );
        let lobe = H::lobe::<S>(&constants, incoming, normal, view).exact();
        worst = worst.max((lobe - exact).abs());
    }
    worst
}

fn assert_highlight<H: SpecularLobe>(name: &str, oracle: Lobe, shininesses: [u32; 3]) {
    for shininess in shininesses {
        let measured = [
            highlight_error::<f32, H>(oracle, shininess),
            highlight_error::<Fx32, H>(oracle, shininess),
            highlight_error::<Fx16, H>(oracle, shininess),
        ];
        bounds::assert_row("lobe", &format!("{name} {shininess}"), measured);
    }
}

#[test]
fn phong_keeps_its_rows() {
    assert_highlight::<Phong>("phong", oracle::phong, [2, 32, 256]);
}

#[test]
fn blinn_phong_keeps_its_rows() {
    assert_highlight::<BlinnPhong>("blinn-phong", oracle::blinn_phong, [2, 32, 256]);
}

#[test]
fn dual_cone_keeps_its_rows() {
    assert_highlight::<DualConeLobe>("dual cone", oracle::dual_cone, [2, 32, 256]);
}

#[test]
fn lyon_keeps_its_rows() {
    assert_highlight::<DifferenceForm<Phong, 2>>("difference-form", oracle::lyon, [4, 32, 256]);
}

/// The lobe for light that falls vertically on a horizontal surface, seen from this versine off the
/// mirror direction.
fn lobe_at<H: SpecularLobe, S: Format>(shininess: u32, versine: f32) -> f64 {
    let cosine = 1.0 - versine;
    let [up, down, view] = [[0.0, 1.0], [0.0, -1.0], [(1.0 - cosine * cosine).sqrt(), cosine]]
        .map(|[x, y]| Vec3::new(x, y, 0.0_f32));
    H::lobe::<S>(&H::constants::<S>(shininess), S::axis(down), up.map(S::from_f32), S::axis(view)).exact()
}

fn assert_end<H: SpecularLobe>(shininess: [u32; 3]) {
    for shininess in shininess {
        let end = H::end(shininess);
        let [inside, outside] = [0.8, 1.001].map(|part| {
            let versine = part * end;
            [lobe_at::<H, f32>, lobe_at::<H, Fx32>, lobe_at::<H, Fx16>].map(|lobe| lobe(shininess, versine))
        });
        assert!(H::SHINES == inside.iter().all(|lobe| *lobe > 0.0), "{shininess}: {inside:?} before {end}");
        assert_eq!(outside, [0.0; 3], "{shininess}: after {end}");
    }
}

#[test]
fn a_highlight_ends_where_it_says() {
    assert_end::<Phong>([1, 2, 4]);
    assert_end::<DifferenceForm<Phong, 2>>([4, 32, 256]);
    assert_end::<NoSpecular>([0, 1, 32]);
}

/// The difference form against the power, over the angle between the two directions.
#[test]
fn lyons_form_is_as_near_to_the_power_as_is_stated() {
    for squarings in [2, 3, 4] {
        let largest = [16.0_f64, 64.0, 256.0].map(|shininess| {
            let off = (0..=100_000).map(|i| {
                let cosine = f64::from(i) / 100_000.0;
                let factor = shininess / f64::from(1 << squarings);
                let lyon = (1.0 - factor * (1.0 - cosine)).max(0.0).powi(1 << squarings);
                (lyon - cosine.powf(shininess)).abs()
            });
            off.fold(0.0, f64::max)
        });
        println!("difference form, {squarings} squarings: {}", bounds::shown(&largest));
        let name = format!("{squarings} squarings");
        bounds::assert_kept(&bounds::broken("difference form", &name, "f64", &largest));
    }
}

/// The largest errors of the whole equation, in linear light and in display codes.
fn lit_errors<S: Format>() -> [f64; 2] {
    let mut rng = Rng::with_seed(1975);
    let outer_degrees = 20.0_f32;
    let cone = Cone::from_outer(Soft, sweep::half(outer_degrees)).expect("a sound cone");
    // Channels that every format stores exactly.
    let [ma, md, ms] = [0.25_f32, 0.625, 0.375];
    let [ia, diffuse, specular] = [0.125_f32, 0.75, 0.5];
    let grey = |value: f32| Rgb::new(value, value, value);
    let material = Material::new(grey(md))
        .and_then(|material| material.with_ambient(grey(ma)))
        .and_then(|material| material.with_highlight(Phong, grey(ms), 32))
        .expect("a sound material");
    let ambient = AmbientLight::new(grey(ia)).expect("sound").compile::<S>();
    let compiled = material.compile::<S>();
    let (mut linear, mut codes) = (0.0_f64, 0.0_f64);
    for _ in 0..200 * sweep::effort() {
        let reach = 1.0 + 15.0 * rng.f32();
        let spot = sweep::spot(&mut rng, cone)
            .with_color(grey(diffuse))
            .and_then(|spot| spot.with_specular_color(grey(specular)))
            .and_then(|spot| spot.with_intensity((reach * reach).round()))
            .expect("a sound light");
        let lit = spot.compile::<S>().expect("held");
        let exact_cone = oracle::Cone::new(oracle::soft, oracle::versine(outer_degrees.into()));
        let exact_spot = sweep::stored::<S, _, _>(&spot, exact_cone);
        for _ in 0..1_000 {
            let distance = f64::from(reach) * (1.0 + rng.f64());
            let way = direction_within(&mut rng, exact_spot.axis, 0.4);
            let site = sweep::on_grid(exact_spot.position + distance * way);
            let normal = direction_within(&mut rng, -way, 1.7);
            let normal = sweep::single(normal).map(S::from_f32);
            let exact_normal = S::exact_normal(normal);
            let to_light = (exact_spot.position - site).normalize();
            // At grazing incidence the highlight jumps to zero, in the model itself: no format can
            // place the jump.
            if exact_normal.normalize().dot(to_light).abs() < 1e-3 {
                continue;
            }
            let mirror = (-to_light).reflect(exact_normal.normalize());
            let eye_way = direction_within(&mut rng, mirror, 0.8);
            let eye = sweep::on_grid(site + 5.0 * eye_way);
            let to_length = |v: DVec3| sweep::single(v).map(S::length);
            let surface = SurfacePoint::seen_from(to_length(eye), to_length(site), normal);
            let light = compiled.glow(ambient) + compiled.reflect(&surface, &lit);
            let classic = Classic {
                ambient: [ma.into(), ia.into()],
                diffuse: [md.into(), diffuse.into()],
                specular: [ms.into(), specular.into()],
                shininess: 32.0,
            };
            let to_eye = (eye - site).normalize();
            let exact = classic.light(exact_spot.arriving(site), to_light, to_eye, exact_normal.normalize());
            linear = linear.max((S::exact_light(light.red) - exact).abs());
            let code = f64::from(encode_srgb(clip(light).red));
            codes = codes.max((code - oracle::srgb_code(exact.min(1.0))).abs());
        }
    }
    [linear, codes]
}

#[test]
fn the_lit_point_keeps_its_rows() {
    let [float, wide, narrow] = [lit_errors::<f32>(), lit_errors::<Fx32>(), lit_errors::<Fx16>()];
    let column = |i: usize| [float[i], wide[i], narrow[i]];
    bounds::assert_row("lit point", "linear", column(0));
    bounds::assert_row("lit point", "codes", column(1));
}
