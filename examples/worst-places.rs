//! Searches the inputs with the largest error of each falloff in each format, and prints the file
//! that `tests/slow/worst.rs` checks the kernel against:
//!
//! `cargo run -p suite --example worst-places > tests/slow/worst/places.txt`

use luminaire::{Fx16, Fx32, falloff::Falloff};
use support::with_every_shape;
use support::{falloffs::Shape, format::Format, worst};

fn find<S: Format, P: Falloff>(shape: &Shape<P>) {
    if worst::is_smooth(shape) {
        for half_degrees in [worst::narrowest::<S, P>(shape), 30.0] {
            println!("{}", worst::search::<S, P>(shape, half_degrees));
        }
    }
}

fn main() {
    println!("# format, shape, half angle, axis, point, error: what must be exact as the bits of f32");
    with_every_shape!(find::<f32>);
    with_every_shape!(find::<Fx32>);
    with_every_shape!(find::<Fx16>);
}
