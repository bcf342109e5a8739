//! Draws `docs/feasible-region.svg`: which ratio of field to beam versine each edge slope of a monotone cubic reaches.
//!
//! `cargo run -p suite --example feasible-region > docs/feasible-region.svg`. Everything is computed in f64, by search;
//! `tests/two_angles.rs` holds the picture to this.

#[path = "../tests/support/cubics.rs"]
#[allow(dead_code, reason = "the tests use the rest")]
#[allow(missing_docs, reason = "it is the tests' module")]
#[allow(unreachable_pub, reason = "it is the tests' module")]
mod cubics;

#[path = "../tests/support/region.rs"]
#[allow(missing_docs, reason = "it is the tests' module")]
#[allow(unreachable_pub, reason = "it is the tests' module")]
mod region;

fn main() {
    print!("{}", region::svg());
}
