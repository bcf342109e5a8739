//! What a user sees of the roundings, beside what no method can do better: the error from an ideal
//! position and axis to the display, and what the rounding of these inputs alone makes of it.
//!
//! `LUMINAIRE_FULL=1 cargo test --test slow limits:: -- --nocapture --test-threads 1` prints the
//! measured rows.

use fastrand::Rng;
use luminaire::{
    Fx16, Fx32, SpotLight,
    display::encode_srgb,
    falloff::{AnyFalloff, Falloff},
};
use support::{
    beams,
    bounds::{self, REFUSE},
    falloffs::{self, Shape},
    format::Format,
    limits::{self, CONES, Column, DISTANCE, LIGHT_WITHIN, TABLES},
    oracle::{self, DVec3},
    sweep,
};

/// The largest errors, linear and in codes, from ideal inputs: the format rounds position, axis and
/// point.
fn errors<S: Format, P: Falloff>(shape: &Shape<P>, half_degrees: f32) -> [f64; 2] {
    let cone = shape.at(half_degrees);
    if cone.compile::<S>().is_err() {
        return [REFUSE; 2];
    }
    let exact = shape.exactly_at(half_degrees);
    let mut rng = Rng::with_seed(8);
    let mut worst = [0.0_f64; 2];
    for _ in 0..200 * sweep::effort() {
        let position = DVec3::from_array([0; 3].map(|_| LIGHT_WITHIN * (2.0 * rng.f64() - 1.0)));
        let axis = sweep::direction(&mut rng);
        let spot = SpotLight::new(sweep::single(position), sweep::single(axis), cone).expect("a sound light");
        let compiled = spot.compile::<S>().expect("the cone compiled");
        for _ in 0..500 {
            let off_axis = f64::from(half_degrees).to_radians() * rng.f64();
            let way = sweep::direction_off(&mut rng, axis, off_axis);
            let point = position + DISTANCE * way;
            let ideal = exact.falloff(2.0 * (off_axis / 2.0).sin().powi(2));
            let found = compiled.falloff_at(sweep::single(point).map(S::length));
            let code = f64::from(encode_srgb(found)) - oracle::srgb_code(ideal);
            worst = [
                worst[0].max(oracle::counted(255.0 * (found.exact() - ideal).abs())),
                worst[1].max(code.abs()),
            ];
        }
    }
    worst
}

/// What the rounding of the inputs alone makes, at most: linear and in codes, for each cone.
fn limit<S: Format, P: Falloff>(shape: &Shape<P>) -> [Column; 2] {
    let at = CONES.map(|half| {
        limits::largest_change(&shape.exactly_at(half), half.into(), limits::input_rounding::<S>(), 0.0)
    });
    [at.map(|[linear, _]| linear), at.map(|[_, codes]| codes)]
}

/// What the kernel may add of its own, linear and in codes: the rounding from a versine to an
/// intensity by its row in the table of bounds, and what the length of its directions is off:
/// `|l| = 1 + e` stretches every versine by `e`.
fn own<S: Format, P: Falloff>(shape: &Shape<P>, half_degrees: f32) -> [f64; 2] {
    let row = bounds::of("falloff", shape.name, S::NAME).expect("every falloff has a row");
    let falloff = row[0] * f64::from(S::STEP);
    let stretch = beams::operation::<S>("ray direction its length");
    let [linear, codes] =
        limits::largest_change(&shape.exactly_at(half_degrees), half_degrees.into(), 0.0, stretch);
    // A step of the linear value is worth most codes where the sRGB curve is straight. Half a code
    // is the display's.
    [linear + 255.0 * falloff, codes + 255.0 * 12.92 * falloff + 0.502]
}

fn show(errors: Column) -> String {
    errors.map(|error| format!("{error:.2e}")).join(", ")
}

/// What a shape breaks of its row and of four times its limit.
fn broken<S: Format, P: Falloff>(shape: &Shape<P>) -> Vec<String> {
    let measured = CONES.map(|half| errors::<S, P>(shape, half));
    let measured = [measured.map(|[linear, _]| linear), measured.map(|[_, codes]| codes)];
    let limit = limit::<S, P>(shape);
    println!("{} {}:", shape.name, S::NAME);
    println!("    linear: [{}], limits [{}]", show(measured[0]), show(limit[0]));
    println!("    codes:  [{}], limits [{}]", show(measured[1]), show(limit[1]));
    let own = CONES.map(|half| own::<S, P>(shape, half));
    let mut broken = Vec::new();
    for (of, table) in TABLES.into_iter().enumerate() {
        broken.extend(bounds::broken(table, shape.name, S::NAME, &measured[of]));
        for (i, half_degrees) in CONES.into_iter().enumerate() {
            let (error, most) = (measured[of][i], 4.0 * limit[of][i] + own[i][of]);
            if error != REFUSE && error > most {
                let cell = format!("{table} {} {} at {half_degrees} degrees", shape.name, S::NAME);
                broken.push(format!("{cell}: {error:.2e}, expected four times the limit, {most:.2e}"));
            }
        }
    }
    broken
}

fn each<S: Format>() -> Vec<String> {
    shapes().iter().flat_map(broken::<S, _>).collect()
}

/// The shapes of the tables.
fn shapes() -> Vec<Shape<AnyFalloff>> {
    let is_of_them = |shape: &Shape<_>| limits::FALLOFFS.contains(&shape.name);
    falloffs::listed().into_iter().filter(is_of_them).collect()
}

#[test]
fn f32_is_within_four_times_the_limit() {
    bounds::assert_kept(&each::<f32>());
}

#[test]
fn fx32_is_within_four_times_the_limit() {
    bounds::assert_kept(&each::<Fx32>());
}

#[test]
fn fx16_is_within_four_times_the_limit() {
    bounds::assert_kept(&each::<Fx16>());
}

/// The a-priori bound of the versine form is kept, and its part that grows as the cone narrows is
/// no more than two and a half times what random points find; the cosine form is off by
/// `4 c / theta^2`, with the error `c` of the cosine in steps of its format.
fn assert_forms<S: Format>(half_angles: [f64; 3], cosine_steps: std::ops::RangeInclusive<f64>) {
    for half_degrees in half_angles {
        let found = beams::errors::<S>(half_degrees, 20_000 * sweep::effort());
        let (versine, bound) = (found.versine_form.expect("held"), beams::versine_bound::<S>(half_degrees));
        assert!((bound / 2.5..=bound).contains(&versine), "{} at {half_degrees}: {versine:.2e}", S::NAME);
        let theta = half_degrees.to_radians();
        let steps = found.cosine_form * theta * theta / 4.0 / f64::from(S::STEP);
        println!("{} at {half_degrees}: {versine:.2e} within {bound:.2e}, cosine {steps:.2} steps", S::NAME);
        let lost = found.cosine_form > 0.5;
        assert!(lost || cosine_steps.contains(&steps), "{} at {half_degrees}: {steps:.2} steps", S::NAME);
    }
}

#[test]
fn the_two_forms_keep_their_a_priori_bounds() {
    assert_forms::<f32>([0.0052, 0.1, 1.0], 1.2..=2.0);
    // The length of a direction has an error of up to 26 steps of 2^-30.
    assert_forms::<Fx32>([0.00013, 0.01, 0.1], 5.0..=26.0);
    assert_forms::<Fx16>([1.0, 2.0, 3.0], 2.0..=4.0);
}

/// The tables of the documentation are those of the bounds.
#[test]
fn the_documented_tables_are_up_to_date() {
    let shapes = shapes();
    let block = limits::markdown(|falloff, format| {
        let shape = shapes.iter().find(|shape| shape.name == falloff).expect("a falloff of the list");
        match format {
            "f32" => limit::<f32, _>(shape),
            "fx32" => limit::<Fx32, _>(shape),
            _ => limit::<Fx16, _>(shape),
        }
    });
    let page = include_str!("../../docs/NUMERICS.md");
    assert!(page.contains(&block), "replace the tables under \"What a user sees\" by these:\n\n{block}");
}
