//! A ball on a floor on a display of [embedded-graphics](https://docs.rs/embedded-graphics), which
//! has no third dimension: a ray for each pixel finds the point that it sees.

use std::convert::Infallible;

use embedded_graphics::{
    framebuffer::{Framebuffer, buffer_size},
    image::GetPixel,
    mono_font::{MonoTextStyle, ascii::FONT_9X15},
    pixelcolor::{Rgb565, Rgb888, raw::BigEndian},
    prelude::*,
    text::{Alignment, Text},
};
use luminaire::light::{CompiledMaterial, CompiledSpotLight, SurfacePoint};
use luminaire::{Fx16, Rgb, display, falloff::Soft};
use scene::{HEIGHT, Picture, Site, WIDTH, ambient, lights, seen, white};

/// The middle of the text, above its base line.
const TEXT: Point = Point::new(WIDTH as i32 / 2, HEIGHT as i32 - 12);

struct Lit {
    white: CompiledMaterial<Fx16>,
    lights: [CompiledSpotLight<Fx16, Soft>; 2],
    ambient: Rgb<luminaire::number::Light16>,
}

impl Lit {
    fn pixel(&self, at: Point) -> Rgb565 {
        let Site { point, normal, .. } = seen(f64::from(at.x) + 0.5, f64::from(at.y) + 0.5);
        let [point, normal] = [point, normal].map(|v| v.map(|part| part as f32));
        // glue
        let surface = SurfacePoint::matte(Fx16::point(point), Fx16::normal(normal));
        let color = self.white.color(&surface, &self.lights, self.ambient);
        display::Rgb565::from_linear_dithered(color, at.x as u32, at.y as u32).into()
        // end of glue
    }
}

/// Draws on any display that takes RGB565.
fn draw<D: DrawTarget<Color = Rgb565>>(display: &mut D, lit: &Lit) -> Result<(), D::Error> {
    let area = display.bounding_box();
    display.fill_contiguous(&area, area.points().map(|at| lit.pixel(at)))?;
    let style = MonoTextStyle::new(&FONT_9X15, Rgb565::WHITE);
    Text::with_alignment("warm and cool", TEXT, style, Alignment::Center).draw(display)?;
    Ok(())
}

type Panel = Framebuffer<
    Rgb565,
    <Rgb565 as PixelColor>::Raw,
    BigEndian,
    WIDTH,
    HEIGHT,
    { buffer_size::<Rgb565>(WIDTH, HEIGHT) },
>;

fn picture() -> Result<Picture, luminaire::Error> {
    let lit = Lit { white: white()?, lights: lights()?, ambient: ambient::<Fx16>()? };
    let mut panel = Box::new(Panel::new());
    let Ok(()): Result<(), Infallible> = draw(&mut *panel, &lit);
    let shown = panel.bounding_box().points().filter_map(|at| panel.pixel(at));
    Ok(Picture(shown.map(Rgb888::from).map(|color| [color.r(), color.g(), color.b()]).collect()))
}

fn main() -> Result<(), luminaire::Error> {
    picture()?.write("picture.png");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn picture_is_what_the_kernel_computes() {
        let picture = picture().expect("valid lights");
        let found = picture.agreement::<Fx16>(|_, y| y >= HEIGHT - 32);
        // A step of five bits is 8.2 codes, and dither shows the one above or the one below.
        let bounds = [9.0, 9.0];
        let (source, folder) = (include_str!("main.rs"), env!("CARGO_MANIFEST_DIR"));
        scene::check("embedded-graphics 0.8", source, folder, &picture, found, bounds);
    }
}
