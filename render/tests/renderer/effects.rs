//! Gobos, shadows and haze in a picture: each pixel has the kernel's result, and an effect that is
//! not needed is not computed.

use luminaire::{
    Angle, Cone, Error, Rgb, SpotLight, Vec3,
    display::{
        Gray1, Gray2, Gray4, Gray8, Palette, Pixel, Rgb332, Rgb444, Rgb555, Rgb565, Rgb666, Rgb888,
        compress_keep_hue,
    },
    dynamic::AnyLight,
    falloff::SoftOrHard,
    haze::Haze,
    light::SurfacePoint,
    projector::{Fixture, Gobo, Projection},
    specular::{DifferenceForm, Phong},
};
use luminaire_render::{
    ACEP, Display, Format, Material, Output, Renderer, Scene, ShadowMap, scenes::gobos, scenes::stage,
};

const SIZE: (usize, usize) = (160, 90);
const STAR: [u8; 32 * 32] = gobos::star();

/// The lights of the stage: one with a gobo, one with shadows, one with both.
fn fixtures() -> Result<Vec<Fixture>, Error> {
    let [key, fill, back] = stage::lights()?.map(Fixture::from);
    let star = |fixture: Fixture| fixture.with_gobo(Gobo::of(&STAR), Angle::degrees(20.0));
    Ok(vec![star(key)?.with_shadow(128)?, fill.with_shadow(64)?, star(back)?])
}

fn hazy() -> Result<Scene, Error> {
    let mut scene = stage::scene().unwrap();
    scene.set_haze(Some(Haze::new(0.03)?));
    Ok(scene)
}

fn renderer<S: Format>(scene: &Scene, fixtures: &[Fixture]) -> Renderer<S> {
    renderer_of(SIZE, scene, fixtures)
}

fn renderer_of<S: Format>(
    (width, height): (usize, usize),
    scene: &Scene,
    fixtures: &[Fixture],
) -> Renderer<S> {
    let mut renderer = Renderer::new(width, height).expect("a sound size");
    renderer.draw_geometry(scene, &stage::camera());
    renderer.draw_shadows(scene, fixtures).expect("held");
    renderer.draw_light(fixtures).expect("held");
    renderer
}

fn pixels() -> impl Iterator<Item = (usize, usize)> {
    (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (x, y)))
}

fn bits<S: Format>(renderer: &Renderer<S>) -> Vec<Option<[u32; 3]>> {
    let channels = |Rgb { red, green, blue }: Rgb<f32>| [red, green, blue].map(f32::to_bits);
    pixels().map(|(x, y)| renderer.linear(x, y).map(channels)).collect()
}

/// The light of a pixel is the arriving light times the transmittance of gobo and shadow, bit for
/// bit.
#[test]
fn patterns_and_shadows_are_factors() -> Result<(), Error> {
    let mut scene = stage::scene().unwrap();
    scene.set_ambient(Rgb::default()).unwrap();
    let fixture = fixtures()?[0];
    let AnyLight::Spot(spot) = *fixture.light() else { panic!("it is a spotlight") };
    let renderer = renderer::<f32>(&scene, &[fixture]);
    let compiled = spot.compile::<f32>()?;
    let gobo = fixture.compile_gobo::<f32>()?.expect("it has one");
    let mut map = ShadowMap::<f32>::new(128).expect("a sound side");
    map.draw(&scene, &Projection::of(&spot)?).expect("the format holds it");
    let shadow = map.shadow().expect("drawn");
    let (mut dimmed, mut shadowed) = (0, 0);
    for (x, y) in pixels() {
        let Some((point, normal, material)) = renderer.surface(x, y) else { continue };
        let light = compiled.irradiance(point, normal);
        let (pattern, visibility) = (gobo.at(point), shadow.visibility(point));
        dimmed += u32::from(light > 0.0 && pattern < 1.0);
        shadowed += u32::from(light > 0.0 && visibility < 1.0);
        let light = light * pattern * visibility;
        let expected = spot.color().zip(material.albedo(), |color, albedo| light * color * albedo);
        assert_eq!(renderer.linear(x, y), Some(expected), "at {x}, {y}");
    }
    assert!(dimmed > 500 && shadowed > 200, "{dimmed} pixels under the pattern, {shadowed} in shadow");
    Ok(())
}

/// A highlight is Phong's, in the form that takes the same steps whatever the shininess.
#[test]
fn highlights_are_phongs() -> Result<(), Error> {
    let (albedo, specular) = (Rgb::new(0.0, 0.0, 0.0), Rgb::new(0.9, 0.8, 0.7));
    let mut scene = stage::scene().unwrap();
    scene.set_ambient(Rgb::default()).unwrap();
    let glazed = Material::new(albedo)?.with_highlight(specular, 40)?;
    scene.repaint(|_| glazed);
    let spots = stage::lights()?;
    let renderer = renderer::<f32>(&scene, &spots.map(Fixture::from));
    let phong =
        luminaire::Material::new(albedo)?.with_highlight(DifferenceForm::<_, 3>(Phong), specular, 40)?;
    let phong = phong.compile::<f32>();
    let compiled = [spots[0].compile::<f32>()?, spots[1].compile()?, spots[2].compile()?];
    let eye = stage::camera().eye();
    let (mut largest, mut brightest) = (0.0_f32, 0.0_f32);
    for (x, y) in pixels() {
        let Some((point, normal, _)) = renderer.surface(x, y) else { continue };
        let surface = SurfacePoint::seen_from(eye, point, normal);
        let expected = compiled.iter().map(|spot| phong.reflect(&surface, spot).green).sum::<f32>();
        let found = renderer.linear(x, y).expect("inside").green;
        largest = largest.max((found - expected).abs() / (1.0 + expected));
        brightest = brightest.max(expected);
    }
    assert!(brightest > 1.0, "the brightest highlight is {brightest}");
    assert!((1e-8..1e-5).contains(&largest), "{largest}, expected largest in 1e-8..1e-5");
    Ok(())
}

/// A fixture that moves changes only the tiles that it lights on surfaces or in the air.
#[test]
fn what_no_beam_meets_is_not_lit_again() -> Result<(), Error> {
    let cone = Cone::from_outer(SoftOrHard::Hard, Angle::degrees(6.0))?;
    let narrow = |x: f32| -> Result<Fixture, Error> {
        let down = Vec3::new(0.0, -1.0, 0.0);
        Ok(SpotLight::new(Vec3::new(x, 3.0, 0.0), down, cone)?.with_intensity(9.0)?.into())
    };
    let mut relit = [0; 2];
    for (scene, relit) in [stage::scene().unwrap(), hazy()?].iter().zip(&mut relit) {
        let fixtures = [narrow(-1.0)?, narrow(1.0)?];
        let mut renderer = renderer_of::<f32>((640, 360), scene, &fixtures);
        assert!(!renderer.draw_light(&fixtures)?);
        assert!(renderer.draw_light(&[narrow(-1.0)?, narrow(1.01)?])?);
        *relit = renderer.account().tiles_relit;
    }
    // Of 460 tiles. In haze a tile is skipped if a plane separates it from the beam, which is not
    // so for every dark tile.
    let [in_clear_air, in_haze] = relit;
    assert!(
        (2..40).contains(&in_clear_air) && (in_clear_air..400).contains(&in_haze),
        "{relit:?}, expected in_clear_air in 2..40 and in_haze in in_clear_air..400"
    );
    Ok(())
}

/// A redrawn map re-lights its tiles; a map that is kept re-lights none.
#[test]
fn shadows_that_change_are_seen() -> Result<(), Error> {
    let fixtures = fixtures()?;
    let mut renderer = renderer::<f32>(&stage::scene().unwrap(), &fixtures);
    assert_eq!(renderer.draw_shadows(&stage::scene().unwrap(), &fixtures), Ok(false));
    assert!(!renderer.draw_light(&fixtures)?);
    // A scene without shadow casters, while the camera's geometry is unchanged.
    assert_eq!(renderer.draw_shadows(&Scene::new(), &fixtures), Ok(true));
    let before = bits(&renderer);
    assert!(renderer.draw_light(&fixtures)?);
    assert_ne!(bits(&renderer), before);
    Ok(())
}

/// Each output shows the kernel's pixels, and keeps the hue before it encodes.
#[test]
fn every_output_shows_the_pixels_of_the_kernel() -> Result<(), Error> {
    fn shown<P: Pixel>(color: Rgb<f32>, place: Option<(u32, u32)>) -> Rgb<u8> {
        place.map_or_else(|| P::nearest(color), |(x, y)| P::dithered(color, x, y)).to_codes()
    }
    let palette = Palette::new(&ACEP)?;
    let acep = |color, place: Option<(u32, u32)>| {
        let index = place.map_or_else(|| palette.nearest(color), |(x, y)| palette.dithered(color, x, y));
        palette.color(index)
    };
    let mut renderer = renderer::<f32>(&stage::scene().unwrap(), &fixtures()?);
    for &output in Output::ALL {
        for (is_dithered, keeps_hue) in [(false, false), (true, false), (false, true), (true, true)] {
            renderer.set_display(Display { output, is_dithered, keeps_hue });
            let codes = renderer.encode().to_vec();
            let width = renderer.size().0;
            for (i, found) in codes.chunks_exact(4).enumerate().step_by(7) {
                let (x, y) = (i % width, i / width);
                let linear = renderer.linear(x, y).unwrap();
                let color = if keeps_hue { compress_keep_hue(linear) } else { linear };
                let place = is_dithered.then_some((x as u32, y as u32));
                let expected = match output {
                    Output::Gray1 => shown::<Gray1>(color, place),
                    Output::Gray2 => shown::<Gray2>(color, place),
                    Output::Gray4 => shown::<Gray4>(color, place),
                    Output::Gray8 => shown::<Gray8>(color, place),
                    Output::Rgb332 => shown::<Rgb332>(color, place),
                    Output::Rgb444 => shown::<Rgb444>(color, place),
                    Output::Rgb555 => shown::<Rgb555>(color, place),
                    Output::Rgb565 => shown::<Rgb565>(color, place),
                    Output::Rgb666 => shown::<Rgb666>(color, place),
                    Output::Rgb888 => shown::<Rgb888>(color, place),
                    _ => acep(color, place),
                };
                let found = Rgb::new(found[0], found[1], found[2]);
                assert_eq!(found, expected, "{output:?} at ({x}, {y})");
            }
        }
    }
    Ok(())
}
