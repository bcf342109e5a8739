//! The bytes of strips of addressable LEDs, within a limit of their current.

use super::pwm::{FULL, Pwm8, TemporalDither, rounded_up};
use crate::{color::Rgb, number::Scalar};

/// The order of the three bytes of an LED.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum LedOrder {
    /// Green, red, blue: WS2812, SK6812.
    Grb,
    /// Red, green, blue: WS2811, WS2815 of some makers.
    Rgb,
    /// Blue, green, red: APA102 after its byte of brightness.
    Bgr,
}

/// A strip of addressable LEDs with eight bits a channel: the order of its bytes, and its current.
///
/// An LED shows linear light in proportion to its duty, so no curve is applied. Temporal dither shows what
/// is between two duties.
///
/// ```
/// use luminaire::{Fx16, Rgb, display::{LedOrder, LedStrip, TemporalDither}};
/// let strip = LedStrip::new(LedOrder::Grb).with_limit(500, 20, 1);
/// let amber = Rgb::new(1.0, 0.35, 0.01).map(Fx16::from_f32);
/// // Phases that differ, so that LEDs of equal light do not flash together.
/// let mut dithers: [Rgb<_>; 8] =
///     std::array::from_fn(|i| [0, 1, 2].map(|c| TemporalDither::new(3 * i as u16 + c)).into());
/// let mut bytes = [0; 24];
/// assert_eq!(strip.write(&[amber; 8], &mut dithers, &mut bytes), 8);
/// assert_eq!(bytes[..3], [89, 255, 2]);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LedStrip {
    order: LedOrder,
    limit: Option<Limit>,
}

/// A limit of the current in milliamperes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Limit {
    most: u32,
    channel: u16,
    idle: u16,
}

impl LedStrip {
    /// Creates a strip without a limit of its current.
    pub const fn new(order: LedOrder) -> Self {
        Self { order, limit: None }
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

    /// Writes the three bytes of each LED, and returns the number of LEDs written: that of the shortest
    /// slice.
    ///
    /// Light is clipped to `[0, 1]`. The duties of all frames differ from the light, dimmed to the limit, as
    /// [`TemporalDither`] states. In no frame is the current more than the limit, if all LEDs dark do not
    /// exceed it: each duty is less than 1 above the light, and the limit counts these.
    pub fn write<S: Scalar>(
        &self,
        lights: &[Rgb<S>],
        dithers: &mut [Rgb<TemporalDither<8>>],
        bytes: &mut [u8],
    ) -> usize {
        let count = lights.len().min(dithers.len()).min(bytes.len() / 3);
        let lights = lights.get(..count).unwrap_or_default();
        let factor = self.limit.map_or(FULL, |limit| limit.factor(lights));
        let leds = lights.iter().zip(dithers).zip(bytes.chunks_exact_mut(3));
        for ((light, dither), bytes) in leds {
            let duty = |light: S, dither: &mut TemporalDither<8>| dither.next_dimmed(light, factor) as u8;
            let (red, green) = (duty(light.red, &mut dither.red), duty(light.green, &mut dither.green));
            let blue = duty(light.blue, &mut dither.blue);
            let ordered = match self.order {
                LedOrder::Grb => [green, red, blue],
                LedOrder::Rgb => [red, green, blue],
                LedOrder::Bgr => [blue, green, red],
            };
            bytes.iter_mut().zip(ordered).for_each(|(byte, duty)| *byte = duty);
        }
        count
    }
}

impl Limit {
    /// Returns the factor of all light in units of 2^-16, at most 1, rounded down.
    fn factor<S: Scalar>(&self, lights: &[Rgb<S>]) -> u32 {
        let Self { most, channel, idle } = *self;
        let leds = lights.len() as u64;
        // The light of channels that the current suffices for, in units of 2^-14 of a channel at full duty.
        let current = u64::from(most).saturating_sub(leds.saturating_mul(idle.into()));
        let full = (current << 14).checked_div(channel.into()).unwrap_or(u64::MAX >> 16);
        let dither = ((3 * leds) << 14).div_ceil(Pwm8::LAST.into());
        let available = full.saturating_sub(dither);
        let channels = lights.iter().flat_map(|light| [light.red, light.green, light.blue]);
        let needed: u64 = channels.map(|light| u64::from(rounded_up::<14>(light.word()))).sum();
        if needed <= available { FULL } else { (available << 16).checked_div(needed).unwrap_or(0) as u32 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fastrand::Rng;

    extern crate std;
    use std::{vec, vec::Vec};

    /// No frame exceeds the limit, a limit that is needed is used, and without it the mean is the light.
    fn assert_limit<S: Scalar>() {
        const FRAMES: usize = 64;
        let mut rng = Rng::with_seed(2812);
        for _ in 0..200 {
            let (count, channel, idle) = (rng.usize(1..60), rng.u16(1..40), rng.u16(0..4));
            let brightness = if rng.bool() { 1.0 } else { rng.f32() };
            let lights: Vec<_> = (0..count)
                .map(|_| Rgb::new((), (), ()).map(|()| S::from_f32((brightness * 1.2 * rng.f32()).min(1.0))))
                .collect();
            let dark = count as u32 * u32::from(idle);
            let white = dark + 3 * count as u32 * u32::from(channel);
            let most = rng.u32(dark..=white);
            let strip = LedStrip::new(LedOrder::Rgb).with_limit(most, channel, idle);
            let mut dithers = vec![[0, 1, 2].map(TemporalDither::new).into(); count];
            let mut sums = vec![0; 3 * count];
            let mut bytes = vec![0; 3 * count];
            for _ in 0..FRAMES {
                assert_eq!(strip.write(&lights, &mut dithers, &mut bytes), count);
                let duties: u32 = bytes.iter().copied().map(u32::from).sum();
                let current = f64::from(dark) + f64::from(duties) * f64::from(channel) / 255.0;
                assert!(current <= f64::from(most), "{strip:?}: {current} mA of {count} LEDs");
                sums.iter_mut().zip(&bytes).for_each(|(sum, byte)| *sum += u32::from(*byte));
            }
            let light = lights.iter().flat_map(|light| [light.red, light.green, light.blue]);
            let exact: Vec<_> = light.map(|light| f64::from(light.to_f32())).collect();
            // What the limit leaves for light, in channels at full duty, less what it counts for the dither.
            let full = f64::from(most - dark) / f64::from(channel) - 3.0 * count as f64 / 255.0;
            let factor = (full / exact.iter().sum::<f64>()).clamp(0.0, 1.0);
            for (sum, exact) in sums.iter().zip(&exact) {
                let mean = f64::from(*sum) / FRAMES as f64;
                assert!((mean - 255.0 * factor * exact).abs() < 0.05, "{strip:?}: {mean} of {exact}");
            }
        }
    }

    #[test]
    fn strips_keep_their_limit_and_the_mean_of_the_light() {
        assert_limit::<f32>();
        #[cfg(feature = "fixed")]
        assert_limit::<crate::Fx16>();
        #[cfg(feature = "fixed")]
        assert_limit::<crate::Fx32>();
    }
}
