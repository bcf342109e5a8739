//! The bytes of strips of addressable LEDs, within a limit of their current.

mod chip;

use core::mem;

use super::pwm::{FULL, Pwm8, rounded_up};
use crate::{color::Rgb, number::Scalar};

pub use chip::{Apa102, CurrentDither, Hd108, LedChip, LedOrder, Rgbw};

/// A strip of addressable LEDs: the family of its chips, its brightness, and its current.
///
/// An LED shows linear light in proportion to its duty, so no curve is applied. Temporal dither shows what
/// is between two duties.
///
/// ```
/// use luminaire::{Fx16, Rgb, display::{LedChip, LedOrder, LedStrip}};
/// let strip = LedStrip::new(LedOrder::Grb).with_limit(500, 20, 1);
/// let amber = Rgb::new(1.0, 0.35, 0.01).map(Fx16::from_f32);
/// // Phases that differ, so that LEDs of equal light do not flash together.
/// let mut dithers: [_; 8] = std::array::from_fn(|i| LedOrder::dither(i as u16));
/// let mut bytes = [0; 24];
/// assert_eq!(strip.write(&[amber; 8], &mut dithers, &mut bytes), 8);
/// assert_eq!(bytes[..3], [89, 255, 2]);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LedStrip<C = LedOrder> {
    chip: C,
    /// In units of 2^-16.
    brightness: u32,
    limit: Option<Limit>,
}

/// A limit of the current in milliamperes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Limit {
    most: u32,
    channel: u16,
    idle: u16,
}

impl<C: LedChip> LedStrip<C> {
    /// Creates a strip without a limit of its current.
    pub const fn new(chip: C) -> Self {
        Self { chip, brightness: FULL, limit: None }
    }

    /// Limits the current of the strip to `most` milliamperes.
    ///
    /// `channel` is the current of one channel of one LED at full duty, and `idle` that of an LED that is
    /// dark, both in milliamperes: 20 and 1 are on the safe side for a WS2812B. Where the light of a frame
    /// would take more current, all its light is dimmed by the same factor.
    #[must_use]
    pub const fn with_limit(self, most: u32, channel: u16, idle: u16) -> Self {
        Self { limit: Some(Limit { most, channel, idle }), ..self }
    }

    /// Dims all light by a share in `[0, 1]`, which is clipped, and rounded up to 2^-16.
    ///
    /// This keeps the hue of dim light, because the product has more bits than the light: `Fx16` has 16 steps at a
    /// thousandth of full scale. Let lights be as bright as the format takes, and dim the strip.
    ///
    /// ```
    /// use luminaire::{Fx16, Rgb, display::{LedChip, LedOrder, LedStrip}};
    /// let strip = LedStrip::new(LedOrder::Rgb).with_brightness(0.001_f32);
    /// let orange = Rgb::new(1.0, 0.5, 0.0).map(Fx16::from_f32);
    /// let (mut dither, mut bytes, mut sum) = ([LedOrder::dither(0)], [0; 3], [0_u32; 3]);
    /// for _ in 0..100_000 {
    ///     strip.write(&[orange], &mut dither, &mut bytes);
    ///     sum.iter_mut().zip(bytes).for_each(|(sum, duty)| *sum += u32::from(duty));
    /// }
    /// let ratio = f64::from(sum[1]) / f64::from(sum[0]);
    /// assert!((ratio - 0.5).abs() < 1e-3);
    /// ```
    #[must_use]
    pub fn with_brightness<S: Scalar>(self, share: S) -> Self {
        Self { brightness: rounded_up::<16>(share.word()), ..self }
    }
}

impl<C: LedChip> LedStrip<C> {
    /// Writes the bytes of each LED, and returns the number of LEDs written: that of the shortest slice.
    ///
    /// Light is clipped to `[0, 1]`. The duties of all frames differ from the light, dimmed to the limit, as
    /// [`TemporalDither`](super::TemporalDither) states. In no frame is the current more than the limit, if all LEDs dark
    /// do not exceed it: each duty is less than 1 above the light, and the limit counts these.
    pub fn write<S: Scalar>(&self, lights: &[Rgb<S>], dithers: &mut [C::Dither], bytes: &mut [u8]) -> usize {
        let count = lights.len().min(dithers.len()).min(bytes.len() / C::BYTES);
        let lights = lights.get(..count).unwrap_or_default();
        let needed = || lights.iter().map(|light| u64::from(C::current(*light))).sum();
        let factor =
            self.available(count).map_or(self.brightness, |available| self.factor(needed(), available));
        let leds = lights.iter().zip(dithers).zip(bytes.chunks_exact_mut(C::BYTES));
        for ((light, dither), bytes) in leds {
            self.chip.write(*light, factor, dither, bytes);
        }
        count
    }

    /// Begins a frame of `count` LEDs that are written one by one: the program needs no memory for the light of all.
    ///
    /// `load` is the same in all frames, at first the default. The light of a frame is dimmed by what the
    /// frame before needed. Where it suddenly needs more, the current is kept within the limit: the last LEDs of that
    /// one frame are darker.
    ///
    /// ```
    /// use luminaire::{Fx16, Rgb, display::{LedChip, LedLoad, LedOrder, LedStrip}};
    /// let strip = LedStrip::new(LedOrder::Grb).with_limit(300, 20, 1);
    /// let mut load = LedLoad::default();
    /// let mut duties = [0; 100];
    /// for number in 0..2 {
    ///     let mut frame = strip.frame(100, &mut load);
    ///     for led in 0..100 {
    ///         let mut bytes = [0; 3];
    ///         let light = Rgb::new(0.2, 0.2, 0.2).map(Fx16::from_f32);
    ///         // A dither by the number of the frame needs no memory, either.
    ///         frame.write(light, &mut LedOrder::dither(led as u16 + number), &mut bytes);
    ///         duties[led] = bytes.iter().map(|byte| u32::from(*byte)).sum();
    ///     }
    ///     assert!(100 + duties.iter().sum::<u32>() * 20 / 255 <= 300);
    /// }
    /// assert!(duties[99] > 0, "from the second frame on all are alike");
    /// ```
    pub fn frame<'a>(&self, count: usize, load: &'a mut LedLoad) -> LedFrame<'a, C> {
        let available = self.available(count);
        let needed = mem::take(&mut load.needed);
        let factor = available.map_or(self.brightness, |available| self.factor(needed, available));
        LedFrame { chip: self.chip, factor, rest: available.map(|available| available << 16), load }
    }

    /// Returns the light that the current suffices for, in units of 2^-14 of a channel at full duty; none without a
    /// limit.
    fn available(&self, leds: usize) -> Option<u64> {
        let Limit { most, channel, idle } = self.limit?;
        let leds = leds as u64;
        let current = u64::from(most).saturating_sub(leds.saturating_mul(idle.into()));
        let full = (current << 14).checked_div(channel.into()).unwrap_or(u64::MAX >> 16);
        let dither = (leds.saturating_mul(C::CHANNELS.into()) << 14).div_ceil(Pwm8::LAST.into());
        Some(full.saturating_sub(dither))
    }

    /// Returns the factor of all light, at most the brightness, rounded down.
    fn factor(&self, needed: u64, available: u64) -> u32 {
        let most = (available << 16).checked_div(needed).unwrap_or(u64::MAX);
        most.min(self.brightness.into()) as u32
    }
}

/// What the light of the last frame needed, for the next: see [`LedStrip::frame`].
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct LedLoad {
    /// In units of 2^-14 of a channel at full duty.
    needed: u64,
}

/// A frame of a strip that is written LED by LED: see [`LedStrip::frame`].
#[derive(Debug)]
pub struct LedFrame<'a, C> {
    chip: C,
    factor: u32,
    /// What is left of the current, in units of 2^-30 of that of a channel at full duty; none without a limit.
    rest: Option<u64>,
    load: &'a mut LedLoad,
}

impl<C: LedChip> LedFrame<'_, C> {
    /// Writes the bytes of the next LED: nothing where `bytes` has another length than [`LedChip::BYTES`].
    pub fn write<S: Scalar>(&mut self, light: Rgb<S>, dither: &mut C::Dither, bytes: &mut [u8]) {
        let mut factor = self.factor;
        if let Some(rest) = &mut self.rest {
            let needed = u64::from(C::current(light));
            self.load.needed = self.load.needed.saturating_add(needed);
            if needed * u64::from(factor) > *rest {
                factor = rest.checked_div(needed).unwrap_or(0) as u32;
            }
            *rest = rest.saturating_sub(needed * u64::from(factor));
        }
        self.chip.write(light, factor, dither, bytes);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::display::TemporalDither;
    use core::{array, fmt::Debug};
    use fastrand::Rng;

    extern crate std;
    use std::{vec, vec::Vec};

    /// A family of chips as its data sheet reads it: what the channels show of 1, and their current.
    trait Chip: LedChip + Debug {
        const ORDERED: Self;
        fn shown(bytes: &[u8]) -> ([f64; 3], f64);
    }

    fn byte(duty: u8) -> f64 {
        f64::from(duty) / 255.0
    }

    impl Chip for LedOrder {
        const ORDERED: Self = Self::Grb;
        fn shown(bytes: &[u8]) -> ([f64; 3], f64) {
            let shown = [1, 0, 2].map(|place| byte(bytes[place]));
            (shown, shown.iter().sum())
        }
    }

    impl Chip for Rgbw {
        const ORDERED: Self = Self(LedOrder::Grb);
        fn shown(bytes: &[u8]) -> ([f64; 3], f64) {
            (
                [1, 0, 2].map(|place| byte(bytes[place]) + byte(bytes[3])),
                bytes.iter().copied().map(byte).sum(),
            )
        }
    }

    impl Chip for Apa102 {
        const ORDERED: Self = Self(LedOrder::Bgr);
        fn shown(bytes: &[u8]) -> ([f64; 3], f64) {
            assert!(bytes[0] > 0xe0);
            let shown = [3, 2, 1].map(|place| byte(bytes[place]) * f64::from(bytes[0] & 31) / 31.0);
            (shown, shown.iter().sum())
        }
    }

    impl Chip for Hd108 {
        const ORDERED: Self = Self(LedOrder::Rgb);
        fn shown(bytes: &[u8]) -> ([f64; 3], f64) {
            assert_eq!(bytes[..2], [0xff; 2]);
            let shown =
                [2, 4, 6].map(|at| f64::from(u16::from_be_bytes([bytes[at], bytes[at + 1]])) / 65_535.0);
            (shown, shown.iter().sum())
        }
    }

    fn random<S: Scalar>(brightness: f32, rng: &mut Rng) -> Rgb<S> {
        let grey = rng.f32();
        let mut channel =
            || S::from_f32((brightness * 1.2 * if rng.u8(..4) > 0 { rng.f32() } else { grey }).min(1.0));
        Rgb::new(channel(), channel(), channel())
    }

    /// No frame exceeds the limit, a limit that is needed is used, and the mean is the light, dimmed to the brightness
    /// and to the limit; LED by LED, too, from the second frame on.
    fn assert_strip<C: Chip, S: Scalar>() {
        const FRAMES: usize = 64;
        let mut rng = Rng::with_seed(2812);
        for case in 0..150 {
            let (count, channel, idle) = (rng.usize(1..40), rng.u16(1..40), rng.u16(0..4));
            let bright = [1.0, rng.f32(), 0.01][case % 3];
            let lights: Vec<Rgb<S>> = (0..count).map(|_| random(bright, &mut rng)).collect();
            let share = if rng.bool() { 1.0 } else { rng.f32() };
            let dark = count as u32 * u32::from(idle);
            let white = dark + C::CHANNELS * count as u32 * u32::from(channel);
            let most = rng.u32(dark..=white);
            let strip = LedStrip::new(C::ORDERED).with_limit(most, channel, idle).with_brightness(share);
            let exact: Vec<_> = lights.iter().map(|light| light.map(|c| f64::from(c.to_f32()))).collect();
            let needed: f64 = exact.iter().map(|light| needed::<C>(*light)).sum();
            let full =
                f64::from(most - dark) / f64::from(channel) - f64::from(C::CHANNELS) * count as f64 / 255.0;
            let factor = (full / needed).clamp(0.0, share.into());
            for is_stream in [false, true] {
                let mut dithers: Vec<_> = (0..count as u16).map(C::dither).collect();
                let (mut bytes, mut load) = (vec![0; C::BYTES * count], LedLoad::default());
                let mut sums = vec![[0.0; 3]; count];
                for frame in 0..=FRAMES {
                    if is_stream {
                        let mut frame = strip.frame(count, &mut load);
                        let leds = lights.iter().zip(&mut dithers).zip(bytes.chunks_exact_mut(C::BYTES));
                        leds.for_each(|((light, dither), bytes)| frame.write(*light, dither, bytes));
                    } else {
                        assert_eq!(strip.write(&lights, &mut dithers, &mut bytes), count);
                    }
                    let shown: Vec<_> = bytes.chunks_exact(C::BYTES).map(C::shown).collect();
                    let current =
                        shown.iter().map(|led| led.1).sum::<f64>() * f64::from(channel) + f64::from(dark);
                    assert!(current <= f64::from(most) + 1e-9, "{strip:?}: {current} mA, frame {frame}");
                    let is_first = frame == 0;
                    let sums = sums.iter_mut().zip(&shown).filter(|_| !is_first);
                    sums.for_each(|(sum, (shown, _))| *sum = array::from_fn(|c| sum[c] + shown[c]));
                }
                for (sum, light) in sums.iter().zip(&exact) {
                    let light = [light.red, light.green, light.blue];
                    for (sum, light) in sum.iter().zip(light) {
                        let mean = 255.0 * sum / FRAMES as f64;
                        let expected = 255.0 * factor * light;
                        assert!(
                            (mean - expected).abs() < 0.08,
                            "{strip:?}, {is_stream}: {mean} of {expected}"
                        );
                    }
                }
            }
        }
    }

    /// The current of light in channels.
    fn needed<C: Chip>(light: Rgb<f64>) -> f64 {
        let white = if C::CHANNELS == 4 { light.red.min(light.green).min(light.blue) } else { 0.0 };
        light.red + light.green + light.blue - 2.0 * white
    }

    fn assert_strips<S: Scalar>() {
        assert_strip::<LedOrder, S>();
        assert_strip::<Rgbw, S>();
        assert_strip::<Apa102, S>();
        assert_strip::<Hd108, S>();
    }

    #[test]
    fn strips_keep_their_limit_and_the_mean_of_the_light() {
        assert_strips::<f32>();
        #[cfg(feature = "fixed")]
        assert_strips::<crate::Fx16>();
        #[cfg(feature = "fixed")]
        assert_strips::<crate::Fx32>();
    }

    /// Light that changes between all currents comes to the same as its mean.
    #[test]
    fn currents_of_an_apa102_lose_no_light_where_they_change() {
        let mut rng = Rng::with_seed(102);
        let strip = LedStrip::new(Apa102::ORDERED);
        let (mut dither, mut bytes) = ([Apa102::dither(5)], [0; 4]);
        let (mut shown, mut exact, mut currents) = ([0.0; 3], [0.0; 3], [false; 32]);
        for frame in 1..=100_000 {
            let light = random::<f32>(0.5_f32.powi(rng.i32(0..10)), &mut rng);
            strip.write(&[light], &mut dither, &mut bytes);
            currents[usize::from(bytes[0] & 31)] = true;
            let (now, light) = (Apa102::shown(&bytes).0, [light.red, light.green, light.blue]);
            for channel in 0..3 {
                shown[channel] += now[channel];
                exact[channel] += f64::from(light[channel]);
                // Less than one duty, and what each value is rounded up by.
                let most = 1.0 + f64::from(frame) * (0.5_f64.powi(13) + 0.5_f64.powi(11) / 31.0);
                assert!((shown[channel] - exact[channel]).abs() < most / 255.0, "{shown:?} {exact:?}");
            }
        }
        assert_eq!(currents.iter().filter(|is_used| **is_used).count(), 6);
    }

    /// The sum of the duties without memory, as the documentation of `LedChip::dither` states it.
    #[test]
    fn a_dither_by_the_number_of_the_frame_needs_no_memory() {
        let mut rng = Rng::with_seed(7);
        let mut most = 0.0_f64;
        let mut search = |step: u16| {
            for _ in 0..60 {
                let (start, light) = (rng.u16(..), rng.f32());
                let (mut sum, mut exact) = (0.0, 0.0);
                for frame in 0..=u16::MAX {
                    let mut dither = TemporalDither::<8>::new(start.wrapping_add(frame.wrapping_mul(step)));
                    sum += f64::from(dither.next(light));
                    exact += 255.0 * f64::from(light);
                    most = most.max((sum - exact).abs());
                }
            }
        };
        search(3);
        search(4);
        assert!(most < 12.0, "{most}");
    }
}
