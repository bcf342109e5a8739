//! Running effects over inputs between the markers.

mod input;
mod output;

use luminaire_effects::{FORMAT, Irradiance, Light, Listed, Visit, effects, listed};

use self::input::{Input, Inputs};
use self::output::Output;
use crate::COUNT;
use crate::board::println;
use crate::measure::pass;

macro_rules! run {
    ($input:ident: $($effect:ident)*) => {$(
        run(stringify!($effect), effects::$effect, Inputs::$input);
    )*};
}

/// Runs what comes of the lists.
struct Each;

impl Visit for Each {
    fn irradiance<L: Listed<Output = Irradiance>>(&mut self) {
        run(L::NAME, L::effect, Inputs::surface);
    }

    fn light<L: Listed<Output = Light>>(&mut self) {
        run(L::NAME, L::effect, Inputs::surface);
    }
}

/// Runs every effect over its inputs, the empty loop over the same inputs before it, and prints lines as
/// [`measure`](crate::measure()) does.
pub fn price() {
    run!(surface: directional point);
    run!(surface: spot_soft spot_soft_lambert_hotspot spot_soft_lambert_delimiter);
    run!(surface: spot_soft_lambert_gobo spot_soft_lambert_shadow matte);
    listed(&mut Each);
    run!(view: haze);
    run!(light: ambient exposure clip keep_hue);
    run!(color: srgb rgb565);
    run!(pixel: dither rgb565_dithered);
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
