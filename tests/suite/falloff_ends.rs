//! Angles, flux and steepness of falloffs at the ends of their parameters, which the list of models
//! does not sample.

use luminaire::{
    Error,
    falloff::{Falloff, Formula, InvertedRealPower, Quadratic, RealPower, SoftOrHard},
};

use crate::setup::{last_u, relative};

/// The largest slope between two shares of the outer half angle, as [`largest_slope`].
fn slope_within(formula: Formula<'_>, hotspot: f64, [from, to]: [f64; 2]) -> f64 {
    let intensity = |angle: f64| formula.exact(((1.0 - angle * angle) / (1.0 - hotspot)).clamp(0.0, 1.0));
    let width = (to - from) / 400_000.0;
    let slope =
        |i| (intensity(from + width * f64::from(i)) - intensity(from + width * f64::from(i + 1))) / width;
    (0..400_000).map(slope).fold(0.0, f64::max)
}

/// The figures of a falloff whose slope may have no bound within strips at both ends. Differences
/// miss a part of a slope that changes quickly.
fn assert_figures<P: Falloff>(falloff: P, strips: [f64; 2], slope_error: f64) {
    assert_angles_and_flux(falloff, 1e-6);
    let formula = falloff.formula();
    for hotspot in [0.0, 0.25, 0.9] {
        let start = f64::from(hotspot).sqrt();
        let found = slope_within(formula, hotspot.into(), [start + strips[0], 1.0 - strips[1]]);
        let stated = falloff.steepness(hotspot);
        assert!(
            relative(stated, found.max(1.0)) < slope_error,
            "{formula:?}: {stated} at {hotspot}, expected {found}"
        );
    }
}

fn assert_angles_and_flux<P: Falloff>(falloff: P, integral_error: f64) {
    let formula = falloff.formula();
    for (found, intensity) in [(falloff.beam_versine(), 0.5), (falloff.field_versine(), 0.1)] {
        let exact = last_u(|t| formula.exact(t.max(1e-30)), intensity);
        // Some are found by halving the whole ramp 26 times.
        assert!(
            (f64::from(found) - exact).abs() < 1e-6 * exact + 8e-9,
            "{formula:?}: {found} for {intensity}, expected {exact}"
        );
    }
    for to in [1e-12_f32, 2e-7, 9.7e-7, 2.8e-5, 1.5e-4, 3e-4, 0.02, 0.3, 0.999] {
        // Steps that are short at both ends, where a root is steep.
        let steps = 40_000;
        let at = |i: f64| f64::from(to) * (i / f64::from(steps)).powi(3);
        let height = |i: f64| formula.exact(1.0 - at(i + 0.5)) * (at(i + 1.0) - at(i));
        let exact: f64 = (0..steps).map(|i| height(f64::from(i))).sum();
        let found = falloff.integral(to);
        assert!(relative(found, exact) < integral_error, "{formula:?}: {found} up to {to}, expected {exact}");
    }
}

/// Real powers that the list does not sample: roots, the floor of a light from Godot, and the
/// largest exponent.
#[test]
fn figures_of_real_powers_hold_at_the_ends_of_their_exponents() -> Result<(), Error> {
    const STRIP: f64 = 1.0 / 510.0;
    for exponent in [0.05, 0.3, 0.7, 1.0, 1.5, 33.3] {
        let strip = if exponent < 1.0 { STRIP } else { 0.0 };
        if exponent > 0.1 {
            assert_figures(RealPower::new(exponent)?, [0.0, strip], 6e-4);
            assert_figures(InvertedRealPower::new(exponent)?, [strip, 0.0], 6e-4);
        }
        if exponent == 1.0 {
            continue;
        }
        assert_figures(InvertedRealPower::with_floor(exponent, 1e-4)?, [strip, 0.0], 6e-4);
    }
    assert_angles_and_flux(RealPower::new(1_024.0)?, 2e-7);
    assert_angles_and_flux(InvertedRealPower::new(1_024.0)?, 2e-7);
    Ok(())
}

/// Slopes of nearly 0.
#[test]
fn figures_of_polynomials_hold_at_the_ends_of_their_parameters() -> Result<(), Error> {
    for slope in [0.0, 0.000_5, 1.999, 2.0] {
        assert_figures(Quadratic::new(slope)?, [0.0; 2], 4e-3);
        assert_eq!(Quadratic::from_bits(slope.to_bits()).edge_slope(), slope);
    }
    Ok(())
}

/// Roots so high that they are nearly a step are as steep as one, and a linear falloff is exactly
/// as steep at its edge as its formula.
#[test]
fn the_steepness_of_a_step_and_of_a_line() -> Result<(), Error> {
    assert_eq!(RealPower::new(1e-5)?.steepness(0.0), 1.0);
    assert_eq!(InvertedRealPower::new(1e-5)?.steepness(0.0), 1.0);
    let line = RealPower::new(1.0)?.steepness(0.0);
    assert!((line - 2.0).abs() < 1e-6, "{line}, expected 2");
    Ok(())
}

#[test]
fn soft_or_hard_is_the_formula_of_either() {
    for t in [0.25, 0.5, 0.75] {
        assert_eq!(SoftOrHard::Soft.formula().exact(t), t * t);
        assert_eq!(SoftOrHard::Hard.formula().exact(t), t * (2.0 - t));
    }
}

#[test]
fn bits_beyond_the_parameters_become_the_nearest() {
    assert_eq!(RealPower::from_bits((-1.0_f32).to_bits()).exponent(), 0.0);
    assert_eq!(RealPower::from_bits(9_999_f32.to_bits()).exponent(), 1_024.0);
}
