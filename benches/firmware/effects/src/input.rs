//! Inputs of effects: words in memory that the compiler does not know, and sequences for counting.

use core::mem::MaybeUninit;
use core::ptr;

use luminaire::number::{Light16, Light32};
use luminaire::{Fx16, Fx32, Rgb, Scalar, attenuation::InverseSquare};
use luminaire_kernels::scene::{EYE, Population, Site, Sites};
use luminaire_kernels::{Format as _, Setting};

use crate::constants::{MATTE, NARROW};
use crate::format::{Color, Format, Light, Surface};
use crate::listed::Listed;
use crate::output::Output;

/// An input of an effect.
pub trait Input: Copy {
    /// Reads the input from memory whose content the compiler does not know.
    fn read() -> Self;

    /// The word that the empty loop loads.
    fn word(&self) -> u32;
}

/// A pixel's position in the picture.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// The pixel's column.
    pub x: u32,
    /// The pixel's row.
    pub y: u32,
}

macro_rules! inputs {
    ($($input:ty: |$value:ident| $word:expr;)*) => {$(
        impl Input for $input {
            #[inline(always)]
            fn read() -> Self {
                static mut MEMORY: MaybeUninit<$input> = MaybeUninit::zeroed();
                // SAFETY: the input consists of numbers, for which every bit pattern is valid, and
                // the memory is initialised to zero.
                unsafe { ptr::read_volatile(&raw const MEMORY).assume_init() }
            }

            #[inline(always)]
            fn word(&self) -> u32 {
                let $value = self;
                $word
            }
        }
    )*};
}

inputs! {
    Place: |place| place.x;
    Surface: |surface| Format::length_bits(surface.point.x);
    Rgb<f32>: |color| color.red.fold();
    Rgb<Fx16>: |color| color.red.fold();
    Rgb<Fx32>: |color| color.red.fold();
    Rgb<Light16>: |color| color.red.fold();
    Rgb<Light32>: |color| color.red.fold();
}

impl Input for () {
    fn read() {}

    fn word(&self) -> u32 {
        0
    }
}

impl<A: Input, B: Input> Input for (A, B) {
    #[inline(always)]
    fn read() -> Self {
        (A::read(), B::read())
    }

    #[inline(always)]
    fn word(&self) -> u32 {
        self.0.word()
    }
}

/// Runs an effect once: reads its input from memory and writes its output to memory.
#[inline(always)]
pub fn run<I: Input, O>(effect: impl FnOnce(I) -> O) {
    let output = effect(I::read());
    let mut memory = MaybeUninit::uninit();
    // SAFETY: the memory is a local variable of the output's type.
    unsafe { ptr::write_volatile(memory.as_mut_ptr(), output) };
}

/// Number of columns of the picture.
const WIDTH: u32 = 160;

/// Sequences of inputs, the same on every machine.
#[derive(Debug)]
pub struct Inputs {
    /// The surface points in the cone that face the light, those that face away, those outside, and those
    /// in a narrow cone.
    sites: [Sites; 4],
    /// The surface point that all of them are instead, if there is one.
    given: Option<Site>,
    /// The bits of a number in [0, 1).
    number: u32,
    /// Number of pixels so far.
    pixels: u32,
}

impl Default for Inputs {
    fn default() -> Self {
        let outer = Setting::standard().outer_versine();
        let sites = [
            Sites::new(Population::Lit, outer),
            Sites::new(Population::Away, outer),
            Sites::new(Population::Outside, outer),
            Sites::new(Population::Lit, NARROW),
        ];
        Self { sites, given: None, number: 0, pixels: 0 }
    }
}

impl Inputs {
    /// The inputs of one surface point.
    pub fn at(site: Site) -> Self {
        Self { given: Some(site), ..Self::default() }
    }

    fn site(&mut self, population: usize) -> Surface {
        let site = self.given.or_else(|| self.sites[population].next()).expect("an endless sequence");
        let [eye, point] = [EYE, site.point].map(|place| place.map(<Format as Scalar>::length));
        Surface::seen_from(eye, point, site.normal.map(Format::from_f32))
    }

    /// A surface point in the cone whose normal faces the light, and the direction to the eye.
    pub fn surface(&mut self) -> Surface {
        self.site(0)
    }

    /// A surface point in the cone that faces away from the light.
    pub fn away(&mut self) -> Surface {
        self.site(1)
    }

    /// A surface point outside the cone that faces the light.
    pub fn outside(&mut self) -> Surface {
        self.site(2)
    }

    /// A surface point in the narrowest cone that `Fx16` holds, whose normal faces the light.
    pub fn narrow(&mut self) -> Surface {
        self.site(3)
    }

    /// The light that a lit point reflects, some of it over full scale.
    pub fn light(&mut self) -> Light {
        MATTE.reflect(&self.surface(), &InverseSquare::CONSTANT)
    }

    /// The light that a lit point reflects and its pixel position, as in [`pixel`](Self::pixel).
    pub fn lit(&mut self) -> (Light, Place) {
        (self.light(), self.place())
    }

    /// A colour, its channels spread evenly from black to white.
    pub fn color(&mut self) -> Color {
        Rgb::new(self.channel(), self.channel(), self.channel())
    }

    /// A colour and its pixel position. Positions run from left to right and from top to bottom.
    pub fn pixel(&mut self) -> (Color, Place) {
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
