//! Goniometric data as tables: the difference between a table and its data, the correctness of the
//! stated difference, and the error that the formats add. `cargo test --test suite tables:: --
//! --nocapture --test-threads 1` prints the differences.

use fastrand::Rng;
use luminaire::{
    Angle, Cone, Fx16, Fx32,
    falloff::{Knot, Table},
};
use support::{assert_that, format::Format, in_every_format, oracle, sweep};

/// A file of LM-63 as it is published, in candela every 2.5 degrees from the axis to 90:
/// `tests/data` of dlippok/photometric-viewer (MIT licence).
#[rustfmt::skip]
const PUBLISHED: [f32; 37] = [
    2200.0, 2000.2, 1950.0, 1700.1, 1328.4, 1115.1, 900.5, 700.4, 600.3, 501.2, 400.1, 398.3, 380.9, 400.2, 390.5, 320.0,
    185.0, 100.6, 40.1, 20.0, 15.2, 15.0, 14.0, 11.0, 10.8, 10.8, 10.0, 7.0, 4.0, 1.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0,
];

fn published() -> [f32; 37] {
    PUBLISHED.map(|candela| candela / 2200.0)
}

/// The data at a half angle in degrees, linear between.
fn exact(measured: &[f32], outer: f64, half: f64) -> f64 {
    let last = measured.len() - 1;
    let place = (2.0 * half / outer).clamp(0.0, 1.0) * last as f64;
    let index = (place as usize).min(last - 1);
    let [here, next] = [index, index + 1].map(|i| f64::from(measured[i]));
    here + (next - here) * (place - index as f64)
}

/// The line of a table at a `u`, from its bits.
fn line(knots: &[Knot], u: f64) -> f64 {
    let place = u * 65_536.0;
    let knot =
        knots.iter().rfind(|knot| f64::from(knot.to_bits().0) <= place).expect("the first is at the axis");
    let (start, value, slope) = knot.to_bits();
    (f64::from(value) + (place - f64::from(start)) * f64::from(slope) / 32_768.0).clamp(0.0, 65_535.0)
        / 65_535.0
}

/// The largest difference between a table and its data, by a dense search in the angle.
fn searched(table: Table<'_>, measured: &[f32], outer: f64) -> f64 {
    let versine = oracle::versine(outer / 2.0);
    let count = 20_000 * sweep::effort() as u32;
    let places = (0..=count).map(|i| f64::from(i) / f64::from(count));
    let bends = (0..measured.len()).map(|i| i as f64 / (measured.len() - 1) as f64);
    let both_sides =
        bends.flat_map(|place| [place - 1e-9, place, place + 1e-9]).map(|place| place.clamp(0.0, 1.0));
    places
        .chain(both_sides)
        .map(|place| {
            let half = outer / 2.0 * place;
            let u = (oracle::versine(half) / versine).min(1.0);
            (line(table.knots(), u) - exact(measured, outer, half)).abs()
        })
        .fold(0.0, f64::max)
}

#[test]
fn sixty_four_knots_hold_a_published_file_within_a_linear_code() {
    let outer = Angle::degrees(180.0);
    for (count, most) in [(8, 9.8), (16, 1.8), (32, 1.0), (48, 1.0), (64, 1.0), (128, 1.0)] {
        let mut knots = [Knot::default(); 128];
        let (table, difference) =
            Table::from_angles(&published(), outer, &mut knots[..count]).expect("sound data");
        let codes = 255.0 * f64::from(difference);
        let found = 255.0 * searched(table, &published(), 180.0);
        println!("{count} knots: {codes:.3} linear codes stated, {found:.3} found");
        assert!(codes <= most && codes > most / 300.0, "{count} knots: {codes:.2} codes");
    }
}

/// Curves that no fixture has, with one knot and more.
#[test]
fn a_stated_difference_is_what_a_dense_search_finds() {
    let mut rng = Rng::with_seed(63);
    let mut ratio = 0.0_f64;
    for _ in 0..150 * sweep::effort() {
        let count = rng.usize(2..60);
        let mut level = 1.0_f32;
        let kind = rng.u8(..4);
        let measured: Vec<f32> = (0..count)
            .map(|_| match kind {
                // Any, falling, peaks and steps.
                0 => rng.f32(),
                1 => {
                    level *= rng.f32();
                    level
                }
                2 => f32::from(rng.u8(..8) == 0),
                _ => f32::from(rng.u8(..3)) / 2.0,
            })
            .collect();
        let outer = [0.05, 3.0, 40.0, 120.0, 180.0][rng.usize(..5)];
        let mut knots = vec![Knot::default(); rng.usize(1..100)];
        let (table, stated) =
            Table::from_angles(&measured, Angle::degrees(outer), &mut knots).expect("sound data");
        let (stated, found) = (f64::from(stated), searched(table, &measured, outer.into()));
        assert!(stated >= found - 1e-9, "{outer} {measured:?}: {found:.3e} is stated as {stated:.3e}");
        assert!(stated <= 1.01 * found + 1e-4, "{outer} {measured:?}: {found:.3e} is stated as {stated:.3e}");
        ratio = if found > 1e-3 { ratio.max(stated / found) } else { ratio };
        // A table falls where its data fall.
        let places: Vec<_> = table.knots().iter().map(|knot| knot.to_bits().0).collect();
        assert!(places.is_sorted_by(|a, b| a < b) && places[0] == 0);
        if kind == 1 {
            let fall = |u: u32| line(table.knots(), f64::from(u) / 65_536.0);
            assert!((1..65_536).step_by(7).all(|u| fall(u) <= fall(u - 1)), "{measured:?}");
        }
    }
    println!("stated over found: {ratio:.4} at most");
}

/// The rounding of f32 in the last interval alone, where its slope is large.
#[test]
fn the_difference_at_a_steep_edge_is_not_understated() {
    let mut rng = Rng::with_seed(65);
    for count in (0..60).map(|i| 2 + 20 * i) {
        let mut measured = vec![1.0; count];
        measured[count - 1] = 0.1 * rng.f32();
        let outer = 1.0 + 170.0 * rng.f32();
        let mut knots = [Knot::default(); 30];
        let (table, stated) =
            Table::from_angles(&measured, Angle::degrees(outer), &mut knots).expect("sound data");
        let (stated, found) = (f64::from(stated), searched(table, &measured, outer.into()));
        assert!(stated >= found - 1e-9, "{count} to {outer}: {found:.3e} is stated as {stated:.3e}");
    }
    let mut knots = [Knot::default()];
    let (_, stated) = Table::from_angles(&[1.0, 0.0, 1.0], Angle::degrees(90.0), &mut knots).expect("sound");
    assert_eq!(stated, 1.0);
}

/// At every versine of `Fx16`, and at many of the other formats, the intensity is within two steps
/// of the line, and never rises where the line falls.
#[test]
fn formats_keep_to_the_line_between_knots() {
    fn assert_format<S: Format>(table: Table<'_>, steps: f64) {
        let cone = Cone::from_outer(table, Angle::degrees(90.0)).expect("a sound angle");
        let (falloff, outer) = (cone.compile::<S>().expect("held"), f64::from(cone.outer_versine()));
        let (mut worst, mut before) = (0.0_f64, 2.0);
        for i in 0..100_000 * sweep::effort() as u32 {
            let versine =
                falloff.versine((outer * f64::from(i) / f64::from(100_000 * sweep::effort() as u32)) as f32);
            let found = falloff.at(versine).exact();
            let u = S::exact_versine(&falloff, versine) / outer;
            // The slopes of these lines are up to 4.
            worst = worst.max((found - line(table.knots(), u)).abs() / f64::from(S::STEP));
            assert!(found <= before, "{}: rises at {u}", S::NAME);
            before = found;
        }
        println!("{}: {worst:.2} steps", S::NAME);
        assert!(worst <= steps && worst > steps / 2.0, "{}: {worst} steps", S::NAME);
    }
    let measured = [1.0, 0.99, 0.9, 0.7, 0.3, 0.1, 0.02, 0.0];
    let mut knots = [Knot::default(); 24];
    let (table, _) = Table::from_angles(&measured, Angle::degrees(90.0), &mut knots).expect("sound data");
    assert_format::<f32>(table, 3.0);
    assert_format::<Fx32>(table, 3.5);
    assert_format::<Fx16>(table, 2.5);
}

/// As many samples as a table may have, in a cone so narrow that `Fx16` evaluates it finely.
#[test]
fn the_largest_table_keeps_to_its_line() {
    fn assert_format<S: Format>(table: Table<'_>) {
        let outer = Angle::degrees(1.5 * Cone::narrowest::<Fx16>(table).to_degrees());
        let cone = Cone::from_outer(table, outer).expect("a sound angle");
        let (falloff, outer) = (cone.compile::<S>().expect("held"), f64::from(cone.outer_versine()));
        for i in 0..1_000_u32 {
            let versine = falloff.versine((outer * f64::from(i) / 1_000.0) as f32);
            let (found, u) = (falloff.at(versine).exact(), S::exact_versine(&falloff, versine) / outer);
            assert_that!((found - (1.0 - u)).abs() <= 6.0 * f64::from(S::STEP), S::NAME, found, u);
        }
    }
    let samples: Vec<_> = (0..=u16::MAX).rev().collect();
    let table = Table::new(&samples).expect("65,536 samples");
    in_every_format!(assert_format(table));
}

/// Next to the axis, before the first knot, the line of the first knot goes on.
#[test]
fn the_first_line_goes_on_to_the_axis() {
    fn assert_format<S: Format>(table: Table<'_>) {
        let cone = Cone::from_outer(table, Angle::degrees(90.0)).expect("a sound angle");
        let falloff = cone.compile::<S>().expect("held");
        assert_eq!(falloff.at(falloff.versine(0.0)), S::ONE, "{}", S::NAME);
    }
    let knots = [Knot::from_bits(6_553, 65_535, 0), Knot::from_bits(32_768, 65_535, -65_534)];
    let table = Table::of_knots(&knots);
    in_every_format!(assert_format(table));
}

/// Knots of any bits give intensities from 0 to 1, and a table without knots would be dark.
#[test]
fn every_bit_pattern_of_a_knot_has_an_answer() {
    fn assert_format<S: Format>(table: Table<'_>) {
        let Ok(falloff) = Cone::from_outer(table, Angle::degrees(120.0)).expect("sound").compile::<S>()
        else {
            return;
        };
        for i in 0..=64_u8 {
            let found = falloff.at(falloff.versine(f32::from(i) / 128.0)).exact();
            assert_that!((0.0..=1.0).contains(&found), table, found);
        }
        let _ = (table.samples(), falloff.at(falloff.versine(f32::NAN)));
    }
    let mut rng = Rng::with_seed(64);
    for _ in 0..2_000 {
        let knots: [Knot; 4] = std::array::from_fn(|_| {
            let slope = if rng.bool() { [i32::MIN, -1, 0, i32::MAX][rng.usize(..4)] } else { rng.i32(..) };
            Knot::from_bits(rng.u16(..), rng.u16(..), slope)
        });
        let table = Table::of_knots(&knots);
        in_every_format!(assert_format(table));
    }
}
