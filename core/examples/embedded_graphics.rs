//! A lit wall in 16-bit integers on a display of `embedded-graphics` 0.8 or its core 0.4, which the
//! feature `embedded-graphics-core04` connects. `draw` runs with every driver that implements
//! `DrawTarget`; here the driver is an array, printed as characters.

use std::convert::Infallible;

use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics_core::prelude::{DrawTarget, OriginDimensions, Pixel, PointsIter, Size};
use luminaire::display::{self, clip};
use luminaire::{
    Angle, Cone, Fx16, Length, Rgb, SpotLight, Vec3, falloff::Falloff, light::CompiledSpotLight,
};

const WIDTH: usize = 80;
const HEIGHT: usize = 32;

/// Draws a wall that faces the light, 16 pixels to the metre.
fn draw<D: DrawTarget<Color = Rgb565>, F: Falloff>(
    display: &mut D,
    light: &CompiledSpotLight<Fx16, F>,
) -> Result<(), D::Error> {
    const NORMAL: Vec3<Fx16> = Fx16::normal([0.0, 0.0, 1.0]);
    let metres = |pixels: i32| Length::from_bits(pixels << (16 - 4)); // 16 fraction bits
    let area = display.bounding_box();
    let pixels = area.points().map(|at| {
        let point = Vec3::new(metres(at.x), metres(at.y), Length::ZERO);
        let color = clip(Rgb::lit(light.irradiance(point, NORMAL), light.color()));
        display::Rgb565::from_linear_dithered_fast(color, at.x as u32, at.y as u32).into()
    });
    display.fill_contiguous(&area, pixels)
}

/// A display in memory.
struct Panel([[Rgb565; WIDTH]; HEIGHT]);

impl OriginDimensions for Panel {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
    }
}

impl DrawTarget for Panel {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, color) in pixels {
            self.0[at.y as usize][at.x as usize] = color;
        }
        Ok(())
    }
}

fn main() -> Result<(), luminaire::Error> {
    // The angles of a data sheet, three metres before the wall. An intensity of 3 x 3 is full scale there.
    let cone = Cone::from_beam_and_field(Angle::degrees(22.0), Angle::degrees(40.0))?;
    let light = SpotLight::new([2.5, 1.0, 3.0], [0.0, 0.0, -1.0], cone)?;
    let light = light.with_intensity(9.0)?.with_color(Rgb::new(1.0, 0.8, 0.5))?.compile()?;
    let mut panel = Panel([[Rgb565::BLACK; WIDTH]; HEIGHT]);
    let Ok(()) = draw(&mut panel, &light);
    assert_eq!(panel.0[16][40], Rgb565::new(31, 58, 23), "the middle of the pool of light");
    assert_eq!(panel.0[16][0], Rgb565::BLACK, "outside the cone");
    for row in panel.0 {
        println!(
            "{}",
            String::from_utf8_lossy(&row.map(|color| b" .:-=+*#%@"[usize::from(color.g()) * 9 / 63]))
        );
    }
    Ok(())
}
