//! Effects at the surface points of a search, each between markers of its own.

use core::hint::black_box;

use luminaire::{Scalar, Vec3};
use luminaire_effects::{Entry, Format, Input, Inputs, Output, Visit, each, each_choice, each_evaluation};
use luminaire_kernels::scene::Site;
#[cfg(target_os = "none")]
use semihosting::{fs::File, io::Read};
#[cfg(not(target_os = "none"))]
use std::{fs::File, io::Read};

use crate::COUNT;
use crate::board::{begin, end, opaque, println};

/// Runs every effect at its own surface points, and prints a line for each, `name points inputs`. Before them it runs
/// the empty call, whose instructions are subtracted from the others.
///
/// Inlined, as [`stack`](crate::stack()).
#[inline]
pub fn effects() {
    each(&mut Points(open()));
}

/// Runs the [lit points](crate::evaluations) that are no effects. There is no room for all in one program.
#[inline]
pub fn evaluations() {
    each_evaluation(&mut Points(open()));
}

/// Runs the lit points that have [one model](crate::choices) each.
#[inline]
pub fn choices() {
    each_choice(&mut Points(open()));
}

/// The file with the points: a point and a normal, six numbers each.
struct Points(File);

impl Points {
    /// The next point; none at the end of the file.
    fn next(&mut self) -> Option<Site> {
        let mut words = [[0; 4]; 6];
        let bytes = words.as_flattened_mut();
        let mut length = 0;
        while length < bytes.len() {
            match self.0.read(&mut bytes[length..]).expect("the file can be read") {
                0 => return None,
                read => length += read,
            }
        }
        let [x, y, z, a, b, c] = words.map(f32::from_le_bytes);
        Some(Site { point: Vec3::new(x, y, z), normal: Vec3::new(a, b, c) })
    }
}

impl Visit for Points {
    #[inline(never)]
    fn effect<I: Input, O: Output>(
        &mut self,
        entry: Entry,
        next: fn(&mut Inputs) -> I,
        effect: impl Fn(I) -> O,
    ) {
        let mut sequence = Inputs::default();
        for place in 0..COUNT {
            // Without points, those of the mean.
            let input = self.next().map_or_else(|| next(&mut sequence), |site| next(&mut Inputs::at(site)));
            if place == 0 {
                begin();
                black_box(opaque(&input).word());
                end();
            }
            begin();
            black_box(effect(*opaque(&input)).fold());
            end();
        }
        println!("{}.{} {COUNT} inputs", entry.name, Format::NAME);
    }
}

/// Opens the file, which is in the folder that the emulator was started in.
#[cfg(target_os = "none")]
fn open() -> File {
    File::open(c"worst-inputs").expect("the file is there")
}

#[cfg(not(target_os = "none"))]
fn open() -> File {
    File::open("worst-inputs").expect("the file is there")
}
