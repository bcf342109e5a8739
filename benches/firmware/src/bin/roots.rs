//! Square roots by the processor's instruction, on the host by the standard library's: prints a
//! checksum of their bits for each sign and exponent.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_firmware::board::{opaque, println};

luminaire_firmware::entry!(roots);

fn roots() {
    for upper in 0..512_u32 {
        // Both ends of the exponent, and mantissas between them: of zero exponents the subnormal
        // numbers, of full ones infinity and NaN.
        let mantissas = (0..1 << 23).step_by(4093).chain([(1 << 23) - 1]);
        let sum = mantissas.fold(0_u32, |sum, mantissa| {
            let root = root(f32::from_bits(*opaque(&(upper << 23 | mantissa))));
            // The sign and the payload of a NaN are the processor's.
            sum.wrapping_mul(3) ^ if root.is_nan() { 0x7fc0_0000 } else { root.to_bits() }
        });
        println!("{upper} {sum:08x} bits");
    }
}

#[cfg(target_os = "none")]
fn root(x: f32) -> f32 {
    luminaire_native::sqrt(x).expect("a processor with a square root")
}

#[cfg(not(target_os = "none"))]
fn root(x: f32) -> f32 {
    x.sqrt()
}
