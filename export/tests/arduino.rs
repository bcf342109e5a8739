//! The library for Arduino: its sketch draws what the kernel computes.

#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
#[allow(dead_code, reason = "this test runs its program itself")]
mod compiler;

use std::fs;
use std::process::Command;

use luminaire::{Angle, Cone, Fx16, Length, SpotLight, Vec3, falloff::Soft};
use luminaire_export::arduino;

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

fn key() -> SpotLight<Soft> {
    let cone = Cone::soft(Angle::degrees(40.0)).expect("a cone");
    let key = SpotLight::new([2.5, 1.0, 3.0], [0.0, 0.0, -1.0], cone).expect("a light");
    key.with_intensity(9.0).expect("a light")
}

/// Writes the library, and checks its properties.
fn library() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in arduino().expect("a library") {
        let file = folder.path().join(name);
        fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
        fs::write(file, text).expect("a folder");
    }
    let properties = fs::read_to_string(folder.path().join("library.properties")).expect("properties");
    assert!(properties.contains(concat!("version=", env!("CARGO_PKG_VERSION"), "\n")), "{properties}");
    let url = concat!("url=", env!("CARGO_PKG_REPOSITORY"), "\n");
    assert_eq!(properties.contains(url), url != "url=\n", "{properties}");
    folder
}

#[test]
fn the_sketch_draws_what_the_kernel_computes() {
    let build = tempfile::tempdir().expect("a folder");
    let library = library();
    let sketch = fs::read_to_string(library.path().join("examples/Wall/Wall.ino")).expect("a sketch");
    let program = build.path().join("wall");
    let main = build.path().join("wall.cpp");
    fs::write(&main, format!("{CORE}{sketch}int main() {{ setup(); loop(); return 0; }}\n"))
        .expect("a folder");
    let include = |path: &str| format!("-I{}", library.path().join(path).display());
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
