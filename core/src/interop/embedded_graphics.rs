//! Lossless conversions of colours from and to the colours of `embedded-graphics-core`, and drawing.
//!
//! | here | there |
//! |---|---|
//! | [`Gray1`] | `BinaryColor`: white is on |
//! | [`Gray2`], [`Gray4`], [`Gray8`] | the type of the same name |
//! | [`Rgb555`], [`Rgb565`], [`Rgb666`], [`Rgb888`] | the type of the same name, and with `Bgr` |
//! | [`Rgb<u8>`](Rgb) | `Rgb888`, `Bgr888` |
//!
//! The trait `ToBytes` of `embedded-graphics-core` chooses the byte order. `Rgb` types have red in
//! the upper bits, and `Bgr` types have blue in the upper bits. Most SPI displays expect big
//! endian: the upper byte first.
//!
//! ```
//! use embedded_graphics_core::pixelcolor::{Bgr565, Bgr888, Rgb565, Rgb888, raw::ToBytes};
//! use luminaire::{Rgb, display};
//!
//! let amber = Rgb::new(0xff_u8, 0x9e, 0x1a);
//! assert_eq!(Rgb888::from(amber).to_be_bytes(), [0xff, 0x9e, 0x1a]);
//! assert_eq!(Rgb888::from(amber).to_le_bytes(), [0x1a, 0x9e, 0xff]);
//! assert_eq!(Bgr888::from(amber).to_be_bytes(), [0x1a, 0x9e, 0xff]);
//!
//! let pixel = display::Rgb565::from_codes(amber);
//! assert_eq!(Rgb565::from(pixel).to_be_bytes(), [0b11111_100, 0b111_00011]);
//! assert_eq!(Rgb565::from(pixel).to_be_bytes(), pixel.to_be_bytes());
//! assert_eq!(Bgr565::from(pixel).to_be_bytes(), [0b00011_100, 0b111_11111]);
//! ```
//!
//! [`Area`] draws the drawables of [`draw`](crate::draw).

use core::marker::PhantomData;

use crate::{
    color::Rgb,
    display::{Gray1, Gray2, Gray4, Gray8, Pixel, Rgb555, Rgb565, Rgb666, Rgb888},
};
use embedded_graphics_core::{
    Drawable,
    draw_target::DrawTarget,
    geometry::{Point, Size},
    pixelcolor::{
        self, Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, PixelColor, RgbColor,
        raw::{RawData as _, RawU1, RawU2, RawU4, RawU8, RawU16, RawU24},
    },
    primitives::Rectangle,
};

/// A rectangle of a display whose rows of pixels a function writes: a drawable of [`draw`](crate::draw),
/// or several of them, one over another.
///
/// The part on the display is drawn in pieces of at most 64 pixels of a row. The function gets y, x and
/// the pixels from `(x, y)` on, which are 0 before it: black.
///
/// ```
/// use embedded_graphics_core::{prelude::*, pixelcolor, primitives::Rectangle};
/// use luminaire::{Rgb, display::Rgb565, draw::Gradient, interop::embedded_graphics::Area};
/// # fn main() -> Result<(), luminaire::Error> {
/// let sky: Gradient<Rgb565> =
///     Gradient::linear(&[Rgb::new(12, 18, 60), Rgb::new(190, 90, 80)], [0.0, 0.0], [0.0, 159.0])?;
/// let area = Area::new(Rectangle::new(Point::zero(), Size::new(240, 160)), |y, x, pixels| sky.row(y, x, pixels));
/// # let mut display = Display;
/// area.draw(&mut display).expect("a display");
/// # struct Display;
/// # impl OriginDimensions for Display {
/// #     fn size(&self) -> Size { Size::new(240, 160) }
/// # }
/// # impl DrawTarget for Display {
/// #     type Color = pixelcolor::Rgb565;
/// #     type Error = ();
/// #     fn draw_iter<I: IntoIterator<Item = Pixel<Self::Color>>>(&mut self, _: I) -> Result<(), ()> { Ok(()) }
/// # }
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Area<P, C, F> {
    rectangle: Rectangle,
    row: F,
    colors: PhantomData<fn(P) -> C>,
}

impl<P: Pixel, C, F: Fn(i32, i32, &mut [P])> Area<P, C, F> {
    /// Creates an area from its rectangle and the function that writes its rows.
    pub const fn new(rectangle: Rectangle, row: F) -> Self {
        Self { rectangle, row, colors: PhantomData }
    }
}

impl<P: Pixel, C: PixelColor + From<P>, F: Fn(i32, i32, &mut [P])> Drawable for Area<P, C, F> {
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        let visible = self.rectangle.intersection(&target.bounding_box());
        for y in visible.rows() {
            for x in visible.columns().step_by(64) {
                let mut pixels = [P::of_bits(0); 64];
                let piece = Rectangle::new(Point::new(x, y), Size::new(64, 1)).intersection(&visible);
                let pixels = pixels.get_mut(..piece.size.width as usize).unwrap_or_default();
                (self.row)(y, x, pixels);
                target.fill_contiguous(&piece, pixels.iter().map(|pixel| C::from(*pixel)))?;
            }
        }
        Ok(())
    }
}

/// Implements conversions between pixels and types with the same bits, and from these to types with
/// blue in the upper bits.
macro_rules! pixels {
    ($($name:ident: $same:ty, $raw:ident $(, $swapped:ident)?;)*) => {$(
        impl From<$name> for $same {
            fn from(pixel: $name) -> Self {
                $raw::new(pixel.0).into()
            }
        }

        impl From<$same> for $name {
            fn from(pixel: $same) -> Self {
                Self($raw::from(pixel).into_inner())
            }
        }

        $(
            impl From<$name> for $swapped {
                fn from(pixel: $name) -> Self {
                    <$same>::from(pixel).into()
                }
            }

            impl From<$swapped> for $name {
                fn from(pixel: $swapped) -> Self {
                    <$same>::from(pixel).into()
                }
            }
        )?
    )*};
}

pixels! {
    Gray1: BinaryColor, RawU1;
    Gray2: pixelcolor::Gray2, RawU2;
    Gray4: pixelcolor::Gray4, RawU4;
    Gray8: pixelcolor::Gray8, RawU8;
    Rgb555: pixelcolor::Rgb555, RawU16, Bgr555;
    Rgb565: pixelcolor::Rgb565, RawU16, Bgr565;
    Rgb666: pixelcolor::Rgb666, RawU24, Bgr666;
    Rgb888: pixelcolor::Rgb888, RawU24, Bgr888;
}

/// Implements conversions between codes of eight bits and types with their own channel order.
macro_rules! both_ways {
    ($($other:ty),*) => {$(
        impl From<Rgb<u8>> for $other {
            fn from(Rgb { red, green, blue }: Rgb<u8>) -> Self {
                Self::new(red, green, blue)
            }
        }

        impl From<$other> for Rgb<u8> {
            fn from(codes: $other) -> Self {
                Self::new(codes.r(), codes.g(), codes.b())
            }
        }
    )*};
}

both_ways!(pixelcolor::Rgb888, Bgr888);

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics_core::{
        geometry::Dimensions,
        pixelcolor::{IntoStorage as _, raw::ToBytes as _},
        primitives::PointsIter as _,
    };

    #[test]
    fn every_pixel_keeps_its_bits_and_comes_back() {
        macro_rules! assert_kept {
            ($($name:ident: $same:ty, $bits:literal $(, $swapped:ident)?;)*) => {$(
                // Of 2^24 pixels every 251st.
                for bits in (0..1_u32 << $bits).step_by(if $bits > 18 { 251 } else { 1 }) {
                    let pixel = $name(bits.try_into().expect("the bits of the pixel"));
                    let same = <$same>::from(pixel);
                    assert_eq!((u32::from(same.into_storage()), $name::from(same)), (bits, pixel));
                    $(
                        let swapped = $swapped::from(pixel);
                        assert_eq!((swapped.r(), swapped.g(), swapped.b()), (same.r(), same.g(), same.b()));
                        assert_eq!($name::from(swapped), pixel);
                    )?
                }
            )*};
        }
        assert_kept! {
            Gray2: pixelcolor::Gray2, 2;
            Gray4: pixelcolor::Gray4, 4;
            Gray8: pixelcolor::Gray8, 8;
            Rgb555: pixelcolor::Rgb555, 15, Bgr555;
            Rgb565: pixelcolor::Rgb565, 16, Bgr565;
            Rgb666: pixelcolor::Rgb666, 18, Bgr666;
            Rgb888: pixelcolor::Rgb888, 24, Bgr888;
        }
        assert_eq!([0, 1].map(|bit| BinaryColor::from(Gray1(bit))), [BinaryColor::Off, BinaryColor::On]);
        assert_eq!([BinaryColor::Off, BinaryColor::On].map(Gray1::from), [Gray1(0), Gray1(1)]);
        let color = Rgb::new(0xff, 0x9e, 0x1a);
        assert_eq!(Rgb565::from_codes(color).to_be_bytes(), pixelcolor::Rgb565::new(31, 39, 3).to_be_bytes());
    }

    /// A display of 100 x 5 pixels in memory, the first at (-10, -2); it accepts no others.
    struct Panel([[Option<Bgr565>; 100]; 5]);

    impl Dimensions for Panel {
        fn bounding_box(&self) -> Rectangle {
            Rectangle::new(Point::new(-10, -2), Size::new(100, 5))
        }
    }

    impl DrawTarget for Panel {
        type Color = Bgr565;
        type Error = core::num::TryFromIntError;

        fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Self::Error>
        where
            I: IntoIterator<Item = embedded_graphics_core::Pixel<Bgr565>>,
        {
            for embedded_graphics_core::Pixel(at, color) in pixels {
                let [x, y] = [usize::try_from(at.x + 10)?, usize::try_from(at.y + 2)?];
                self.0[y][x] = Some(color);
            }
            Ok(())
        }
    }

    #[test]
    fn an_area_draws_each_visible_pixel_once() {
        let place = |y: i32, x: i32| Rgb565((x + 200 * y) as u16);
        for (corner, size) in [((-20, -9), (200, 20)), ((-3, 0), (65, 2)), ((80, -9), (1 << 30, 1 << 30))] {
            let rectangle = Rectangle::new(Point::from(corner), Size::from(size));
            let area = Area::new(rectangle, |y, x, pixels: &mut [Rgb565]| {
                for (pixel, x) in pixels.iter_mut().zip(x..) {
                    *pixel = Rgb565(pixel.0 + place(y, x).0);
                }
            });
            let mut panel = Panel([[None; 100]; 5]);
            area.draw(&mut panel).expect("no pixel outside the display");
            for (point, found) in panel.bounding_box().points().zip(panel.0.as_flattened()) {
                let expected = rectangle.contains(point).then(|| place(point.y, point.x).into());
                assert_eq!(*found, expected, "{point}");
            }
        }
    }

    #[test]
    fn codes_of_eight_bits_keep_their_channels_and_come_back() {
        for code in 0..=u8::MAX {
            let color = Rgb::new(code, 1, 255 - code);
            let (rgb, bgr) = (pixelcolor::Rgb888::from(color), Bgr888::from(color));
            assert_eq!(rgb.to_be_bytes(), [code, 1, 255 - code]);
            assert_eq!(bgr.to_be_bytes(), [255 - code, 1, code]);
            assert_eq!((Rgb::from(rgb), Rgb::from(bgr)), (color, color));
        }
    }
}
