//! Evaluates the worst inputs that a search has found, and checks that each error is still the one
//! that was found.
//!
//! `cargo run -p suite --example worst-places > tests/slow/worst/places.txt` repeats the search.

use luminaire::{Fx16, Fx32, falloff::Falloff};
use support::{
    falloffs::Shape,
    format::Format,
    with_every_shape,
    worst::{self, Find},
};

const PLACES: &str = include_str!("worst/places.txt");

/// The largest error of each format at these inputs. The promise is half a step of eight bits,
/// 1.96e-3. Random points have smaller errors than those that hill climbing finds. The largest
/// error of `Fx16` is at 30 degrees, because it evaluates its narrowest cones with more bits.
const LARGEST: [(&str, f64); 3] = [("f32", 8.2e-4), ("fx32", 1.04e-3), ("fx16", 9.4e-4)];

/// Evaluates a shape's two inputs, in its narrowest cone and in one of 30 degrees. An error that
/// has grown or shrunk by 2 % or more fails. Returns the larger error.
fn as_found<S: Format, P: Falloff>(shape: &Shape<P>) -> f64 {
    let finds =
        PLACES.lines().filter(|line| !line.starts_with('#')).map(|line| Find::parse(line).expect(line));
    let finds: Vec<_> = finds.filter(|find| find.format == S::NAME && find.shape == shape.name).collect();
    assert_eq!(finds.len(), if worst::is_smooth(shape) { 2 } else { 0 }, "{} {}", S::NAME, shape.name);
    finds.into_iter().fold(0.0, |largest, find| {
        let error =
            worst::error::<S, P>(shape, find.half_degrees, find.place).expect("the light is accepted");
        println!("{} {} at {}: {error:.2e}", S::NAME, shape.name, find.half_degrees);
        assert!((error / find.error - 1.0).abs() < 0.02, "{find}: now {error:.3e}; search anew");
        largest.max(error)
    })
}

fn assert_most(format: &str, errors: impl IntoIterator<Item = f64>) {
    let most = errors.into_iter().fold(0.0, f64::max);
    let (_, bound) = LARGEST.into_iter().find(|(name, _)| *name == format).expect("a format");
    assert!(most <= bound && most > 0.97 * bound, "{format}: {most:.3e}, not {bound:.2e}");
}

#[test]
fn the_worst_places_are_as_they_were_found() {
    assert_most("f32", with_every_shape!(as_found::<f32> -> f64));
    assert_most("fx32", with_every_shape!(as_found::<Fx32> -> f64));
    assert_most("fx16", with_every_shape!(as_found::<Fx16> -> f64));
}
