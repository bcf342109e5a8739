//! A profile spotlight that a lighting desk drives, in 16-bit integers: prints its light on a painted cloth as
//! characters.
//!
//! Its channels are bytes, as DMX512 sends them. Two of them are the angles of the cone, which are known only when the
//! cue arrives. So the cone is designed on the chip, in integers: there `Cone` would need a library of software floats.
//! A cue whose cone 16 bits cannot hold is refused, and the light stays as it was.

use luminaire::{
    Fx16, Length, Rgb, Vec3,
    display::{Gray8, Pixel, clip},
    falloff::{Cubic, SoftOrHard},
    light::{CompiledSpotLight, IntegerCone, Refusal},
};

type Light = CompiledSpotLight<Fx16, Cubic>;

/// The channels of a cue: dimmer; zoom, the outer angle; edge, the inner angle as a share of it; gel; pan and tilt, here
/// the slopes of the axis in steps of 1/256 from 128. A moving head would turn its yoke by angles.
type Cue = [u8; 6];

const COLUMNS: usize = 80;
const ROWS: i32 = 24;
const CUES: [Cue; 4] = [
    [255, 110, 0, 0, 128, 128],   // a wide pool of white, without a hotspot
    [255, 60, 200, 1, 100, 140],  // a small red one with a hotspot, lower and to the left
    [160, 110, 128, 2, 160, 128], // a green one, dimmed, to the right
    [255, 0, 255, 0, 128, 128],   // too narrow and too sharp for 16 bits
];
/// The light that each gel lets through.
const GELS: [Rgb<Fx16>; 3] = [linear([1.0, 1.0, 1.0]), linear([0.9, 0.04, 0.02]), linear([0.1, 0.7, 0.15])];
/// The cloth: stripes of red and of green paint, each half a metre wide.
const PAINTS: [Rgb<Fx16>; 2] = [linear([0.8, 0.08, 0.06]), linear([0.1, 0.6, 0.15])];
const STRIPE: usize = 8;

fn main() -> Result<(), Refusal> {
    let mut light = lamp(CUES[0])?;
    for (number, cue) in CUES.into_iter().enumerate() {
        match lamp(cue) {
            Ok(next) => light = next,
            Err(refusal) => println!("cue {number} is left out: {refusal}"),
        }
        println!("cue {number}");
        for row in 0..ROWS {
            let mut greys = [0; COLUMNS];
            scanline(&light, row, &mut greys);
            println!(
                "{}",
                String::from_utf8_lossy(&greys.map(|grey| b" .:-=+*#%@"[usize::from(grey) * 9 / 255]))
            );
        }
    }
    Ok(())
}

/// The light of a cue, four metres in front of the middle of the cloth, with an outer angle of 10 to 60 degrees.
fn lamp([dimmer, zoom, edge, gel, pan, tilt]: Cue) -> Result<Light, Refusal> {
    const POSITION: Vec3<Length> = Fx16::point([2.5, 1.5, 4.0]);
    const INTENSITY: Length = Fx16::length(16.0);
    // Full angles in steps of 2^-16 degrees.
    let outer = (10 << 16) + u32::from(zoom) * (50 << 16) / 255;
    let inner = outer / 256 * u32::from(edge);
    let cone = IntegerCone::from_inner_and_outer(SoftOrHard::Hard, inner, outer)?;
    let [pan, tilt] = [pan, tilt].map(|channel| i16::from(channel) - 128);
    let axis = Vec3::new(pan, tilt, -256).map(Length::from_int);
    let part = Fx16::from_bits((i32::from(dimmer) * i32::from(Fx16::ONE.to_bits()) / 255) as i16);
    let gel = GELS[usize::from(gel) % GELS.len()];
    Ok(cone.light(POSITION, axis, INTENSITY)?.with_color(gel).dimmed(part))
}

/// One row of the cloth, 16 columns and 8 rows to the metre, in greys of an sRGB display; y points down.
fn scanline(light: &Light, row: i32, greys: &mut [u8]) {
    const FACING: Vec3<Fx16> = Fx16::normal([0.0, 0.0, 1.0]);
    let metres = |count: i32, parts: i32| Length::from_bits((count << 16) / parts); // 16 fraction bits
    for (column, grey) in greys.iter_mut().enumerate() {
        let point = Vec3::new(metres(column as i32, 16), metres(row, 8), Length::ZERO);
        let arrived = Rgb::lit(light.irradiance(point, FACING), light.color());
        *grey = Gray8::nearest(clip(arrived.filtered(PAINTS[column / STRIPE % 2]))).0;
    }
}

/// A linear colour.
const fn linear([red, green, blue]: [f32; 3]) -> Rgb<Fx16> {
    Rgb::new(Fx16::from_f32(red), Fx16::from_f32(green), Fx16::from_f32(blue))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The greys of the cloth's middle row under a cue.
    fn middle(cue: Cue) -> [u8; COLUMNS] {
        let mut greys = [0; COLUMNS];
        scanline(&lamp(cue).expect("a light"), ROWS / 2, &mut greys);
        greys
    }

    #[test]
    fn every_channel_does_what_it_says() {
        let [red, green] = [36, 43]; // stripes on both sides of the middle
        let white = middle([255, 110, 0, 0, 128, 128]);
        let lit = |cue| middle(cue).iter().filter(|&&grey| grey > 0).count();
        assert!(white[green] > white[red] && white[red] > 80, "{white:?}");
        assert!(middle([100, 110, 0, 0, 128, 128])[green] < white[green]);
        assert!(lit([255, 60, 0, 0, 128, 128]) < lit([255, 110, 0, 0, 128, 128]));
        assert!(middle([255, 110, 128, 0, 128, 128])[28] > white[28]);
        let reddened = middle([255, 110, 0, 1, 128, 128]);
        assert!(reddened[red] > 2 * reddened[green], "{reddened:?}");
        let panned = middle([255, 60, 0, 0, 170, 128]);
        assert!(panned[30] == 0 && panned[60] > 0, "{panned:?}");
        let tilted = lamp([255, 60, 0, 0, 128, 200]).expect("a light");
        let is_lit = |row| {
            let mut greys = [0; COLUMNS];
            scanline(&tilted, row, &mut greys);
            greys.iter().any(|&grey| grey > 0)
        };
        assert!(is_lit(21) && !is_lit(12), "the light is tilted down");
    }

    #[test]
    fn a_cue_without_a_cone_is_refused() {
        assert_eq!(lamp(CUES[3]), Err(Refusal::Steepness));
        assert!(CUES[..3].iter().all(|&cue| lamp(cue).is_ok()));
    }
}
