//! Linear RGB colours.

mod temperature;

use core::ops::{Add, AddAssign};

use crate::{
    error::{Error, Parameter, check_components},
    number::Scalar,
};

/// Three channels, red, green and blue: a linear colour, linear light, or the codes of a display.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[repr(C)]
pub struct Rgb<T> {
    /// The red channel.
    pub red: T,
    /// The green channel.
    pub green: T,
    /// The blue channel.
    pub blue: T,
}

impl<T> Rgb<T> {
    /// Creates a colour from its channels.
    pub const fn new(red: T, green: T, blue: T) -> Self {
        Self { red, green, blue }
    }

    /// Applies `f` to each channel.
    #[inline]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Rgb<U> {
        Rgb::new(f(self.red), f(self.green), f(self.blue))
    }

    /// Applies `f` to each pair of channels.
    #[inline]
    pub fn zip<U, V>(self, other: Rgb<U>, mut f: impl FnMut(T, U) -> V) -> Rgb<V> {
        Rgb::new(f(self.red, other.red), f(self.green, other.green), f(self.blue, other.blue))
    }
}

impl<T> From<[T; 3]> for Rgb<T> {
    fn from([red, green, blue]: [T; 3]) -> Self {
        Self { red, green, blue }
    }
}

impl<T> From<Rgb<T>> for [T; 3] {
    fn from(Rgb { red, green, blue }: Rgb<T>) -> Self {
        [red, green, blue]
    }
}

impl<I: Copy> Rgb<I> {
    /// Returns light of this irradiance in a linear colour.
    #[inline]
    pub fn lit<S: Scalar<Irradiance = I>>(light: I, color: Rgb<S>) -> Self {
        color.map(|channel| S::filter(light, channel))
    }

    /// Multiplies the light by a colour, as the reflection from a surface of that colour does.
    #[must_use]
    #[inline]
    pub fn filtered<S: Scalar<Irradiance = I>>(self, color: Rgb<S>) -> Self {
        self.zip(color, S::filter)
    }
}

/// The sum of two lights; in fixed point it saturates.
impl<T: Add<Output = T>> Add for Rgb<T> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        self.zip(other, T::add)
    }
}

impl<T: Copy + Add<Output = T>> AddAssign for Rgb<T> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Rgb<f32> {
    /// Returns whether all channels are 0.
    pub(crate) fn is_black(self) -> bool {
        self == Self::default()
    }
}

/// Returns the colour if all channels are in [0, 1], or an error with the first channel outside.
pub(crate) fn checked_color(color: Rgb<f32>) -> Result<Rgb<f32>, Error> {
    let channels = [("red", color.red), ("green", color.green), ("blue", color.blue)];
    check_components(Parameter::Color, channels, 0.0, 1.0)?;
    Ok(color)
}
