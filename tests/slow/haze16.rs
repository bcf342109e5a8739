//! In-scattering in 32-bit products, searched over rays of which half are near critical directions,
//! with climbs by bits from the worst.
//!
//! `LUMINAIRE_FULL=1 cargo test --release --test slow haze16:: -- --nocapture` evaluates 60,000 rays
//! a cone and falloff, a third of them in climbs.

use luminaire::falloff::{Falloff, Hard, Smooth, Soft};
use support::{
    bounds,
    every::is_full,
    haze16::{BOUNDS, HALF_ANGLES, Lights},
    oracle::{self, climb::Search},
};

#[test]
fn in_scattering_keeps_its_bound() {
    fn row<P: Falloff>(name: &str, falloff: P, truth: oracle::Falloff, bound: f64) {
        let search = if is_full() {
            Search { starts: 40_000, climbs: 10, steps: 2_000, seed: 1 }
        } else {
            Search { starts: 800, climbs: 2, steps: 100, seed: 1 }
        };
        let measured = HALF_ANGLES.map(|half| Lights::new(falloff, truth, half).largest(search));
        println!("{name} {}", measured.map(|e| format!("{e:.3}")).join(", "));
        for measured in measured {
            let kept = if is_full() { bounds::check(name, measured, bound) } else { Ok(()) };
            assert!(measured <= bound && kept.is_ok(), "{name}: {measured:.3}, not {bound}: {kept:?}");
        }
    }
    let [soft, hard, smooth] = BOUNDS;
    row(soft.0, Soft, oracle::soft, soft.1);
    row(hard.0, Hard, oracle::hard, hard.1);
    row(smooth.0, Smooth, oracle::smooth, smooth.1);
}
