//! The sketch of `luminaire leds` sends what the library in Rust writes for the same lights and places.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use luminaire::display::{self, Apa102, Hd108, LedChip, LedLoad, LedOrder, LedStrip, Rgbw};
use luminaire::dynamic::{AnyLight, CompiledAnyLight};
use luminaire::{Fx16, Length, Rgb, Vec3};
use luminaire_export::json;

const LIBRARY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../export/c/src");

/// Two spotlights, a point light, one that is not round, a sun and ambient light, which all lights of the tree have together.
const SCENE: &str = r#"{ "format": "luminaire-lights-1", "lights": [
    { "name": "Key", "position": [2, 3, 0], "axis": [-2, -2, 0], "cone": { "outer_degrees": 40 }, "intensity": 12,
      "color": [1, 0.5, 0] },
    { "name": "Rim", "position": [-2, 1, 1], "axis": [2, 0, -1], "cone": { "outer_degrees": 70 }, "intensity": 6,
      "color": [0, 0.25, 1] },
    { "name": "Star", "kind": "point", "position": [0, 2.25, 0], "intensity": 0.5 },
    { "name": "Wash", "kind": "measured", "position": [1.5, 2, 1], "axis": [-1, -1, -0.5], "side": [0, 0.5, -1], "intensity": 3,
      "distribution": { "size": 3, "symmetry": "bilateral", "samples": [65535, 50000, 0, 30000, 0, 30000] } },
    { "name": "Moon", "kind": "directional", "axis": [0.25, -1, 0.125], "intensity": 0.125 },
    { "name": "Night", "kind": "ambient", "intensity": 0.01 } ] }"#;

/// What a sketch uses of Arduino and of Adafruit NeoPixel, as they declare it: the bytes go to the standard output.
const ARDUINO: &str = r#"#ifndef ARDUINO_H
#define ARDUINO_H
#include <stdint.h>
#include <stdio.h>
static unsigned long now;
static inline unsigned long millis() { return now; }
#define NEO_GRB 0x52
#define NEO_RGB 0x06
#define NEO_BGR 0xa4
#define NEO_GRBW 0xd2
#define NEO_KHZ800 0
class Adafruit_NeoPixel {
    uint8_t bytes[20000];
    uint32_t count;
public:
    Adafruit_NeoPixel(uint16_t n, int16_t = 6, uint16_t type = NEO_GRB + NEO_KHZ800)
        : count(n * (type == NEO_GRBW ? 4u : 3u)) {}
    bool begin() { return true; }
    uint8_t *getPixels() { return bytes; }
    void show() { fwrite(bytes, 1, count, stdout); }
};
#define MSBFIRST 1
#define SPI_MODE0 0
#define SPI_MODE3 3
struct SPISettings { SPISettings(uint32_t, uint8_t, uint8_t) {} };
struct SPIClass {
    void begin() {}
    void beginTransaction(SPISettings) {}
    uint8_t transfer(uint8_t value) { return putchar(value), 0; }
    void endTransaction() {}
};
extern SPIClass SPI;
#endif
"#;

/// The moments of the frames: at the start, a little later, and after a quarter of a turn of 16 seconds.
const MOMENTS: [u32; 4] = [0, 0, 0, 4_000];

fn luminaire(words: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_luminaire")).args(words.split(' ')).output().expect("the program runs")
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{}-{name}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// A spiral of 100 LEDs around a cone whose axis is z, and one at its top.
fn tree() -> Vec<[f64; 3]> {
    let spiral = (0..100).map(|i| {
        let (turn, height) = (2.4 * f64::from(i), f64::from(i) / 50.0);
        let radius = 0.7 * (1.0 - height / 2.0);
        [radius * turn.cos(), radius * turn.sin(), height]
    });
    spiral.chain([[0.0, 0.0, 2.0]]).collect()
}

/// Compiles the sketch of a folder and returns the bytes that it sends in each frame.
fn sent(folder: &Path, sketch: &str) -> Vec<u8> {
    let main = folder.join("main.cpp");
    let frames: String = MOMENTS.iter().fold(String::new(), |mut text, moment| {
        let _ = write!(text, " now = {moment}; loop();");
        text
    });
    let text = format!(
        "#include \"Arduino.h\"\nSPIClass SPI;\n#include \"{sketch}\"\nint main() {{ setup();{frames} }}\n"
    );
    fs::write(&main, text).expect("a file");
    for header in ["Arduino.h", "SPI.h", "Adafruit_NeoPixel.h"] {
        fs::write(folder.join(header), ARDUINO).expect("a file");
    }
    let program = folder.join("program");
    let flags = [
        "-std=c++11",
        "-O1",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-fsanitize=undefined",
        "-fno-sanitize-recover=all",
    ];
    let library = format!("-I{LIBRARY}");
    let mut compiler = Command::new("c++");
    compiler.args(flags).args([&library, "-I."]).arg("-o").arg(&program).arg(&main);
    let output = compiler.current_dir(folder).output().expect("a compiler of C++");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(&program).output().expect("the program runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

/// Where an LED is, and the way it faces.
type Place = (Vec3<Length>, Vec3<Fx16>);

/// The places of the tree in steps of 2^-16 and the ways its LEDs face, with y upwards, and its middle.
fn placed() -> (Vec<Place>, [f64; 2]) {
    let upright: Vec<_> = tree().into_iter().map(|[x, y, z]| [x, z, -y]).collect();
    let middle = [0, 2].map(|axis| {
        let all = || upright.iter().map(|place| place[axis]);
        (all().fold(f64::INFINITY, f64::min) + all().fold(f64::NEG_INFINITY, f64::max)) / 2.0
    });
    let place = |&[x, y, z]: &[f64; 3]| {
        let (a, b) = (x - middle[0], z - middle[1]);
        let outward = [a / a.hypot(b), 0.0, b / a.hypot(b)];
        let steps = |value: f64, one: f64| (value * one).round() as i32;
        let [a, b, c] = outward.map(|c| Fx16::from_bits(steps(c, 16_384.0) as i16));
        (Vec3::new(x, y, z).map(|c| Length::from_bits(steps(c, 65_536.0))), Vec3::new(a, b, c))
    };
    (upright.iter().map(place).collect(), middle)
}

/// The lights as they are described, and after a quarter of a turn about the middle: the first and the third to one
/// side, the second to the other.
fn lights(middle: [f64; 2]) -> [(Vec<CompiledAnyLight<Fx16>>, Rgb<luminaire::number::Light16>); 2] {
    let read = json::read(SCENE).expect("lights");
    let ambient = read.ambient[0].light.compile::<Fx16>();
    let turned = |number: usize, [x, y, z]: [f32; 3], middle: [f64; 2]| {
        let side = if number.is_multiple_of(2) { 1.0 } else { -1.0 };
        let [a, b] = [f64::from(x) - middle[0], f64::from(z) - middle[1]];
        [(middle[0] - side * b) as f32, y, (middle[1] + side * a) as f32]
    };
    let quarter = |(number, light): (usize, &AnyLight)| match *light {
        AnyLight::Spot(spot) => {
            let position = turned(number, spot.position().into(), middle);
            let axis = turned(number, spot.axis().into(), [0.0; 2]);
            let own = luminaire::SpotLight::new(position, axis, spot.cone()).expect("a light");
            let own =
                own.with_attenuation(spot.attenuation()).with_intensity(spot.intensity()).expect("a light");
            own.with_color(spot.color()).expect("a light").into()
        }
        AnyLight::Measured(light) => {
            let position = turned(number, light.position().into(), middle);
            let [side, _, axis] = light.frame().map(|axis| turned(number, axis.into(), [0.0; 2]));
            let own = luminaire::MeasuredLight::new(position, axis, side, light.distribution());
            let own = own.expect("a light").with_intensity(light.intensity()).expect("a light");
            own.with_attenuation(light.attenuation()).into()
        }
        AnyLight::Point(point) => {
            let own =
                luminaire::PointLight::new(turned(number, point.position().into(), middle)).expect("a light");
            own.with_intensity(point.intensity())
                .expect("a light")
                .with_color(point.color())
                .expect("a light")
                .into()
        }
        other => other,
    };
    let lights: Vec<_> = read.lights.iter().map(|named| named.light).collect();
    let moved: Vec<_> = lights.iter().enumerate().map(quarter).collect();
    [lights, moved]
        .map(|lights| (lights.iter().map(|light| light.compile().expect("a light")).collect(), ambient))
}

/// What a strip in Rust writes for the frames.
fn expected<C: LedChip>(chip: C, keeps: bool) -> Vec<Vec<u8>> {
    let strip = LedStrip::new(chip).with_limit(1_500, 12, 1).with_brightness(0.5_f32);
    let (leds, middle) = placed();
    let [still, turned] = lights(middle);
    let mut load = LedLoad::default();
    let mut dithers: Vec<_> = (0..leds.len()).map(|led| C::dither(led as u16)).collect();
    let frame = |number: usize| {
        let (lights, ambient) = if number < 3 { &still } else { &turned };
        let mut frame = strip.frame(leds.len(), &mut load);
        let mut bytes = vec![0; leds.len() * C::BYTES];
        for ((led, (place, facing)), bytes) in leds.iter().enumerate().zip(bytes.chunks_exact_mut(C::BYTES)) {
            let lit = lights.iter().map(|light| Rgb::lit(light.irradiance(*place, *facing), light.color()));
            if !keeps {
                dithers[led] = C::dither((led + number) as u16);
            }
            frame.write(
                display::clip(lit.fold(*ambient, |sum, light| sum + light)),
                &mut dithers[led],
                bytes,
            );
        }
        bytes
    };
    (0..MOMENTS.len()).map(frame).collect()
}

/// Each family, from a table of places to the bytes on the wire. The limit of the current counts in each.
#[test]
fn a_sketch_sends_the_bytes_of_the_library() {
    let folder = folder("leds");
    let (map, scene) = (folder.join("tree.csv"), folder.join("scene.json"));
    let lines: String = tree().iter().map(|[x, y, z]| format!("{x},{y},{z}\n")).collect();
    fs::write(&map, lines).expect("a file");
    fs::write(&scene, SCENE).expect("a file");
    let count = tree().len();
    let ends: &dyn Fn(usize, u8, usize) -> [Vec<u8>; 2] =
        &|begin, last, end| [vec![0; begin], vec![last; end]];
    for (chip, frames, [begin, end]) in [
        ("ws2812", expected(LedOrder::Grb, false), ends(0, 0, 0)),
        ("sk6812-rgbw", expected(Rgbw(LedOrder::Grb), false), ends(0, 0, 0)),
        ("apa102", expected(Apa102(LedOrder::Bgr), true), ends(4, 0, 4 + count.div_ceil(16))),
        ("hd108", expected(Hd108(LedOrder::Grb), false), ends(16, 0xff, count.div_ceil(8))),
    ] {
        let own = folder.join(chip);
        let [map, scene, own_path] = [&map, &scene, &own].map(|path| path.display());
        let output = luminaire(&format!(
            "leds --map {map} {scene} --output {own_path} --chip {chip} --limit 1500 --channel 12 --brightness 0.5 --turn 16"
        ));
        let told = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && told.contains("lights reach 101 at first"), "{told}");
        let found = sent(&own, &format!("{chip}.ino"));
        let length = begin.len() + frames[0].len() + end.len();
        assert_eq!(found.len(), MOMENTS.len() * length, "{chip}");
        for (number, (found, expected)) in found.chunks_exact(length).zip(&frames).enumerate() {
            let (found_begin, rest) = found.split_at(begin.len());
            let (found, found_end) = rest.split_at(expected.len());
            assert_eq!((found_begin, found_end), (&begin[..], &end[..]), "{chip}");
            if number < 3 {
                assert_eq!(found, expected, "{chip}, frame {number}");
            } else if chip == "ws2812" {
                // The axis of a light that turned is rounded once more.
                let most =
                    found.iter().zip(expected).map(|(found, expected)| found.abs_diff(*expected)).max();
                assert!(most <= Some(1), "{most:?}");
                assert_ne!(found, &frames[2][..], "the lights turn");
            }
        }
        assert!(frames[0].iter().filter(|byte| **byte > 8).count() > count, "{chip}: too few are lit");
    }
}

/// What cannot be lit is refused before anything is written.
#[test]
fn refusals_name_the_option_and_the_remedy() {
    let folder = folder("refused");
    let file = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).expect("a file");
        path.display().to_string()
    };
    let (map, far, flat) =
        (file("a.csv", "0,0,1\n0,0,2"), file("far.csv", "0,0,40000"), file("flat.csv", "0,1,2\n1,1,2"));
    let zoom = concat!(env!("CARGO_MANIFEST_DIR"), "/../exchange/tests/files/fixture.gdtf");
    let output = folder.join("tree");
    for (words, error) in [
        (
            format!("--map {far}"),
            "LED 0: place = [0.0, 40000.0, 0.0]: expected coordinates up to 16383: scale",
        ),
        (
            format!("--map {flat} --height 2"),
            "height = 2: expected a height over 0, and LEDs at more than one: --up",
        ),
        (format!("--map {map} --brightness 2"), "brightness = 2: expected a share from 0 to 1"),
        (format!("--map {map} {zoom}"), "lights = 6: expected one end of a zoom: choose it by --light"),
        (format!("--map {map} --limit 2"), "limit = 2: expected more than 2 mA, which 2 dark LEDs take"),
        (format!("--map {map} --limit 9 --channel 0"), "0 is not in 1..=65535"),
        ("--map none.csv".to_owned(), "map = none.csv: expected a file of text that can be read"),
    ] {
        let told = luminaire(&format!("leds {words} --output {}", output.display()));
        let told = String::from_utf8_lossy(&told.stderr).into_owned();
        assert!(told.contains(error) && !output.exists(), "{words}: {told}");
    }
    let told = luminaire(&format!("leds --map {map} --output {}/ä", folder.display()));
    assert!(
        String::from_utf8_lossy(&told.stderr).contains("a folder whose name is that of a sketch"),
        "{told:?}"
    );
}

/// A sketch that was changed, as for another pin, is not written over; the same one is written again, and a light that
/// the language lacks does not stop the others.
#[test]
fn a_changed_sketch_stays() {
    let folder = folder("again");
    let file = |name: &str| folder.join(name);
    fs::write(file("map.csv"), "1,0,1\n0,1,2").expect("a file");
    let far = SCENE.replace("[-2, 1, 1]", "[-20000, 1, 1]");
    fs::write(file("scene.json"), far).expect("a file");
    let sketch = file("tree").join("tree.ino");
    let write = || {
        let [map, scene, tree] =
            ["map.csv", "scene.json", "tree"].map(|name| file(name).display().to_string());
        let output = luminaire(&format!("leds --map {map} {scene} --output {tree}"));
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let lights = || fs::read_to_string(file("tree").join("tree_lights.h")).expect("a file");
    for told in [write(), write()] {
        assert!(told.contains("error: Rim: ") && told.contains("2 LEDs take"), "{told}");
        assert!(lights().contains("tree_light(") && lights().contains("luminaire_spot key;"), "{}", lights());
    }
    let own = fs::read_to_string(&sketch).expect("a file").replace("PIN = 6", "PIN = 2");
    fs::write(&sketch, &own).expect("a file");
    let told = write();
    assert!(told.contains("expected a folder without another tree.ino: move that away"), "{told}");
    assert_eq!(fs::read_to_string(&sketch).expect("a file"), own);
}
