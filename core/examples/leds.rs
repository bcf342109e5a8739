//! A tree of 500 LEDs under four moving spotlights, in 16-bit integers: prints frames as characters, and
//! the bytes and the current of the strip.
//!
//! The lights and the positions of the LEDs are set up once, on a microcontroller by a build script. Each
//! frame then aims the lights, lights each LED, and writes the bytes of the strip: without floating point.

use luminaire::{
    Cone, Fx16, HalfAngle, Length, Rgb, SpotLight, Vec3,
    attenuation::NoAttenuation,
    display::{LedOrder, LedStrip, TemporalDither, clip},
    falloff::Soft,
    light::QuickSpotLight,
};

type Light = QuickSpotLight<Fx16, Soft, NoAttenuation>;

const LEDS: usize = 500;
const STRIP: LedStrip = LedStrip::new(LedOrder::Grb).with_limit(LIMIT, 20, 1);
/// The limit of the current in milliamperes.
const LIMIT: u32 = 4_000;

fn main() -> Result<(), luminaire::Error> {
    let (places, lamps) = (tree(), lamps()?);
    let mut dithers = phases();
    for frame in 0..4 {
        let mut bytes = [0; 3 * LEDS];
        draw(&aimed(&lamps, 5 * frame), &places, &mut dithers, &mut bytes);
        println!("frame {frame}: {} milliamperes", current(&bytes));
        print(&places, &bytes);
    }
    Ok(())
}

/// The positions of the LEDs: a spiral of 20 turns around a cone 2 m high and 1.2 m wide.
fn tree() -> [Vec3<Length>; LEDS] {
    std::array::from_fn(|i| {
        let height = i as f32 / LEDS as f32;
        let (sine, cosine) = (20.0 * std::f32::consts::TAU * height).sin_cos();
        let radius = 0.6 * (1.0 - height);
        Vec3::new(radius * cosine, 2.0 * height, radius * sine).map(Length::from_f32)
    })
}

/// Four spotlights of other colours around the tree, as bright at every distance.
fn lamps() -> Result<[Light; 4], luminaire::Error> {
    let colors = [[1.0, 0.1, 0.0], [0.0, 0.3, 1.0], [1.0, 0.6, 0.1], [0.5, 0.0, 1.0]];
    let cone = Cone::from_outer(Soft, HalfAngle::degrees(9.0))?;
    let mut lamps = [None; 4];
    for (i, (lamp, color)) in lamps.iter_mut().zip(colors).enumerate() {
        let (x, z) = [(3.0, 0.0), (0.0, 3.0), (-3.0, 0.0), (0.0, -3.0)][i];
        let light = SpotLight::new([x, 1.0, z], [-x, 0.0, -z], cone)?.with_attenuation(NoAttenuation);
        *lamp = Some(light.with_color(color.into())?.compile_quick::<Fx16>()?);
    }
    Ok(lamps.map(|lamp| lamp.expect("set above")))
}

/// The lights of a frame: each goes up and down the tree.
fn aimed(lamps: &[Light; 4], frame: i32) -> [Light; 4] {
    std::array::from_fn(|i| {
        // A triangle of 40 frames, from the foot to the top and back.
        let phase = (frame + 10 * i as i32).rem_euclid(40) - 20;
        let target = Vec3::new(Length::ZERO, Length::from_bits(phase.abs() * (2 << 16) / 20), Length::ZERO);
        lamps[i].aimed_at(target).unwrap_or(lamps[i])
    })
}

/// States of the dither with other phases, so that LEDs of equal light do not flash together.
fn phases() -> [Rgb<TemporalDither<8>>; LEDS] {
    std::array::from_fn(|i| [0, 1, 2].map(|channel| TemporalDither::new(3 * i as u16 + channel)).into())
}

/// Lights the LEDs, and writes the bytes of the strip.
fn draw(
    lights: &[Light],
    places: &[Vec3<Length>; LEDS],
    dithers: &mut [Rgb<TemporalDither<8>>; LEDS],
    bytes: &mut [u8; 3 * LEDS],
) {
    let lit = places.map(|place| {
        let add = |sum: Rgb<_>, light: &Light| {
            sum.plus::<Fx16>(Rgb::lit(light.irradiance_facing(place), light.color()))
        };
        clip::<Fx16>(lights.iter().fold(Rgb::default(), add))
    });
    STRIP.write(&lit, dithers, bytes);
}

/// The current of the strip in milliamperes.
fn current(bytes: &[u8; 3 * LEDS]) -> u32 {
    let duties: u32 = bytes.iter().copied().map(u32::from).sum();
    LEDS as u32 + duties * 20 / 255
}

/// Prints the half of the tree that is in front.
fn print(places: &[Vec3<Length>; LEDS], bytes: &[u8; 3 * LEDS]) {
    let mut rows = [[b' '; 40]; 20];
    for (place, led) in places.iter().zip(bytes.chunks_exact(3)) {
        let place = place.map(Length::to_f32);
        let (row, column) = ((9.99 * (2.0 - place.y)) as usize, (20.0 + 30.0 * place.x) as usize);
        let brightest = led.iter().copied().max().unwrap_or(0);
        if place.z > 0.0 {
            rows[row][column] = b".:-=+*#%@"[usize::from(brightest) * 8 / 255];
        }
    }
    rows.iter().for_each(|row| println!("{}", String::from_utf8_lossy(row).trim_end()));
}

#[test]
fn the_strip_keeps_its_limit_and_shows_all_lights() {
    let (places, lamps, mut dithers) = (tree(), lamps().expect("valid lights"), phases());
    let mut most = Rgb::new(0, 0, 0);
    for frame in 0..40 {
        let mut bytes = [0; 3 * LEDS];
        draw(&aimed(&lamps, frame), &places, &mut dithers, &mut bytes);
        assert!(current(&bytes) <= LIMIT, "frame {frame}: {}", current(&bytes));
        for led in bytes.chunks_exact(3) {
            most = most.zip(Rgb::new(led[1], led[0], led[2]), u8::max);
        }
    }
    assert!(most.red > 120 && most.green > 80 && most.blue > 120, "{most:?}");
}
