//! Programs in C: the sketch of Arduino and the project of ESP-IDF.

use luminaire::dynamic::AnyLight;
use luminaire_export::C_HEADERS;

use super::options::{Family, Order, Target};
use super::program::{File, Program, Words, lines, replaced, steps};

/// The texts of the programs: words in braces are replaced.
const LEDS: &str = include_str!("leds.h");
const TURNING: &str = include_str!("turning.h");
const WIRE: [&str; 2] = [include_str!("wire.ino"), include_str!("idf/wire.c")];
const SPI: [&str; 2] = [include_str!("spi.ino"), include_str!("idf/spi.c")];
const PROJECT: &str = include_str!("idf/CMakeLists.txt");
const COMPONENT: &str = include_str!("idf/component.txt");
const DEPENDENCIES: &str = include_str!("idf/component.yml");

/// Returns the files of a sketch with the text of the lights.
pub(super) fn sketch(program: &Program<'_>, lights: &str) -> Vec<File> {
    let words = words(program);
    let sketch = if program.options.chip.has_clock() { SPI[0] } else { WIRE[0] };
    vec![
        // The builder of Arduino takes the sketch of the folder's own name.
        File::own(&format!("{}.ino", program.stem), replaced(sketch, &words)),
        File::data("leds.h", replaced(LEDS, &words)),
        File::data(&format!("{}_lights.h", program.name), lights.to_owned()),
    ]
}

/// Returns the files of a project with the text of the lights, and with the library for C.
pub(super) fn project(program: &Program<'_>, lights: &str) -> Vec<File> {
    let words = words(program);
    let main = if program.options.chip.has_clock() { SPI[1] } else { WIRE[1] };
    let own = [
        ("CMakeLists.txt", PROJECT),
        ("main/CMakeLists.txt", COMPONENT),
        ("main/idf_component.yml", DEPENDENCIES),
        ("main/main.c", main),
    ];
    let own = own.into_iter().map(|(path, text)| File::own(path, replaced(text, &words)));
    let data = [
        File::data("main/leds.h", replaced(LEDS, &words)),
        File::data(&format!("main/{}_lights.h", program.name), lights.to_owned()),
    ];
    let library = C_HEADERS.map(|(name, text)| File::data(&format!("main/{name}"), text.to_owned()));
    own.chain(data).chain(library).collect()
}

/// What is put in place of each word of the texts.
fn words(program: &Program<'_>) -> Words {
    [own_words(program), program.words()].concat()
}

fn own_words(program: &Program<'_>) -> Words {
    let Program { options, name, placed, .. } = program;
    let guard = name.to_ascii_uppercase();
    let order = match program.order() {
        Order::Grb => "GRB",
        Order::Rgb => "RGB",
        Order::Bgr => "BGR",
    };
    let family = match options.chip {
        Family::Ws2812 => "",
        Family::Sk6812Rgbw => " + LUMINAIRE_LED_RGBW",
        Family::Apa102 => " + LUMINAIRE_LED_APA102",
        Family::Hd108 => " + LUMINAIRE_LED_HD108",
    };
    let (most, channel) = options.limit.map_or((0, 0), |limit| (limit, options.channel));
    let dimmed = 65_536 - steps(options.brightness, 16);
    let strip = format!("{most}, {channel}, 1, LUMINAIRE_LED_{order}{family}, {dimmed}");
    // An APA102 changes its current with the light, so that its carries need memory.
    let carries = if options.chip == Family::Apa102 {
        format!(
            "    static uint16_t all[{guard}_COUNT][3];\n    uint16_t *carries = all[led];\n    \
             if (number == 0) {{ luminaire_led_start(carries, {name}_strip.order, led); }}"
        )
    } else {
        format!(
            "    uint16_t carries[4];\n    luminaire_led_start(carries, {name}_strip.order, led + number);"
        )
    };
    let (steps, facing, way, read, lit) = match &placed.facing {
        Some(facing) => (
            "A place has steps of 2^-16, and the way that an LED faces has steps of 2^-14. Both stay in flash.",
            format!(
                "static const int16_t {name}_facing[{guard}_COUNT][3] LUMINAIRE_TABLE = {{\n{}}};\n",
                lines(facing, 14, ["{ ", " }"])
            ),
            "    int16_t facing[3];\n",
            format!(
                "    for (i = 0; i < 3; ++i) {{ facing[i] = (int16_t)LUMINAIRE_READ_16(&{name}_facing[led][i]); }}\n"
            ),
            format!("{name}_light(scene, place, facing)"),
        ),
        None => (
            "A place has steps of 2^-16. The places stay in flash.",
            String::new(),
            "",
            String::new(),
            format!("{name}_light_facing(scene, place)"),
        ),
    };
    let turns = |light: &str, own: &AnyLight, forth: bool| {
        let way = if forth { "turn" } else { "0 - turn" };
        let (function, aims) = match own {
            AnyLight::Measured(_) => ("measured_turned", ""),
            AnyLight::Spot(_) => ("light_turned", " 1,"),
            AnyLight::Point(_) | AnyLight::Directional(_) => ("light_turned", " 0,"),
        };
        format!("    {name}_{function}(&scene->{light}, &{name}_start.{light},{aims} {way});\n")
    };
    let (turning, period, moves) = match (program.turns(), options.to) {
        (false, _) => ("", String::new(), String::new()),
        (true, Target::EspIdf) => (
            TURNING,
            format!(
                "#define TURN UINT32_C({}000) /* milliseconds of a turn of the lights */\n",
                options.turn
            ),
            format!(
                "        const uint32_t now = (uint32_t)(esp_timer_get_time() / 1000) % TURN;\n        \
                 {name}_turn(&scene, (uint32_t)((uint64_t)now * 65536 / TURN));\n"
            ),
        ),
        (true, _) => (
            TURNING,
            format!("const uint32_t TURN = {}000; // milliseconds of a turn of the lights\n\n", options.turn),
            format!("    {name}_turn(&scene, (uint32_t)((uint64_t)(millis() % TURN) * 65536 / TURN));\n"),
        ),
    };
    let mode = match (options.chip, options.to) {
        (Family::Apa102, Target::EspIdf) => "0",
        (_, Target::EspIdf) => "3",
        (Family::Apa102, _) => "SPI_MODE0",
        _ => "SPI_MODE3",
    };
    let white = if options.chip == Family::Sk6812Rgbw { "W" } else { "" };
    let (model, set, driver) = match options.chip {
        Family::Sk6812Rgbw => (
            "SK6812",
            "led_strip_set_pixel_rgbw(pixels, led, bytes[0], bytes[1], bytes[2], bytes[3])",
            "  espressif/led_strip: \"^3.0.0\"\n",
        ),
        Family::Ws2812 => (
            "WS2812",
            "led_strip_set_pixel(pixels, led, bytes[0], bytes[1], bytes[2])",
            "  espressif/led_strip: \"^3.0.0\"\n",
        ),
        Family::Apa102 | Family::Hd108 => ("", "", ""),
    };
    vec![
        ("TURNING", turning.to_owned()),
        ("TURNS", program.each_placed(turns)),
        ("PLACES", lines(&placed.places, 16, ["{ ", " }"])),
        ("FACING", facing),
        ("STEPS", steps.to_owned()),
        ("WAY", way.to_owned()),
        ("READ", read),
        ("LIT", lit),
        ("CARRIES", carries),
        ("STRIP", strip),
        ("MIDDLE", program.middle()),
        ("PERIOD", period),
        ("MOVE", moves),
        ("MODE", mode.to_owned()),
        ("WIRE", format!("NEO_{order}{white}")),
        ("COMPONENTS", format!("RGB{white}")),
        ("MODEL", model.to_owned()),
        ("SET", set.to_owned()),
        ("DRIVER", driver.to_owned()),
    ]
}
