//! The library for Arduino: its files are what the crate writes, and its sketch draws what the kernel
//! computes.

#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
#[allow(dead_code, reason = "this test runs its program itself")]
mod compiler;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use luminaire::{Angle, Cone, Fx16, Length, SpotLight, Vec3, falloff::Soft};
use luminaire_export::{Language, c_header, export};

use compiler::compile;

/// What a sketch uses of Arduino's core, which its builder puts before a sketch.
const CORE: &str = "#include <stdint.h>
extern \"C\" int putchar(int letter);
struct Port {
    void begin(long) {}
    void print(char letter) { putchar(letter); }
    void println() { putchar('\\n'); }
};
static Port Serial;
";

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("arduino")
}

fn key() -> SpotLight<Soft> {
    let cone = Cone::soft(Angle::degrees(40.0)).expect("a cone");
    let key = SpotLight::new([2.5, 1.0, 3.0], [0.0, 0.0, -1.0], cone).expect("a light");
    key.with_intensity(9.0).expect("a light")
}

#[test]
fn files_are_what_the_crate_writes() {
    let light = export(key(), "key", Language::CFixed).expect("a light");
    for (file, text) in [("src/luminaire_fx16.h", c_header().to_owned()), ("examples/Wall/key.h", light)] {
        let file = folder().join(file);
        if env::var_os("LUMINAIRE_BLESS").is_some() {
            fs::write(&file, &text).expect("a file");
        }
        let found = fs::read_to_string(&file).unwrap_or_default();
        assert!(found == text, "{}: run the test with LUMINAIRE_BLESS=1", file.display());
    }
    let properties = fs::read_to_string(folder().join("library.properties")).expect("properties");
    assert!(properties.contains(concat!("version=", env!("CARGO_PKG_VERSION"), "\n")), "{properties}");
}

#[test]
fn the_sketch_draws_what_the_kernel_computes() {
    let build = tempfile::tempdir().expect("a folder");
    let sketch = fs::read_to_string(folder().join("examples/Wall/Wall.ino")).expect("a sketch");
    let program = build.path().join("wall");
    let main = build.path().join("wall.cpp");
    fs::write(&main, format!("{CORE}{sketch}int main() {{ setup(); loop(); return 0; }}\n"))
        .expect("a folder");
    let include = |path: &str| format!("-I{}", folder().join(path).display());
    let options = ["-std=c++11", &include("src"), &include("examples/Wall")].join(" ");
    let small = format!("{options} -Os -mcpu=cortex-m0 -mthumb -ffreestanding -c");
    compile("arm-none-eabi-g++", &small, &main, &build.path().join("wall.o"));
    if compile("c++", &options, &main, &program).is_none() {
        return;
    }
    let found = Command::new(&program).output().expect("a program").stdout;
    let found = String::from_utf8(found).expect("text");
    let light = key().compile::<Fx16>().expect("a light");
    let normal = Fx16::normal([0.0, 0.0, 1.0]);
    let level = |column: i32, row: i32| {
        let point = Vec3::new(column * (65_536 / 12), row * (65_536 / 8), 0).map(Length::from_bits);
        ((light.irradiance(point, normal).to_bits() * 9) >> 14).min(9) as usize
    };
    let row = |row| (0..60).map(|column| char::from(b" .:-=+*#%@"[level(column, row)])).collect::<String>();
    let expected: Vec<_> = (0..16).map(row).collect();
    assert!(expected.iter().any(|row| row.contains('%')) && expected[0].contains(' '), "{expected:?}");
    assert_eq!(found.lines().collect::<Vec<_>>(), expected);
}
