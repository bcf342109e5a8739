//! The examples of the library for C that draw on displays, with what they call of the displays' libraries as these declare
//! it. All four also compile against the libraries themselves, which no package holds for a test.

#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
mod compiler;

use std::fs;
use std::process::Command;

use luminaire::display::{Rgb565, clip};
use luminaire::dynamic::AnyLight;
use luminaire::{Fx16, Length, Rgb, Vec3};
use luminaire_export::{Language, Scene, export_scene, json};

use compiler::compile;

const LIBRARY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/c/src");
const EXAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/c/examples");
const WIDTH: usize = 80;
const HEIGHT: usize = 60;

/// A screen, which prints its pixels at the end of each frame, and the calls of Arduino's core.
const SCREEN: &str = "#ifndef SCREEN_H
#define SCREEN_H
#include <stdint.h>
#include <stdio.h>
enum { WIDTH = 80, HEIGHT = 60 };
static uint16_t screen[HEIGHT][WIDTH];
static inline void delay(unsigned long) {}
static inline void shown() {
    for (int i = 0; i < WIDTH * HEIGHT; ++i) { printf(\"%04x\", (unsigned)screen[i / WIDTH][i % WIDTH]); }
    puts(\"\");
}
#endif
";

const TFT_ESPI: &str = "#include \"screen.h\"
class TFT_eSPI {
    int x, y, swaps;
public:
    TFT_eSPI() : x(0), y(0), swaps(0) {}
    void init(uint8_t = 0) {}
    void setRotation(uint8_t) {}
    void setSwapBytes(bool swap) { swaps = swap; }
    int16_t width() { return WIDTH; }
    int16_t height() { return HEIGHT; }
    void startWrite() {}
    void setAddrWindow(int32_t xs, int32_t ys, int32_t, int32_t) { x = xs, y = ys; }
    void pushPixels(const void *data, uint32_t count) {
        for (const uint16_t *next = (const uint16_t *)data; swaps && count > 0; --count) { screen[y][x++] = *next++; }
    }
    void endWrite() { shown(); }
};
";

/// A row is read when the next one is sent, as a transfer that takes its time would.
const LOVYAN_GFX: &str = "#include \"screen.h\"
namespace lgfx { struct rgb565_t { uint16_t raw; }; }
class LGFX {
    const uint16_t *sent;
    int row;
public:
    LGFX() : sent(0), row(0) {}
    bool init() { return true; }
    int32_t width() const { return WIDTH; }
    int32_t height() const { return HEIGHT; }
    void startWrite() {}
    template <typename T> void pushImageDMA(int32_t, int32_t y, int32_t, int32_t, const T *data) {
        wait();
        sent = &data->raw, row = y;
    }
    void endWrite() { wait(); shown(); }
private:
    void wait() {
        for (int x = 0; sent && x < WIDTH; ++x) { screen[row][x] = sent[x]; }
        sent = 0;
    }
};
";

/// Packets of a console: pan to the right, then a wider zoom, then the start code of another protocol, then darkness.
const ESP_DMX: &str = "#include \"screen.h\"
#include <stddef.h>
#include <string.h>
typedef unsigned int dmx_port_t;
struct dmx_config_t { int priority; };
struct dmx_personality_t { uint16_t footprint; char description[33]; };
struct dmx_packet_t { int err, sc; size_t size; bool is_rdm; };
enum { DMX_PACKET_SIZE = 513, DMX_TIMEOUT_TICK = 125 };
#define DMX_CONFIG_DEFAULT { 255 }
static int received;
static inline bool dmx_driver_install(dmx_port_t, const dmx_config_t *, const dmx_personality_t *, int) { return true; }
static inline bool dmx_set_pin(dmx_port_t, int, int, int) { return true; }
static inline size_t dmx_receive(dmx_port_t, dmx_packet_t *packet, unsigned) {
    static const dmx_packet_t packets[] = { { 0, 0, 513, false }, { 0, 0, 10, false }, { 0, 0, 513, false },
        { 0, 0xcc, 26, true }, { 5, 0, 513, false }, { 0, 0, 513, false }, { 0, 0, 0, false } };
    *packet = packets[received++ % 7];
    return packet->size;
}
static inline size_t dmx_read(dmx_port_t, void *to, size_t size) {
    static const uint8_t slots[][9] = { { 125, 0, 213, 85, 255, 40, 255, 255, 255 },
        { 130, 0, 213, 85, 255, 40, 255, 255, 255 }, { 130, 0, 213, 85, 255, 255, 255, 255, 255 }, { 0 }, { 0 },
        { 130, 0, 213, 85, 0, 255, 255, 255, 255 } };
    memset(to, 0, size);
    if (size > 9) { memcpy((uint8_t *)to + 1, slots[received - 1], 9); }
    return size;
}
";

/// Two pages, of the upper and the lower half.
const GX_EPD2: &str = "#include \"screen.h\"
#define GxEPD_BLACK 0x0000
#define GxEPD_WHITE 0xffff
struct GxEPD2_290_T94_V2 {
    static const uint16_t HEIGHT = 296;
    GxEPD2_290_T94_V2(int16_t, int16_t, int16_t, int16_t) {}
};
template <typename Panel, uint16_t page_height> class GxEPD2_BW {
    int page;
public:
    GxEPD2_BW(Panel) : page(0) {}
    void init(uint32_t = 0) {}
    void setRotation(uint8_t) {}
    int16_t width() const { return WIDTH; }
    int16_t height() const { return HEIGHT; }
    void setFullWindow() {}
    void firstPage() { page = 0; }
    bool nextPage() {
        if (++page < 2) { return true; }
        shown();
        return false;
    }
    void drawPixel(int16_t x, int16_t y, uint16_t color) {
        if (y * 2 / HEIGHT == page) { screen[y][x] = color; }
    }
    void hibernate() {}
};
";

/// A slider, which is moved to a quarter by the second call of the timer.
const LVGL: &str = "#include \"screen.h\"
#define LV_COLOR_FORMAT_RGB565 18
#define LV_DRAW_BUF_DEFINE_STATIC(name, w, h, format) static lv_draw_buf_t name; static uint16_t name##_data[w * h]
#define LV_DRAW_BUF_INIT_STATIC(name) (name.data = (uint8_t *)name##_data, name.stride = sizeof(name##_data) / SIZE)
struct lv_draw_buf_t { uint8_t *data; uint32_t stride; };
struct lv_obj_t { lv_draw_buf_t *buffer; };
struct lv_event_t {};
typedef void (*lv_event_cb_t)(lv_event_t *);
enum { LV_ALIGN_TOP_MID = 2, LV_ALIGN_BOTTOM_MID = 5, LV_EVENT_VALUE_CHANGED = 35, LV_ANIM_OFF = 0 };
static lv_obj_t objects[2];
static lv_event_cb_t changed;
static int32_t value;
static inline void lv_init() {}
static inline lv_obj_t *lv_screen_active() { return 0; }
static inline lv_obj_t *lv_canvas_create(lv_obj_t *) { return objects; }
static inline lv_obj_t *lv_slider_create(lv_obj_t *) { return objects + 1; }
static inline void lv_canvas_set_draw_buf(lv_obj_t *canvas, lv_draw_buf_t *buffer) { canvas->buffer = buffer; }
static inline void lv_obj_align(lv_obj_t *, int, int32_t, int32_t) {}
static inline void lv_slider_set_range(lv_obj_t *, int32_t, int32_t) {}
static inline void lv_slider_set_value(lv_obj_t *, int32_t now, int) { value = now; }
static inline int32_t lv_slider_get_value(const lv_obj_t *) { return value; }
static inline void *lv_obj_add_event_cb(lv_obj_t *, lv_event_cb_t call, int, void *) { return changed = call, (void *)0; }
static inline void *lv_draw_buf_goto_xy(const lv_draw_buf_t *buffer, uint32_t x, uint32_t y) {
    return buffer->data + y * buffer->stride + 2 * x;
}
static inline void lv_obj_invalidate(lv_obj_t *canvas) {
    for (int y = 0; y < HEIGHT; ++y) {
        for (int x = 0; x < WIDTH; ++x) { screen[y][x] = ((uint16_t *)lv_draw_buf_goto_xy(canvas->buffer, x, y))[0]; }
    }
    shown();
}
static inline uint32_t lv_timer_handler() {
    value = 4096;
    changed(0);
    return 5;
}
";

/// What a sketch shows in each of some frames: the calls of its `loop`, and of its `setup` where that draws.
fn shown(name: &str, libraries: &[(&str, &str)], frames: usize) -> Vec<Vec<u16>> {
    let folder = tempfile::tempdir().expect("a folder");
    for (file, text) in [("screen.h", SCREEN)].iter().chain(libraries) {
        fs::write(folder.path().join(file), text).expect("a file");
    }
    let (main, program) = (folder.path().join("main.cpp"), folder.path().join(name));
    let calls =
        format!("int main() {{ setup(); for (int i = 0; i < {frames}; ++i) {{ loop(); }} return 0; }}\n");
    let sketch = format!("{EXAMPLES}/{name}/{name}.ino");
    fs::write(&main, format!("#include \"{sketch}\"\n{calls}")).expect("a file");
    let options = format!("-std=c++11 -O1 -fsanitize=undefined -I{LIBRARY} -I{}", folder.path().display());
    if compile("c++", &options, &main, &program).is_none() {
        return Vec::new();
    }
    let output = Command::new(&program).output().expect("a program");
    let text = String::from_utf8(output.stdout).expect("text");
    let pixel = |at: usize, line: &str| u16::from_str_radix(&line[4 * at..4 * at + 4], 16).expect("a pixel");
    text.lines().map(|line| (0..WIDTH * HEIGHT).map(|at| pixel(at, line)).collect()).collect()
}

/// The mean column of the lit pixels, and how many there are.
fn lit(frame: &[u16]) -> (f64, usize) {
    let lit: Vec<_> = (0..frame.len()).filter(|at| frame[*at] != 0).map(|at| at % WIDTH).collect();
    (lit.iter().sum::<usize>() as f64 / lit.len() as f64, lit.len())
}

/// The header is that of the scene beside it; `LUMINAIRE_BLESS=1` writes it. The picture is what the kernel computes.
#[test]
fn the_stage_is_what_the_kernel_computes() {
    let file = |name: &str| format!("{EXAMPLES}/Stage/{name}");
    let read = json::read(&fs::read_to_string(file("lights.json")).expect("a file")).expect("lights");
    let named = || read.lights.iter().map(|own| (own.name.as_str(), own.light));
    let ambient: Vec<_> = read.ambient.iter().map(|own| own.light).collect();
    let scene = Scene { name: "stage", ambient: &ambient };
    let (text, refused) = export_scene(&scene, named(), Language::CFixed).expect("a scene");
    assert!(refused.is_empty(), "{refused:?}");
    if std::env::var_os("LUMINAIRE_BLESS").is_some() {
        fs::write(file("stage.h"), &text).expect("a file");
    }
    let found = fs::read_to_string(file("stage.h")).expect("a file");
    assert!(found == text, "stage.h: expected another text: write it with LUMINAIRE_BLESS=1");

    let night = ambient[0].compile::<Fx16>();
    let up = Fx16::normal([0.0, 1.0, 0.0]);
    let length = Length::from_bits;
    for (number, frame) in shown("Stage", &[("TFT_eSPI.h", TFT_ESPI)], 34).iter().enumerate() {
        let along = if number < 32 { number } else { 64 - number } as i32;
        let target = Vec3::new((along - 16) * 4_096, 0, 0).map(length);
        let arrived = |(name, light): (&str, AnyLight), point| match light {
            AnyLight::Spot(spot) => {
                let spot = spot.compile::<Fx16>().expect("a light");
                let spot = if name == "key" { spot.aimed_at(target).expect("another place") } else { spot };
                Rgb::lit(spot.irradiance(point, up), spot.color())
            }
            other => {
                let light = other.compile::<Fx16>().expect("a light");
                Rgb::lit(light.irradiance(point, up), light.color())
            }
        };
        let step = 4 * 65_536 / WIDTH as i32;
        let pixel = |x: usize, y: usize| {
            let [column, row] = [x as i32 * step - 2 * 65_536, (y as i32 - HEIGHT as i32 / 2) * step];
            let point = Vec3::new(column, 0, row).map(length);
            let light = named().fold(night, |sum, light| sum + arrived(light, point));
            Rgb565::from_linear_dithered(clip(light), x as u32, y as u32).0
        };
        let expected: Vec<_> = (0..WIDTH * HEIGHT).map(|at| pixel(at % WIDTH, at / WIDTH)).collect();
        let differs = frame.iter().zip(&expected).position(|(found, expected)| found != expected);
        assert_eq!(differs, None, "frame {number}");
        let red = |frame: &[u16]| frame.iter().filter(|pixel| **pixel >> 11 > 20).count();
        assert!(red(frame) > 50, "frame {number}: {}", red(frame));
    }
}

#[test]
fn the_head_turns_and_zooms() {
    let found: Vec<_> =
        shown("Head", &[("LovyanGFX.hpp", LOVYAN_GFX)], 33).iter().map(|frame| lit(frame)).collect();
    let [first, .., last] = &found[..] else { return };
    assert!(last.0 > first.0 + 20.0 && last.1 > 3 * first.1, "{found:?}");
    assert!(found.windows(2).all(|pair| pair[1].0 > pair[0].0), "{found:?}");
}

/// A larger pan is counterclockwise as seen from above: to the left of the wall that the head looks at. Packets of other protocols, with errors or of no bytes leave the picture.
#[test]
fn the_console_turns_zooms_and_dims_the_head() {
    let frames = shown("Patch", &[("LovyanGFX.hpp", LOVYAN_GFX), ("esp_dmx.h", ESP_DMX)], 7);
    let found: Vec<_> = frames.iter().map(|frame| lit(frame)).collect();
    let [first, turned, wide, dark] = found[..] else { return assert!(found.is_empty(), "{found:?}") };
    assert!(
        (turned.0 - first.0).abs() > 10.0 && (turned.1 as f64 / first.1 as f64 - 1.0).abs() < 0.2,
        "{found:?}"
    );
    assert!((wide.0 - turned.0).abs() < 4.0 && wide.1 > 3 * turned.1, "{found:?}");
    assert!(turned.0 < first.0 && dark.1 == 0, "{found:?}");
}

#[test]
fn the_light_on_paper_moves_along_the_wall() {
    let found: Vec<_> =
        shown("Paper", &[("GxEPD2_BW.h", GX_EPD2)], 7).iter().map(|frame| lit(frame)).collect();
    assert!(found.iter().all(|(_, white)| (200..WIDTH * HEIGHT / 2).contains(white)), "{found:?}");
    assert!(found.windows(2).all(|pair| pair[1].0 > pair[0].0 + 2.0), "{found:?}");
}

#[test]
fn the_slider_dims_the_lamp() {
    let found = shown("Widget", &[("lvgl.h", LVGL)], 1);
    let [first, dimmed] = &found[..] else { return assert!(found.is_empty(), "{} frames", found.len()) };
    let sum = |frame: &[u16]| frame.iter().map(|pixel| u32::from(pixel >> 11)).sum::<u32>();
    assert!(sum(dimmed) > 0 && 2 * sum(dimmed) < 3 * sum(first) / 2, "{} {}", sum(first), sum(dimmed));
    assert!(lit(first).1 > 500, "{:?}", lit(first));
}
