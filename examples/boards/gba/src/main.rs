//! A golem's head of stone under two moving lights, on a Game Boy Advance.
//!
//! The button A switches between light that is interpolated over cells and light point by point.
#![no_std]
#![no_main]

mod console;
mod run;

use core::panic::PanicInfo;

use luminaire_sprite::{
    Lights, SPANS, Sprite, WORDS, cells,
    measures::SIDE,
    points,
    shown::{LEVEL, PIXELS, Pixels, Shown},
};

use console::{Buttons, Console};

/// The upper left corner of the sprite on the screen.
const CORNER: [usize; 2] = [(console::WIDTH - SIDE) / 2, (console::HEIGHT - SIDE) / 2];

/// 64 kB, which the memory beside the processor has no room for.
#[unsafe(link_section = ".far")]
static TABLE: Pixels = PIXELS;

static LEVEL_TABLE: luminaire_sprite::shown::Steps = LEVEL;

/// Draws pictures for ever.
#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    let mut console = Console::take();
    let sprite =
        Sprite { words: &WORDS, spans: &SPANS, shown: Shown { pixels: &TABLE, levels: &LEVEL_TABLE } };
    let picture = console.picture();
    let mut buttons = Buttons::default();
    let mut is_pointwise = false;
    loop {
        if buttons.has_pressed_a() {
            is_pointwise = !is_pointwise;
        }
        let time = console.time();
        let cycles = console.cycles();
        let lights = Lights::at(time);
        if is_pointwise {
            points::draw(&sprite, &lights, picture);
        } else {
            cells::draw::<4>(&sprite, &lights, picture, run::run);
        }
        let cycles = console.cycles().wrapping_sub(cycles);
        console.show(picture, sprite.spans, CORNER, lights.pixels(), [time, is_pointwise.into(), cycles]);
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    loop {}
}
