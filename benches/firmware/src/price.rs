//! Running effects over inputs between the markers.

mod input;

use luminaire_effects::{Color, FORMAT, Light, Output, Place, Surface, Visit, each};

use self::input::{Input, Inputs};
use crate::COUNT;
use crate::board::println;
use crate::measure::pass;

/// Runs every effect over its inputs, after the empty loop over the same inputs, and prints lines
/// as [`measure`](crate::measure()) does.
pub fn price() {
    each(&mut Run);
}

/// Runs effects over inputs of their kind.
struct Run;

macro_rules! inputs {
    ($($input:ident: $type:ty;)*) => {$(
        fn $input<O: Output>(&mut self, name: &str, effect: impl Fn($type) -> O) {
            run(name, effect, Inputs::$input);
        }
    )*};
}

impl Visit for Run {
    inputs! {
        surface: Surface;
        light: Light;
        lit: (Light, Place);
        color: Color;
        pixel: (Color, Place);
    }
}

/// The name of the loop that does nothing.
const EMPTY: &str = "empty";

// Never inlined: the smallest board's memory holds a single table of inputs.
#[inline(never)]
fn run<I: Input, O: Output>(name: &str, effect: impl Fn(I) -> O, next: impl Fn(&mut Inputs) -> I) {
    let mut sequence = Inputs::new();
    let mut inputs = [next(&mut sequence); COUNT];
    for input in &mut inputs[1..] {
        *input = next(&mut sequence);
    }
    report(EMPTY, pass(&inputs, I::word));
    report(name, pass(&inputs, |input| effect(*input).fold()));
}

#[inline(never)]
fn report(name: &str, sum: u32) {
    println!("effect {FORMAT} {name} {COUNT} {sum:08x}");
}
