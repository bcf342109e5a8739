//! The outputs of a display as C, with the tables of the kernel.

use std::fmt::{Display, Write};

use luminaire::codegen::{CodeTables, Tables};
use luminaire::display::threshold;

/// The part of `luminaire.h` with the pixels of most displays, without the tables.
const PIXELS: &str = include_str!("../c/pixels.h");
/// The other outputs, without the tables.
const DISPLAY: &str = include_str!("../c/luminaire_display.h");
/// The line of both that the tables replace.
const TABLES: &str = "/* TABLES */\n";

/// Returns the part of `luminaire.h` with the light of colours, the sRGB codes and the pixels of RGB565.
pub fn c_pixels() -> String {
    let srgb = Tables::KERNEL.srgb;
    let mut text = String::new();
    let thresholds = (0..64).map(|place| threshold(place % 8, place / 8));
    table(&mut text, "Bayer's matrix as thresholds in 128ths.", "uint8_t", "thresholds", thresholds);
    let doc = "256 times a code up to those of light with these upper bits, over any last code, rounded up.";
    table(&mut text, doc, "uint8_t", "starts", starts(&srgb));
    for codes in &srgb[4..] {
        nearest(&mut text, &bits(codes).to_string(), codes);
        lights(&mut text, &bits(codes).to_string(), codes);
    }
    PIXELS.replace(TABLES, text.trim_start())
}

/// Returns the file `luminaire_display.h`: the other outputs of [`display`](luminaire::display). It
/// includes `luminaire.h`.
///
/// Its tables are those of the kernel.
pub fn c_display_header() -> String {
    let Tables { srgb, gammas, .. } = Tables::KERNEL;
    let mut text = String::new();
    for codes in &srgb {
        let bits = bits(codes);
        if bits.is_power_of_two() {
            let doc =
                format!("The least luminance of grey codes of {bits} bits from 1 on, in steps of 2^-30.");
            let values = codes.fine_thresholds.iter().copied().chain([1 << 30]);
            table(&mut text, &doc, "uint32_t", &format!("grays_{bits}"), values);
        }
        if (2..5).contains(&bits) {
            nearest(&mut text, &bits.to_string(), codes);
        }
        if bits < 5 {
            lights(&mut text, &bits.to_string(), codes);
        }
    }
    for (codes, name) in gammas.iter().zip(["22", "28"]) {
        let doc = "The lower code around the least light with these upper bits.";
        table(
            &mut text,
            doc,
            "uint8_t",
            &format!("starts_{name}"),
            (0..256).map(|place| lower(codes, place)),
        );
        nearest(&mut text, name, codes);
        lights(&mut text, name, codes);
    }
    DISPLAY.replace(TABLES, text.trim_start())
}

/// Returns the number of bits of codes.
fn bits(codes: &CodeTables) -> u32 {
    codes.lights.len().count_ones()
}

/// Returns the lower code around the least light with these upper eight bits.
fn lower(codes: &CodeTables, place: u32) -> usize {
    codes.lights.partition_point(|light| *light <= place << 16)
}

/// Returns for each place the largest start that no width of codes scales to more than its lower code.
fn starts(widths: &[CodeTables]) -> impl Iterator<Item = usize> {
    let fits = |place, start: usize| {
        widths.iter().all(|codes| (start * codes.lights.len()) >> 8 <= lower(codes, place))
    };
    (0..256).map(move |place| (0..256).rfind(|start| fits(place, *start)).unwrap_or_default())
}

/// Writes the table of the nearest codes.
fn nearest(text: &mut String, name: &str, codes: &CodeTables) {
    let doc = "The least light whose nearest code is each from 1 on, in steps of 2^-14.";
    let values = codes.thresholds.iter().copied().chain([1 << 14]);
    table(text, doc, "uint16_t", &format!("nearest_{name}"), values);
}

/// Writes the table of the light of codes.
fn lights(text: &mut String, name: &str, codes: &CodeTables) {
    let values = [0].into_iter().chain(codes.lights.iter().copied());
    table(text, "The light of each code, in steps of 2^-24.", "uint32_t", &format!("lights_{name}"), values);
}

/// Writes a table.
fn table(text: &mut String, doc: &str, kind: &str, name: &str, values: impl Iterator<Item = impl Display>) {
    let values: Vec<_> = values.map(|value| value.to_string()).collect();
    let rows = values.chunks(8).map(|row| row.join(", ")).collect::<Vec<_>>().join(",\n    ");
    let size = values.len();
    let _ = write!(
        text,
        "\n/* {doc} */\nLUMINAIRE_TABLE({kind}, luminaire_{name}, {size}) = {{\n    {rows}\n}};\n"
    );
}
