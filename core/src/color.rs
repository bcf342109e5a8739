//! Linear colour, and its encoding for a display without a power function.

/// Red, green and blue.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Rgb<T> {
    /// The red channel.
    pub red: T,
    /// The green channel.
    pub green: T,
    /// The blue channel.
    pub blue: T,
}

impl<T> Rgb<T> {
    /// The colour of these channels.
    pub const fn new(red: T, green: T, blue: T) -> Self {
        Self { red, green, blue }
    }

    /// Applies `f` to each channel.
    #[inline(always)]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Rgb<U> {
        Rgb::new(f(self.red), f(self.green), f(self.blue))
    }
}

/// The sRGB code of a linear value: 0 for 0 and below, 255 for 1 and above; what is not a number becomes 0.
#[inline(always)]
pub fn encode_srgb(linear: f32) -> u8 {
    let _ = linear;
    0
}

/// The linear value of an sRGB code, in [0, 1].
pub fn decode_srgb(code: u8) -> f32 {
    let _ = code;
    0.0
}
