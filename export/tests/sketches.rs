//! The examples of the library for C: what they print on this machine, an AVR prints too.

#[path = "support/avr.rs"]
mod avr;
#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
mod compiler;

use std::cmp::Ordering::{Greater, Less};
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::Command;

use luminaire::{Angle, Cone, Fx16, Length, SpotLight, Vec3, falloff::Soft};
use luminaire_export::{Language, export};

use avr::{LIBRARY, emulate, printed, writes};
use compiler::{compile, is_missing};

const EXAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/c/examples");
const SKETCHES: [&str; 4] = ["Wall", "Spot", "Sprite", "Leds"];

/// The calls of a sketch's `loop`.
const FRAMES: u32 = 6;

/// What the sketches use of Arduino's core, which its builder puts before a sketch.
const CORE: &str = "#include <stdint.h>
#include <stdio.h>
struct Port {
    void begin(long) {}
    void print(char letter) { putchar(letter); }
    void println() { putchar('\\n'); }
    void println(int number) { printf(\"%d\\n\", number); }
    void println(const char *text) { puts(text); }
};
static Port Serial;
";

/// Arduino's core for AVR, of Debian's package `arduino-core-avr`, and the files of it that a sketch needs.
const AVR_CORE: &str = "/usr/share/arduino/hardware/arduino/avr";
const AVR_FILES: [&str; 5] =
    ["HardwareSerial.cpp", "HardwareSerial0.cpp", "Print.cpp", "wiring.c", "hooks.c"];

/// The options of the core's `platform.txt` for an Arduino Uno.
const UNO: &str = "-Os -mmcu=atmega328p -DF_CPU=16000000L -DARDUINO=10807 -DARDUINO_AVR_UNO \
    -DARDUINO_ARCH_AVR -ffunction-sections -fdata-sections -flto";
const CXX: &str = "-std=gnu++11 -fpermissive -fno-exceptions -fno-threadsafe-statics";

fn key() -> SpotLight<Soft> {
    let cone = Cone::soft(Angle::degrees(40.0)).expect("a cone");
    let key = SpotLight::new([2.5, 1.0, 3.0], [0.0, 0.0, -1.0], cone).expect("a light");
    key.with_intensity(9.0).expect("a light")
}

/// The normal map of the sprite's ball, as an image editor stores it.
fn ball() -> String {
    const SIZE: i32 = 16;
    let mut text = format!(
        "/* The normal map of a ball: red, green and blue of each pixel, as an image editor stores it. Green points\n\
         \x20* up, as in OpenGL, and black is outside the ball. */\n\
         #define BALL_SIZE {SIZE}\n\
         static const uint8_t ball[BALL_SIZE][3 * BALL_SIZE] LUMINAIRE_TABLE = {{\n"
    );
    for y in 0..SIZE {
        let row = (0..SIZE).flat_map(|x| {
            let [x, y] = [2 * x + 1 - SIZE, SIZE - 1 - 2 * y].map(|c| f64::from(c) / f64::from(SIZE));
            let rest = 1.0 - x * x - y * y;
            [x, y, rest.max(0.0).sqrt()].map(|c| if rest > 0.0 { 128.0 + (127.0 * c).round() } else { 0.0 })
        });
        text += &format!("    {{ {} }},\n", row.map(|c| c.to_string()).collect::<Vec<_>>().join(", "));
    }
    text + "};\n"
}

/// The files are those of the examples; `LUMINAIRE_BLESS=1` writes them.
#[test]
fn examples_have_the_light_and_the_normals_that_are_written() {
    let key = export(key(), "key", Language::CFixed).expect("a light");
    for (file, text) in [("Wall/key.h", key), ("Sprite/ball.h", ball())] {
        let path = Path::new(EXAMPLES).join(file);
        if std::env::var_os("LUMINAIRE_BLESS").is_some() {
            fs::write(&path, &text).expect("a file");
        }
        let found = fs::read_to_string(path).expect("a file");
        assert!(found == text, "{file}: expected another text: write it with LUMINAIRE_BLESS=1");
    }
}

fn sketch(name: &str) -> String {
    fs::read_to_string(format!("{EXAMPLES}/{name}/{name}.ino")).expect("a sketch")
}

/// What a sketch prints on this machine.
fn on_host(name: &str, folder: &Path) -> Option<Vec<String>> {
    let (main, program) = (folder.join("host.cpp"), folder.join(name));
    let frames =
        format!("int main() {{ setup(); for (int i = 0; i < {FRAMES}; ++i) {{ loop(); }} return 0; }}\n");
    fs::write(&main, format!("{CORE}{}{frames}", sketch(name))).expect("a folder");
    let options = format!("-std=c++11 -I{LIBRARY} -I{EXAMPLES}/{name}");
    let small = format!("{options} -Os -mcpu=cortex-m0 -mthumb -ffreestanding -c");
    compile("arm-none-eabi-g++", &small, &main, &folder.join("small.o"));
    compile("c++", &options, &main, &program)?;
    let found = Command::new(&program).output().expect("a program").stdout;
    Some(String::from_utf8(found).expect("text").lines().map(str::to_owned).collect())
}

/// Compiles files without linking them.
fn objects(options: &str, files: &[PathBuf], folder: &Path) {
    let mut compile = Command::new("avr-gcc");
    // Debian's avr-gcc does not define `DECIMAL_DIG` in C++, of which the core needs a value.
    compile.args(UNO.split_whitespace()).args(options.split_whitespace()).arg("-DDECIMAL_DIG=17").arg("-c");
    compile.args(["cores/arduino", "variants/standard"].map(|part| format!("-I{AVR_CORE}/{part}")));
    let output = compile.args(files).current_dir(folder).output().expect("avr-gcc");
    assert!(output.status.success(), "{files:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// What a sketch prints on an Arduino Uno; `None` without the tools. Its memory is printed.
fn on_avr(name: &str, folder: &Path) -> Option<Vec<String>> {
    if !Path::new(AVR_CORE).exists() {
        return is_missing("arduino-core-avr");
    }
    if Command::new("avr-gcc").arg("--version").output().is_err() {
        return is_missing("avr-gcc");
    }
    let [main, frame] = ["main.cpp", "frame.cpp"].map(|file| folder.join(file));
    fs::write(&main, format!("#include <Arduino.h>\n{}", sketch(name))).expect("a folder");
    fs::write(&frame, include_str!("avr/sketch.cpp")).expect("a folder");
    objects(&format!("{CXX} -Wall -Wextra -Werror -I{LIBRARY} -I{EXAMPLES}/{name}"), &[main], folder);
    let mut core: Vec<_> =
        AVR_FILES.iter().map(|file| PathBuf::from(format!("{AVR_CORE}/cores/arduino/{file}"))).collect();
    let c = core.split_off(3);
    core.push(frame);
    objects(&format!("-w {CXX} -DFRAMES={FRAMES}"), &core, folder);
    objects("-w -std=gnu11", &c, folder);
    let program = folder.join("sketch.elf");
    let mut link = Command::new("avr-gcc");
    link.args(UNO.split_whitespace()).args(["-fuse-linker-plugin", "-Wl,--gc-sections", "-o"]).arg(&program);
    link.args([
        "main.o",
        "frame.o",
        "HardwareSerial.o",
        "HardwareSerial0.o",
        "Print.o",
        "wiring.o",
        "hooks.o",
    ]);
    assert!(link.current_dir(folder).status().expect("avr-gcc").success());
    let sizes = Command::new("avr-size").arg(&program).output().expect("avr-size").stdout;
    let sizes = String::from_utf8(sizes).expect("text");
    let sizes: Vec<u32> =
        sizes.lines().nth(1)?.split_whitespace().map_while(|size| size.parse().ok()).collect();
    let mut lines = emulate("atmega328p", &program)?;
    let unused: u32 = lines.pop()?.parse().expect("a number");
    let [flash, variables] = [sizes[0] + sizes[1], sizes[1] + sizes[2]];
    println!("{name}: {flash} bytes of flash, {variables} of RAM and {} of stack", 2048 - variables - unused);
    // As the README says.
    assert!(unused >= 200 && (7_500..22_500).contains(&flash), "{name}: {unused} bytes of RAM left");
    Some(lines)
}

/// Returns what a sketch prints, which an AVR prints too.
fn print(name: &str) -> Vec<String> {
    let folder = tempfile::tempdir().expect("a folder");
    let host = on_host(name, folder.path()).unwrap_or_default();
    if let Some(avr) = on_avr(name, folder.path()) {
        assert_eq!(avr, host, "{name}");
    }
    host
}

#[test]
fn the_wall_is_what_the_kernel_computes() {
    let found = print(SKETCHES[0]);
    let light = key().compile::<Fx16>().expect("a light");
    let normal = Fx16::normal([0.0, 0.0, 1.0]);
    let level = |column: i32, row: i32| {
        let point = Vec3::new(column * (65_536 / 12), row * (65_536 / 8), 0).map(Length::from_bits);
        ((light.irradiance(point, normal).to_bits() * 9) >> 14).min(9) as usize
    };
    let row = |row| (0..60).map(|column| char::from(b" .:-=+*#%@"[level(column, row)])).collect::<String>();
    let expected: Vec<_> = (0..16).map(row).collect();
    assert!(expected.iter().any(|row| row.contains('%')) && expected[0].contains(' '), "{expected:?}");
    if !found.is_empty() {
        assert_eq!(found, expected);
    }
}

#[test]
fn the_light_of_the_spot_moves() {
    let found = print(SKETCHES[1]);
    // A line of the set-up, then twelve rows and an empty line for each frame.
    let frames: Vec<_> = found.get(1..).unwrap_or_default().chunks(13).collect();
    assert!(frames.windows(2).all(|pair| pair[0] != pair[1]), "{found:?}");
    assert!(frames.iter().all(|frame| frame.concat().contains('@') && frame.concat().contains(' ')));
}

#[test]
fn the_light_of_the_sprite_comes_from_the_left_and_then_from_the_right() {
    let found = print(SKETCHES[2]);
    let bright = |frame: &[String], columns: Range<usize>| -> usize {
        frame.iter().map(|row| row[columns.clone()].matches('#').count()).sum()
    };
    let sides: Vec<_> = found
        .get(1..)
        .unwrap_or_default()
        .chunks(16)
        .map(|frame| bright(frame, 0..16).cmp(&bright(frame, 16..32)))
        .collect();
    // The frame after the fifth is the first again.
    assert!(matches!(sides[..], [] | [Greater, Greater, _, Less, Less, Greater]), "{sides:?}");
    // The light is above the ball, of which the map's green says what faces up.
    for frame in found.get(1..).unwrap_or_default().chunks(16) {
        let [upper, lower] = [&frame[..8], &frame[8..]].map(|half| bright(half, 0..32));
        assert!(upper > 2 * lower, "{frame:#?}");
    }
}

#[test]
fn the_leds_keep_the_limit_of_their_current() {
    let found = print(SKETCHES[3]);
    let milliamperes = |frame: &[String]| -> f64 {
        let text = frame.concat();
        let bytes = (0..768).map(|i| u8::from_str_radix(&text[2 * i..2 * i + 2], 16).expect("a byte"));
        256.0 + bytes.map(|byte| f64::from(byte) * 12.0 / 255.0).sum::<f64>()
    };
    let currents: Vec<_> = found.get(1..).unwrap_or_default().chunks(32).map(milliamperes).collect();
    assert!(currents.iter().all(|current| *current <= 2000.0), "{currents:?}");
    assert!(currents.is_empty() || currents.iter().any(|current| *current > 1940.0), "{currents:?}");
}

/// Integers of 16 bits, and conversions between them and larger ones, hide in other tests.
#[test]
fn an_avr_compiles_all_headers_without_warnings() {
    let folder = tempfile::tempdir().expect("a folder");
    let main = folder.path().join("main.c");
    let text = "#include \"luminaire_constant.h\"\n#include \"luminaire_display.h\"\n#include \"key.h\"\n";
    fs::write(&main, text).expect("a folder");
    for (compiler, standard) in [("avr-gcc", "gnu99"), ("avr-g++", "gnu++11")] {
        let flags = format!(
            "-std={standard} -Os -mmcu=atmega328p -c -Wconversion -Wshadow -Wundef -I{LIBRARY} -I{EXAMPLES}/Wall"
        );
        compile(compiler, &flags, &main, &folder.path().join("main.o"));
    }
}

/// Where an `int` has 16 bits, every function returns what it returns here.
#[test]
fn an_avr_returns_what_this_machine_does() {
    let folder = tempfile::tempdir().expect("a folder");
    let (main, program) = (folder.path().join("calls.c"), folder.path().join("calls"));
    fs::write(&main, include_str!("calls.c")).expect("a folder");
    if compile("cc", &format!("-std=c99 -I{LIBRARY}"), &main, &program).is_none() {
        return;
    }
    let output = Command::new(&program).output().expect("a program");
    assert!(output.status.success() && output.stdout.len() > 10_000);
    writes(&main, &[], &output.stdout);
}

#[test]
fn the_program_of_the_readme_compiles() {
    let (_, rest) = include_str!("../c/README.md").split_once("```c\n").expect("a program");
    let (program, _) = rest.split_once("```").expect("its end");
    let folder = tempfile::tempdir().expect("a folder");
    let main = folder.path().join("main.c");
    fs::write(&main, program).expect("a folder");
    for (compiler, options) in
        [("cc", "-std=c99 -O1"), ("c++", "-std=c++11 -O1"), ("avr-gcc", "-std=gnu99 -Os -mmcu=atmega328p")]
    {
        let flags = format!("{options} -c -Wconversion -Wshadow -Wundef -I{LIBRARY}");
        compile(compiler, &flags, &main, &folder.path().join("main.o"));
    }
}

#[test]
fn an_avr_counts_its_cycles() {
    let folder = tempfile::tempdir().expect("a folder");
    let main = folder.path().join("cycles.c");
    fs::write(&main, include_str!("avr/cycles.c")).expect("a folder");
    let Some(lines) = printed(&format!("-DPRINT -I{EXAMPLES}/Wall"), &main, &[]) else { return };
    println!("cycles of an AVR\n{}", lines.join("\n"));
    let [counts @ .., sums] = &lines[..] else { panic!("{lines:?}") };
    assert!(counts.len() == 11 && sums.starts_with("00000000 "), "{lines:?}");
    let readme = include_str!("../c/README.md");
    for (call, cycles) in counts.iter().filter_map(|line| line.split_once(": ")) {
        assert!(readme.contains(&format!("| {call} | {cycles} |\n")), "not in the README: {call}, {cycles}");
    }
}
