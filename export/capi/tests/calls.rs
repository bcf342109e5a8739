//! A program in C99, and the same in C++11, gets what the kernel computes.

use std::env;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use luminaire::{
    Angle, Cone, Error, Fx16, Length, Rgb, SpotLight, Vec3,
    display::{Rgb565, clip, encode_srgb},
    falloff::{Falloff, Hard, Soft},
    light::CompiledSpotLight,
    number::Light16,
};

type Light = CompiledSpotLight<Fx16, Soft>;

/// The numbers of `calls.c`.
struct Random(u32);

impl Random {
    fn bits(&mut self) -> i32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 1).cast_signed() - (1 << 30)
    }

    fn point(&mut self) -> Vec3<Length> {
        let [x, y, z] = [(); 3].map(|()| Length::from_bits(self.bits() >> 12));
        Vec3::new(x, y, z)
    }
}

const UP: Vec3<Fx16> = Vec3::new(Fx16::ZERO, Fx16::ONE, Fx16::ZERO);

fn compiled<P: Falloff>(cone: Result<Cone<P>, Error>) -> Result<CompiledSpotLight<Fx16, P>, Error> {
    SpotLight::new([0.0, 3.0, 0.0], [0.0, -1.0, 0.0], cone?)?
        .with_intensity(9.0)?
        .with_color(Rgb::new(1.0, 0.75, 0.5))?
        .compile()
}

fn spot(field: f32) -> Result<Light, Error> {
    compiled(Cone::soft(Angle::degrees(field)))
}

/// The line that `calls.c` prints of a light with the angles of a data sheet, and of the light zoomed and
/// moved.
fn line<P: Falloff>(cone: Result<Cone<P>, Error>, wide: &Light, part: Fx16, random: &mut Random) -> String {
    let light = compiled(cone).expect("a light");
    let (point, target) = (random.point(), random.point());
    let shifted = |c: Length, by: u32| Length::from_bits(c.to_bits() >> by);
    let point = Vec3::new(shifted(point.x, 2), point.y, shifted(point.z, 2));
    let beside = Vec3 { x: Length::from_bits(target.x.to_bits() + shifted(point.x, 1).to_bits()), ..target };
    let zoomed = light.zoomed(&wide.with_falloff(light.falloff()), part).moved_to(random.point());
    let moved = zoomed.aimed_at(target).expect("another point");
    let bits = |light: &CompiledSpotLight<Fx16, P>, point| {
        (light.irradiance(point, UP).to_bits(), light.falloff_at(point).to_bits())
    };
    let ((irradiance, falloff), (others, other)) = (bits(&light, point), bits(&moved, beside));
    format!("{irradiance} {falloff} {other} {others}\n")
}

/// What `calls.c` prints, computed by the kernel.
fn expected() -> String {
    let part = |bits: i32| Fx16::from_bits(bits as i16);
    let (narrow, wide) = (spot(30.0).expect("a light"), spot(70.0).expect("a light"));
    let message = spot(400.0).expect_err("too wide").to_string();
    let mut text = format!("{}\n{}\n", cut(&message, 95), cut(&message, 11));
    let both = |beam, field| Cone::from_beam_and_field(Angle::degrees(beam), Angle::degrees(field));
    let refused = both(30.0, 20.0).expect_err("less than the beam angle").to_string();
    let none = spot(0.0).expect_err("no angle").to_string();
    let _ = writeln!(text, "{}\n{}", cut(&refused, 95), cut(&none, 95));
    let mut random = Random(1);
    let mut changed = narrow;
    for i in 0..1000 {
        let (point, target) = (random.point(), random.point());
        let zoomed = narrow.zoomed(&wide, part(i << 4)).moved_to(random.point());
        let aimed = zoomed.aimed_at(target).expect("another point").dimmed(part((i * 7) & 0x3fff));
        changed = aimed.with_color(Rgb::new(part(1 << 14), part(1 << 13), part(i * 5)));
        let lit = |light: &Light, point| Rgb::lit(light.irradiance(point, UP), light.color());
        let sum = lit(&changed, target).plus::<Fx16>(lit(&wide, point));
        let light = sum.filtered::<Fx16>(Rgb::new(part(1 << 13), part(1 << 14), part(1 << 12)));
        let shown = clip::<Fx16>(light);
        let codes = shown.map(|channel| u32::from(encode_srgb(channel)));
        let _ = writeln!(
            text,
            "{} {} {} {} {} {} {} {} {}",
            narrow.irradiance(point, UP).to_bits(),
            wide.falloff_at(point).to_bits(),
            u8::from(narrow.can_reach(point, Length::from_bits(1 << 14))),
            light.red.to_bits(),
            light.green.to_bits(),
            light.blue.to_bits(),
            Rgb565::from_linear(shown).0,
            Rgb565::from_linear_dithered(shown, i.cast_unsigned(), 3).0,
            codes.red << 16 | codes.green << 8 | codes.blue
        );
    }
    for i in 0..1000 {
        let part = part(i << 3);
        let beam = Angle::degrees(24.0);
        text += &match i % 5 {
            0 => line(Cone::from_beam(Hard, beam), &wide, part, &mut random),
            1 => line(Cone::from_beam(Soft, beam), &wide, part, &mut random),
            2 => line(both(22.0, 40.0), &wide, part, &mut random),
            3 => line(both(28.0, 30.0), &wide, part, &mut random),
            _ => line(both(12.0, 26.0), &wide, part, &mut random),
        };
    }
    let aimed = changed.aimed_along(Vec3::new(1, -9, 0).map(Length::from_bits)).expect("not zero");
    for i in 0..64 {
        let point = Vec3::new(i * (1 << 12) - (2 << 16), 0, 0).map(Length::from_bits);
        let mut sum = Rgb::<Light16>::default();
        for light in [narrow, aimed] {
            sum = sum.plus::<Fx16>(Rgb::lit(light.irradiance(point, UP), light.color()));
        }
        let pixel = Rgb565::from_linear_dithered(clip::<Fx16>(sum), i.cast_unsigned(), 5).0.swap_bytes();
        let is_dark = sum == Rgb::default();
        let _ = writeln!(text, "{} {}", sum.green.to_bits(), if is_dark { 0 } else { pixel });
    }
    text
}

/// The first bytes of a text.
fn cut(text: &str, bytes: usize) -> &str {
    text.get(..bytes).unwrap_or(text)
}

/// The static library. Cargo writes it beside the test.
fn library() -> PathBuf {
    let test = env::current_exe().expect("a program");
    let folder = test.parent().expect("a folder").read_dir().expect("a folder");
    let files = folder.map(|entry| entry.expect("a file").path());
    let is_library = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("libluminaire_c-") && name.ends_with(".a")
    };
    let age = |path: &PathBuf| path.metadata().and_then(|data| data.modified()).expect("a time");
    files.filter(is_library).max_by_key(age).expect("a static library")
}

/// Compiles a program of C and runs it; `None` without the compiler, unless the environment says that
/// it must be installed.
fn printed(compiler: &str, options: &str, source: &Path, folder: &Path) -> Option<String> {
    let include = Path::new(env!("CARGO_MANIFEST_DIR")).join("include");
    let program = folder.join(compiler);
    let mut build = Command::new(compiler);
    build.args(["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1", "-I"]).arg(include);
    build.args(options.split(' ')).arg(source).args(["-x", "none"]).arg(library());
    build.args(["-lm", "-lpthread", "-ldl", "-o"]).arg(&program);
    let built = match build.output() {
        Err(_) if env::var_os("LUMINAIRE_TOOLS").is_none() => return None,
        built => built.expect("a compiler"),
    };
    assert!(built.status.success(), "{compiler}: {}", String::from_utf8_lossy(&built.stderr));
    let found = Command::new(program).output().expect("a program");
    assert!(found.status.success(), "{compiler}: {:?}", found.status);
    Some(String::from_utf8(found.stdout).expect("text"))
}

/// In C with sanitizers: they see what the library does to the program's memory at its borders.
const C99: (&str, &str) = ("cc", "-std=c99 -fsanitize=address,undefined -fno-sanitize-recover=all -x c");
const CPP11: (&str, &str) = ("c++", "-std=c++11 -x c++");

#[test]
fn c_and_cpp_have_the_bits_of_the_kernel() {
    let folder = tempfile::tempdir().expect("a folder");
    let expected = expected();
    assert!(expected.lines().filter(|line| !line.starts_with("0 0 ")).count() > 500, "{expected}");
    let calls = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/calls.c");
    for (compiler, options) in [C99, CPP11] {
        let Some(found) = printed(compiler, options, &calls, folder.path()) else { continue };
        for (found, expected) in found.lines().zip(expected.lines()) {
            assert_eq!(found, expected, "{compiler}");
        }
        assert_eq!(found.lines().count(), expected.lines().count());
    }
}

#[test]
fn program_of_the_readme_prints_a_pixel() {
    let (_, rest) = include_str!("../README.md").split_once("```c\n").expect("a program");
    let (program, _) = rest.split_once("```").expect("an end");
    let folder = tempfile::tempdir().expect("a folder");
    let source = folder.path().join("readme.c");
    std::fs::write(&source, program).expect("a folder");
    for (compiler, options) in [C99, CPP11] {
        let Some(found) = printed(compiler, options, &source, folder.path()) else { continue };
        // Half of full scale, where the beam angle ends.
        assert_eq!(found, format!("pixel {:04x}\n", Rgb565::from_linear(Rgb::new(0.5, 0.4, 0.3)).0));
    }
}
