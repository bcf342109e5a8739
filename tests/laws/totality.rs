//! Every bit pattern gives a defined result: no panic, no NaN, in range, and bit-identical with and
//! without early-outs.

use super::format::Format;
use super::scene::{self, with_any_highlight};
use super::words::Words;
use luminaire::{
    AmbientLight, DirectionalLight, Material, PointLight, Rgb,
    display::{Exposure, Rgb565, clip, compress_keep_hue, encode_srgb},
    falloff::{AnyFalloff, Soft},
    light::{LightModel, SurfacePoint},
    specular::SpecularLobe,
};

/// Falloff and light of a spotlight with any falloff are sound.
pub fn spotlights_answer<S: Format>(words: &[u32]) {
    let _: Option<()> = spotlight::<S>(&mut Words::new(words));
}

fn spotlight<S: Format>(words: &mut Words<'_>) -> Option<()> {
    let falloff = scene::falloff(words)?;
    let cone = scene::cone::<S, _>(words, falloff)?;
    let places = scene::places::<S>(words);
    let spot = scene::spot(words, cone, places)?;
    let light = spot.compile::<S>().ok()?;
    let (point, normal) = (words.point::<S>(places[1]), words.normal::<S>());
    assert_within_one(light.falloff_at(point), "falloff");
    let arrived = light.irradiance(point, normal);
    assert_eq!(arrived, light.irradiance_unskipped(point, normal), "{spot:?} {point:?} {normal:?}");
    assert_sound::<S>(arrived);
    assert_sound::<S>(light.irradiance_facing(point));
    let falloff = cone.compile::<S>().ok()?;
    assert_within_one(falloff.at(S::versine_from_bits(words.wide())), "falloff of a versine");
    assert_within_one(falloff.at(falloff.versine(f32::from_bits(words.next()))), "falloff of a number");
    Some(())
}

/// The light of a point light and of a spotlight, with any attenuation, is sound.
pub fn distances_answer<S: Format>(words: &[u32]) {
    let _: Option<()> = distance::<S>(&mut Words::new(words));
}

fn distance<S: Format>(words: &mut Words<'_>) -> Option<()> {
    let cone = scene::cone::<S, _>(words, AnyFalloff::from(Soft));
    let [position, place] = scene::places::<S>(words);
    let spot = cone.and_then(|cone| scene::spot(words, cone, [position, place]));
    let model = scene::attenuation(words)?;

    let point = PointLight::new(position).ok()?.with_intensity(scene::intensity(words)).ok()?;
    let matte = Material::new(Rgb::new(1.0, 0.5, 0.25)).ok()?;
    let surface = words.surface::<S>(place);
    if let Ok(light) = point.with_attenuation(model).compile::<S>() {
        assert_reflects(matte, &light, &surface);
        assert_sound::<S>(light.irradiance_facing(surface.point));
    }
    if let Ok(light) = spot?.with_attenuation(model).compile::<S>() {
        assert_reflects(matte, &light, &surface);
    }
    Some(())
}

/// Any specular lobe gives sound light under a directional light: a lobe sees nothing else of a
/// light. The sum with ambient and emitted light stays sound up to the display.
pub fn highlights_answer<S: Format>(words: &[u32]) {
    let _: Option<()> = highlight::<S>(&mut Words::new(words));
}

fn highlight<S: Format>(words: &mut Words<'_>) -> Option<()> {
    with_any_highlight!(words, highlight => {
        let material = scene::material(words, highlight)?;
        let place = words.place();
        let surface = words.surface::<S>(place);
        let direction = words.numbers(-1.0, 1.0);
        let sun = DirectionalLight::new(direction).and_then(|sun| sun.with_intensity(scene::intensity(words)));
        let mut sum = Rgb::default();
        if let Ok(sun) = sun {
            sum = assert_reflects(material, &sun.compile::<S>(), &surface);
        }
        let ambient = AmbientLight::new(scene::color(words)).and_then(|a| a.with_intensity(words.number(0.0, 2.0)));
        if let Ok(ambient) = ambient {
            sum += material.compile::<S>().glow(ambient.compile::<S>());
        }
        assert_shown::<S>(words, sum);
        Some(())
    })
}

/// Reflects a light. Asserts that the result is sound and bit-identical without early-outs.
fn assert_reflects<S: Format, H: SpecularLobe>(
    material: Material<H>,
    light: &impl LightModel<S>,
    surface: &SurfacePoint<S>,
) -> Rgb<S::Irradiance> {
    let compiled = material.compile::<S>();
    let reflected = compiled.reflect(surface, light);
    assert_eq!(reflected, compiled.reflect_unskipped(surface, light), "{material:?} {light:?} {surface:?}");
    reflected.map(assert_sound::<S>);
    reflected
}

/// Asserts that light stays in range at every step to the display.
fn assert_shown<S: Format>(words: &mut Words<'_>, light: Rgb<S::Irradiance>) {
    let Ok(exposure) = Exposure::factor(words.number(0.0, 4.0)) else { return };
    let exposed = exposure.compile::<S>().expose(light);
    exposed.map(assert_sound::<S>);
    for fitted in [clip(exposed), compress_keep_hue(exposed)] {
        fitted.map(|channel| assert_within_one(channel, "channel"));
        let codes = fitted.map(encode_srgb);
        let Rgb { red, green, blue } = Rgb565::from_linear(fitted).to_codes();
        // A channel of five bits differs from the 8-bit code by at most half of its step.
        for (wide, narrow) in [(codes.red, red), (codes.green, green), (codes.blue, blue)] {
            assert!(
                wide.abs_diff(narrow) <= 5,
                "{fitted:?}: {wide} {narrow}, expected wide.abs_diff(narrow) <= 5"
            );
        }
    }
}

fn assert_within_one<S: Format>(value: S, what: &str) {
    assert!((0.0..=1.0).contains(&value.exact()), "{what}: {value:?}, expected value.exact() in 0.0..=1.0");
}

/// Asserts that light is not negative, infinite or NaN.
fn assert_sound<S: Format>(light: S::Irradiance) {
    let value = S::exact_light(light);
    assert!(value >= 0.0 && value.is_finite(), "{light:?}, expected value >= 0.0 and value.is_finite()");
}
