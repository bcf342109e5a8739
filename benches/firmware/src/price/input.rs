//! The inputs of the effects.

use luminaire::{Rgb, Scalar, attenuation::InverseSquare};
use luminaire_effects::constants::MATTE;
use luminaire_effects::{Color, Format, Light, Listed, Output, Place, Surface};
use luminaire_kernels::scene::{EYE, Population, Site, Sites};
use luminaire_kernels::{Format as _, Setting};

/// Number of columns of the picture.
const WIDTH: u32 = 160;

/// Sequences of inputs, the same on every machine.
pub(super) struct Inputs {
    sites: Sites,
    /// The bits of a number in [0, 1).
    number: u32,
    /// Number of pixels so far.
    pixels: u32,
}

impl Inputs {
    /// The sequences from their beginnings.
    pub(super) fn new() -> Self {
        let sites = Sites::new(Population::Lit, Setting::standard().outer_versine());
        Self { sites, number: 0, pixels: 0 }
    }

    fn site(&mut self) -> Site {
        self.sites.next().expect("an endless sequence")
    }

    /// A surface point in the cone whose normal faces the light, and the direction to the eye.
    pub(super) fn surface(&mut self) -> Surface {
        let site = self.site();
        let [eye, point] = [EYE, site.point].map(|place| place.map(Format::length));
        Surface::seen_from(eye, point, site.normal.map(Format::from_f32))
    }

    /// The light that a lit point reflects, some of it over full scale.
    pub(super) fn light(&mut self) -> Light {
        MATTE.reflect(&self.surface(), &InverseSquare::CONSTANT)
    }

    /// The light that a lit point reflects and its pixel position, as in [`pixel`](Self::pixel).
    pub(super) fn lit(&mut self) -> (Light, Place) {
        (self.light(), self.place())
    }

    /// A colour, its channels spread evenly from black to white.
    pub(super) fn color(&mut self) -> Color {
        Rgb::new(self.channel(), self.channel(), self.channel())
    }

    /// A colour and its pixel position. Positions run from left to right and from top to bottom.
    pub(super) fn pixel(&mut self) -> (Color, Place) {
        (self.color(), self.place())
    }

    fn place(&mut self) -> Place {
        let place = Place { x: self.pixels % WIDTH, y: self.pixels / WIDTH };
        self.pixels += 1;
        place
    }

    /// The next number in [0, 1): the fractional parts of multiples of the golden ratio, which are
    /// evenly spread however many are taken.
    fn channel(&mut self) -> Format {
        self.number = self.number.wrapping_add(0x9e37_79b9);
        Format::from_f32((self.number >> 8) as f32 / 16_777_216.0)
    }
}

/// An input of an effect.
pub(super) trait Input: Copy {
    /// The word that the empty loop loads.
    fn word(&self) -> u32;
}

impl Input for Surface {
    #[inline(always)]
    fn word(&self) -> u32 {
        Format::length_bits(self.point.x)
    }
}

impl<T: Output + Copy> Input for Rgb<T> {
    #[inline(always)]
    fn word(&self) -> u32 {
        self.red.fold()
    }
}

impl<T: Input> Input for (T, Place) {
    #[inline(always)]
    fn word(&self) -> u32 {
        self.0.word()
    }
}
