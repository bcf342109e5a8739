//! Pictures of the renderer in `Fx16`, and what the program `pictures` needs to light them again.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use luminaire::codegen::{Source, as_source};
use luminaire::dynamic::AnyLight;
use luminaire::projector::Fixture;
use luminaire::specular::SpecularLobe as _;
use luminaire::{AmbientLight, Fx16, Length, Rgb, Vec3};
use luminaire_render::{Display, Highlight, Material, Output, Renderer, scenes::Example};

type Outcome<T> = Result<T, Box<dyn Error>>;

/// A scene with its size and display. If it has a number, its lights get shadow maps of this side, and its surfaces
/// broad highlights.
type Row = (&'static str, Example, [usize; 2], Display, Option<u16>);

/// The pictures. The fifth has gobos, the sixth keeps the hue of overexposed light, and the last has highlights in
/// shadows. These three are small because two shadow maps take half of the 4 MB of the board.
const PICTURES: [Row; 7] = [
    ("bare-spot", Example::BareSpot, [160, 120], Example::BareSpot.display(), None),
    ("pocket", Example::Pocket, [160, 120], Example::Pocket.display(), None),
    ("three-point", Example::ThreePoint, [160, 120], Example::ThreePoint.display(), None),
    ("turntable", Example::Turntable, [160, 120], Example::Turntable.display(), None),
    ("show", Example::Show, [80, 60], Example::Show.display(), None),
    ("hue", Example::Pocket, [60, 45], Display { keeps_hue: true, ..Output::Rgb888.nearest() }, None),
    ("highlights", Example::Turntable, [60, 45], Example::Turntable.display(), Some(32)),
];

/// The moment of the animations.
const SECONDS: f32 = 2.5;

/// Draws the pictures, and writes them as constants of the program.
pub(crate) fn write() -> Outcome<()> {
    let out = env::var("OUT_DIR")?;
    let pictures: Outcome<Vec<_>> = PICTURES.iter().map(|picture| drawn(Path::new(&out), picture)).collect();
    Ok(fs::write(Path::new(&out).join("pictures.rs"), format!("[{}]", pictures?.concat()))?)
}

/// Draws a picture without haze, which the renderer computes in floats. Returns the constant of the program.
fn drawn(out: &Path, &(name, example, [width, height], display, side): &Row) -> Outcome<String> {
    let mut setup = example.setup()?;
    setup.scene.set_haze(None);
    if let Some(side) = side {
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
    file("codes", renderer.encode().chunks(4).flat_map(|pixel| &pixel[..3]).copied().collect())?;
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

    let mut fixtures = String::new();
    for (number, fixture) in lights.iter().enumerate() {
        let depths = renderer.shadow_map(number).map(|depths| depths.flat_map(u32::to_le_bytes).collect());
        fixtures += &fixture_source(fixture, &format!("{name}.{number}"))?;
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
    let files =
        ["points", "normals", "materials", "codes"].map(|kind| format!("{kind}: file!(\"{name}.{kind}\"),"));
    Ok(format!(
        "Picture {{ name: \"{name}\", width: {width}, eye: {eye}, ambient: {ambient}, keeps_hue: {keeps_hue}, \
         encode: {encode}, fixtures: &[{fixtures}], finishes: &[{finishes}], {} }},",
        files.concat()
    ))
}

fn fixture_source(fixture: &Fixture, depths: &str) -> Outcome<String> {
    let AnyLight::Spot(spot) = fixture.light() else { return Err("the program has spotlights only".into()) };
    let light = source(&spot.compile::<Fx16>()?);
    let gobo = fixture.compile_gobo::<Fx16>()?.map(|gobo| source(&gobo));
    let gobo = gobo.map_or_else(|| "None".to_owned(), |gobo| format!("Some({gobo})"));
    let shadow = match fixture.shadow() {
        Some((side, square)) => {
            format!("Some(({}, {side}, file!(\"{depths}\")))", source(&square.compile::<Fx16>()?))
        }
        None => "None".to_owned(),
    };
    Ok(format!("Fixture {{ light: {light}, gobo: {gobo}, shadow: {shadow} }},"))
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
