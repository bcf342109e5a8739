//! Pixels of surfaces of one colour from a table, against f64: a cell of 8 x 8 pixels has the mean
//! steps of the colour that it shows.

use fastrand::Rng;
use luminaire::display::{Rgb565, Rgb565Ramp};
use luminaire::number::{Light16, Light32};
use luminaire::{Fx16, Fx32, Rgb};
use support::oracle::climb::Search;

use crate::draw::steps;

/// The last codes of red, green and blue.
const LASTS: [u32; 3] = [31, 63, 31];

/// The steps that a cell of the dither shows on average.
fn shown(ramp: &Rgb565Ramp, light: Light16) -> [f64; 3] {
    let mut mean = [0.0; 3];
    for (x, y) in (0..64).map(|place| (place % 8, place / 8)) {
        let Rgb565(pixel) = ramp.pixel::<Fx16>(light, x, y);
        let codes = [pixel >> 11, pixel >> 5 & 63, pixel & 31];
        mean.iter_mut().zip(codes).for_each(|(mean, code)| *mean += f64::from(code) / 64.0);
    }
    mean
}

/// A grey surface and an irradiance in steps of 2^-14: its base, what it reflects, and the light.
type Case = (f32, f32, u32);

/// The largest error of a channel, in steps of RGB565.
fn error((base, reflected, light): Case) -> f64 {
    let gray = |value| Rgb::new(value, value, value);
    let ramp = Rgb565Ramp::new(gray(base), gray(reflected)).expect("a ramp");
    // Past 4 every level is the last.
    let exact = f64::from(base) + f64::from(light) / 16_384.0 * f64::from(reflected);
    let found = shown(&ramp, Light16::from_bits(light)).into_iter().zip(LASTS);
    found.map(|(found, last)| (found - steps(exact, last)).abs()).fold(0.0, f64::max)
}

/// The largest error with a base of at least `least`, searched.
fn worst(least: f32) -> f64 {
    let somewhere = |rng: &mut Rng| {
        let base = least + (1.0 - least) * rng.f32().powi(4);
        let (reflected, bits) = (if rng.bool() { 1.0 } else { rng.f32() }, rng.u32(8..=16));
        // Half the time at an end of a level of the width that begins there.
        let light = if rng.bool() { (1 << (bits & !1)) - 8 } else { rng.u32(0..1 << bits) };
        (base, reflected, light)
    };
    let moved = |rng: &mut Rng, (base, reflected, light): Case| match rng.u8(0..3) {
        0 => ((base * (1.0 + 0.1 * (rng.f32() - 0.5))).clamp(least, 1.0), reflected, light),
        1 => (base, (reflected + 0.02 * (rng.f32() - 0.5)).clamp(0.0, 1.0), light),
        _ => (base, reflected, light.saturating_add_signed(rng.i32(-20..=20)).min((1 << 16) - 1)),
    };
    let search = Search { starts: 3_000, climbs: 4, steps: 1_000, ..Search::default() };
    let worst = search.worst(somewhere, moved, error).expect("an error");
    println!("from {least}: {:.4} steps at {:?}", worst.error, worst.input);
    worst.error
}

/// The errors of darkness are those of the 32nds of a step alone.
#[test]
fn a_cell_without_light_shows_its_base() {
    let bases = (0..=1_000).map(|base| (base as f32 / 1_000.0).powi(3));
    let worst = bases.map(|base| error((base, 1.0, 0))).fold(0.0, f64::max);
    assert!((0.0154..=0.0158).contains(&worst), "{worst} steps");
}

#[test]
fn a_cell_shows_the_steps_of_its_light() {
    let (dark, lit) = (worst(0.0), worst(0.01));
    assert!((0.38..=0.42).contains(&dark), "{dark} steps");
    assert!((0.22..=0.24).contains(&lit), "{lit} steps");
}

/// Exhaustive over the light.
#[test]
fn no_code_falls_when_light_rises() {
    let ramp = Rgb565Ramp::new(Rgb::new(0.01, 0.0, 0.2), Rgb::new(0.9, 0.5, 0.1)).expect("a ramp");
    for (x, y) in (0..64).map(|place| (place % 8, place / 8)) {
        let mut before = [0; 3];
        for light in 0..1 << 17 {
            let Rgb565(pixel) = ramp.pixel::<Fx16>(Light16::from_bits(light), x, y);
            let codes = [pixel >> 11, pixel >> 5 & 63, pixel & 31];
            let falls = codes.iter().zip(before).any(|(&code, before)| code < before);
            assert!(!falls, "{before:?}, then {codes:?} at {light}");
            before = codes;
        }
    }
}

#[test]
fn every_format_has_the_pixels_of_sixteen_bits() {
    let ramp = Rgb565Ramp::new(Rgb::new(0.02, 0.1, 0.0), Rgb::new(0.7, 0.4, 1.0)).expect("a ramp");
    for (light, x) in (0..1 << 17).step_by(7).chain([u32::MAX]).zip(0..) {
        let pixel = ramp.pixel::<Fx16>(Light16::from_bits(light), x, x / 8);
        let wide = Light32::from_bits(u64::from(light) << 16 | 0xffff);
        assert_eq!(ramp.pixel::<Fx32>(wide, x, x / 8), pixel, "{light}");
        assert_eq!(ramp.pixel::<f32>(light as f32 / 16_384.0, x, x / 8), pixel, "{light}");
    }
    for nothing in [f32::NAN, -1.0, f32::NEG_INFINITY] {
        assert_eq!(ramp.pixel::<f32>(nothing, 1, 2), ramp.pixel::<f32>(0.0, 1, 2));
    }
    assert_eq!(ramp.pixel::<f32>(f32::INFINITY, 1, 2), ramp.pixel::<f32>(4.0, 1, 2));
    assert_eq!(ramp.pixel::<Fx32>(Light32::from_bits(u64::MAX), 1, 2), ramp.pixel::<f32>(4.0, 1, 2));
}

/// Levels of any bits: every pixel is defined.
#[test]
fn any_levels_give_a_pixel() {
    let mut rng = Rng::with_seed(565);
    for _ in 0..100 {
        let ramp = Rgb565Ramp::from_levels(std::array::from_fn(|_| rng.u32(..)));
        for _ in 0..1_000 {
            ramp.pixel::<Fx16>(Light16::from_bits(rng.u32(..)), rng.u32(..), rng.u32(..));
        }
    }
}

#[test]
fn a_colour_outside_the_range_is_refused() {
    let (black, white) = (Rgb::new(0.0, 0.0, 0.0), Rgb::new(1.0, 1.0, 1.0));
    assert!(Rgb565Ramp::new(black, white).is_ok());
    for wrong in [-0.1, 1.1, f32::NAN, f32::INFINITY] {
        let wrong = Rgb::new(0.5, wrong, 0.5);
        for refused in [Rgb565Ramp::new(wrong, white), Rgb565Ramp::new(black, wrong)] {
            let text = refused.expect_err("a colour outside the range").to_string();
            assert!(text.contains("color") && text.contains("from 0 to 1"), "{text}");
        }
    }
}
