//! Draws `docs/feasible-region.svg`: which ratio of field to beam versine each edge slope of a
//! monotone cubic reaches.
//!
//! `cargo run -p suite --example feasible-region > docs/feasible-region.svg`. Everything is
//! computed in f64, by search; `tests/suite/two_angles.rs` holds the picture to this.

use support::region;

fn main() {
    print!("{}", region::svg());
}
