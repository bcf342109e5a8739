//! The dithered codes of RGB565 in fixed point, searched for from a table.

use super::{
    curve::Transfer,
    dither::{BITS, light},
};
use crate::{
    color::Rgb,
    number::{Scalar, Word},
};

/// Number of leading bits of a value that a table has the first code for.
const PLACE_BITS: u32 = 8;

/// The lower of the two codes around the smallest value with these leading bits.
type Starts = [u8; 1 << PLACE_BITS];

/// The light of each code in units of 2^-32, and the step to the next in units of 2^-24. From the last code on, the
/// light is above that of all values.
type Lights = [[u32; 2]; 65];

static FIVE: Lights = lights(31);
static SIX: Lights = lights(63);
static FIVE_STARTS: Starts = starts(&FIVE);
static SIX_STARTS: Starts = starts(&SIX);
const _: () = assert!(2 * (size_of::<Lights>() + size_of::<Starts>()) == 1_552, "as is documented");

const fn lights(last: usize) -> Lights {
    let (mut lights, mut code) = ([[u32::MAX, 0]; 65], 0);
    while code < last {
        let here = light(Transfer::Srgb, code, last);
        lights[code] = [here << (32 - BITS), light(Transfer::Srgb, code + 1, last) - here];
        code += 1;
    }
    lights
}

const fn starts(lights: &Lights) -> Starts {
    let (mut starts, mut place, mut code) = ([0; 1 << PLACE_BITS], 0, 0);
    while place < starts.len() {
        while lights[code + 1][0] <= (place as u32) << (32 - PLACE_BITS) {
            code += 1;
        }
        starts[place] = code as u8;
        place += 1;
    }
    starts
}

/// Returns the codes of a colour's channels, of five, six and five bits; `None` for a colour in f32.
#[inline(always)]
pub(super) fn dithered<S: Scalar>(color: Rgb<S>, threshold: u8) -> Option<Rgb<u32>> {
    let (Rgb { red, green, blue }, threshold) = (below_one(color)?, threshold.into());
    Some(Rgb {
        red: code(&FIVE_STARTS, red, threshold, &FIVE),
        green: code(&SIX_STARTS, green, threshold, &SIX),
        blue: code(&FIVE_STARTS, blue, threshold, &FIVE),
    })
}

/// Returns the channels of a colour in fixed point in units of 2^-32, cut to 24 bits. A value of 1 or more becomes the
/// value below 1: with every threshold, its code is the last, too.
#[inline(always)]
fn below_one<S: Scalar>(color: Rgb<S>) -> Option<Rgb<u32>> {
    match color.map(S::word) {
        Rgb { red: Word::Steps14(red), green: Word::Steps14(green), blue: Word::Steps14(blue) } => {
            let color = Rgb::new(red, green, blue);
            // One test for what is seldom: a channel below 0, or of at least 1.
            let is_usual = (red | green | blue) as u16 >> 14 == 0;
            let color = if is_usual { color } else { color.map(|channel| channel.clamp(0, (1 << 14) - 1)) };
            Some(color.map(|channel| u32::from(channel as u16) << 18))
        }
        Rgb { red: Word::Steps30(red), green: Word::Steps30(green), blue: Word::Steps30(blue) } => {
            let clamped = Rgb::new(red, green, blue).map(|channel| channel.clamp(0, (1 << 30) - 1) as u32);
            Some(clamped.map(|channel| channel >> (30 - BITS) << (32 - BITS)))
        }
        _ => None,
    }
}

/// Returns the code of a channel.
///
/// A function of its own, because three loops in one function take more registers than a Cortex-M0 has.
#[inline(never)]
fn code(starts: &Starts, linear: u32, threshold: u32, lights: &Lights) -> u32 {
    let mut code = u32::from(starts[(linear >> (32 - PLACE_BITS)) as usize]);
    loop {
        // The remainder changes no index. It shows the compiler that the index is in bounds.
        let place = code as usize % 64;
        if linear < lights[place + 1][0] {
            let [here, step] = lights[place];
            // The place between two codes, in 128ths of the step, as in `dithered_fixed`.
            return code + u32::from((linear - here) >> 1 > step * threshold);
        }
        code += 1;
    }
}
