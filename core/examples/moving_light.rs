//! A spotlight that follows a target over a floor, zooms and fades, in 16-bit integers: prints frames
//! as characters.
//!
//! The light is compiled once, on a microcontroller by a build script. Each frame then aims, zooms
//! and dims it: calls without floating point and without a division.

use luminaire::{
    Angle, Cone, Fx16, Length, Rgb, SpotLight, Vec3,
    display::{clip, encode_srgb},
    falloff::Soft,
    light::CompiledSpotLight,
};

type Light = CompiledSpotLight<Fx16, Soft>;

const COLUMNS: usize = 64;
const ROWS: i32 = 16;
const FRAMES: i32 = 4;

fn main() -> Result<(), luminaire::Error> {
    let lights = lamp()?;
    for frame in 0..FRAMES {
        let light = follow(lights, frame);
        println!("frame {frame}");
        for row in 0..ROWS {
            let mut codes = [0; COLUMNS];
            scanline(&light, row, &mut codes);
            println!(
                "{}",
                String::from_utf8_lossy(&codes.map(|code| b" .:-=+*#%@"[usize::from(code) * 9 / 255]))
            );
        }
    }
    Ok(())
}

/// A spotlight three metres above the middle of the floor, with its narrowest and its widest cone.
fn lamp() -> Result<[Light; 2], luminaire::Error> {
    let [narrow, wide] = [Cone::soft(Angle::degrees(20.0))?, Cone::soft(Angle::degrees(40.0))?];
    SpotLight::new([4.0, 3.0, 2.0], [0.0, -1.0, 0.0], narrow)?.with_intensity(9.0)?.compile_zoom(&wide)
}

/// Moves the light half a metre along its rail, and aims it at a target that walks along the floor, two metres
/// in each frame. In the last frame the light is halfway to its narrowest cone, and dimmed to a half.
fn follow([narrow, wide]: [Light; 2], frame: i32) -> Light {
    let target = Vec3::new(metres(1 + 2 * frame, 1), Length::ZERO, metres(2, 1));
    let part = Fx16::from_bits(((1 << 14) - (frame << 13) / (FRAMES - 1)) as i16); // 14 fraction bits
    let place = Vec3::new(metres(8 + frame, 2), metres(3, 1), metres(2, 1));
    let light = narrow.zoomed(&wide, part).moved_to(place);
    // `None` would mean that the target is at the position of the light.
    light.aimed_at(target).unwrap_or(light).dimmed(part)
}

/// One row of the floor, 8 columns and 4 rows to the metre, in sRGB codes.
fn scanline(light: &Light, row: i32, codes: &mut [u8]) {
    const UP: Vec3<Fx16> = Fx16::normal([0.0, 1.0, 0.0]);
    for (column, code) in (0..).zip(codes) {
        let point = Vec3::new(metres(column, 8), Length::ZERO, metres(row, 4));
        let color = clip(Rgb::lit(light.irradiance(point, UP), light.color()));
        *code = encode_srgb(color.green);
    }
}

/// A length of some parts of a metre, with 16 fraction bits.
fn metres(count: i32, parts: i32) -> Length {
    Length::from_bits((count << 16) / parts)
}

#[test]
fn the_light_follows_its_target() {
    for frame in 0..FRAMES {
        let light = follow(lamp().expect("a valid light"), frame);
        let mut codes = [0; COLUMNS];
        scanline(&light, ROWS / 2, &mut codes);
        let target = 8 * (1 + 2 * frame) as usize;
        assert!(codes[target] > 60, "frame {frame}: {codes:?}");
        assert_eq!(codes[(target + 32) % 64], 0, "frame {frame}: {codes:?}");
    }
}
