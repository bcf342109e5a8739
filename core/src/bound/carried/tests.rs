//! What the numbers carry, against the exact functions at random places.

use super::*;
use crate::{
    attenuation::{
        Attenuation, Decay, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
    },
    number::{Errors as _, Types},
};
use fastrand::Rng;

extern crate std;

fn pass(distances: [f64; 2], intensity: f64) -> Pass {
    let stages = f32::stages(1.0);
    Pass { stages, is_fine: false, distances, intensity, is_kept: false, lit: Cell::default() }
}

/// Returns two random numbers in order.
fn interval(rng: &mut Rng) -> [f64; 2] {
    let [a, b] = [rng.f64(), rng.f64()];
    [a.min(b), a.max(b)]
}

#[cfg(feature = "libm")] // of the exact formula
#[test]
fn a_falloff_encloses_the_exact_one_in_each_cell() {
    use crate::falloff::{AnyFalloff, CompiledFalloff as _, Cubic, Falloff as _};

    let (mut rng, pass) = (Rng::with_seed(1966), pass([1.0; 2], 1.0));
    let cubic = |rng: &mut Rng| Cubic::with_slopes(4.0 * rng.f32(), 4.0 * rng.f32());
    let cubics: std::vec::Vec<AnyFalloff> =
        (0..1_000).filter_map(|_| cubic(&mut rng).ok()).map(AnyFalloff::from).collect();
    assert!(cubics.len() > 100, "{} cubics", cubics.len());
    for falloff in AnyFalloff::samples().chain(cubics) {
        for _ in 0..20 {
            let [low, high] = interval(&mut rng);
            let cell = Carried::argument(&pass, [low, high], 0.0);
            let found = falloff.compile::<f32>().intensity(cell);
            let places = [low, low + (high - low) * rng.f64(), high];
            let exact = places.map(|t| falloff.formula().exact(t));
            let room = found.error + 1e-9;
            let range = found.low - room..=found.high + room;
            assert!(
                exact.iter().all(|exact| range.contains(exact)),
                "{falloff:?} in {places:?}: {exact:?}, {found:?}"
            );
            for i in 0..2 {
                let [rise, run] = [exact, places].map(|ends| (ends[i + 1] - ends[i]).abs());
                assert!(
                    rise <= found.steepness() * run + 2.0 * room,
                    "{falloff:?} in {places:?}: {exact:?}, {found:?}"
                );
            }
        }
    }
}

/// The operations of a share and a factor with any errors within their bounds.
#[test]
fn light_errs_by_at_most_its_error() {
    let mut rng = Rng::with_seed(1967);
    let (mut reached, mut bounds) = (0.0, 0.0);
    for _ in 0..20_000 {
        let mut small = || 10_f64.powf(-1.0 - 5.0 * rng.f64());
        let (error, relative, given) = (small(), small(), small());
        let light = Rounding { absolute: small(), relative: small() };
        let mut pass = pass([1.0; 2], 10_f64.powf(3.0 * rng.f64() - 1.5));
        pass.stages = Stages { given, light, ..pass.stages };
        let (shares, factors) = (interval(&mut rng), interval(&mut rng));
        Carried::number(&pass, shares, error).lit_by(factors, relative);
        let (lit, mut worst) = (pass.lit.get(), 0.0_f64);
        for _ in 0..16 {
            let mut at = |[least, most]: [f64; 2]| match rng.u8(..3) {
                0 => least,
                1 => most,
                _ => least + (most - least) * rng.f64(),
            };
            let (share, factor) = (at(shares), at(factors) * pass.intensity);
            let off = at([-1.0, 1.0]);
            let exact = (share * factor).min(1.0);
            let found =
                (share + off * (error + given)) * factor * (1.0 + off * relative) + off * light.of(exact);
            assert!(lit.from <= exact + 1e-12 && exact <= lit.to + 1e-12, "{exact}: {lit:?}");
            worst = worst.max((found.clamp(0.0, 1.0) - exact).abs());
        }
        assert!(worst <= lit.error + 1e-12, "{worst}: {lit:?} of {shares:?} {factors:?}");
        (reached, bounds) = (reached + worst, bounds + lit.error);
    }
    assert!(reached > 0.5 * bounds, "{reached} of {bounds}");
}

/// Asserts that the light of a cell of distances is that of its ends.
fn assert_ends<A: Attenuation>(rng: &mut Rng, attenuation: A) {
    let most = attenuation.range().map_or(100.0, |range| 0.9 * f64::from(range));
    let [near, far] = interval(rng).map(|part| most * 1e-3_f64.powf(1.0 - part));
    let pass = pass([near, far], 10_f64.powf(4.0 * rng.f64() - 2.0));
    let offset = <f32 as Types>::Offset::between(Vec3::default(), Vec3::default());
    let share = Carried::number(&pass, [1.0; 2], 0.0);
    A::light::<f32, _, _>(&attenuation.constants::<f32>(), &offset, &Way(&pass), share, 1.0);
    let (lit, exact) = (pass.lit.get(), |distance| (pass.intensity * attenuation.exact(distance)).min(1.0));
    for (found, exact) in [(lit.from, exact(far)), (lit.to, exact(near))] {
        assert!(
            (found - exact).abs() <= 1e-5 * exact,
            "{attenuation:?} at {near} to {far}: {found}, expected {exact}"
        );
    }
}

#[test]
fn each_attenuation_has_its_light_at_the_ends_of_a_cell() {
    let rng = &mut Rng::with_seed(1971);
    for _ in 0..2_000 {
        let [a, b, c] = [0; 3].map(|_| 2.0 * rng.f32());
        assert_ends(rng, NoAttenuation);
        assert_ends(rng, InverseSquare);
        assert_ends(rng, Polynomial::new(a, b, c + 1e-3).expect("sound"));
        assert_ends(rng, Decay::new(a + 0.1, 1.0 + 1e3 * b).expect("sound"));
        assert_ends(rng, SmoothRange::new(a + 0.1).expect("sound"));
        assert_ends(rng, GltfRange::new(InverseSquare, Some(a + 0.1)).expect("sound"));
        assert_ends(rng, FilamentRange::new(InverseSquare, Some(a + 0.1)).expect("sound"));
    }
}
