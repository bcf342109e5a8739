//! The outputs of C have the bits of the kernel.

#[path = "support/avr.rs"]
mod avr;
#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
mod compiler;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use fastrand::Rng;
use luminaire::display::{
    Apa102, Curve, Gamma22, Gamma28, Gray1, Gray2, Gray4, Gray8, Hd108, Layout, LedChip, LedLoad, LedOrder,
    LedStrip, Linear, Palette, Pixel, Pwm, Rgb332, Rgb444, Rgb555, Rgb565, Rgb666, Rgb888, Rgbw,
    TemporalDither, clip, decode_srgb, encode_srgb, encode_srgb_dithered, pack,
};
use luminaire::number::Light16;
use luminaire::{Fx16, Rgb};

use compiler::{bytes, compile_in_integers, run, write_headers};

/// The warnings that both files do without.
const WARNINGS: &str = "-Wconversion -Wshadow -Wundef";

/// The colours of electronic paper.
const COLORS: [Rgb<u8>; 4] =
    [Rgb::new(0, 0, 0), Rgb::new(255, 255, 255), Rgb::new(200, 30, 20), Rgb::new(230, 210, 30)];

/// The most LEDs of a strip and pixels of a row.
const MOST: u32 = 64;

/// Writes the headers and the program, and returns the options that find them.
fn program(folder: &Path, palette: &Palette<'_>) -> String {
    write_headers(folder);
    let mut cells = String::new();
    for cell in palette.cells() {
        let _ = write!(cells, "{cell}, ");
    }
    let text = format!(
        "static const uint8_t cells[4096] LUMINAIRE_TABLE = {{ {cells} }};\n\
         static const luminaire_palette palette = {{ cells, {} }};\n",
        palette.spacing()
    );
    fs::write(folder.join("palette.h"), text).expect("a folder");
    fs::write(folder.join("main.c"), include_str!("pixels.c")).expect("a folder");
    format!("{WARNINGS} -I{}", folder.display())
}

/// Returns one word of the codes at all places of the dither.
fn each(code: impl Fn(u32, u32) -> u32) -> u32 {
    let places = (0..64).map(|place| (place % 8, place / 8));
    places.fold(0_u32, |hash, (x, y)| hash.wrapping_mul(31).wrapping_add(code(x, y)))
}

/// Returns what the kernel shows of a colour.
fn by_the_kernel(light: Rgb<u32>, place: u32, palette: &Palette<'_>) -> Vec<u32> {
    fn all<P: Pixel>(color: Rgb<Fx16>) -> u32 {
        each(|x, y| P::dithered(color, x, y).to_bits())
    }
    let sum = light.map(Light16::from_bits);
    let color = clip(sum);
    let (red, x, y) = (color.red, place, place >> 3);
    let mut words = vec![
        all::<Rgb888>(color),
        all::<Rgb565>(color),
        all::<Rgb332>(color),
        all::<Rgb444>(color),
        all::<Gray1>(color),
        all::<Gray2>(color),
        all::<Gray4>(color),
        all::<Gray8>(color),
        each(|x, y| Gamma22::encode_dithered(red, x, y).into()),
        each(|x, y| Gamma28::encode_dithered(red, x, y).into()),
        each(|x, y| Linear::encode_dithered(red, x, y).into()),
    ];
    macro_rules! formats {
        ($($pixel:ident)*) => {
            $(words.extend([$pixel::nearest(color), $pixel::dithered(color, x, y)].map(Pixel::to_bits));)*
        };
    }
    formats!(Gray1 Gray2 Gray4 Gray8 Rgb332 Rgb444 Rgb555 Rgb565 Rgb666 Rgb888);
    let rgb565 = Rgb565::nearest(color);
    words.push(Rgb888::nearest(color).to_bits());
    words.extend(
        [rgb565.to_be_bytes(), rgb565.0.to_le_bytes()].map(|bytes| u32::from(u16::from_be_bytes(bytes))),
    );
    words.extend([encode_srgb(red), encode_srgb_dithered(red, x, y)].map(u32::from));
    words.extend([Gamma22::encode(red), Gamma28::encode(red)].map(u32::from));
    words.extend([palette.nearest(color), palette.dithered(color, x, y)].map(u32::from));
    macro_rules! duties {
        ($($bits:literal)*) => { words.extend([$(Pwm::<$bits>::duty(red)),*].map(u32::from)) };
    }
    duties!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16);
    let filter = (light.red & 0x7fff) as i16;
    let filter = Rgb::new(filter, 20_000 - filter, -1 - filter).map(Fx16::from_bits);
    let Rgb { red, green, blue } = (sum + sum.filtered(filter)).map(Light16::to_bits);
    words.extend([red, green, blue]);
    let texel = Rgb565((place & 0xffff) as u16);
    words.push(decode_srgb::<Fx16>((place & 0xff) as u8).to_bits() as u32);
    let textured = sum.filtered(texel.to_codes().map(decode_srgb::<Fx16>)).map(Light16::to_bits);
    words.extend(<[u32; 3]>::from(textured));
    words
}

/// All words of 16 bits in each channel, and larger ones.
fn colors(rng: &mut Rng) -> Vec<Rgb<u32>> {
    let mut colors: Vec<_> =
        (0..1 << 16).map(|light| Rgb::new(light, light ^ 0x1555, 0xffff - light)).collect();
    // Grey has the luminance of equal channels, and of any.
    colors.extend((0..=1 << 14).map(|light| Rgb::new(light, light, light)));
    let any = |rng: &mut Rng| Rgb::new((), (), ()).map(|()| rng.u32(..) >> rng.u8(..32));
    colors.extend((0..10_000).map(|_| any(rng)));
    colors.extend([u32::MAX, 1 << 31, 1 << 30].map(|light| Rgb::new(light, light - 1, light / 2)));
    colors
}

/// Writes the words of strips of all families of chips, and returns the bytes that the kernel sends them.
fn strips(count: u32, rng: &mut Rng, input: &mut Vec<u32>) -> Vec<u32> {
    input.push(count);
    let strips = (0..count).flat_map(|index| {
        let channels = index % 4;
        let order = [LedOrder::Grb, LedOrder::Rgb, LedOrder::Bgr, LedOrder::Grb][channels as usize];
        match index / 4 % 4 {
            0 => strip(order, channels, index, rng, input),
            1 => strip(Rgbw(order), channels + 4, index, rng, input),
            2 => strip(Apa102(order), channels + 8, index, rng, input),
            _ => strip(Hd108(order), channels + 12, index, rng, input),
        }
    });
    strips.collect()
}

fn strip<C: LedChip>(chip: C, order: u32, index: u32, rng: &mut Rng, input: &mut Vec<u32>) -> Vec<u32> {
    let mut expected = Vec::new();
    let leds = rng.u32(0..=MOST);
    let channel = if index.is_multiple_of(5) { 0 } else { rng.u16(1..) >> rng.u8(..16) };
    let idle = rng.u16(..) >> rng.u8(..16);
    let white = leds * (u32::from(idle) + 3 * u32::from(channel));
    let most = if index % 8 == 1 { rng.u32(..) } else { rng.u32(0..=white) };
    let brightness = if index.is_multiple_of(3) { 1 << 14 } else { rng.u32(0..=1 << 14) >> rng.u8(..14) };
    input.extend([leds, order, most, channel.into(), idle.into(), (1 << 16) - 4 * brightness]);
    let lights: Vec<_> = (0..leds).map(|_| [0; 3].map(|_| rng.u32(0..20_000) >> rng.u8(..15))).collect();
    input.extend(lights.iter().flatten());
    let mut strip = LedStrip::new(chip).with_brightness(Fx16::from_bits(brightness as i16));
    if channel > 0 {
        strip = strip.with_limit(most, channel, idle);
    }
    let lights: Vec<_> = lights.iter().map(|light| clip(Rgb::from(light.map(Light16::from_bits)))).collect();
    let mut dithers: Vec<_> = (0..leds as u16).map(C::dither).collect();
    let (mut bytes, mut load) = (vec![0; C::BYTES * lights.len()], LedLoad::default());
    for frame in 0..6 {
        if frame < 3 {
            strip.write(&lights, &mut dithers, &mut bytes);
        } else {
            let mut frame = strip.frame(lights.len(), &mut load);
            let leds = lights.iter().zip(&mut dithers).zip(bytes.chunks_exact_mut(C::BYTES));
            leds.for_each(|((light, dither), bytes)| frame.write(*light, dither, bytes));
        }
        expected.extend(bytes.iter().map(|byte| u32::from(*byte)));
    }
    expected
}

/// Writes the words of rows of pixels of a format, and returns the bytes that the kernel packs.
fn rows<P: Pixel>(
    rows: u32,
    format: u32,
    pixel: fn(u32) -> P,
    rng: &mut Rng,
    input: &mut Vec<u32>,
) -> Vec<u32> {
    let mut expected = Vec::new();
    for case in 0..rows {
        let (size, count) = (rng.usize(0..=3 * MOST as usize), rng.u32(0..=MOST));
        let layout = [Layout::MsbFirst, Layout::LsbFirst][case as usize % 2];
        let words: Vec<_> = (0..count).map(|_| rng.u32(..)).collect();
        input.extend([format, case % 2, size as u32, count]);
        input.extend(&words);
        let pixels: Vec<_> = words.into_iter().map(pixel).collect();
        let mut bytes = [0xaa; 3 * MOST as usize];
        expected.push(pack(&pixels, layout, &mut bytes[..size]) as u32);
        expected.extend(bytes.map(u32::from));
    }
    expected
}

fn temporal<const BITS: u32>() -> impl Iterator<Item = u32> {
    let mut dither = TemporalDither::<BITS>::new(BITS as u16);
    (0..16_400).map(move |light| dither.next(Fx16::from_bits(light)).into())
}

/// The words of the program for these colours, and for as many strips and rows of each format, and what the
/// kernel returns.
fn words(colors: &[Rgb<u32>], cases: u32, palette: &Palette<'_>, rng: &mut Rng) -> (Vec<u32>, Vec<u32>) {
    let mut input = vec![colors.len() as u32];
    input.extend(colors.iter().flat_map(|light| [light.red, light.green, light.blue]));
    let shown = (0..).zip(colors).flat_map(|(place, light)| by_the_kernel(*light, place, palette));
    let mut expected: Vec<_> = shown.collect();
    macro_rules! temporals {
        ($($bits:literal)*) => { $(expected.extend(temporal::<$bits>());)* };
    }
    temporals!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16);
    expected.extend(strips(4 * cases, rng, &mut input));
    macro_rules! packed {
        ($($pixel:ident $format:literal),*) => {
            input.push(cases * [$($format),*].len() as u32);
            $(expected.extend(rows(cases, $format, |word| $pixel(word as _), rng, &mut input));)*
        };
    }
    packed!(
        Gray1 0x010, Gray2 0x020, Gray4 0x040, Gray8 0x080, Rgb332 0x332, Rgb444 0x444, Rgb555 0x555,
        Rgb565 0x565, Rgb666 0x666, Rgb888 0x888
    );
    (input, expected)
}

/// Every channel of 16 bits at every place of the dither, and random strips and rows.
#[test]
fn outputs_have_the_bits_of_the_kernel() {
    let mut rng = Rng::with_seed(565);
    let palette = Palette::new(&COLORS).expect("colours");
    let colors = colors(&mut rng);
    let (input, expected) = words(&colors, 100, &palette, &mut rng);
    let of_a_color = by_the_kernel(colors[0], 0, &palette).len();
    let folder = tempfile::tempdir().expect("a folder");
    let options = program(folder.path(), &palette);
    for (compiler, flags) in [
        ("cc", "-std=c99 -O2"),
        ("cc", "-std=c99 -O1 -D__AVR__ -fsanitize=undefined -fno-sanitize-recover=all"),
        ("c++", "-std=c++11 -Os -Wold-style-cast"),
    ] {
        let main = folder.path().join("main.c");
        let Some(found) = run(compiler, &format!("{flags} {options}"), &main, &input) else { continue };
        if let Some(at) = found.iter().zip(&expected).position(|(found, expected)| found != expected) {
            let (found, expected, output) = (found[at], expected[at], at % of_a_color);
            let light = colors.get(at / of_a_color);
            panic!(
                "{compiler} {flags}: {found}, expected {expected}: output {output} of {light:?}, word {at}"
            );
        }
        assert_eq!(found.len(), expected.len(), "{compiler} {flags}");
    }
    // An AVR, where an `int` has 16 bits.
    let some: Vec<_> = colors.iter().step_by(colors.len() / 150).copied().collect();
    let (input, expected) = words(&some, 2, &palette, &mut rng);
    avr::writes(&folder.path().join("main.c"), &bytes(&input), &bytes(&expected));
}

/// The smallest processors need neither floats nor a division for any output.
#[test]
fn small_processors_compile_all_outputs_in_integers() {
    let folder = tempfile::tempdir().expect("a folder");
    program(folder.path(), &Palette::new(&COLORS).expect("colours"));
    compile_in_integers(&folder.path().join("main.c"));
}
