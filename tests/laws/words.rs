//! Raw words, and the numbers and vectors that are made of them.

use super::format::Format;
use luminaire::{Vec3, light::SurfacePoint};

/// Words of any bits, taken one by one. After the last word come zeros.
///
/// Each bit of the first word decides whether one of the following numbers is any bit pattern or a
/// number of everyday size. A scene made only of arbitrary bit patterns is nearly always refused or
/// dark.
#[derive(Clone, Debug)]
pub struct Words<'a> {
    rest: &'a [u32],
    wild: u32,
}

impl<'a> Words<'a> {
    /// Starts with numbers of both kinds.
    pub fn new(words: &'a [u32]) -> Self {
        let mut words = Self::tame(words);
        words.wild = words.next();
        words
    }

    /// Starts with numbers of everyday size only.
    pub fn tame(words: &'a [u32]) -> Self {
        Self { rest: words, wild: 0 }
    }

    /// The next word.
    pub fn next(&mut self) -> u32 {
        let Some((first, rest)) = self.rest.split_first() else { return 0 };
        self.rest = rest;
        *first
    }

    /// Two words.
    pub fn wide(&mut self) -> u64 {
        u64::from(self.next()) << 32 | u64::from(self.next())
    }

    /// A random index below `count`.
    pub fn choice(&mut self, count: u32) -> u32 {
        self.next() % count
    }

    /// Whether the next value is an end of its domain: true for one draw in four.
    pub fn is_end(&mut self) -> bool {
        self.choice(4) == 3
    }

    /// One of these values.
    pub fn one_of<T: Copy, const N: usize>(&mut self, values: [T; N]) -> T {
        values[self.choice(N as u32) as usize]
    }

    /// Whether the next number is any bit pattern.
    fn is_wild(&mut self) -> bool {
        self.wild = self.wild.rotate_right(1);
        self.wild >> 31 == 1
    }

    /// A number from `least` to `most`.
    pub fn between(&mut self, least: f32, most: f32) -> f32 {
        least + (most - least) * (self.next() as f32 / u32::MAX as f32)
    }

    /// A number from `least` to `most`, or any bit pattern.
    pub fn number(&mut self, least: f32, most: f32) -> f32 {
        if self.is_wild() { f32::from_bits(self.next()) } else { self.between(least, most) }
    }

    /// Two numbers above zero. In half of all cases the second is larger by a power of two of ULPs,
    /// up to 2^15, because a fault in monotony shows between neighbours.
    pub fn pair(&mut self, most: f32) -> (f32, f32) {
        let one = self.number(most / 1_024.0, most);
        if self.choice(2) == 0 {
            return (one, self.number(most / 1_024.0, most));
        }
        (one, f32::from_bits(one.to_bits().saturating_add(1 << self.choice(16))))
    }

    /// Three numbers.
    pub fn numbers(&mut self, least: f32, most: f32) -> Vec3<f32> {
        Vec3::new(self.number(least, most), self.number(least, most), self.number(least, most))
    }

    /// Three coordinates on the grid that all formats share, within 8 of the origin.
    pub fn place(&mut self) -> Vec3<f32> {
        let mut on_grid = || (self.between(-8.0, 8.0) * 65_536.0).round() / 65_536.0;
        Vec3::new(on_grid(), on_grid(), on_grid())
    }

    /// A vector of unit length within the roundings of f32.
    pub fn direction(&mut self) -> Vec3<f32> {
        let v = Vec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0));
        let length = v.dot(v).sqrt();
        if length > 0.01 { v.map(|c| c / length) } else { Vec3::new(0.0, -1.0, 0.0) }
    }

    /// A position as a format stores it, with some components of any bits.
    pub fn point<S: Format>(&mut self, place: Vec3<f32>) -> Vec3<S::Length> {
        place.map(|c| if self.is_wild() { S::length_from_bits(self.wide()) } else { S::length(c) })
    }

    /// A normal whose components are those of a unit vector or any bits.
    pub fn normal<S: Format>(&mut self) -> Vec3<S> {
        self.direction()
            .map(|c| if self.is_wild() { S::scalar_from_bits(self.wide()) } else { S::from_f32(c) })
    }

    /// A surface point at `place`, with a normal and a direction to an eye.
    pub fn surface<S: Format>(&mut self, place: Vec3<f32>) -> SurfacePoint<S> {
        let (point, normal) = (self.point::<S>(place), self.normal());
        let view = S::axis(self.direction());
        let view = view.map(|c| if self.is_wild() { S::unit_from_bits(self.wide()) } else { c });
        SurfacePoint { point, normal, view }
    }
}
