//! The lights of a scene together: one function of C and of Rust with the same bits, for points and for rows, also of lights
//! that moved.

mod support;

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use fastrand::Rng;
use luminaire::attenuation::InverseSquare;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Falloff, Formula, Hard, Smooth, Soft};
use luminaire::light::{Distribution, Symmetry};
use luminaire::number::Light16;
use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Fx16, Length, MeasuredLight, PointLight, Rgb, SpotLight,
    Vec3,
};
use luminaire_export::{Language, Scene, export_scene, names};

use support::compiler::{bytes, compile, compile_in_integers, compile_rust, run, write_headers};
use support::{points_of_light, spots, suns};

type Failure = Box<dyn std::error::Error>;

/// The words of a point and a normal.
type Place = [i32; 6];

/// The pixels of a row.
const PIXELS: usize = 150;

/// Lights with their names, and ambient light.
struct Room {
    names: Vec<String>,
    lights: Vec<AnyLight>,
    ambient: Vec<AmbientLight>,
}

impl Room {
    fn new(lights: Vec<AnyLight>, ambient: usize) -> Self {
        let sky =
            |i: usize| AmbientLight::new(Rgb::new(0.1, 0.5, 1.0))?.with_intensity(0.03 * (i + 1) as f32);
        let ambient = (0..ambient).map(|i| sky(i).expect("a light")).collect();
        let names = (0..lights.len()).map(|index| format!("light_{index}")).collect();
        Self { names, lights, ambient }
    }

    fn text(&self, language: Language) -> String {
        let lights = self.names.iter().map(String::as_str).zip(self.lights.iter().copied());
        let scene = Scene { name: "room", ambient: &self.ambient };
        let (text, refused) = export_scene(&scene, lights, language).expect("a scene");
        assert!(refused.is_empty(), "{refused:?}");
        text
    }

    /// Places in reach of each light, at its position, beyond all lights, and of any words.
    fn places(&self, rng: &mut Rng, count: usize) -> Vec<Place> {
        let place = |index: usize| {
            let any = |rng: &mut Rng| rng.i32(..) >> rng.u8(..32);
            let (Some(light), false) = (rng.choice(&self.lights), index % 8 < 1) else {
                return [0; 6].map(|_| any(rng));
            };
            let (point, normal) = support::place(rng, light);
            let [x, y, z] = match (light, index % 8) {
                (AnyLight::Spot(spot), 1) => spot.position().into(),
                (AnyLight::Point(point), 1) => point.position().into(),
                (_, 2) => [20_000.0; 3],
                _ => point,
            };
            let [x, y, z] = [x, y, z].map(|c| Length::from_f32(c).to_bits());
            let [a, b, c] = normal.map(|c| i32::from(Fx16::from_f32(c).to_bits()));
            [x, y, z, a, b, c]
        };
        (0..count).map(place).collect()
    }

    /// What the lights give one by one, at a surface and at one that faces each of them.
    fn alone(&self, place: &Place) -> [u32; 6] {
        let [x, y, z, a, b, c] = *place;
        let point = Vec3::new(x, y, z).map(Length::from_bits);
        let normal = Vec3::new(a, b, c).map(|c| Fx16::from_bits(c as i16));
        let lit = |is_facing: bool| {
            let lit = |light: &AnyLight| {
                let light = light.compile::<Fx16>().expect("a light");
                let facing = || light.irradiance_facing(point);
                Rgb::lit(if is_facing { facing() } else { light.irradiance(point, normal) }, light.color())
            };
            let ambient = self.ambient.iter().map(AmbientLight::compile::<Fx16>);
            let all = ambient.chain(self.lights.iter().map(lit));
            <[Light16; 3]>::from(all.fold(Rgb::default(), |sum, light| sum + light)).map(Light16::to_bits)
        };
        let ([a, b, c], [d, e, f]) = (lit(false), lit(true));
        [a, b, c, d, e, f]
    }
}

/// Whether a scene evaluates a light by its falloff as a cubic, whose fine evaluation rounds in another way.
fn is_cubic(light: &AnyLight) -> bool {
    let AnyLight::Spot(spot) = light else { return false };
    let is_square = spot.attenuation() == InverseSquare.into();
    is_square && matches!(spot.cone().falloff().formula(), Formula::Polynomial(_))
}

fn distance(light: &AnyLight, &[x, y, z, ..]: &Place) -> f64 {
    let AnyLight::Spot(spot) = light else { return f64::INFINITY };
    let way = Vec3::new(x, y, z).zip(spot.position(), |c, own| f64::from(c) / 65_536.0 - f64::from(own));
    (way.x * way.x + way.y * way.y + way.z * way.z).sqrt()
}

/// The program in C: it lights each place, then the row from each fourth place on, and moves the first light in between.
fn in_c(room: &Room) -> String {
    let moves = match room.lights.first() {
        Some(AnyLight::Directional(_)) => "luminaire_directional_aim_along(&scene.light_0, w);",
        Some(AnyLight::Measured(_)) => {
            "luminaire_spot_move(&scene.light_0.spot, w); luminaire_measured_aim_along(&scene.light_0, w);
             luminaire_measured_turn(&scene.light_0, w + 3); luminaire_measured_aim(&scene.light_0, w + 3);"
        }
        Some(_) => "luminaire_spot_move(&scene.light_0, w); luminaire_spot_aim_along(&scene.light_0, w);",
        None => "",
    };
    format!(
        r#"#include <stdio.h>
#include "room.h"

int main(void) {{
    room_scene scene = room_start;
    int32_t w[6];
    uint32_t place, i;
    for (place = 0; fread(w, 4, 6, stdin) == 6; ++place) {{
        int16_t n[3] = {{ (int16_t)w[3], (int16_t)w[4], (int16_t)w[5] }};
        luminaire_rgb light = room_light(&scene, w, n), facing = room_light_facing(&scene, w);
        if (fwrite(&light, 4, 3, stdout) != 3 || fwrite(&facing, 4, 3, stdout) != 3) {{ return 1; }}
        if (place % 4 == 0) {{
            luminaire_row row = {{ {{ w[0], w[1], w[2] }}, {{ w[3], w[4] / 4, w[5] }}, {{ n[1], n[0], n[2] }} }};
            luminaire_rgb lights[{PIXELS}];
            for (i = 0; i < {PIXELS}; ++i) {{ lights[i].red = lights[i].green = lights[i].blue = 0; }}
            room_row_add(lights, &row, &scene, {PIXELS});
            for (i = 0; i < {PIXELS}; i += 7) {{ if (fwrite(&lights[i], 4, 3, stdout) != 3) {{ return 1; }} }}
        }}
        if (place % 64 == 63) {{ {moves} }}
    }}
    return room_light(0, w, 0).red != 0 || room_light_facing(0, w).red != 0 || room_light_facing(&scene, 0).red != 0;
}}
"#
    )
}

/// The same program in Rust.
fn in_rust(room: &Room) -> String {
    let moves = match room.lights.first() {
        Some(AnyLight::Directional(_)) => {
            "scene.light_0 = scene.light_0.aimed_along(point).unwrap_or(scene.light_0);"
        }
        Some(AnyLight::Measured(_)) => {
            "scene.light_0 = scene.light_0.moved_to(point);
             scene.light_0 = scene.light_0.aimed_along(point).unwrap_or(scene.light_0);
             let side = Vec3::new(w[3], w[4], w[5]).map(Length::from_bits);
             scene.light_0 = scene.light_0.turned_to(side).unwrap_or(scene.light_0);
             scene.light_0 = scene.light_0.aimed_at(side).unwrap_or(scene.light_0);"
        }
        Some(AnyLight::Spot(_)) => {
            "scene.light_0 = scene.light_0.moved_to(point);
             scene.light_0 = scene.light_0.aimed_along(point).unwrap_or(scene.light_0);"
        }
        Some(AnyLight::Point(_)) => "scene.light_0 = scene.light_0.moved_to(point);",
        None => "",
    };
    format!(
        r#"{}
use luminaire::{{Fx16, Length, Rgb, Vec3, light::Row, number::Light16}};
use std::io::{{Read, Write}};

fn main() {{
    let (mut input, mut output) = (Vec::new(), Vec::new());
    std::io::stdin().read_to_end(&mut input).expect("words");
    let words: Vec<i32> = input.chunks_exact(4).map(|word| i32::from_le_bytes(word.try_into().expect("a word"))).collect();
    let mut scene = room::SCENE;
    let put = |output: &mut Vec<u8>, light: Rgb<Light16>| {{
        <[Light16; 3]>::from(light).iter().for_each(|light| output.extend(light.to_bits().to_le_bytes()));
    }};
    for (place, w) in words.chunks_exact(6).enumerate() {{
        let point = Vec3::new(w[0], w[1], w[2]).map(Length::from_bits);
        let normal = Vec3::new(w[3], w[4], w[5]).map(|c| Fx16::from_bits(c as i16));
        put(&mut output, scene.light(point, normal));
        put(&mut output, scene.light_facing(point));
        if place % 4 == 0 {{
            let step = [w[3], w[4] / 4, w[5]];
            let at = |i: usize| {{
                let at = |k: usize| w[k].wrapping_add(step[k].wrapping_mul(i as i32));
                Vec3::new(at(0), at(1), at(2)).map(Length::from_bits)
            }};
            let row = Row::new(Vec3::new(normal.y, normal.x, normal.z), at);
            let mut lights = [Rgb::default(); {PIXELS}];
            scene.row(&row, &mut lights, |pixel, i, light| {{
                assert_eq!(light, scene.light(at(i), Vec3::new(normal.y, normal.x, normal.z)), "pixel {{i}}");
                *pixel = light;
            }});
            lights.into_iter().step_by(7).for_each(|light| put(&mut output, light));
        }}
        if place % 64 == 63 {{
            {moves}
        }}
    }}
    std::io::stdout().write_all(&output).expect("words");
}}
"#,
        room.text(Language::RustFixed16)
    )
}

fn answers(program: &Path, input: &[u32]) -> Result<Vec<u32>, Failure> {
    let file = program.with_extension("input");
    fs::write(&file, bytes(input))?;
    let output = Command::new(program).stdin(fs::File::open(file)?).stdout(Stdio::piped()).output()?;
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Ok(output
        .stdout
        .chunks_exact(4)
        .map(|word| u32::from_le_bytes(word.try_into().expect("a word")))
        .collect())
}

#[test]
fn a_scene_has_the_same_bits_in_c_and_in_rust() -> Result<(), Failure> {
    let mut rng = Rng::with_seed(2031);
    let mut all: Vec<AnyLight> = spots::<Fx16>(&mut rng, 1).into_iter().map(AnyLight::from).collect();
    all.extend(points_of_light::<Fx16>(&mut rng).into_iter().map(AnyLight::from));
    all.extend(suns(&mut rng, 4).into_iter().map(AnyLight::from));
    rng.shuffle(&mut all);
    all.truncate(14);
    let near = |falloff: AnyFalloff, x: f32| {
        let cone = Cone::from_outer(falloff, Angle::degrees(70.0))?;
        let spot = SpotLight::new([x, 2.0, 0.0], [0.1, -1.0, 0.2], cone)?.with_intensity(8.0)?;
        Ok::<AnyLight, luminaire::Error>(spot.with_color(Rgb::new(1.0, 0.5, x.abs()))?.into())
    };
    let nine = [
        vec![
            near(Soft.into(), 0.0)?,
            near(Hard.into(), 0.5)?,
            near(Soft.into(), -0.5)?,
            near(Smooth.into(), 1.0)?,
        ],
        vec![PointLight::new([0.0, 1.0, 0.5])?.into(), DirectionalLight::new([1.0, -2.0, 0.0])?.into()],
        all[..3].to_vec(),
    ];
    let mut sun_first = all.clone();
    sun_first.sort_by_key(|light| !matches!(light, AnyLight::Directional(_)));
    let rooms = [
        Room::new(Vec::new(), 0),
        Room::new(Vec::new(), 1),
        Room::new(nine.concat()[..1].to_vec(), 0),
        Room::new(sun_first[..2].to_vec(), 0),
        Room::new(vec![crooked()?, PointLight::new([0.0, 1.0, 0.5])?.into(), street()?], 1),
        Room::new(nine.concat(), 2),
        Room::new(all, 1),
    ];
    let (mut lit, mut count, mut compared, mut most) = (0, 0, 0, 0);
    for room in &rooms {
        let folder = tempfile::tempdir()?;
        let places = room.places(&mut rng, 2_000);
        let input: Vec<_> = places.iter().flatten().map(|word| *word as u32).collect();
        write_headers(folder.path());
        fs::write(folder.path().join("room.h"), room.text(Language::CFixed))?;
        let main = folder.path().join("main.c");
        fs::write(&main, in_c(room))?;
        let program = folder.path().join("program");
        compile_rust(&in_rust(room), "bin", &program)?;
        let expected = answers(&program, &input)?;
        for (compiler, flags) in [
            ("cc", "-std=c99 -O2"),
            (
                "cc",
                "-std=c99 -O1 -DLUMINAIRE_BY_PARTS -fsanitize=undefined,address -fno-sanitize-recover=all",
            ),
            ("c++", "-std=c++11 -Os"),
            ("clang", "-std=c99 -Os"),
        ] {
            let Some(found) = run(compiler, flags, &main, &input) else { continue };
            assert_eq!(found.len(), expected.len(), "{compiler} {flags}");
            let differs = found.iter().zip(&expected).position(|(found, expected)| found != expected);
            assert_eq!(differs, None, "{compiler} {flags}: {} lights", room.lights.len());
        }
        // Before a light moves: the sum of the lights alone, but for a step of each cubic, away from its light.
        let cubics: Vec<_> = room.lights.iter().filter(|light| is_cubic(light)).collect();
        let mut rest = &expected[..];
        for (index, place) in places[..64].iter().enumerate() {
            let (found, alone) = (&rest[..6], room.alone(place));
            rest = &rest[if index % 4 == 0 { 6 + 3 * PIXELS.div_ceil(7) } else { 6 }..];
            let off = (0..6).map(|i| found[i].abs_diff(alone[i])).max().unwrap_or_default();
            if cubics.iter().all(|light| distance(light, place) > 0.5) {
                assert!(off as usize <= cubics.len(), "{found:?}, expected {alone:?} at {place:?}");
                (compared, most) = (compared + 1, most.max(off));
            }
        }
        lit += expected.chunks_exact(3).filter(|light| light.iter().any(|channel| *channel > 0)).count();
        count += expected.len() / 3;
    }
    println!("{lit} of {count} points are lit; {most} steps from the lights alone at {compared}");
    assert!(lit > count / 3 && compared > 200, "{lit} of {count}, {compared}");
    Ok(())
}

/// A light without a symmetry: a side or a front of the other sign changes it.
fn crooked() -> Result<AnyLight, luminaire::Error> {
    static SAMPLES: [u16; 9] = [65_535, 9, 30_000, 20_000, 50_000, 3, 0, 40_000, 60_000];
    let lamp = Distribution::from_parts(&SAMPLES, 3, Symmetry::None);
    let light = MeasuredLight::new([0.5, 1.0, 0.75], [0.2, -1.0, 0.1], [0.1, 0.2, 0.9], lamp)?;
    Ok(light.with_color(Rgb::new(0.5, 0.75, 1.0))?.with_intensity(2.0)?.into())
}

/// A light that is not round, which shines sideways and upwards, too.
fn street() -> Result<AnyLight, luminaire::Error> {
    static SAMPLES: [u16; 15] = [65_535, 3, 40_000, 0, 7, 9, 1, 40_000, 0, 7, 65_535, 3, 1, 3, 65_535];
    let lamp = Distribution::new(&SAMPLES, 5, Symmetry::Bilateral)?;
    let light = MeasuredLight::new([-0.5, 1.5, 0.25], [0.3, -1.0, 0.5], [0.9, 0.1, 0.1], lamp)?;
    Ok(light.with_color(Rgb::new(1.0, 0.75, 0.5))?.with_intensity(4.0)?.into())
}

/// A scene in floats is the sum of the lights of the kernel, bit for bit; each format of Rust compiles, and a build script.
#[test]
fn a_scene_is_the_sum_of_its_lights_in_every_language() -> Result<(), Failure> {
    let cone = Cone::soft(Angle::degrees(70.0))?;
    let spot = SpotLight::new([0.5, 2.0, 0.0], [0.1, -1.0, 0.2], cone)?.with_intensity(8.0)?;
    let spot = spot.with_color(Rgb::new(1.0, 0.5, 0.25))?;
    let sun = DirectionalLight::new([1.0, -2.0, 0.0])?.with_intensity(0.3)?;
    let lamp = PointLight::new([0.0, 1.0, 0.5])?.into();
    let room = Room::new(vec![spot.into(), sun.into(), lamp, street()?], 1);
    let folder = tempfile::tempdir()?;
    fs::write(folder.path().join("room.h"), room.text(Language::CFloat))?;
    let main = folder.path().join("main.c");
    let program = "#include <stdio.h>\n#include \"room.h\"\nint main(void) {
    const float first[3] = { -1.0f, 0.0f, 0.125f }, step[3] = { 0.03125f, 0.0f, 0.0f }, up[3] = { 0.0f, 1.0f, 0.0f };
    float lights[100][3], light[3];
    int i, k;
    for (i = 0; i < 100; ++i) { for (k = 0; k < 3; ++k) { lights[i][k] = 0.0f; } }
    room_row_add(lights, first, step, up, 100);
    room_light(light, first, up);
    for (k = 0; k < 3; ++k) { if (light[k] != lights[0][k]) { return 1; } }
    return fwrite(lights, 4, 300, stdout) != 300;\n}\n";
    fs::write(&main, program)?;
    let lights: Vec<_> = room.lights.iter().map(|light| light.compile::<f32>()).collect::<Result<_, _>>()?;
    let sum = |i: u16| {
        let point = Vec3::new(-1.0 + f32::from(i) * 0.03125, 0.0, 0.125);
        let lit = lights
            .iter()
            .map(|light| Rgb::lit(light.irradiance(point, Vec3::new(0.0, 1.0, 0.0)), light.color()));
        <[f32; 3]>::from(lit.fold(room.ambient[0].compile::<f32>(), |sum, light| sum + light))
            .map(f32::to_bits)
    };
    let expected: Vec<_> = (0..100).flat_map(sum).collect();
    for (compiler, standard) in [("cc", "c99"), ("c++", "c++11")] {
        let flags = format!("-std={standard} -O2 -ffp-contract=off");
        if let Some(found) = run(compiler, &flags, &main, &[]) {
            assert_eq!(found, expected, "{compiler}");
        }
    }

    const USE: &str = "pub fn lit(scene: &room::Scene, at: luminaire::Vec3<<FORMAT as luminaire::Scalar>::Length>,
        up: luminaire::Vec3<FORMAT>) -> luminaire::Rgb<<FORMAT as luminaire::Scalar>::Irradiance> { scene.light(at, up) }";
    for (language, format) in [
        (Language::RustFloat, "f32"),
        (Language::RustFixed32, "luminaire::Fx32"),
        (Language::RustFixed16, "luminaire::Fx16"),
    ] {
        let text = room.text(language) + &USE.replace("FORMAT", format);
        compile_rust(&text, "lib", &folder.path().join(language.name()))?;
    }
    let script = folder.path().join("script");
    compile_rust(&room.text(Language::RustBuild), "bin", &script)?;
    assert!(Command::new(&script).env("OUT_DIR", folder.path()).status()?.success());
    let lit = <[Light16; 3]>::from(room.ambient[0].compile::<Fx16>()).map(Light16::to_bits);
    let user = format!(
        "mod room {{ include!({:?}); }}\nfn main() {{\n    let dark = luminaire::Fx16::normal([0.0, -1.0, 0.0]);\n    \
         let light = room::SCENE.light(luminaire::Fx16::point([0.0, -3.0, 0.0]), dark);\n    \
         assert_eq!([light.red, light.green, light.blue].map(|light| light.to_bits()), {lit:?});\n}}\n",
        folder.path().join("room.rs")
    );
    // The compiler of the test has no `OUT_DIR`, by which the file names the others.
    let own = fs::read_to_string(folder.path().join("room.rs"))?;
    let out = format!("{:?}", folder.path().display().to_string());
    fs::write(folder.path().join("room.rs"), own.replace("env!(\"OUT_DIR\")", &out))?;
    let user_program = folder.path().join("user");
    compile_rust(&user, "bin", &user_program)?;
    assert!(Command::new(user_program).status()?.success());
    Ok(())
}

/// Lights of any names are members of one structure: names that become the same, keywords, the name of the scene and
/// that of the ambient light.
#[test]
fn lights_of_any_names_are_members_of_a_scene() -> Result<(), Failure> {
    let texts = [
        "Key 1", "key-1", "switch", "Class", "room", "ambient", "", "self", "loop", "scene", "spots", "sum",
        "row", "int",
    ];
    let cone = Cone::soft(Angle::degrees(40.0))?;
    let light: AnyLight = SpotLight::new([0.0, 3.0, 0.0], [0.0, -1.0, 0.0], cone)?.into();
    let folder = tempfile::tempdir()?;
    write_headers(folder.path());
    for language in Language::ALL.iter().copied().filter(|language| language.has_scenes()) {
        let names = names(texts, language);
        let lights = names.iter().map(|name| (name.as_str(), light));
        let (text, refused) = export_scene(&Scene { name: "room", ambient: &[] }, lights, language)?;
        assert!(refused.is_empty(), "{language}: {refused:?}");
        match language {
            Language::CFixed => {
                for member in [
                    "key_1_2;",
                    "switch_light;",
                    "class_light;",
                    "ambient;",
                    "luminaire_rgb ambient_2;",
                    "int_light;",
                ] {
                    assert!(text.contains(member), "expected {member} in {text}");
                }
                let main = folder.path().join("main.c");
                let user = "luminaire_rgb lit(const room_2_scene *s, const int32_t p[3], const int16_t n[3]);
luminaire_rgb lit(const room_2_scene *s, const int32_t p[3], const int16_t n[3]) {
    luminaire_rgb sum = room_2_light(s ? s : &room_2_start, p, n);
    luminaire_row row = { { 0, 0, 0 }, { 1, 1, 1 }, { 0, 0, 1 } };
    room_2_row_add(&sum, &row, s, 1);
    return sum;\n}\n";
                fs::write(folder.path().join("room.h"), &text)?;
                fs::write(&main, format!("#include \"room.h\"\n#include \"room.h\"\n{user}"))?;
                compile_in_integers(&main);
            }
            Language::RustBuild => compile_rust(&text, "bin", &folder.path().join("script"))?,
            Language::RustFloat | Language::RustFixed32 | Language::RustFixed16 => {
                assert!(text.contains("pub self_light: ") && text.contains("pub ambient_2: "), "{text}");
                compile_rust(&text, "lib", &folder.path().join("scene"))?;
            }
            _ => assert!(text.contains("room_2_light("), "{language}: {text}"),
        }
    }
    for (name, language, told) in [
        ("a b", Language::CFixed, "name = a b: expected"),
        ("switch", Language::CFixed, "name = switch: expected"),
        ("room", Language::RustProgram, "scene = room: expected none in rust-program"),
        ("room", Language::Json, "scene = room: expected none in json"),
    ] {
        let refused = export_scene(&Scene { name, ambient: &[] }, [("key", light)], language)
            .expect_err(told)
            .to_string();
        assert!(refused.starts_with(told), "{refused}: expected {told}");
    }
    Ok(())
}

/// The program of a page between a head and a fence.
fn program<'a>(page: &'a str, head: &str, language: &str) -> &'a str {
    let (_, rest) = page.split_once(head).expect("a section");
    let (_, rest) = rest.split_once(&format!("```{language}\n")).expect("a program");
    rest.split_once("```").expect("its end").0
}

/// The programs of the pages compile for a scene of eight lights, and the one in C has less than 6.5 kB on a Cortex-M0.
#[test]
fn programs_of_the_pages_draw_a_scene_of_eight_lights() -> Result<(), Failure> {
    const MOST: usize = 6_500;
    let spot = |position: [f32; 3], axis: [f32; 3], color: [f32; 3], cone: Cone<AnyFalloff>| {
        let spot = SpotLight::new(position, axis, cone)?.with_intensity(9.0)?;
        Ok::<AnyLight, luminaire::Error>(spot.with_color(color.into())?.into())
    };
    let soft = |field: f32| Cone::from_field(AnyFalloff::from(Soft), Angle::degrees(field));
    let fitted = |beam, field| {
        let cone = Cone::from_beam_and_field(Angle::degrees(beam), Angle::degrees(field))?;
        Ok::<_, luminaire::Error>(cone.with_falloff(cone.falloff().into()))
    };
    let lights = vec![
        spot([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], [1.0; 3], fitted(15.0, 26.0)?)?,
        spot([0.0, 4.0, -2.0], [0.0, -2.0, 1.0], [0.4, 0.6, 1.0], fitted(20.0, 34.0)?)?,
        spot([-2.0, 3.0, 1.0], [1.0, -2.0, 0.0], [1.0, 0.6, 0.2], soft(40.0)?)?,
        spot([2.0, 3.0, 1.0], [-1.0, -2.0, 0.0], [1.0, 0.3, 0.5], soft(40.0)?)?,
        spot([0.0, 5.0, 1.0], [0.0, -1.0, 0.0], [1.0; 3], soft(24.0)?)?,
        PointLight::new([-1.0, 2.0, 0.0])?.with_intensity(0.5)?.into(),
        DirectionalLight::new([1.0, -2.0, 0.0])?.with_intensity(0.05)?.into(),
    ];
    let mut room = Room::new(lights, 1);
    room.names = ["key", "back", "left", "right", "top", "lamp", "sun"].map(str::to_owned).into();
    let folder = tempfile::tempdir()?;
    write_headers(folder.path());
    fs::write(folder.path().join("room.h"), room.text(Language::CFixed))?;
    let main = folder.path().join("main.c");
    fs::write(&main, program(include_str!("../c/README.md"), "## A scene of another tool", "c"))?;
    for (compiler, flags) in
        [("cc", "-std=c99 -O1"), ("c++", "-std=c++11 -O1 -Wno-missing-field-initializers")]
    {
        compile(compiler, &format!("{flags} -c -Wconversion -Wshadow"), &main, &folder.path().join("main.o"));
    }
    let flags = "-std=c99 -Os -mcpu=cortex-m0 -mthumb -ffunction-sections -fdata-sections -Wl,--gc-sections -nostartfiles \
                 --specs=nosys.specs -Wl,-e,main";
    let elf = folder.path().join("main.elf");
    if compile("arm-none-eabi-gcc", flags, &main, &elf).is_some() {
        let told = Command::new("arm-none-eabi-size").arg(&elf).output()?.stdout;
        let bytes = String::from_utf8(told)?;
        let bytes = bytes.lines().nth(1).and_then(|line| line.split_whitespace().next()).expect("a size");
        println!("{bytes} bytes of code and constants, of eight lights on a Cortex-M0");
        assert!(bytes.parse::<usize>()? < MOST, "{bytes}");
    }
    fs::write(folder.path().join("room.rs"), room.text(Language::RustFixed16))?;
    let text = program(include_str!("../../docs/LIGHTS.md"), "a file for `include!`:", "rust");
    compile_rust(text, "lib", &folder.path().join("draw"))?;
    Ok(())
}
