//! A tree of 500 LEDs under four moving spotlights, in 16-bit integers: prints frames as characters.
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
const STRIP: LedStrip = LedStrip::new(LedOrder::Grb).with_limit(4_000, 20, 1);

fn main() -> Result<(), luminaire::Error> {
    let (places, lamps) = (tree(), lamps()?);
    let mut dithers = phases();
    for frame in 0..4 {
        let mut bytes = [0; 3 * LEDS];
        draw(&aimed(&lamps, 5 * frame), &places, &mut dithers, &mut bytes);
        println!("frame {frame}");
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
