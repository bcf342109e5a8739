//! The programs of `luminaire leds` send what the library in Rust writes for the same lights and places.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use luminaire::display::{self, Apa102, Hd108, LedChip, LedLoad, LedOrder, LedStrip, Rgbw};
use luminaire::dynamic::{AnyLight, CompiledAnyLight};
use luminaire::{Fx16, Length, Rgb, Vec3};
use luminaire_exchange::leds::{Facing, LedMap, PlacedLeds, Up};
use luminaire_export::{Language, export_all, json};
use luminaire_render::Strip;
use luminaire_render::scenes::{Example, tree as page};

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

/// What a project uses of ESP-IDF 5 and of espressif/led_strip 3.0, as their headers declare it: the bytes go to the
/// standard output. The program ends behind the last frame.
const IDF: &str = r#"#ifndef IDF_H
#define IDF_H
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
static const uint32_t moments[] = { MOMENTS };
static unsigned frames;
typedef int esp_err_t;
#define ESP_OK 0
#define ESP_ERROR_CHECK(x) do { esp_err_t code = (x); if (code != ESP_OK) { exit(1); } } while (0)
#define DMA_ATTR __attribute__((aligned(4)))
static inline int64_t esp_timer_get_time(void) { return INT64_C(1000) * moments[frames]; }
typedef uint32_t TickType_t;
static inline void vTaskDelay(const TickType_t ticks) {
    if (ticks == 0 || ++frames == sizeof moments / sizeof *moments) { exit(0); }
}

typedef union {
    struct format_layout {
        uint32_t r_pos : 2, g_pos : 2, b_pos : 2, w_pos : 2, reserved : 21, num_components : 3;
    } format;
    uint32_t format_id;
} led_color_component_format_t;
#define LED_STRIP_COLOR_COMPONENT_FMT_RGB \
    (led_color_component_format_t){ .format = { .r_pos = 0, .g_pos = 1, .b_pos = 2, .w_pos = 3, .num_components = 3 } }
#define LED_STRIP_COLOR_COMPONENT_FMT_RGBW \
    (led_color_component_format_t){ .format = { .r_pos = 0, .g_pos = 1, .b_pos = 2, .w_pos = 3, .num_components = 4 } }
typedef enum { LED_MODEL_WS2812, LED_MODEL_SK6812, LED_MODEL_WS2811, LED_MODEL_INVALID } led_model_t;
typedef struct {
    int strip_gpio_num;
    uint32_t max_leds;
    led_model_t led_model;
    led_color_component_format_t color_component_format;
    struct led_strip_extra_flags { uint32_t invert_out : 1; } flags;
} led_strip_config_t;
typedef int rmt_clock_source_t;
typedef struct {
    rmt_clock_source_t clk_src;
    uint32_t resolution_hz;
    size_t mem_block_symbols;
    struct { uint32_t with_dma : 1; } flags;
} led_strip_rmt_config_t;
typedef struct led_strip_t *led_strip_handle_t;
struct led_strip_t {
    led_strip_config_t config;
    uint8_t bytes[20000];
};
static inline esp_err_t led_strip_new_rmt_device(
    const led_strip_config_t *led_config, const led_strip_rmt_config_t *rmt_config, led_strip_handle_t *ret_strip
) {
    static struct led_strip_t strip;
    const int is_white = led_config->color_component_format.format.num_components == 4;
    strip.config = *led_config;
    *ret_strip = &strip;
    return led_config->led_model != (is_white ? LED_MODEL_SK6812 : LED_MODEL_WS2812)
        || rmt_config->resolution_hz != 10000000;
}
static inline esp_err_t led_strip_set_pixel_rgbw(
    led_strip_handle_t strip, uint32_t index, uint32_t red, uint32_t green, uint32_t blue, uint32_t white
) {
    const struct format_layout format = strip->config.color_component_format.format;
    uint8_t *at = strip->bytes + index * format.num_components;
    at[format.r_pos] = (uint8_t)red;
    at[format.g_pos] = (uint8_t)green;
    at[format.b_pos] = (uint8_t)blue;
    if (format.num_components == 4) { at[format.w_pos] = (uint8_t)white; }
    return index >= strip->config.max_leds;
}
static inline esp_err_t led_strip_set_pixel(
    led_strip_handle_t strip, uint32_t index, uint32_t red, uint32_t green, uint32_t blue
) {
    return led_strip_set_pixel_rgbw(strip, index, red, green, blue, 0);
}
static inline esp_err_t led_strip_refresh(led_strip_handle_t strip) {
    const uint32_t count = strip->config.max_leds * strip->config.color_component_format.format.num_components;
    return fwrite(strip->bytes, 1, count, stdout) != count;
}

typedef enum { SPI1_HOST, SPI2_HOST, SPI3_HOST } spi_host_device_t;
typedef enum { SPI_DMA_DISABLED = 0, SPI_DMA_CH_AUTO = 3 } spi_dma_chan_t;
typedef struct {
    int mosi_io_num, miso_io_num, sclk_io_num, quadwp_io_num, quadhd_io_num, max_transfer_sz;
} spi_bus_config_t;
typedef struct {
    uint8_t mode;
    int clock_speed_hz, spics_io_num, queue_size;
} spi_device_interface_config_t;
typedef struct {
    uint32_t flags;
    size_t length, rxlength;
    const void *tx_buffer;
    void *rx_buffer;
} spi_transaction_t;
typedef struct spi_device_t *spi_device_handle_t;
static int most;
static inline esp_err_t spi_bus_initialize(
    spi_host_device_t host_id, const spi_bus_config_t *bus_config, spi_dma_chan_t dma_chan
) {
    most = bus_config->max_transfer_sz;
    return host_id == SPI1_HOST || dma_chan == SPI_DMA_DISABLED;
}
static inline esp_err_t spi_bus_add_device(
    spi_host_device_t host_id, const spi_device_interface_config_t *dev_config, spi_device_handle_t *handle
) {
    *handle = NULL;
    return host_id == SPI1_HOST || dev_config->mode != MODE || dev_config->queue_size < 1;
}
static inline esp_err_t spi_device_transmit(spi_device_handle_t handle, spi_transaction_t *trans_desc) {
    const size_t count = trans_desc->length / 8;
    return handle != NULL || count > (size_t)most || fwrite(trans_desc->tx_buffer, 1, count, stdout) != count;
}
#endif
"#;

/// The moments of the frames: at the start, a little later, after a quarter of a turn of 16 seconds, and after a third.
const MOMENTS: [u32; 5] = [0, 0, 0, 4_000, 5_300];

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

/// Compiles a file of a folder with these flags and returns what the program writes.
fn run(folder: &Path, compiler: &str, flags: &[&str], file: &str) -> Vec<u8> {
    const CHECKS: [&str; 5] = ["-O1", "-Wall", "-Wextra", "-Werror", "-fsanitize=undefined"];
    let program = folder.join("program");
    let mut command = Command::new(compiler);
    command.args(CHECKS).arg("-fno-sanitize-recover=all").args(flags).arg("-o").arg(&program).arg(file);
    let output = command.current_dir(folder).output().expect("a compiler");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(&program).output().expect("the program runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

/// Compiles the sketch of a folder and returns the bytes that it sends in all frames.
fn sent(folder: &Path, sketch: &str) -> Vec<u8> {
    let frames: String = MOMENTS.iter().fold(String::new(), |mut text, moment| {
        let _ = write!(text, " now = {moment}; loop();");
        text
    });
    let text = format!(
        "#include \"Arduino.h\"\nSPIClass SPI;\n#include \"{sketch}\"\nint main() {{ setup();{frames} }}\n"
    );
    fs::write(folder.join("main.cpp"), text).expect("a file");
    for header in ["Arduino.h", "SPI.h", "Adafruit_NeoPixel.h"] {
        fs::write(folder.join(header), ARDUINO).expect("a file");
    }
    run(folder, "c++", &["-std=c++11", &format!("-I{LIBRARY}"), "-I."], "main.cpp")
}

/// Compiles the project of a folder, which has all headers but those of ESP-IDF, and returns the bytes that it sends in
/// all frames.
fn sent_by_idf(folder: &Path, mode: u8) -> Vec<u8> {
    let include = folder.join("include");
    for header in ["driver/spi_master.h", "freertos/FreeRTOS.h", "freertos/task.h"] {
        let header = include.join(header);
        fs::create_dir_all(header.parent().expect("a folder")).expect("a folder");
        fs::write(header, "#include \"../led_strip.h\"\n").expect("a file");
    }
    let text = IDF.replace("MOMENTS", &MOMENTS.map(|moment| moment.to_string()).join(", "));
    for header in ["led_strip.h", "esp_err.h", "esp_attr.h", "esp_timer.h"] {
        fs::write(include.join(header), text.replace("!= MODE", &format!("!= {mode}"))).expect("a file");
    }
    // Parts of a frame, of which a strip this short would have one.
    let main = folder.join("main/main.c");
    let text = fs::read_to_string(&main).expect("a file").replace("PART 2048", "PART 96");
    fs::write(main, text).expect("a file");
    fs::write(folder.join("host.c"), "#include \"main/main.c\"\nint main(void) { app_main(); }\n")
        .expect("a file");
    run(folder, "cc", &["-std=c11", "-pedantic", "-Imain", "-Iinclude"], "host.c")
}

/// The newest library of a name beside this program, which Cargo built for it.
fn libraries(name: &str) -> Vec<PathBuf> {
    let program = std::env::current_exe().expect("a program");
    let folder = fs::read_dir(program.parent().expect("a folder")).expect("a folder");
    let mut found: Vec<_> = folder
        .map(|entry| entry.expect("a file"))
        .filter(|entry| {
            let own = entry.file_name().to_string_lossy().into_owned();
            own.starts_with(&format!("lib{name}-")) && own.ends_with(".rlib")
        })
        .map(|entry| (entry.metadata().and_then(|own| own.modified()).expect("a time"), entry.path()))
        .collect();
    found.sort();
    found.into_iter().rev().map(|(_, path)| path).collect()
}

/// A driver of strips that keeps what it sends, and a program that sends all frames of each crate: as bytes, and to the
/// driver, which gets the same with the channels in the order red, green and blue.
const DRIVER: &str = r#"use smart_leds_trait::*;
struct Strip<T>(Vec<T>);
impl<T> SmartLedsWrite for Strip<T> {
    type Error = ();
    type Color = T;
    fn write<I: IntoIterator<Item = J>, J: Into<T>>(&mut self, all: I) -> Result<(), ()> {
        self.0 = all.into_iter().map(Into::into).collect();
        Ok(())
    }
}
fn main() {
    use std::io::Write;
    let mut output = std::io::stdout();
    const MOMENTS: [u32; 5] = [0, 0, 0, 4_000, 5_300];
    macro_rules! frames {
        ($of:ident, |$strip:ident, $leds:ident, $now:ident| $send:expr, $bytes:expr) => {
            let (mut leds, mut $leds, mut $strip) = ($of::Leds::new(), $of::Leds::new(), Strip(Vec::new()));
            for $now in MOMENTS {
                let mut bytes = [[0; $of::BYTES]; $of::COUNT];
                leds.bytes($now, &mut bytes);
                $send.expect("a frame");
                let sent: Vec<[u8; $of::BYTES]> = $strip.0.iter().map($bytes).collect();
                assert_eq!(sent, bytes, stringify!($of));
                output.write_all(bytes.as_flattened()).expect("bytes");
            }
        };
    }
    frames!(ws2812, |strip, leds, now| leds.write(now, &mut strip), |own: &RGB8| [own.g, own.r, own.b]);
    frames!(sk6812_rgbw, |strip, leds, now| leds.write(now, &mut strip), |own: &RGBW<u8>| [own.g, own.r, own.b, own.a.0]);
    frames!(apa102, |strip, leds, now| leds.write(now, &mut strip, |current, color| (current, color)),
        |(current, own): &(u8, RGB8)| [0xe0 | current, own.b, own.g, own.r]);
    frames!(hd108, |strip, leds, now| leds.write(now, &mut strip), |own: &RGB16| {
        let [[a, b], [c, d], [e, f]] = [own.g, own.r, own.b].map(u16::to_be_bytes);
        [0xff, 0xff, a, b, c, d, e, f]
    });
}
"#;

/// Compiles the crates of a folder and returns the bytes of all frames of each, one crate after the other.
fn sent_by_rust(folder: &Path, crates: &[(&str, PathBuf)]) -> Vec<u8> {
    let program = std::env::current_exe().expect("a program");
    let dependencies = program.parent().expect("a folder").display().to_string();
    let driver = libraries("smart_leds_trait").remove(0);
    fs::write(folder.join("main.rs"), DRIVER).expect("a file");
    let mut told = None;
    // The newest is usually that of this program; any will do that this compiler has built.
    'libraries: for library in libraries("luminaire") {
        let compile = |name: &str, kind: &str, file: &Path, lints: &[&str], own: &[String]| {
            let mut compiler = Command::new(std::env::var_os("RUSTC").unwrap_or("rustc".into()));
            compiler.args(["--edition=2024", "--crate-name", name, "--crate-type", kind]).args(lints);
            compiler.arg("-L").arg(format!("dependency={dependencies}")).arg("-L").arg(folder);
            compiler.arg("--extern").arg(format!("luminaire={}", library.display()));
            compiler.arg("--extern").arg(format!("smart_leds_trait={}", driver.display()));
            for own in own {
                compiler.arg("--extern").arg(format!("{own}={}/lib{own}.rlib", folder.display()));
            }
            let output =
                compiler.arg("--out-dir").arg(folder).arg(file).output().expect("a compiler of Rust");
            (!output.status.success()).then(|| String::from_utf8_lossy(&output.stderr).into_owned())
        };
        let mut names = Vec::new();
        for (name, path) in crates {
            if let Some(error) = compile(name, "lib", &path.join("src/lib.rs"), &["-Dwarnings"], &[]) {
                told = told.or(Some(error));
                continue 'libraries;
            }
            names.push((*name).to_owned());
        }
        let error = compile("frames", "bin", &folder.join("main.rs"), &[], &names);
        assert_eq!(error, None);
        let output = Command::new(folder.join("frames")).output().expect("the program runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        return output.stdout;
    }
    panic!("{}", told.as_deref().unwrap_or("no library is built"));
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
fn expected<C: LedChip>(chip: C, keeps: bool, from_all_sides: bool) -> Vec<Vec<u8>> {
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
            let irradiance = |light: &CompiledAnyLight<Fx16>| match from_all_sides {
                true => light.irradiance_facing(*place),
                false => light.irradiance(*place, *facing),
            };
            let lit = lights.iter().map(|light| Rgb::lit(irradiance(light), light.color()));
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

/// Each family, from a table of places to the bytes on the wire, by each target. The limit of the current counts in each.
#[test]
fn each_target_sends_the_bytes_of_the_library() {
    let folder = folder("leds");
    let (map, scene) = (folder.join("tree.csv"), folder.join("scene.json"));
    let lines: String = tree().iter().map(|[x, y, z]| format!("{x},{y},{z}\n")).collect();
    fs::write(&map, lines).expect("a file");
    fs::write(&scene, SCENE).expect("a file");
    let count = tree().len();
    let ends: &dyn Fn(usize, u8, usize) -> [Vec<u8>; 2] =
        &|begin, last, end| [vec![0; begin], vec![last; end]];
    let (mut crates, mut of_crates) = (Vec::new(), Vec::new());
    for (chip, name, is_all, mode, frames, [begin, end]) in [
        ("ws2812", "ws2812", false, 0, expected(LedOrder::Grb, false, false), ends(0, 0, 0)),
        ("sk6812-rgbw", "sk6812_rgbw", true, 0, expected(Rgbw(LedOrder::Grb), false, true), ends(0, 0, 0)),
        (
            "apa102",
            "apa102",
            true,
            0,
            expected(Apa102(LedOrder::Bgr), true, true),
            ends(4, 0, 4 + count.div_ceil(16)),
        ),
        (
            "hd108",
            "hd108",
            false,
            3,
            expected(Hd108(LedOrder::Grb), false, false),
            ends(16, 0xff, count.div_ceil(8)),
        ),
    ] {
        let own = |target: &str| {
            let own = folder.join(target).join(chip);
            let [map, scene, path] = [&map, &scene, &own].map(|path| path.display());
            let facing = if is_all { " --facing all" } else { "" };
            let output = luminaire(&format!(
                "leds --map {map} {scene} --output {path} --to {target} --chip {chip} --limit 1500 --channel 12 \
                 --brightness 0.5 --turn 16{facing}"
            ));
            let told = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success() && told.contains("lights reach 101 at first"), "{told}");
            own
        };
        let found = sent(&own("arduino"), &format!("{chip}.ino"));
        assert!(sent_by_idf(&own("esp-idf"), mode) == found, "{chip}: ESP-IDF sends what Arduino does");
        crates.push((name, own("rust")));
        let length = begin.len() + frames[0].len() + end.len();
        assert_eq!(found.len(), MOMENTS.len() * length, "{chip}");
        for (number, (found, expected)) in found.chunks_exact(length).zip(&frames).enumerate() {
            let (found_begin, rest) = found.split_at(begin.len());
            let (found, found_end) = rest.split_at(expected.len());
            assert_eq!((found_begin, found_end), (&begin[..], &end[..]), "{chip}");
            of_crates.extend_from_slice(found);
            if number < 3 {
                assert_eq!(found, expected, "{chip}, frame {number}");
            } else if number == 3 && chip == "ws2812" {
                // The axis of a light that turned is rounded once more.
                let most =
                    found.iter().zip(expected).map(|(found, expected)| found.abs_diff(*expected)).max();
                assert!(most <= Some(1), "{most:?}");
                assert_ne!(found, &frames[2][..], "the lights turn");
            }
        }
        assert!(frames[0].iter().filter(|byte| **byte > 8).count() > count, "{chip}: too few are lit");
    }
    let found = sent_by_rust(&folder, &crates);
    assert_eq!(found.len(), of_crates.len());
    let differs = found.iter().zip(&of_crates).position(|(found, expected)| found != expected);
    assert_eq!(differs, None, "Rust writes what Arduino sends");
}

/// The tree of the page, with the LEDs of a map that says which way they face, has the bytes that the program for the same
/// map and lights sends.
#[test]
fn the_tree_of_the_page_has_the_bytes_of_the_program() {
    let folder = folder("page");
    let (map, scene, own) = (folder.join("map.csv"), folder.join("scene.json"), folder.join("own"));
    let mut lines = String::from("index,x,y,z,xn,yn,zn,error\n");
    for (i, [x, y, z]) in (0..).zip(tree()) {
        let _ = writeln!(lines, "{i},{},{},{},{},{},0.3,0", 17.0 * x + 3.0, 17.0 * y, 17.0 * z, x - y, y + x);
    }
    let fixtures = Example::Tree.setup().expect("constants").fixtures_at(1.3).expect("a time");
    let lights: Vec<_> = fixtures.iter().map(|fixture| *fixture.light()).collect();
    let named = ["a", "b", "c", "d"].into_iter().zip(lights.iter().copied());
    let (text, refused) = export_all(named, Language::Json);
    assert_eq!(refused, []);
    fs::write(&scene, text).expect("a file");
    fs::write(&map, &lines).expect("a file");

    let placed = LedMap::read(&lines)
        .and_then(|map| PlacedLeds::new(map, Up::Z, Facing::Map, Some(page::HEIGHT.into())))
        .expect("a map");
    let vectors = |all: &[[f64; 3]]| -> Vec<_> {
        all.iter().map(|own| Vec3::from(own.map(|number| number as f32))).collect()
    };
    let strip = Strip::new(vectors(&placed.places), page::LIMIT);
    let strip = strip.facing(vectors(placed.facing.as_deref().expect("the map has ways")));
    let shown = strip.frame::<Fx16>(&lights).expect("lights of the page");
    let shown: Vec<_> = shown.into_iter().flat_map(|led| [led.red, led.green, led.blue]).collect();

    let [map, scene, path] = [&map, &scene, &own].map(|path| path.display());
    let output = luminaire(&format!(
        "leds --map {map} {scene} --output {path} --height {} --limit {} --order rgb --turn 0",
        page::HEIGHT,
        page::LIMIT
    ));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let sent = sent(&own, "own.ino");
    assert_eq!(sent[..shown.len()], shown);
    let lit = shown.iter().filter(|byte| **byte > 8).count();
    assert!(lit > 50, "{lit} bytes are lit");
}

/// A light at the largest distance that is accepted turns without an overflow, and one beyond it is refused unless it
/// stands still.
#[test]
fn a_turning_light_stays_within_the_coordinates() {
    let folder = folder("far");
    let file = |name: &str, text: String| {
        let path = folder.join(name);
        fs::write(&path, text).expect("a file");
        path.display().to_string()
    };
    let map = file("map.csv", "100,0,0\n300,0,2\n".to_owned());
    let output = folder.join("tree");
    let write = |name: &str, position: &str, rest: &str| {
        let scene = SCENE.replace("[0, 2.25, 0]", position).replace("\"Star\"", &format!("\"{name}\""));
        let scene = file("scene.json", scene);
        let told = luminaire(&format!("leds --map {map} {scene} --output {}{rest}", output.display()));
        (told.status.success(), String::from_utf8_lossy(&told.stderr).into_owned())
    };
    let (is_written, told) = write("Star", "[-15983, 1, 1]", "");
    assert!(!is_written && !output.exists(), "{told}");
    let refusal = "Star: distance from the middle of the LEDs = 16183.00003";
    assert!(told.contains(refusal) && told.contains("at most 16183 for a light that turns"), "{told}");
    assert!(told.contains("--turn 0 lets it stand still"), "{told}");
    assert!(write("Star", "[-15983, 1, 1]", " --turn 0").0, "a light that stands still");
    fs::remove_dir_all(&output).expect("a folder");
    // A light of the name of the folder: the scene gets another.
    let (is_written, told) = write("Tree", "[-15983, 1, 0]", "");
    assert!(is_written && told.contains("2 LEDs take"), "{told}");
    let main = "#include <stdio.h>\n#include \"leds.h\"\nint main(void) {
        tree_2_scene scene = tree_2_start;
        for (uint32_t turn = 0; turn < 65536; turn += 64) {
            tree_2_turn(&scene, turn);
            printf(\"%ld %ld %d\\n\", (long)scene.tree.position[0], (long)scene.tree.position[2], luminaire_sine(turn));
        }
    }";
    fs::write(output.join("main.c"), main).expect("a file");
    let found = run(&output, "cc", &["-std=c11", &format!("-I{LIBRARY}"), "-I."], "main.c");
    let found = String::from_utf8(found).expect("a text");
    let [radius, middle] = [16_183.0, 200.0];
    for (line, number) in found.lines().zip(0_i32..) {
        let words: Vec<f64> = line.split(' ').map(|word| word.parse().expect("a number")).collect();
        let [x, z] = [words[0], words[1]].map(|steps| steps / 65_536.0);
        let turn = f64::from(number) / 1_024.0 * std::f64::consts::TAU;
        let off = (x - middle + radius * turn.cos()).hypot(z + radius * turn.sin());
        // 21 steps of each sine, which is the nearest at the places of its table.
        assert!(off < radius * 30.0 / 16_384.0, "{number}: {x} {z}");
        let sine = 16_384.0 * turn.sin();
        let most = if number % 16 == 0 { 0.5 } else { 21.0 };
        assert!((words[2] - sine).abs() <= most, "{number}: {} and not {sine}", words[2]);
    }
    assert_eq!(found.lines().count(), 1_024);
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
