//! Running effects over inputs between the markers.

mod input;
mod output;

use luminaire_effects::{FORMAT, effects};

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

/// Runs every effect over its inputs, the empty loop over the same inputs before it, and prints lines as
/// [`measure`](crate::measure()) does.
pub fn price() {
    run!(surface: directional point);
    run!(surface: spot_soft_lambert spot_hard_lambert spot_smooth_lambert spot_cubic_lambert);
    run!(surface: spot_linear_lambert spot_cut_off_lambert spot_blend_lambert spot_power_lambert);
    run!(surface: spot_rim_lambert spot_table_lambert);
    run!(surface: spot_soft spot_soft_lambert_hotspot spot_soft_lambert_delimiter);
    run!(surface: spot_soft_lambert_inverse_square spot_soft_lambert_polynomial spot_soft_lambert_smooth_range);
    run!(surface: spot_soft_lambert_windowed spot_soft_lambert_squared_window spot_soft_lambert_hard_range);
    run!(surface: spot_soft_lambert_gobo spot_soft_lambert_shadow);
    run!(view: haze);
    run!(surface: matte phong blinn_phong dual_cone lyon);
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
