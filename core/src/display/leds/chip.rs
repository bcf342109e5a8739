//! The bytes of one addressable LED, by the family of its chip.

use core::fmt::Debug;

use crate::color::Rgb;
use crate::display::pwm::{Pwm8, TemporalDither, dimmed, fine, rounded_up};
use crate::number::Scalar;

/// The order of the three channels of an LED, and the family of chips that have a byte for each.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum LedOrder {
    /// Green, red, blue: WS2812, SK6812, and in 16 bits HD108 by its maker.
    Grb,
    /// Red, green, blue: WS2811, WS2815 of some makers, HD108 as others found it.
    Rgb,
    /// Blue, green, red: APA102, SK9822.
    Bgr,
}

impl LedOrder {
    fn ordered<T>(self, Rgb { red, green, blue }: Rgb<T>) -> [T; 3] {
        match self {
            Self::Grb => [green, red, blue],
            Self::Rgb => [red, green, blue],
            Self::Bgr => [blue, green, red],
        }
    }
}

/// A family of addressable LEDs: how linear light becomes the bytes of one of them.
///
/// | family | chips | bytes of an LED | resolution |
/// |---|---|---|---|
/// | [`LedOrder`] | WS2811, WS2812, WS2815 | three duties | 1/255 |
/// | [`Rgbw`] | SK6812 RGBW | three duties and that of white | 1/255 |
/// | [`Apa102`] | APA102, SK9822 | a current of 1 to 31, and three duties | 1/255 of the current |
/// | [`Hd108`] | HD108, NS108 | two of currents, and three duties of two bytes | 1/65,535 |
///
/// Temporal dither shows what is between two steps. The trait is sealed.
pub trait LedChip: Copy + Sealed {
    /// The temporal dither of an LED.
    type Dither: Copy + Debug;
    /// The bytes of an LED.
    const BYTES: usize;
    /// The channels of an LED that take current.
    const CHANNELS: u32;

    /// Returns the dither of an LED by its index: neighbours do not flash together.
    ///
    /// A program without memory for it takes that of `index + frame`, which may wrap around, in each frame: the sum of
    /// the duties of up to 65,536 frames then differs from that of the light by less than 12 (searched). An
    /// [`Apa102`] needs the memory.
    fn dither(index: u16) -> Self::Dither;

    /// Returns the current that light needs, in units of 2^-14 of that of a channel at full duty, rounded up.
    fn current<S: Scalar>(light: Rgb<S>) -> u32;

    /// Writes the bytes of an LED in the next frame: `bytes` has [`BYTES`](Self::BYTES), else nothing is written.
    ///
    /// `factor` dims the light, in units of 2^-16, at most 1.
    fn write<S: Scalar>(self, light: Rgb<S>, factor: u32, dither: &mut Self::Dither, bytes: &mut [u8]);
}

/// What no other crate implements.
pub trait Sealed {}
impl Sealed for LedOrder {}
impl Sealed for Rgbw {}
impl Sealed for Apa102 {}
impl Sealed for Hd108 {}

/// The current of the three channels.
fn current<S: Scalar>(light: Rgb<S>) -> [u32; 3] {
    [light.red, light.green, light.blue].map(|light| rounded_up::<14>(light.word()))
}

/// The light of the three channels, in units of 2^-16 of 1/255.
fn duties<S: Scalar>(light: Rgb<S>, factor: u32) -> Rgb<u32> {
    light.map(|light| dimmed(fine(light.word(), Pwm8::LAST.count_ones()), factor))
}

/// The phase of a channel of the LED of an index, which has `CHANNELS`.
fn phase<const BITS: u32>(index: u16, channel: u16, channels: u16) -> TemporalDither<BITS> {
    TemporalDither::new(index.wrapping_mul(channels).wrapping_add(channel))
}

impl LedChip for LedOrder {
    type Dither = Rgb<TemporalDither<8>>;
    const BYTES: usize = 3;
    const CHANNELS: u32 = 3;

    fn dither(index: u16) -> Self::Dither {
        Rgb::new(0, 1, 2).map(|channel| phase(index, channel, 3))
    }

    fn current<S: Scalar>(light: Rgb<S>) -> u32 {
        current(light).iter().sum()
    }

    #[inline]
    fn write<S: Scalar>(self, light: Rgb<S>, factor: u32, dither: &mut Self::Dither, bytes: &mut [u8]) {
        let duty = |light: S, dither: &mut TemporalDither<8>| dither.next_dimmed(light, factor) as u8;
        let (red, green) = (duty(light.red, &mut dither.red), duty(light.green, &mut dither.green));
        let duties = Rgb::new(red, green, duty(light.blue, &mut dither.blue));
        if let Ok(bytes) = <&mut [u8; 3]>::try_from(bytes) {
            *bytes = self.ordered(duties);
        }
    }
}

/// LEDs with a white one beside the three, such as SK6812 RGBW: white is the last byte.
///
/// White takes the least of the three channels, and they the rest, which is exact where the white LED is as bright as
/// the three together at the same duty, and as white. It takes the current of one channel in place of three.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Rgbw(pub LedOrder);

impl LedChip for Rgbw {
    type Dither = [TemporalDither<8>; 4];
    const BYTES: usize = 4;
    const CHANNELS: u32 = 4;

    fn dither(index: u16) -> Self::Dither {
        [0, 1, 2, 3].map(|channel| phase(index, channel, 4))
    }

    fn current<S: Scalar>(light: Rgb<S>) -> u32 {
        let [red, green, blue] = current(light);
        // Each is rounded up, and so is their least.
        red + green + blue - 2 * red.min(green).min(blue).saturating_sub(1)
    }

    #[inline]
    fn write<S: Scalar>(self, light: Rgb<S>, factor: u32, dither: &mut Self::Dither, bytes: &mut [u8]) {
        let light = duties(light, factor);
        let white = light.red.min(light.green).min(light.blue);
        let [red, green, blue, rest] = dither;
        let duty = |light: u32, dither: &mut TemporalDither<8>| dither.next_fine(light) as u8;
        let colors = Rgb::new(
            duty(light.red - white, red),
            duty(light.green - white, green),
            duty(light.blue - white, blue),
        );
        let [first, second, third] = self.0.ordered(colors);
        if let Ok(bytes) = <&mut [u8; 4]>::try_from(bytes) {
            *bytes = [first, second, third, duty(white, rest)];
        }
    }
}

/// LEDs with a current of five bits for the three duties: APA102 and SK9822, usually [`LedOrder::Bgr`].
///
/// The current is 31, or the least of 1, 2, 4, 8 and 16 of 31 that the light fits into: faint light has 31 times as
/// many duties. A strip begins with four bytes of 0, and ends with four, and one for each sixteen LEDs.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Apa102(pub LedOrder);

/// The temporal dither of an [`Apa102`].
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct CurrentDither {
    /// What each channel is short of, in units of 2^-11 of a duty at the least current, less than 31 of them.
    carries: [u16; 3],
}

/// The most current of an APA102, and how many powers of two are less.
const MOST_CURRENT: u32 = 31;
const POWERS: u32 = 5;
/// The bits of its carry behind the point: 31 duties fit into 16 bits.
const CARRY: u32 = 11;

impl LedChip for Apa102 {
    type Dither = CurrentDither;
    const BYTES: usize = 4;
    const CHANNELS: u32 = 3;

    fn dither(index: u16) -> Self::Dither {
        // Below one duty at the least current: a strip that is faint begins without a flash.
        let carries = [0, 1, 2]
            .map(|channel| index.wrapping_mul(3).wrapping_add(channel).wrapping_mul(40_503) >> (16 - CARRY));
        CurrentDither { carries }
    }

    fn current<S: Scalar>(light: Rgb<S>) -> u32 {
        LedOrder::current(light)
    }

    #[inline]
    fn write<S: Scalar>(self, light: Rgb<S>, factor: u32, dither: &mut Self::Dither, bytes: &mut [u8]) {
        // In units of 2^-16 of a duty at the least current: at most 255 * 31 * 2^16, of 32 bits.
        let light = duties(light, factor).map(|light| light * MOST_CURRENT);
        let most = light.red.max(light.green).max(light.blue);
        let last = u32::from(Pwm8::LAST);
        let shift = (0..POWERS).find(|shift| most <= last << 16 << shift);
        let current = shift.map_or(MOST_CURRENT, |shift| 1 << shift);
        let [red, green, blue] = &mut dither.carries;
        let duty = |light: u32, carry: &mut u16| {
            let sum = light.div_ceil(1 << (16 - CARRY)) + u32::from(*carry);
            let whole = sum >> CARRY;
            // By a product, because a small processor divides by a call: 8457 / 2^18 is a 31st, exact below 2^13.
            let duty = shift.map_or((whole * 8457) >> 18, |shift| whole >> shift);
            // A carry of a larger current may be more than one duty.
            let duty = duty.min(last);
            *carry = (sum - ((duty * current) << CARRY)) as u16;
            duty as u8
        };
        let duties = Rgb::new(duty(light.red, red), duty(light.green, green), duty(light.blue, blue));
        let [first, second, third] = self.0.ordered(duties);
        if let Ok(bytes) = <&mut [u8; 4]>::try_from(bytes) {
            *bytes = [0xe0 | current as u8, first, second, third];
        }
    }
}

/// LEDs with duties of 16 bits: HD108 and NS108, of [`LedOrder::Grb`] or [`LedOrder::Rgb`].
///
/// The three currents of five bits are 31. A strip begins with sixteen bytes of 0, and ends with ones, a bit for each
/// LED at least.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Hd108(pub LedOrder);

impl LedChip for Hd108 {
    type Dither = Rgb<TemporalDither<16>>;
    const BYTES: usize = 8;
    const CHANNELS: u32 = 3;

    fn dither(index: u16) -> Self::Dither {
        Rgb::new(0, 1, 2).map(|channel| phase(index, channel, 3))
    }

    fn current<S: Scalar>(light: Rgb<S>) -> u32 {
        LedOrder::current(light)
    }

    #[inline]
    fn write<S: Scalar>(self, light: Rgb<S>, factor: u32, dither: &mut Self::Dither, bytes: &mut [u8]) {
        let duty =
            |light: S, dither: &mut TemporalDither<16>| dither.next_dimmed(light, factor).to_be_bytes();
        let (red, green) = (duty(light.red, &mut dither.red), duty(light.green, &mut dither.green));
        let duties = Rgb::new(red, green, duty(light.blue, &mut dither.blue));
        if let Ok(bytes) = <&mut [u8; 8]>::try_from(bytes) {
            let [[a, b], [c, d], [e, f]] = self.0.ordered(duties);
            *bytes = [0xff, 0xff, a, b, c, d, e, f];
        }
    }
}
