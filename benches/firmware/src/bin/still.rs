//! A floor lit by a light that is a constant. Neither set-up nor pixels use floats. Prints the
//! pixels of each row, as hexadecimal digits of RGB565.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::{
    Fx16, Scalar, Vec3,
    display::{Rgb565, clip},
    falloff::Soft,
    light::{CompiledSpotLight, Row},
};
use luminaire_firmware::board::println;

luminaire_firmware::entry!(still);

/// The light, compiled by the build script.
const KEY: CompiledSpotLight<Fx16, Soft> = include!(concat!(env!("OUT_DIR"), "/key.rs"));

const WIDTH: usize = 16;
const HEIGHT: i32 = 12;
/// Distance between pixels across and down, an eighth and a quarter of a metre, in steps of 2^-16
/// m.
const STEP: [i32; 2] = [1 << 13, 1 << 14];
const UP: Vec3<Fx16> = Vec3::new(Fx16::ZERO, Fx16::ONE, Fx16::ZERO);

type Length = <Fx16 as Scalar>::Length;

fn still() {
    for row in 0..HEIGHT {
        println!("{:04x?}", pixels(row));
    }
}

/// A row of the floor.
fn pixels(row: i32) -> [u16; WIDTH] {
    let mut pixels = [0; WIDTH];
    let floor = Row::new(UP, |column| {
        let column = column as i32 - WIDTH as i32 / 2;
        let [x, z] = [column * STEP[0], (row - HEIGHT / 2) * STEP[1]].map(Length::from_bits);
        Vec3::new(x, Length::ZERO, z)
    });
    floor.light(&[KEY], &mut pixels, |pixel, _, light| *pixel = Rgb565::from_linear(clip::<Fx16>(light)).0);
    pixels
}
