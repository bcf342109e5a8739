//! Regions with known numbers of instructions, to test the counter. Prints for each region the
//! number that must be counted.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_firmware::board::{begin, countdown, end, nops, println};

luminaire_firmware::entry!(instrument);

fn instrument() {
    region("nothing", 0, || {});
    region("ten-nops", 10, nops::<10>);
    // Longer than the largest page, so that the region crosses the end of a page.
    region("pages-of-nops", 3000, nops::<3000>);
    // Two instructions per turn, and one that loads the number of turns.
    region("a-hundred-turns", 201, countdown::<100>);
    // The same code is executed more than once.
    for _ in 0..2 {
        region("seven-nops", 7, nops::<7>);
    }
}

/// Prints the number that must be counted, and runs the work in a region.
fn region(name: &str, instructions: u32, work: impl FnOnce()) {
    println!("{name} {instructions} instructions");
    count(work);
}

/// Not inlined: each work has its own copy of this function, so that no code of another work gets
/// into the region.
#[inline(never)]
fn count(work: impl FnOnce()) {
    begin();
    work();
    end();
}
