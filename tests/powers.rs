//! Powers as edge profiles, up to the largest exponent: their figures of set-up against f64.

mod support;

use luminaire::{IntegerPower, IntegerRim, Profile};
use support::bounds;

fn relative(found: f32, exact: f64) -> f64 {
    (f64::from(found) / exact - 1.0).abs()
}

/// `1 - value^(1 / n)`.
fn lost(value: f64, n: f64) -> f64 {
    -(value.ln() / n).exp_m1()
}

/// The largest relative errors of the figures that a cone is designed and checked by: beam, field, integral and
/// steepness, over every whole exponent.
#[test]
fn every_whole_exponent_keeps_its_figures() {
    const HOTSPOTS: [f32; 5] = [0.0, 1e-4, 0.01, 0.5, 0.999];
    let mut worst = [0.0_f64; 6];
    let mut note = |i: usize, error: f64| worst[i] = worst[i].max(error);
    for exponent in 1..=1_024_u16 {
        let n = f64::from(exponent);
        let power = IntegerPower::new(exponent.into()).expect("a sound exponent");
        let rim = IntegerRim::new(exponent.into()).expect("a sound exponent");
        note(0, relative(power.beam_versine(), lost(0.5, n)));
        note(0, relative(power.field_versine(), lost(0.1, n)));
        note(1, relative(rim.beam_versine(), 1.0 - lost(0.5, n)));
        note(1, relative(rim.field_versine(), 1.0 - lost(0.9, n)));
        for u in [1e-7_f32, 1e-4, 0.003, 0.1, 0.7, 1.0] {
            let x = f64::from(u);
            let of_power = -((n + 1.0) * (-x).ln_1p()).exp_m1() / (n + 1.0);
            note(2, relative(power.integral(u), of_power));
            note(3, relative(rim.integral(u), x - x.powf(n + 1.0) / (n + 1.0)));
        }
        for hotspot in HOTSPOTS {
            let h = f64::from(hotspot);
            let v = (1.0 / (2.0 * n - 1.0)).max(h);
            let slope = 2.0 * n * ((1.0 - v) / (1.0 - h)).powf(n - 1.0) * v.sqrt() / (1.0 - h);
            note(4, relative(power.steepness(hotspot), slope));
            note(5, relative(rim.steepness(hotspot), 2.0 * n / (1.0 - h)));
        }
    }
    const FIGURES: [(&str, f64); 6] = [
        ("beam and field of a power", 2e-7),
        ("beam and field of a rim", 5e-8),
        ("integral of a power", 1.5e-7),
        ("integral of a rim", 8e-8),
        ("steepness of a power", 2e-7),
        ("steepness of a rim", 1e-7),
    ];
    for ((name, bound), worst) in FIGURES.into_iter().zip(worst) {
        println!("{name:28} {worst:.2e}");
        bounds::check(name, worst, bound).expect("within its bound");
    }
}
