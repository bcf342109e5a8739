//! Light is linear: twice the intensity is twice the light, and lights add in any order.

use super::format::Format;
use super::scene;
use super::words::Words;
use luminaire::{Rgb, falloff::Soft};

/// Up to full scale, a light of twice the intensity gives twice the light: exactly in f32 unless
/// the light is subnormal, and within the roundings of both values in fixed point.
pub fn twice_is_twice<S: Format>(words: &[u32]) {
    let _: Option<()> = twice::<S>(&mut Words::tame(words));
}

fn twice<S: Format>(words: &mut Words<'_>) -> Option<()> {
    let cone = scene::cone::<S, _>(words, Soft)?;
    let places = scene::places::<S>(words);
    let spot = scene::spot(words, cone, places)?;
    let spot = spot.with_intensity(spot.intensity().min(5e8)).ok()?;
    let (point, normal) = (words.point::<S>(places[1]), words.normal::<S>());
    let light = |factor: f32| {
        let light = spot.with_intensity(factor * spot.intensity()).ok()?.compile::<S>().ok()?;
        Some(S::exact_light(light.irradiance(point, normal)))
    };
    let (once, twice) = (light(1.0)?, light(2.0)?);
    let underflows = S::NAME == "f32" && once.min(f64::from(spot.intensity())) < f64::from(f32::MIN_POSITIVE);
    if twice <= 1.0 && !underflows {
        let (from, to) = (S::exact_point(spot.position().map(S::length)), S::exact_point(point));
        let gain = 2.0 * f64::from(spot.intensity()) / from.distance_squared(to);
        // In 16 bits one of the two may be evaluated finely and the other not, each within half a
        // code.
        let steps = match S::NAME {
            "f32" => 0.0,
            "fx16" if (0.3..64.0).contains(&gain) => 96.0,
            _ => 1.0,
        };
        let off = (twice - 2.0 * once).abs() / f64::from(S::STEP);
        assert!(off <= steps, "{spot:?} {point:?} {normal:?}: {once} and {twice}");
    }
    Some(())
}

/// In fixed point the sum over lights is bit-identical in any order, even if it saturates. In f32
/// two orders differ by at most one rounding for each light.
pub fn order_does_not_matter<S: Format>(words: &[u32]) {
    let words = &mut Words::new(words);
    let mut lights: Vec<Rgb<S::Irradiance>> = Vec::new();
    for _ in 0..2 + words.choice(6) {
        let color = scene::color(words).map(S::from_f32);
        let light = S::from_f32(words.number(0.0, 2.0)).light(S::gain(words.number(0.0, 1e6)));
        lights.push(Rgb::lit::<S>(light, color.map(|c| S::from_f32(c.to_f32().clamp(0.0, 1.0)))));
    }
    let sum = |lights: &mut dyn Iterator<Item = Rgb<S::Irradiance>>| {
        lights.fold(Rgb::default(), |sum: Rgb<S::Irradiance>, light| sum + light)
    };
    let middle = lights.len() / 2;
    let forth = sum(&mut lights.iter().copied());
    let back = sum(&mut lights.iter().rev().copied());
    let swapped = sum(&mut lights[middle..].iter().chain(&lights[..middle]).copied());
    for other in [back, swapped] {
        if S::NAME == "f32" {
            for (a, b) in [(forth.red, other.red), (forth.green, other.green), (forth.blue, other.blue)] {
                let (a, b) = (S::exact_light(a), S::exact_light(b));
                let roundings = lights.len() as f64 * f64::from(S::STEP);
                assert!((a - b).abs() <= roundings * a.max(b), "{lights:?}: {a} and {b}");
            }
        } else {
            assert_eq!(forth, other, "{lights:?}");
        }
    }
}
