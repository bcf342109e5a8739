//! Accuracy of a real power of the distance, against f64.

use fastrand::Rng;
use luminaire::{
    Fx16, Fx32, PointLight,
    attenuation::{Attenuation, Decay},
};
use support::{
    format::Format,
    oracle::{self, DVec3},
    sweep,
};

/// Bounds of the relative error of the light at a facing surface, as a constant and as a multiple of
/// the exponent. The constant has the rounding of products, the multiple that of the distance and of
/// the logarithm. Those of `Fx32` are sums of the errors of its stages: light 6.2e-8, cosine 4.1e-8 and
/// exponential 1e-9; length 2.1e-8 and logarithm 1.4e-9.
struct Bounds {
    constant: f64,
    times_exponent: f64,
}

/// The largest relative error, in parts of its bound, over points at distances from 0.1 to 30. A light
/// that is darker than 100 steps of the format, or brighter than it holds, is left out.
fn worst<S: Format>(bounds: &Bounds, step: f64, brightest: f64) -> f64 {
    let mut rng = Rng::with_seed(1977);
    let mut worst = 0.0_f64;
    for exponent in [0.25, 0.5, 1.0, 1.5, 2.0, 3.3, 5.0, 8.0, 16.0_f32] {
        let decay = Decay::new(exponent, 1e6).expect("a sound decay");
        let model = oracle::Attenuation::Decay([exponent.into(), 1e6]);
        let light = PointLight::new([0.0; 3]).expect("a sound light").with_attenuation(decay);
        let light = light.compile::<S>().expect("a light that the format holds");
        for _ in 0..2_000 * sweep::effort() {
            let angle = std::f64::consts::PI * rng.f64();
            let way = sweep::direction_off(&mut rng, DVec3::Y, angle);
            let place = sweep::on_grid(0.1 * 300.0_f64.powf(rng.f64()) * way);
            let exact = model.at(place.length());
            assert!((decay.exact(place.length()) / exact - 1.0).abs() < 1e-12);
            if !(100.0 * step..=brightest).contains(&exact) {
                continue;
            }
            let normal = sweep::single(-place.normalize()).map(S::from_f32);
            let cosine = -place.normalize().dot(S::exact_normal(normal));
            let found = S::exact_light(light.irradiance(sweep::single(place).map(S::length), normal));
            let error = (found - exact * cosine).abs() - step / 2.0;
            let bound = bounds.constant + bounds.times_exponent * f64::from(exponent);
            worst = worst.max(error / exact / bound);
        }
    }
    println!("{}: {worst:.3} of the bound", S::NAME);
    worst
}

#[test]
fn a_decay_keeps_its_bounds() {
    let parts = [
        worst::<f32>(&Bounds { constant: 3e-7, times_exponent: 1.5e-7 }, 0.0, 1e6),
        worst::<Fx32>(&Bounds { constant: 1.04e-7, times_exponent: 2.3e-8 }, 0.5_f64.powi(30), 1e6),
        worst::<Fx16>(&Bounds { constant: 5e-4, times_exponent: 5e-5 }, 0.5_f64.powi(14), 1e5),
    ];
    assert!(
        parts.iter().all(|part| (0.3..=1.0).contains(part)),
        "{parts:?} of the bounds, expected 0.3 to 1"
    );
}

#[test]
fn a_decay_at_the_light_is_its_cap() {
    for most in [1.0, 100.0, 1e6] {
        let decay = Decay::new(1.5, most).expect("a sound decay");
        assert_eq!([decay.exact(0.0), decay.exact(1e-9)], [f64::from(most); 2]);
    }
}
