//! Pictures of the renderer in `Fx16`, and what the program `pictures` needs to light them again.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use luminaire::attenuation::{AnyAttenuation, InverseSquare};
use luminaire::codegen::{Source, as_source};
use luminaire::display::{clip, encode_srgb};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::AnyFalloff;
use luminaire::haze::{BeamScattering16, Haze};
use luminaire::projector::Fixture;
use luminaire::specular::SpecularLobe as _;
use luminaire::{AmbientLight, Fx16, Length, Rgb, SpotLight, Vec3};
use luminaire_render::{Display, Highlight, Material, Output, Renderer, scenes::Example};

type Outcome<T> = Result<T, Box<dyn Error>>;

/// A scene with its size and display, and what it gets.
type Row = (&'static str, Example, [usize; 2], Display, With);

/// What a scene gets beside its own lights and materials.
enum With {
    Nothing,
    /// Shadow maps of this side, and broad highlights.
    Shadows(u16),
    /// Haze of this density before the one light of the scene.
    Haze(f32),
}

/// The pictures. The fifth has gobos, the sixth keeps the hue of overexposed light, and the seventh has highlights in
/// shadows. These three are small because two shadow maps take half of the 4 MB of the board. The last has the points,
/// normals and materials of the first.
const PICTURES: [Row; 8] = [
    ("bare-spot", Example::BareSpot, [160, 120], Example::BareSpot.display(), With::Nothing),
    ("pocket", Example::Pocket, [160, 120], Example::Pocket.display(), With::Nothing),
    ("three-point", Example::ThreePoint, [160, 120], Example::ThreePoint.display(), With::Nothing),
    ("turntable", Example::Turntable, [160, 120], Example::Turntable.display(), With::Nothing),
    ("show", Example::Show, [80, 60], Example::Show.display(), With::Nothing),
    (
        "hue",
        Example::Pocket,
        [60, 45],
        Display { keeps_hue: true, ..Output::Rgb888.nearest() },
        With::Nothing,
    ),
    ("highlights", Example::Turntable, [60, 45], Example::Turntable.display(), With::Shadows(32)),
    ("haze", Example::BareSpot, [160, 120], Example::BareSpot.display(), With::Haze(0.04)),
];

/// The moment of the animations.
const SECONDS: f32 = 2.5;

/// Largest difference of a code between a picture in haze and the renderer's.
const MOST_APART: u8 = 1;

/// Draws the pictures, and writes them as constants of the program.
pub(crate) fn write() -> Outcome<()> {
    let out = env::var("OUT_DIR")?;
    let pictures: Outcome<Vec<_>> = PICTURES.iter().map(|picture| drawn(Path::new(&out), picture)).collect();
    Ok(fs::write(Path::new(&out).join("pictures.rs"), format!("[{}]", pictures?.concat()))?)
}

/// Draws a picture. The renderer has its haze in floats: a picture in haze is the one that the kernel draws on the host,
/// if the renderer's is near it. Returns the constant of the program.
fn drawn(out: &Path, &(name, example, [width, height], display, ref with): &Row) -> Outcome<String> {
    let mut setup = example.setup()?;
    let haze = if let With::Haze(density) = *with { Some(Haze::new(density)?) } else { None };
    setup.scene.set_haze(haze);
    if let With::Shadows(side) = *with {
        setup.fixtures.iter_mut().for_each(|fixture| *fixture = fixture.with_shadow(side));
        let broad = |material: &Material| material.with_highlight(Rgb::new(0.5, 0.4, 0.3), 8);
        setup.scene.repaint(|material| broad(material).unwrap_or(*material));
    }
    let (camera, lights) = (setup.camera_at(SECONDS), setup.fixtures_at(SECONDS)?);
    let mut renderer = Renderer::<Fx16>::new(width, height)?;
    renderer.set_display(display);
    renderer.draw_geometry(&setup.scene, &camera);
    renderer.draw_shadows(&setup.scene, &lights)?;
    renderer.draw_light(&lights)?;

    let file = |kind: &str, bytes: Vec<u8>| fs::write(out.join(format!("{name}.{kind}")), bytes);
    let mut codes: Vec<u8> = renderer.encode().chunks(4).flat_map(|pixel| &pixel[..3]).copied().collect();
    let (mut points, mut normals, mut numbers) = (Vec::new(), Vec::new(), Vec::new());
    let mut materials = vec![Material::default()];
    for pixel in 0..width * height {
        // Nothing was drawn where there is no surface: no light arrives at a normal of zero.
        let nothing = (Vec3::default(), Vec3::default(), Material::default());
        let (point, normal, material) = renderer.surface(pixel % width, pixel / width).unwrap_or(nothing);
        points.extend([point.x, point.y, point.z].map(Length::to_bits).map(i32::to_le_bytes).concat());
        normals.extend([normal.x, normal.y, normal.z].map(Fx16::to_bits).map(i16::to_le_bytes).concat());
        let number = materials.iter().position(|known| *known == material).unwrap_or(materials.len());
        if number == materials.len() {
            materials.push(material);
        }
        numbers.push(u8::try_from(number)?);
    }
    file("points", points)?;
    file("normals", normals)?;
    file("materials", numbers)?;

    if let Some(haze) = haze {
        let pixels = (0..width * height).map(|pixel| renderer.surface(pixel % width, pixel / width));
        let pixels: Option<Vec<_>> = pixels.collect();
        let pixels = pixels.ok_or("a line of sight without an end has no point")?;
        codes = in_haze(&lights, &haze, camera.eye(), &pixels, &codes)?;
    }
    file("codes", codes)?;

    let mut fixtures = String::new();
    for (number, fixture) in lights.iter().enumerate() {
        let depths = renderer.shadow_map(number).map(|depths| depths.flat_map(u32::to_le_bytes).collect());
        fixtures += &fixture_source(fixture, &format!("{name}.{number}"), haze.as_ref())?;
        if let Some(depths) = depths {
            file(&number.to_string(), depths)?;
        }
    }
    let finishes: String = materials.iter().map(finish_source).collect();
    let (keeps_hue, encode) = match display {
        Display { output: Output::Rgb888, is_dithered: false, keeps_hue } => (keeps_hue, "srgb"),
        Display { output: Output::Rgb565, is_dithered: true, keeps_hue } => (keeps_hue, "rgb565_dithered"),
        display => return Err(format!("the program has no {display:?}").into()),
    };
    let eye = source(&camera.eye().map(Length::from_f32));
    let ambient = source(&AmbientLight::new(setup.scene.ambient())?.compile::<Fx16>());
    // There is no room for the same bytes twice.
    let shared = if haze.is_some() { PICTURES[0].0 } else { name };
    let files = [("points", shared), ("normals", shared), ("materials", shared), ("codes", name)];
    let files = files.map(|(kind, name)| format!("{kind}: file!(\"{name}.{kind}\"),"));
    Ok(format!(
        "Picture {{ name: \"{name}\", width: {width}, eye: {eye}, ambient: {ambient}, keeps_hue: {keeps_hue}, \
         encode: {encode}, fixtures: &[{fixtures}], finishes: &[{finishes}], {} }},",
        files.concat()
    ))
}

/// A surface point, its normal and its material.
type Surface = (Vec3<Length>, Vec3<Fx16>, Material);

/// Returns the codes of a picture of one light and matte surfaces in haze, by the kernel. `floats` are those of the
/// renderer.
fn in_haze(
    lights: &[Fixture],
    haze: &Haze,
    eye: Vec3<f32>,
    pixels: &[Surface],
    floats: &[u8],
) -> Outcome<Vec<u8>> {
    let [fixture] = lights else { return Err("a picture in haze has one light".into()) };
    let spot = spot(fixture)?;
    let (light, beam) = (spot.compile::<Fx16>()?, beam(&spot, haze)?);
    let eye = eye.map(Length::from_f32);
    let pixel = |&(point, normal, material): &Surface| {
        let lit = |arrived| Rgb::lit(arrived, light.color());
        let reflected = lit(light.irradiance(point, normal)).filtered(material.albedo().map(Fx16::from_f32));
        let Rgb { red, green, blue } = clip(reflected + lit(beam.in_scattering(eye, point))).map(encode_srgb);
        [red, green, blue]
    };
    let codes: Vec<u8> = pixels.iter().flat_map(pixel).collect();
    let most = codes.iter().zip(floats).map(|(own, float)| own.abs_diff(*float)).max();
    match most {
        Some(0..=MOST_APART) => Ok(codes),
        _ => Err(format!("haze in 16 bits: expected at most {MOST_APART} codes from floats, found {most:?}")
            .into()),
    }
}

/// Returns the spotlight of a fixture.
fn spot(fixture: &Fixture) -> Outcome<SpotLight<AnyFalloff, AnyAttenuation>> {
    let AnyLight::Spot(spot) = fixture.light() else { return Err("the program has spotlights only".into()) };
    Ok(*spot)
}

/// Returns the beam of a spotlight with the inverse-square law.
fn beam(spot: &SpotLight<AnyFalloff, AnyAttenuation>, haze: &Haze) -> Outcome<BeamScattering16<AnyFalloff>> {
    Ok(spot.with_attenuation(InverseSquare).compile::<Fx16>()?.in_haze(haze))
}

fn fixture_source(fixture: &Fixture, depths: &str, haze: Option<&Haze>) -> Outcome<String> {
    let spot = spot(fixture)?;
    let light = source(&spot.compile::<Fx16>()?);
    let gobo = fixture.compile_gobo::<Fx16>()?.map(|gobo| source(&gobo));
    let gobo = gobo.map_or_else(|| "None".to_owned(), |gobo| format!("Some({gobo})"));
    let shadow = match fixture.shadow() {
        Some((side, square)) => {
            format!("Some(({}, {side}, file!(\"{depths}\")))", source(&square.compile::<Fx16>()?))
        }
        None => "None".to_owned(),
    };
    let beam = haze.map(|haze| beam(&spot, haze)).transpose()?;
    let beam = beam.map_or_else(|| "None".to_owned(), |beam| format!("Some({})", source(&beam)));
    Ok(format!("Fixture {{ light: {light}, gobo: {gobo}, shadow: {shadow}, beam: {beam} }},"))
}

fn finish_source(material: &Material) -> String {
    let [albedo, specular] =
        [material.albedo(), material.specular()].map(|color| source(&color.map(Fx16::from_f32)));
    let highlight = source(&Highlight::constants::<Fx16>(material.shininess()));
    let highlight =
        if material.shines() { format!("Some(({specular}, {highlight}))") } else { "None".into() };
    format!("Finish {{ albedo: {albedo}, highlight: {highlight} }},")
}

fn source(value: &impl Source) -> String {
    as_source(value).to_string()
}
