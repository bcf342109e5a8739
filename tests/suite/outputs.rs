//! Pixels, codes and duties of displays and LEDs against their definitions in f64.

use std::collections::BTreeSet;

use fastrand::Rng;
use luminaire::{
    Fx16, Fx32, Rgb, Scalar,
    display::{
        Curve, Gamma22, Gamma28, Gray1, Gray2, Gray4, Gray8, Layout, Linear, Pixel, Pwm, Rgb332, Rgb444,
        Rgb555, Rgb565, Rgb666, Rgb888, Srgb, TemporalDither, pack, threshold,
    },
};
use support::{format::Format, oracle};

/// A channel of an output: its codes of light that no other channel has.
struct Channel {
    name: &'static str,
    last: u32,
    /// The light of an encoded value in `[0, 1]`.
    law: fn(f64) -> f64,
    narrow: fn(Fx16) -> u32,
    wide: fn(Fx32) -> u32,
    float: fn(f32) -> u32,
    dithered: fn(Fx16, u32, u32) -> u32,
    dithered_wide: fn(Fx32, u32, u32) -> u32,
    dithered_float: fn(f32, u32, u32) -> u32,
}

/// Which channels of a colour have light.
const RED: [u8; 3] = [1, 0, 0];
const GREEN: [u8; 3] = [0, 1, 0];
const BLUE: [u8; 3] = [0, 0, 1];
const GRAY: [u8; 3] = [1, 1, 1];

fn colored<S: Scalar>(light: S, which: [u8; 3]) -> Rgb<S> {
    Rgb::from(which).map(|is_lit| if is_lit == 1 { light } else { S::ZERO })
}

fn srgb(value: f64) -> f64 {
    oracle::srgb_linear(255.0 * value)
}

/// Lists the channels of pixels by their lowest bits and widths, and the curves by their laws.
macro_rules! channels {
    ({$($pixel:ident: $($which:ident $low:literal $bits:literal)*;)*} {$($curve:ident: $law:expr;)*}) => {
        [$($(Channel {
            name: concat!(stringify!($pixel), " ", stringify!($which)),
            last: (1 << $bits) - 1,
            law: srgb,
            // A bit outside the channel makes the code too large.
            narrow: |light| $pixel::nearest(colored(light, $which)).to_bits().rotate_right($low),
            wide: |light| $pixel::nearest(colored(light, $which)).to_bits().rotate_right($low),
            float: |light| $pixel::nearest(colored(light, $which)).to_bits().rotate_right($low),
            dithered: |light, x, y| $pixel::dithered(colored(light, $which), x, y).to_bits().rotate_right($low),
            dithered_wide: |light, x, y| $pixel::dithered(colored(light, $which), x, y).to_bits().rotate_right($low),
            dithered_float: |light, x, y| $pixel::dithered(colored(light, $which), x, y).to_bits().rotate_right($low),
        },)*)* $(Channel {
            name: stringify!($curve),
            last: 255,
            law: $law,
            narrow: |light| $curve::encode(light).into(),
            wide: |light| $curve::encode(light).into(),
            float: |light| $curve::encode(light).into(),
            dithered: |light, x, y| $curve::encode_dithered(light, x, y).into(),
            dithered_wide: |light, x, y| $curve::encode_dithered(light, x, y).into(),
            dithered_float: |light, x, y| $curve::encode_dithered(light, x, y).into(),
        },)*]
    };
}

const CHANNELS: [Channel; 26] = channels! {
    {
        Gray1: GRAY 0 1;
        Gray2: GRAY 0 2;
        Gray4: GRAY 0 4;
        Gray8: GRAY 0 8;
        Rgb332: RED 5 3 GREEN 2 3 BLUE 0 2;
        Rgb444: RED 8 4 GREEN 4 4 BLUE 0 4;
        Rgb555: RED 10 5 GREEN 5 5 BLUE 0 5;
        Rgb565: RED 11 5 GREEN 5 6 BLUE 0 5;
        Rgb666: RED 12 6 GREEN 6 6 BLUE 0 6;
        Rgb888: RED 16 8 GREEN 8 8 BLUE 0 8;
    }
    {
        Linear: |value| value;
        Srgb: srgb;
        Gamma22: |value| libm::pow(value, 2.2);
        Gamma28: |value| libm::pow(value, 2.8);
    }
};

/// Every 16-bit value, and of the other formats the values around each threshold, has the nearest
/// code. All other values have it, too: a bisection finds it, or in f32 a polynomial of sRGB that is
/// less than half a code off.
#[test]
fn every_code_is_the_nearest() {
    for Channel { name, last, law, narrow, wide, float, .. } in CHANNELS {
        let thresholds: Vec<_> =
            (0..last).map(|code| law((f64::from(code) + 0.5) / f64::from(last))).collect();
        let nearest = |exact: f64| thresholds.partition_point(|threshold| exact >= *threshold) as u32;
        for value in (i16::MIN..=i16::MAX).map(Fx16::from_bits) {
            assert_eq!(narrow(value), nearest(value.exact()), "{name}: {value}");
        }
        for (near, off) in thresholds.iter().flat_map(|near| (-3..=3).map(move |off| (near, off))) {
            // Of the thresholds in proportion one is a number, a half, which f64 has exactly.
            let is_clear = |exact: f64| exact == 0.5 || (exact / near - 1.0).abs() > 1e-13;
            let value = Fx32::from_bits((near * f64::from(1 << 30)) as i32 + off);
            assert_eq!(wide(value), nearest(value.exact()), "{name}: {value}");
            assert!(is_clear(value.exact()), "{name}: f64 decides about {value}");
            let value = f32::from_bits((*near as f32).to_bits().wrapping_add_signed(off));
            assert_eq!(float(value), nearest(value.into()), "{name}: {value}");
            assert!(is_clear(value.exact()), "{name}: f64 decides about {value}");
        }
        let special = [f32::NAN, f32::NEG_INFINITY, -0.0, 1e-45, 1.0, f32::INFINITY];
        assert_eq!(special.map(float), [0, 0, 0, 0, last, last], "{name}");
    }
}

/// Bayer's matrix by his recursion: four copies of the next smaller one, four times as far apart.
pub(crate) fn bayer(x: u32, y: u32, size: u32) -> u32 {
    if size == 1 {
        return 0;
    }
    let half = size / 2;
    4 * bayer(x % half, y % half, half) + [[0, 2], [3, 1]][(y / half) as usize][(x / half) as usize]
}

/// The code that a place of a cell shows of a light, by the light of each code; `None` where the 24 bits
/// of the tables may give either code.
fn defined(lights: &[f64], light: f64, place: u32) -> Option<u32> {
    let light = light.clamp(0.0, 1.0);
    let above = lights.partition_point(|of_code| *of_code <= light).clamp(1, lights.len() - 1);
    let [from, to] = [lights[above - 1], lights[above]];
    let part = (f64::from(bayer(place % 8, place / 8, 8)) + 0.5) / 64.0;
    let past = light - from - part * (to - from);
    (past.abs() > 0.5_f64.powi(24)).then(|| above as u32 - u32::from(past < 0.0))
}

/// Each pixel of a cell has the code of the definition, the mean light is the value, within the stated
/// part of a step, and no pixel falls where the light rises: exhaustive in 16 bits, including clipped
/// values. In the other formats the codes of random values are those of the definition.
#[test]
fn every_cell_keeps_the_light() {
    let mut seen = BTreeSet::new();
    for Channel { name, last, law, dithered, dithered_wide, dithered_float, .. } in CHANNELS {
        let lights: Vec<_> = (0..=last).map(|code| law(f64::from(code) / f64::from(last))).collect();
        let (mut before, mut worst) = ([0; 64], 0.0_f64);
        // Every eighth value of a width and a curve that an earlier channel had.
        let stride = if seen.insert((last, law(0.5).to_bits())) { 1 } else { 8 };
        let mut rng = Rng::with_seed(64);
        for value in (-8..=(1 << 14) + 8).step_by(stride).map(Fx16::from_bits) {
            let (light, mut mean) = (value.exact().clamp(0.0, 1.0), 0.0);
            for (place, before) in (0..).zip(&mut before) {
                let code = dithered(value, place % 8, place / 8);
                assert!((*before..=last).contains(&code), "{name}: {value} has {code} after {before}");
                assert!(
                    defined(&lights, light, place).is_none_or(|defined| code == defined),
                    "{name}: {value}"
                );
                *before = code;
                mean += lights[code as usize] / 64.0;
            }
            let (wide, place) = (Fx32::from_f32(law(rng.f64()) as f32), rng.u32(..64));
            if let Some(defined) = defined(&lights, wide.exact(), place) {
                let found = [
                    dithered_wide(wide, place % 8, place / 8),
                    dithered_float(wide.to_f32(), place % 8, place / 8),
                ];
                assert_eq!(found, [defined; 2], "{name}: {wide}");
            }
            let above = lights.partition_point(|of_code| *of_code <= light).clamp(1, last as usize);
            let off = (mean - light).abs() - 1.0 / f64::from(1 << 24);
            worst = worst.max(off / (lights[above] - lights[above - 1]));
        }
        println!("{name}: a cell is off by {worst:.5} of a step");
        assert_eq!(before, [last; 64], "{name}: full scale");
        let special = [f32::NAN, f32::NEG_INFINITY, -0.0, 1e-45, 1.0, f32::INFINITY];
        let found = special.map(|value| dithered_float(value, 5, 2));
        assert_eq!(found, [0, 0, 0, 0, last, last], "{name}");
        assert!((0.007..=0.0081).contains(&worst), "{name}: {worst} of a step");
    }
    let mut thresholds: Vec<_> = (0..64).map(|place| threshold(place % 8 + 8, place / 8)).collect();
    thresholds.sort_unstable();
    assert!(thresholds.into_iter().eq((1..128).step_by(2)), "each threshold once");
}

/// A grey is that of the luminance of Rec. 709, within the stated error, in every format; light
/// without a colour has the grey of a colour of equal channels.
#[test]
fn greys_have_the_luminance() {
    for part in 0..17_u16.pow(3) {
        let color = Rgb::new(part % 17, part / 17 % 17, part / 289).map(|part| f32::from(part) / 16.0);
        let exact = color.map(f64::from);
        let luminance = 0.2126 * exact.red + 0.7152 * exact.green + 0.0722 * exact.blue;
        let code = |off: f64| (oracle::srgb_code((luminance + off).clamp(0.0, 1.0)) + 0.5) as u8;
        let accepted = Gray8(code(-5.4e-6))..=Gray8(code(5.4e-6));
        let (narrow, wide) = (color.map(Fx16::from_f32), color.map(Fx32::from_f32));
        let found = [Gray8::nearest(narrow), Gray8::nearest(wide), Gray8::nearest(color)];
        assert!(found.iter().all(|gray| accepted.contains(gray)), "{color:?}: {found:?} of {accepted:?}");
    }
    for light in (0..=1 << 14).map(Fx16::from_bits) {
        let gray = colored(light, GRAY);
        assert_eq!(Gray4::from_luminance(light), Gray4::nearest(gray));
        assert_eq!(Gray4::from_luminance_dithered(light, 3, 6), Gray4::dithered(gray, 3, 6));
    }
}

/// Every duty is the product with the last one, rounded to nearest, ties up: exhaustive in 16 bits,
/// and in the other formats around each decision. The products are exact in f64.
#[test]
fn every_duty_is_the_nearest() {
    fn assert_one<const BITS: u32, S: Format>(value: S) {
        let exact = value.exact().clamp(0.0, 1.0) * f64::from(Pwm::<BITS>::LAST);
        assert_eq!(Pwm::<BITS>::duty(value), (exact + 0.5) as u16, "{value:?} in {BITS} bits");
    }
    fn assert_each<const BITS: u32>() {
        (i16::MIN..=i16::MAX).map(Fx16::from_bits).for_each(assert_one::<BITS, _>);
        for (duty, off) in (0..Pwm::<BITS>::LAST).flat_map(|duty| (-2..=2).map(move |off| (duty, off))) {
            let near = (f64::from(duty) + 0.5) / f64::from(Pwm::<BITS>::LAST);
            assert_one::<BITS, _>(Fx32::from_bits((near * f64::from(1 << 30)) as i32 + off));
            assert_one::<BITS, _>(f32::from_bits((near as f32).to_bits().wrapping_add_signed(off)));
        }
    }
    assert_each::<1>();
    assert_each::<8>();
    assert_each::<12>();
    assert_each::<16>();
    assert_eq!([f32::NAN, -1.0, 1e-45, 1.0, f32::INFINITY].map(Pwm::<9>::duty), [0, 0, 0, 511, 511]);
}

/// After each frame, the sum of the duties is within one step of the sum of the light; a brighter
/// light has no lower duty, and the least light is not lost.
#[test]
fn temporal_dither_loses_no_light() {
    fn assert_kept<const BITS: u32, S: Format>(value: S, index: u16, rounded: f64) {
        let exact = value.exact() * f64::from(Pwm::<BITS>::LAST);
        let (mut led, mut sum) = (TemporalDither::<BITS>::new(index), 0.0);
        for frame in 1..=20 {
            let duty = f64::from(led.next(value));
            sum += duty;
            let off = sum - f64::from(frame) * exact;
            assert!((duty - exact).abs() < 1.0 + rounded, "{value:?}: {duty} of {exact}");
            assert!(off.abs() < 1.0 + f64::from(frame) * rounded, "{value:?}: off by {off} after {frame}");
        }
    }
    for (bits, index) in (0..=1 << 14).zip(0..) {
        let (value, next) = (Fx16::from_bits(bits), Fx16::from_bits(bits + 1));
        assert_kept::<8, _>(value, index, 0.0);
        assert_kept::<16, _>(value, index, 0.0);
        let dark = value.to_f32().powi(3);
        assert_kept::<8, _>(dark, index, 1.0 / 8_192.0);
        assert_kept::<16, _>(Fx32::from_f32(dark), index, 1.0 / 8_192.0);
        let led = TemporalDither::<8>::new(index);
        assert!(led.clone().next(value) <= led.clone().next(next), "the duty of {value}");
    }
    for value in [1, 2, 5_461, 16_383].map(Fx16::from_bits) {
        let (start, mut led) = (TemporalDither::<8>::new(7), TemporalDither::<8>::new(7));
        let sum: i32 = (0..1 << 14).map(|_| i32::from(led.next(value))).sum();
        assert_eq!((led, sum), (start, 255 * i32::from(value.to_bits())), "a period of {value}");
    }
    let mut led = TemporalDither::<8>::default();
    assert_eq!((0..1 << 16).map(|_| led.next(f32::from_bits(1))).sum::<u16>(), 1, "the least light");
}

/// Packed pixels are their bits one after another, in either order; pixels that do not fit, and bytes
/// behind the last, are left alone.
#[test]
fn packed_bits_are_in_order() {
    fn assert_packed<P: Pixel>(pixel: impl Fn(u32) -> P, text: impl Fn(u32) -> String) {
        for (pixels, length) in (0..7).flat_map(|pixels| (0..20).map(move |length| (pixels, length))) {
            let bits = (1..=pixels).map(|i| 0x9e37_79b9_u32.wrapping_mul(i) >> (32 - P::BITS));
            let row: Vec<_> = bits.clone().map(&pixel).collect();
            let count = row.len().min(length * 8 / P::PACKED_BITS as usize);
            for layout in [Layout::MsbFirst, Layout::LsbFirst] {
                let turned = |text: String| match layout {
                    Layout::MsbFirst => text,
                    Layout::LsbFirst => text.chars().rev().collect(),
                };
                let stream: String = bits.clone().take(count).map(|bits| turned(text(bits))).collect();
                let (mut expected, mut found) = (vec![0x5a; length], vec![0x5a; length]);
                for (byte, part) in expected.iter_mut().zip(stream.as_bytes().chunks(8)) {
                    let part = turned(format!("{:0<8}", str::from_utf8(part).expect("digits")));
                    *byte = u8::from_str_radix(&part, 2).expect("eight digits");
                }
                assert_eq!(pack(&row, layout, &mut found), count);
                assert_eq!(found, expected, "{pixels} pixels of {} bits, {layout:?}", P::BITS);
            }
        }
    }
    assert_packed(|bits| Gray1(bits as u8), |bits| format!("{bits:b}"));
    assert_packed(|bits| Gray4(bits as u8), |bits| format!("{bits:04b}"));
    assert_packed(|bits| Rgb444(bits as u16), |bits| format!("{bits:012b}"));
    assert_packed(|bits| Rgb555(bits as u16), |bits| format!("{bits:016b}"));
    assert_packed(Rgb666, |bits| [12, 6, 0].map(|place| format!("{:06b}00", bits >> place & 63)).concat());
    assert_packed(Rgb888, |bits| format!("{bits:024b}"));
}
