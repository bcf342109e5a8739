//! The encoding for the display against IEC 61966-2-1.

use luminaire::{
    Fx16, Fx32, Rgb,
    display::{Rgb565, decode_srgb, encode_srgb, encode_srgb_each},
};
use support::{format::Format, oracle};

/// Every code decodes to a linear value that encodes to it again, within the stated error of the
/// standard.
#[test]
fn every_code_comes_back() {
    let mut worst = 0.0_f64;
    for code in 0..=255 {
        let linear = decode_srgb(code);
        assert_eq!(encode_srgb(linear), code);
        worst = worst.max((f64::from(linear) - oracle::srgb_linear(code.into())).abs());
    }
    assert!((1e-6..=2e-6).contains(&worst), "largest error {worst:.2e}");
}

/// Encoding many values at once gives the code of each, on both sides of every threshold and
/// outside the range.
#[test]
fn encoding_many_is_encoding_each() {
    fn assert_each<S: Format>(values: impl IntoIterator<Item = S>) {
        let values: Vec<_> = values.into_iter().collect();
        for block in values.as_chunks::<16>().0 {
            assert_eq!(encode_srgb_each(block), block.map(encode_srgb), "{block:?}");
        }
    }
    let thresholds = (0..255).map(|code| oracle::srgb_linear(f64::from(code) + 0.5) as f32);
    let around = thresholds
        .flat_map(|t| (-8..8).map(move |ulps| f32::from_bits(t.to_bits().wrapping_add_signed(ulps))));
    assert_each(around);
    assert_each((0..1 << 20).map(|i| i as f32 / (1 << 20) as f32));
    let special = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -0.0, 0.0, 1.0, 1e-30];
    assert_each(special.into_iter().chain(special.map(|value| -value)));
    assert_each((i16::MIN..=i16::MAX).map(Fx16::from_bits));
    assert_each((0..1 << 16).map(|i| Fx32::from_bits(i << 15)));
}

/// The exact product of numbers: the lowest digits first, without leading zeros.
fn product(factors: impl IntoIterator<Item = u32>) -> Vec<u32> {
    let mut digits = vec![1];
    for factor in factors {
        let mut carry = 0;
        for digit in &mut digits {
            let sum = u64::from(*digit) * u64::from(factor) + carry;
            (*digit, carry) = (sum as u32, sum >> 32);
        }
        digits.extend((carry > 0).then_some(carry as u32));
    }
    digits
}

/// Whether `mantissa / 2^exponent` is at or over the linear value halfway between a code and the
/// next, in exact integers: the standard's power 2.4 is a comparison of a fifth with a twelfth
/// power.
fn reaches([mantissa, exponent]: [u32; 2], code: u32, last: u32) -> bool {
    let odd = 2 * code + 1;
    let copies = |factor, count| std::iter::repeat_n(factor, count);
    // v = odd / (2 last) is in the toe up to 12.92 * 0.0031308; beyond it (v + 0.055) / 1.055 is a
    // quotient of integers.
    let is_toe = f64::from(odd) / f64::from(2 * last) <= 12.92 * 0.003_130_8;
    let (power, [numerator, denominator]) = match is_toe {
        true => ([1, 1], [100 * odd, 1292 * 2 * last]),
        false => ([5, 12], [1000 * odd + 110 * last, 2110 * last]),
    };
    let value = copies(mantissa, power[0]).chain(copies(denominator, power[1]));
    let threshold = copies(numerator, power[1]).chain(copies(2, exponent as usize * power[0]));
    let order = |digits: Vec<u32>| (digits.len(), digits.into_iter().rev().collect::<Vec<_>>());
    order(product(value)) >= order(product(threshold))
}

/// The codes of a grey value, of eight, six and five bits.
fn codes<S: Format>(value: S) -> [u32; 3] {
    let Rgb565(pixel) = Rgb565::from_linear(Rgb::new(value, value, value));
    assert_eq!(pixel >> 11, pixel & 31, "red and blue of {value:?}");
    [encode_srgb(value).into(), (pixel >> 5 & 63).into(), (pixel & 31).into()]
}

/// The code changes exactly where the standard's code does, and nowhere else within `side` values
/// on either side. `exactly` returns a value as a mantissa over a power of two.
fn assert_nearest<S: Format>(one: u32, side: u32, value: fn(u32) -> S, exactly: fn(u32) -> [u32; 2]) {
    for (which, last) in [255, 63, 31].into_iter().enumerate() {
        for code in 0..last {
            let (mut below, mut above) = (0, one);
            while above - below > 1 {
                let middle = u32::midpoint(below, above);
                if reaches(exactly(middle), code, last) { above = middle } else { below = middle }
            }
            for bits in below - side..=(above + side).min(one) {
                let expected = code + u32::from(bits >= above);
                assert_eq!(codes(value(bits))[which], expected, "{:?} of {last} codes", value(bits));
            }
        }
    }
}

/// In f32 and `Fx32` it tests 3,000 values on either side of each threshold. Because codes never
/// fall, which `exhaustive` tests, all other values are right, too.
#[test]
fn every_threshold_is_exact() {
    let float = |bits: u32| [bits & 0x007f_ffff | 0x0080_0000, 150 - (bits >> 23)];
    assert_nearest(1.0_f32.to_bits(), 3_000, f32::from_bits, float);
    assert_nearest(1 << 30, 3_000, |bits| Fx32::from_bits(bits as i32), |bits| [bits, 30]);
    assert_nearest(1 << 14, 0, |bits| Fx16::from_bits(bits as i16), |bits| [bits, 14]);
}

#[test]
fn values_beyond_the_display_are_clipped() {
    let clipped = [-1.0, -0.0, f32::NAN, f32::NEG_INFINITY, 1.0, 2.0, f32::INFINITY].map(encode_srgb);
    assert_eq!(clipped, [0, 0, 0, 0, 255, 255, 255]);
}

/// The nearest code of an exact one.
fn nearest(exact: f64) -> f64 {
    (exact + 0.5).floor()
}

/// Every 16-bit value has the nearest code of eight, six and five bits. Exhaustive, including
/// clipped values.
#[test]
fn sixteen_bits_are_encoded_exactly() {
    for value in (i16::MIN..=i16::MAX).map(Fx16::from_bits) {
        let exact = oracle::srgb_code(value.exact().clamp(0.0, 1.0));
        assert_eq!(f64::from(encode_srgb(value)), nearest(exact), "{value}");
        let Rgb565(pixel) = Rgb565::from_linear(Rgb::new(value, value, value));
        let [five, six] = [31.0, 63.0].map(|last| nearest(exact / 255.0 * last) as u16);
        assert_eq!(pixel, five << 11 | six << 5 | five, "{value}");
    }
}

/// Every pixel is restored from its codes, and every code converts to the nearest pixel.
#[test]
fn pixels_are_the_nearest() {
    for pixel in (0..=u16::MAX).map(Rgb565) {
        assert_eq!(Rgb565::from_codes(pixel.to_codes()), pixel);
    }
    for code in 0..=255_u8 {
        let Rgb565(pixel) = Rgb565::from_codes(Rgb::new(code, code, code));
        for (found, last) in [(pixel >> 11, 31), (pixel >> 5 & 63, 63), (pixel & 31, 31)] {
            let off = |level: u16| (f64::from(level) / f64::from(last) - f64::from(code) / 255.0).abs();
            assert!((0..=last).all(|level| off(found) <= off(level)), "{code} as one of {last}");
        }
    }
}
