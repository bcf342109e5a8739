//! Draws `docs/feasible-region.svg`: the ratios of field versine to beam versine that a monotone
//! cubic reaches, for each edge slope.
//!
//! `cargo run -p suite --example feasible-region > docs/feasible-region.svg`. Everything is
//! computed in f64, by search. `tests/suite/two_angles.rs` checks that the picture is up to date.

use support::region;

fn main() {
    print!("{}", region::svg());
}
