//! Draws `docs/narrow-beams.svg`: the largest error of a soft spotlight over its half angle. It
//! shows the cosine form, and the versine form in each format with the narrowest beam that the
//! format supports.
//!
//! `cargo run --release --example narrow-beams > docs/narrow-beams.svg`. All errors are measured
//! against the tests' f64 reference. `tests/slow/limits.rs` checks the bounds of the lines.

fn main() {
    print!("{}", support::beams_picture::svg());
}
