//! The LEDs of a strip show its bytes.

use luminaire::{
    Error, Fx16, Fx32, Rgb,
    display::{LedChip, LedOrder, LedStrip, clip},
    dynamic::{AnyLight, CompiledAnyLight},
};
use luminaire_render::{Format, Renderer, Strip, Surfaces, scenes::Example};

/// Returns the bytes of a strip by the kernel alone, for spotlights.
fn by_the_kernel<S: Format>(strip: &Strip, lights: &[AnyLight]) -> Result<Vec<Rgb<u8>>, Error> {
    let spots: Vec<_> = lights.iter().map(AnyLight::compile::<S>).collect::<Result<_, _>>()?;
    let mut lit = Vec::new();
    for place in strip.places() {
        let mut sum = Rgb::default();
        for spot in &spots {
            let CompiledAnyLight::Spot(spot) = spot else { panic!("{spot:?}") };
            sum += Rgb::lit(spot.irradiance_facing(place.map(S::length)), spot.color());
        }
        lit.push(clip(sum));
    }
    let leds = lit.len();
    let mut dithers: Vec<_> = (0..leds as u16).map(LedOrder::dither).collect();
    let mut bytes = vec![0; 3 * leds];
    let kernel = LedStrip::new(LedOrder::Rgb).with_limit(strip.limit(), 20, 1);
    assert_eq!(kernel.write(&lit, &mut dithers, &mut bytes), leds);
    Ok(bytes.chunks_exact(3).map(|led| Rgb::new(led[0], led[1], led[2])).collect())
}

/// A pixel of an LED has the linear light of its bytes, and none of the surface's.
fn assert_leds_show_their_bytes<S: Format>() -> Result<(), Box<dyn std::error::Error>> {
    let (width, height) = Example::Tree.size();
    let setup = Example::Tree.setup()?;
    let strip = setup.scene.strip().ok_or("no strip")?;
    let (surfaces, aspect) = (Surfaces::of(&setup.scene), width as f32 / height as f32);
    let mut renderer = Renderer::<S>::new(width, height)?;
    renderer.draw_geometry(&setup.scene, &setup.camera);
    for seconds in [0.0, 1.3, 2.6] {
        let fixtures = setup.fixtures_at(seconds)?;
        let lights: Vec<_> = fixtures.iter().map(|fixture| *fixture.light()).collect();
        renderer.draw_light(&fixtures)?;
        let frame = by_the_kernel::<S>(strip, &lights)?;
        let mut seen = 0;
        // Those at the top overlap.
        for (place, led) in strip.places().iter().zip(&frame).take(400) {
            let [across, down, _] = setup.camera.project(*place, aspect).ok_or("behind the eye")?;
            let (x, y) = ((across * width as f32) as usize, (down * height as f32) as usize);
            let middle = [(x as f32 + 0.5) / width as f32, (y as f32 + 0.5) / height as f32];
            let toward = setup.camera.toward(middle, aspect);
            let Some(depth) = surfaces.first(setup.camera.eye(), toward) else { continue };
            let met = setup.camera.eye().zip(toward, |eye, toward| eye + depth * toward);
            let off = met.zip(*place, |met, place| met - place);
            if off.dot(off) < 0.02 * 0.02 {
                let expected = led.map(|duty| S::light_to_f32(S::light_from_f32(f32::from(duty) / 255.0)));
                assert_eq!(renderer.linear(x, y), Some(expected), "{} at {place:?}", S::NAME);
                seen += 1;
            }
        }
        assert!(seen > 150, "{seen} LEDs are seen");
        let account = renderer.account();
        assert_eq!((account.leds, account.led_current), (500, Strip::current(&frame)));
        assert!(account.led_current <= account.led_limit && account.led_limit == strip.limit());
    }
    Ok(())
}

#[test]
fn leds_show_their_bytes_in_every_format() -> Result<(), Box<dyn std::error::Error>> {
    assert_leds_show_their_bytes::<f32>()?;
    assert_leds_show_their_bytes::<Fx32>()?;
    assert_leds_show_their_bytes::<Fx16>()
}
