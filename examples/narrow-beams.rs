//! Draws `docs/narrow-beams.svg`: the largest error of a soft spotlight over its half angle, by the
//! cosine form and by the versine form in each format, with the narrowest beam that each format
//! takes.
//!
//! `cargo run --release --example narrow-beams > docs/narrow-beams.svg`. Everything in it is
//! measured against the tests' f64 reference; `tests/slow/limits.rs` holds the lines to their
//! bounds.

fn main() {
    print!("{}", support::beams_picture::svg());
}
