//! Searches the inputs with the largest error of each falloff in each format, and prints the file
//! that `tests/slow/worst.rs` checks the kernel against:
//!
//! `cargo run -p suite --example worst-places > tests/slow/worst/places.txt`

use fastrand::Rng;
use luminaire::{Fx16, Fx32, falloff::Falloff};
use support::{
    falloffs::Shape,
    format::Format,
    oracle::climb::{self, Search, Worst, one_of},
    sweep, with_every_shape,
    worst::{self, Find, Place},
};

/// The coordinates that every format has exactly, with their differences.
const FARTHEST: f32 = 128.0;

/// Half the narrowest outer angle that a format accepts of a shape, in degrees, a little wider.
fn narrowest<S: Format, P: Falloff>(shape: &Shape<P>) -> f32 {
    let (mut refused, mut held) = (1e-6_f32, 90.0_f32);
    for _ in 0..40 {
        let middle = (refused * held).sqrt();
        if shape.at(middle).compile::<S>().is_ok() { held = middle } else { refused = middle }
    }
    held * 1.000_01
}

/// Searches for the worst input of a shape at a half angle.
fn search<S: Format, P: Falloff>(shape: &Shape<P>, half_degrees: f32) -> Find {
    let radians = f64::from(half_degrees).to_radians();
    let error = |place| worst::error::<S, P>(shape, half_degrees, place).unwrap_or(0.0);
    let worst = Search::default().worst(|rng| somewhere(rng, radians), moved, error);
    let Worst { input: place, error } = worst.expect("no format is exact");
    Find { format: S::NAME.to_owned(), shape: shape.name.to_owned(), half_degrees, place, error }
}

/// A point in a cone.
fn somewhere(rng: &mut Rng, radians: f64) -> Place {
    let axis = sweep::direction(rng);
    let off_axis = rng.f64() * radians;
    let way = sweep::direction_off(rng, axis, off_axis);
    let distance = 2.0 + 60.0 * rng.f64();
    Place { axis: sweep::single(axis), point: sweep::single(sweep::on_grid(distance * way)) }
}

/// The input with one component of the point or of the axis moved by a random amount.
fn moved(rng: &mut Rng, place: Place) -> Place {
    let size = climb::size(rng);
    if rng.bool() {
        return Place { axis: one_of(rng, place.axis, |c| c + size), ..place };
    }
    let step = climb::grid_step(rng, size);
    Place { point: one_of(rng, place.point, |c| step(c).clamp(-FARTHEST, FARTHEST)), ..place }
}

fn find<S: Format, P: Falloff>(shape: &Shape<P>) {
    if worst::is_smooth(shape) {
        for half_degrees in [narrowest::<S, P>(shape), 30.0] {
            println!("{}", search::<S, P>(shape, half_degrees));
        }
    }
}

fn main() {
    println!("# format, shape, half angle, axis, point, error: what must be exact as the bits of f32");
    with_every_shape!(find::<f32>);
    with_every_shape!(find::<Fx32>);
    with_every_shape!(find::<Fx16>);
}
