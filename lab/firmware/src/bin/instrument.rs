//! Known numbers of instructions, to try the counter on: prints for each region what must be
//! counted.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_firmware::board::{begin, countdown, end, nops, println};

luminaire_firmware::entry!(instrument);

fn instrument() {
    region("nothing", 0, || {});
    region("ten nops", 10, nops::<10>);
    // Longer than the longest page, so that a page ends within.
    region("pages of nops", 3000, nops::<3000>);
    // Two instructions a turn, and one that loads the number of turns.
    region("a hundred turns", 201, countdown::<100>);
    // More than once in the same place.
    for _ in 0..2 {
        region("seven nops", 7, nops::<7>);
    }
}

/// Says what must be counted, and gives it to be counted.
fn region(name: &str, instructions: u32, work: impl FnOnce()) {
    println!("{instructions} {name}");
    count(work);
}

/// A function of its own for each work: what the compiler has to prepare for others stays outside.
#[inline(never)]
fn count(work: impl FnOnce()) {
    begin();
    work();
    end();
}
