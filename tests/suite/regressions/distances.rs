//! Distances that were lost, and ranges that were swapped.

use super::case::assert_fault;
use super::edges::smoothstep_by_comparison;
use luminaire::{
    Fx16, Fx32, PointLight, Vec3,
    attenuation::{Attenuation, Polynomial, SmoothRange},
};
use support::assert_that;
use support::{format::Format, oracle, prices};

/// Holds a distance model to its row of the table of prices in one format, from 0.05 to 12 units
/// straight above a floor.
fn assert_held<S: Format, A: Attenuation>(row: &str, bound: f64, model: A, oracle: oracle::Attenuation) {
    let light = PointLight::new(Vec3::default()).expect("sound").with_attenuation(model);
    let light = light.compile::<S>().expect("held");
    let up = Vec3::new(S::ZERO, S::ONE, S::ZERO);
    for sixty_fourths in 3..=768_u16 {
        let distance = f32::from(sixty_fourths) / 64.0;
        let point = Vec3::new(0.0, -distance, 0.0).map(S::length);
        let error = (S::exact_light(light.irradiance(point, up)) - oracle.at(distance.into())).abs();
        assert_that!(error <= bound, row, S::NAME, distance, error);
    }
}

fn assert_held_by_all<A: Attenuation>(row: &str, model: A, oracle: oracle::Attenuation) {
    let bounds = prices::DISTANCE.iter().find(|known| known.model == row).expect("a row").bounds;
    assert_held::<f32, A>(row, bounds[0], model, oracle);
    assert_held::<Fx32, A>(row, bounds[1], model, oracle);
    assert_held::<Fx16, A>(row, bounds[2], model, oracle);
}

/// C-Chads/tinygl, src/light.c: with `TGL_FEATURE_FISR` the offset is scaled by a fast reciprocal
/// root, and the distance stays at the 0 it was declared with. A light then falls with no distance
/// at all: at 10 units 101 times too bright.
#[test]
fn tinygl_attenuates_by_a_distance_of_zero() {
    let attenuated = |is_fast: bool, squared: f32| {
        let dist = if is_fast { 0.0 } else { squared.sqrt() };
        1.0 / (1.0 + dist * (0.0 + dist * 1.0))
    };
    assert_fault(attenuated(true, 100.0) / attenuated(false, 100.0), 100.9..=101.1);
    let model = Polynomial::new(1.0, 0.0, 1.0).expect("sound");
    assert_held_by_all("polynomial", model, oracle::Attenuation::Polynomial([1.0, 0.0, 1.0]));
}

/// *Quick 'n' Easy Dual-Cone Spotlight in GLSL*: `smoothstep(lightRange, 0.0, distToLight)`, whose
/// edges fall, so that GLSL leaves it undefined. Where the edges are compared first the light is
/// dark up to its range, and lit from there on.
#[test]
fn the_dual_cone_article_fades_from_its_range_to_zero() {
    let range = 8.0;
    assert_eq!([0.0, 4.0, 7.9].map(|d| smoothstep_by_comparison(range, 0.0, d)), [0.0; 3]);
    assert_eq!([8.0, 80.0].map(|d| smoothstep_by_comparison(range, 0.0, d)), [1.0; 2]);
    let model = SmoothRange::new(range).expect("sound");
    assert_held_by_all("smooth range", model, oracle::Attenuation::SmoothRange(range.into()));
}
