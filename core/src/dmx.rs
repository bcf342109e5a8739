//! DMX512: the slots of a universe turn, zoom, dim and colour a light, in integers.
//!
//! A console sends a *universe* of up to 512 bytes, the *slots*, up to 44 times a second. A *patch* says which of them a
//! fixture reads. Each [`Channel`] of it is one quantity, of one slot or of a coarse and a fine one. [`Patch::state`] reads
//! them, and [`State::light`] is the light that the fixture then has, for every evaluation of the kernel:
//!
//! ```
//! use luminaire::{Angle, Cone, Fx16, SpotLight, dmx::{Channel, Patch}};
//!
//! // A moving head at address 21 that hangs 4 m above the floor: pan and tilt of 16 bits, a dimmer, and a zoom of 10 to 40 degrees.
//! let patch = Patch::new()
//!     .with_pan(Channel::degrees(-270.0, 270.0)?.at_fine(21, 22)?)
//!     .with_tilt(Channel::degrees(-135.0, 135.0)?.at_fine(23, 24)?)
//!     .with_dimmer(Channel::share(0.0, 1.0)?.at(25)?)
//!     .with_zoom(Channel::share(0.0, 1.0)?.at(26)?);
//! let narrow = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], Cone::soft(Angle::degrees(10.0))?)?.with_intensity(16.0)?;
//! let ends = narrow.compile_zoom::<Fx16>(&Cone::soft(Angle::degrees(40.0))?)?;
//!
//! let mut universe = [0; 512];
//! universe[20..26].copy_from_slice(&[0x80, 0, 0xd5, 0x54, 255, 128]); // in the middle, tilted by 90 degrees
//! let light = patch.state(&universe).light(&ends);
//! let ahead = Fx16::point([0.0, 4.0, -3.0]);
//! assert!(light.irradiance(ahead, Fx16::normal([0.0, 0.0, 1.0])).to_f32() > 1.7);
//! # Ok::<(), luminaire::Error>(())
//! ```
//!
//! Lengths are y up. Without a pan and a tilt the beam points down, as that of a fixture that hangs: the axes and
//! directions are those of GDTF (DIN SPEC 15800), where pan turns about the vertical, counterclockwise as seen from above, and
//! tilt by 90 degrees aims away from the viewer of the fixture's front, along -z. A fixture that stands or hangs otherwise has a
//! [mount](Patch::with_mount).
//!
//! `export/c/src/luminaire_dmx.h` has the same operations in C, with the same bits.

use crate::{
    attenuation::Attenuation,
    color::Rgb,
    error::{Error, Expected, Parameter},
    falloff::Falloff,
    light::DirectionalLight,
    number::{Scalar, Word},
    shade::CompiledSpotLight,
    vec3::Vec3,
};

/// Fraction bits of a value: 1 is full scale, all of the zoom, or a whole turn.
const BITS: u32 = 24;

/// Fraction bits of a direction.
const UNIT_BITS: u32 = 30;

/// One quantity of a fixture: the value at 0, that at the largest number of its slots, and linear between.
///
/// A channel without a slot has its first value always.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Channel {
    /// The coarse and the fine slot, from 1; 0 for none.
    slots: [u16; 2],
    /// The value at 0 and at the largest number, with 24 fraction bits.
    ends: [i32; 2],
}

impl Channel {
    /// Creates a channel of an angle in degrees, which may exceed a turn: such as -270 to 270 for a pan.
    ///
    /// # Errors
    /// An end outside of -18,000 to 18,000 degrees, or NaN.
    pub fn degrees(from: f32, to: f32) -> Result<Self, Error> {
        Self::new([from, to], [-18_000.0, 18_000.0], 360.0)
    }

    /// Creates a channel of a share of full scale: 1 to 0 for a filter that takes light away.
    ///
    /// # Errors
    /// An end outside of 0 to 1, or NaN.
    pub fn share(from: f32, to: f32) -> Result<Self, Error> {
        Self::new([from, to], [0.0, 1.0], 1.0)
    }

    fn new(ends: [f32; 2], [least, most]: [f32; 2], one: f32) -> Result<Self, Error> {
        for value in ends {
            if !(least..=most).contains(&value) {
                let accepted = Expected::Between(least, most);
                return Err(Error { parameter: Parameter::ChannelValue, value, accepted });
            }
        }
        let steps = |value: f32| {
            let steps = f64::from(value) / f64::from(one) * f64::from(1 << BITS);
            (if steps < 0.0 { steps - 0.5 } else { steps + 0.5 }) as i32
        };
        Ok(Self { slots: [0; 2], ends: ends.map(steps) })
    }

    /// Creates the channel of these slots and ends: what [`slots`](Self::slots) and [`ends`](Self::ends) return.
    pub const fn from_parts(slots: [u16; 2], ends: [i32; 2]) -> Self {
        Self { slots, ends }
    }

    /// Returns the channel of one slot of the universe, from 1 to 512.
    ///
    /// # Errors
    /// A slot outside of 1 to 512.
    pub fn at(self, slot: u16) -> Result<Self, Error> {
        Ok(Self { slots: [checked(slot)?, 0], ..self })
    }

    /// Returns the channel of 16 bits, of two slots of the universe, from 1 to 512.
    ///
    /// # Errors
    /// A slot outside of 1 to 512.
    pub fn at_fine(self, coarse: u16, fine: u16) -> Result<Self, Error> {
        Ok(Self { slots: [checked(coarse)?, checked(fine)?], ..self })
    }

    /// Returns the numbers of the coarse and of the fine slot; 0 for none.
    pub fn slots(&self) -> [u16; 2] {
        self.slots
    }

    /// Returns the ends in steps of 2^-24 of a turn or of full scale.
    pub fn ends(&self) -> [i32; 2] {
        self.ends
    }

    /// Returns the value that the slots give, with 24 fraction bits: the nearest one. At either end it is that end.
    ///
    /// A byte is the coarse and the fine one of 16 bits, so that 255 is the largest number.
    fn value(self, universe: &[u8]) -> i32 {
        let byte = |slot: u16| {
            usize::from(slot).checked_sub(1).map(|index| universe.get(index).copied().unwrap_or(0))
        };
        let [coarse, fine] = self.slots.map(byte);
        let Some(coarse) = coarse else { return self.ends[0] };
        let number = u32::from(coarse) << 8 | u32::from(fine.unwrap_or(coarse));
        // Out of 65,535, as a fraction of 2^32: n (2^16 + 1) / 2^32 is n / (2^16 - 1) less a part of 2^32.
        let part = i64::from(number * 65_537);
        let [from, to] = self.ends.map(i64::from);
        (from + (((to - from).clamp(-MOST, MOST) * part + (1 << 31)) >> 32)) as i32
    }
}

/// The widest range of a channel, from constructors: 100 turns. More would not fit the product.
const MOST: i64 = 100 << BITS;

fn checked(slot: u16) -> Result<u16, Error> {
    let accepted = Expected::WholeBetween(1, 512);
    let refused = Error { parameter: Parameter::Slot, value: slot.into(), accepted };
    if (1..=512).contains(&slot) { Ok(slot) } else { Err(refused) }
}

/// The channels of a fixture.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Patch {
    pan: Channel,
    tilt: Channel,
    zoom: Channel,
    dimmer: Channel,
    color: Rgb<Channel>,
    white: Channel,
    /// The rows of the matrix that turns the fixture's own directions to those of the scene, with 30 fraction bits.
    mount: [[i32; 3]; 3],
}

impl Default for Patch {
    fn default() -> Self {
        Self::new()
    }
}

impl Patch {
    /// Creates a fixture that hangs, and has no channels: its light points down, is narrow, white and at full intensity.
    pub fn new() -> Self {
        let [zero, one] = [0, 1 << BITS].map(|end| Channel { slots: [0; 2], ends: [end; 2] });
        let unit = 1 << UNIT_BITS;
        let mount = [[unit, 0, 0], [0, unit, 0], [0, 0, unit]];
        Self::from_parts([zero, zero, zero, one, one, one, one, zero], mount)
    }

    /// Returns the patch with a channel that turns about the vertical.
    #[must_use]
    pub fn with_pan(self, pan: Channel) -> Self {
        Self { pan, ..self }
    }

    /// Returns the patch with a channel that turns about the horizontal axis of the head.
    #[must_use]
    pub fn with_tilt(self, tilt: Channel) -> Self {
        Self { tilt, ..self }
    }

    /// Returns the patch with a channel of the zoom: share 0 is the narrowest cone, 1 the widest.
    #[must_use]
    pub fn with_zoom(self, zoom: Channel) -> Self {
        Self { zoom, ..self }
    }

    /// Returns the patch with a channel of the intensity.
    #[must_use]
    pub fn with_dimmer(self, dimmer: Channel) -> Self {
        Self { dimmer, ..self }
    }

    /// Returns the patch with channels of the linear red, green and blue. Filters of cyan, magenta and yellow are channels from
    /// 1 to 0.
    #[must_use]
    pub fn with_color(self, color: Rgb<Channel>) -> Self {
        Self { color, ..self }
    }

    /// Returns the patch with a channel of white, which adds to each of the colours, up to full scale.
    #[must_use]
    pub fn with_white(self, white: Channel) -> Self {
        Self { white, ..self }
    }

    /// Returns the patch of a fixture that is mounted otherwise: the directions of the scene that are right, up and toward the
    /// viewer of its front where it hangs, of any length. A fixture that stands on the floor has `[1, 0, 0]`, `[0, -1, 0]` and
    /// `[0, 0, -1]`.
    ///
    /// # Errors
    /// A vector without a direction.
    pub fn with_mount(self, axes: [Vec3<f32>; 3]) -> Result<Self, Error> {
        let mut rows = [[0; 3]; 3];
        for (column, axis) in axes.into_iter().enumerate() {
            let unit = DirectionalLight::new(axis)?.direction();
            for (row, c) in rows.iter_mut().zip(<[f32; 3]>::from(unit)) {
                row[column] = (c * (1 << UNIT_BITS) as f32) as i32;
            }
        }
        Ok(Self { mount: rows, ..self })
    }

    /// Creates the patch of these channels and this mount: what [`channels`](Self::channels) and [`mount`](Self::mount) return.
    pub const fn from_parts(channels: [Channel; 8], mount: [[i32; 3]; 3]) -> Self {
        let [pan, tilt, zoom, dimmer, red, green, blue, white] = channels;
        Self { pan, tilt, zoom, dimmer, color: Rgb::new(red, green, blue), white, mount }
    }

    /// Returns the patch at another address: all slots are that many farther that `address` is from 1.
    ///
    /// # Errors
    /// An address outside of 1 to 512, or with which a channel has a slot beyond 512.
    pub fn at_address(self, address: u16) -> Result<Self, Error> {
        let farther = checked(address)? - 1;
        let moved = |channel: Channel| {
            let mut slots = channel.slots;
            for slot in &mut slots {
                *slot = if *slot == 0 { 0 } else { checked(slot.saturating_add(farther))? };
            }
            Ok(Channel { slots, ..channel })
        };
        let [pan, tilt, zoom, dimmer, red, green, blue, white] = self.channels().map(moved);
        Ok(Self::from_parts([pan?, tilt?, zoom?, dimmer?, red?, green?, blue?, white?], self.mount))
    }

    /// Returns the channels: pan, tilt, zoom, dimmer, red, green, blue and white.
    pub fn channels(&self) -> [Channel; 8] {
        let Rgb { red, green, blue } = self.color;
        [self.pan, self.tilt, self.zoom, self.dimmer, red, green, blue, self.white]
    }

    /// Returns the rows of the matrix of the mount, in steps of 2^-30.
    pub fn mount(&self) -> [[i32; 3]; 3] {
        self.mount
    }

    /// Returns what the slots of a universe say, of which the first is slot 1. A slot that the universe lacks counts as 0.
    ///
    /// Each angle is within 3.8e-7 radians of the exact one, half of it by the rounding of the ends, and within 5.3e-7 for
    /// the widest range. So the beam of a [light](State::light) is within 7.6e-7 radians, and in `f32` within 8.8e-7
    /// (derived). One step of a pan of 540 degrees and 16 bits is 1.4e-4.
    pub fn state(&self, universe: &[u8]) -> State {
        let [pan, tilt] = [self.pan, self.tilt].map(|channel| channel.value(universe));
        let product = |a: i32, b: i32| ((i64::from(a) * i64::from(b) + (1 << 29)) >> UNIT_BITS) as i32;
        let (across, down) = (sine(tilt), sine(tilt.wrapping_add(QUARTER)));
        let own = [-product(across, sine(pan)), -down, -product(across, sine(pan.wrapping_add(QUARTER)))];
        let axis = self.mount.map(|row| {
            let sum: i64 = row.into_iter().zip(own).map(|(a, b)| i64::from(a) * i64::from(b)).sum();
            ((sum + (1 << 29)) >> UNIT_BITS) as i32
        });
        let share = |channel: Channel| channel.value(universe).clamp(0, 1 << BITS);
        let white = share(self.white);
        State {
            axis,
            zoom: share(self.zoom),
            dimmer: share(self.dimmer),
            color: self.color.map(|channel| (share(channel) + white).min(1 << BITS)),
        }
    }
}

/// What a fixture does at a time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct State {
    /// The direction of the beam, with 30 fraction bits.
    axis: [i32; 3],
    /// The parts of the zoom, of the intensity and of each colour, with 24 fraction bits.
    zoom: i32,
    dimmer: i32,
    color: Rgb<i32>,
}

impl State {
    /// Returns the light of the fixture, from those of its narrowest and its widest zoom: aimed, zoomed, dimmed and filtered
    /// by the colours. All else is that of the first light, such as its position, its own colour and full intensity.
    #[must_use]
    pub fn light<S: Scalar, P: Falloff, A: Attenuation>(
        &self,
        [narrow, wide]: &[CompiledSpotLight<S, P, A>; 2],
    ) -> CompiledSpotLight<S, P, A> {
        let part = |steps: i32| S::of_linear(|| steps as f32 / (1 << BITS) as f32, || steps as u32);
        let filtered = |own: S, steps: i32| match own.word() {
            Word::Single(own) => S::of_linear(|| own * (steps as f32 / (1 << BITS) as f32), || 0),
            #[cfg(feature = "fixed")]
            own => {
                let product = u64::from(own.steps24()) * steps as u64;
                S::of_linear(|| 0.0, || ((product + (1 << (BITS - 1))) >> BITS) as u32)
            }
        };
        let color = narrow.color().zip(self.color, filtered);
        let light = narrow.zoomed(wide, part(self.zoom)).dimmed(part(self.dimmer)).with_color(color);
        light.aimed_along(S::along_integers(self.axis)).unwrap_or(light)
    }
}

/// A quarter of a turn.
const QUARTER: i32 = 1 << (BITS - 2);

/// The sine of a quarter turn times `x`, over `x`, in the square of `x`: interpolated at Chebyshev nodes, within 3e-11. The
/// first coefficient has 30 fraction bits, the others 32, and their signs alternate.
const SINE: [u32; 6] = [1_686_629_713, 2_774_394_665, 342_277_127, 20_107_567, 688_288, 14_739];

/// Returns the sine of an angle in steps of 2^-24 turns, with 30 fraction bits, within 2 units (exhaustive).
fn sine(turn: i32) -> i32 {
    let part = turn & (QUARTER - 1);
    let x = if turn & QUARTER == 0 { part } else { QUARTER - part } as u64;
    let square = ((x * x) >> 12).min(u32::MAX.into());
    let [first, rest @ ..] = SINE;
    let sum = rest.into_iter().rev().fold(0, |sum, c| u64::from(c) - ((square * sum) >> 32));
    let factor = u64::from(first) - ((square * sum) >> 34);
    let sine = ((x * factor + (1 << 21)) >> 22) as i32;
    if turn & (2 * QUARTER) == 0 { sine } else { -sine }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_is_within_two_units_at_all_angles() {
        let mut worst = 0.0_f64;
        for turn in 0..1 << BITS {
            let exact = libm::sin(f64::from(turn) * core::f64::consts::TAU / f64::from(1 << BITS));
            worst = worst.max((f64::from(sine(turn)) - exact * f64::from(1 << UNIT_BITS)).abs());
        }
        assert!((1.5..2.0).contains(&worst), "{worst} units");
        assert_eq!([i32::MIN, -QUARTER, i32::MAX].map(sine), [0, -sine(QUARTER), -sine(1)]);
    }
}
