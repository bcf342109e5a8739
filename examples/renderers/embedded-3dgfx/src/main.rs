//! A ball on a floor in [embedded-3dgfx](https://docs.rs/embedded-3dgfx), without its feature `std` as
//! on a microcontroller: its `FragmentShader` asks luminaire for the pixel.

use std::convert::Infallible;

use embedded_3dgfx::pipeline::rasterize::raster::draw_triangle_zbuffered;
use embedded_3dgfx::{ZDepth, pipeline::shade::shader::FragmentShader};
use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_graphics_core::{Pixel, prelude::*};
use luminaire::light::{CompiledMaterial, CompiledSpotLight, SurfacePoint};
use luminaire::{Fx16, Rgb, display, falloff::Soft, number::Light16};
use nalgebra::{Matrix3, Matrix4, Vector3};
use scene::{EYE, HEIGHT, Picture, WIDTH, ambient, ball, floor, lights, ray, to_clip, white};

#[derive(Clone, Copy)]
struct Lights {
    white: CompiledMaterial<Fx16>,
    lights: [CompiledSpotLight<Fx16, Soft>; 2],
    ambient: Rgb<Light16>,
}

/// The shader of a triangle. The rasteriser passes no interpolants, so that the shader finds the point
/// by itself: where the view ray meets the triangle.
struct Lit {
    lights: Lights,
    points: Matrix3<f32>,
    normals: Matrix3<f32>,
    /// From a view ray to the weights of the vertices, up to a factor.
    to_weights: Matrix3<f32>,
}

impl FragmentShader for Lit {
    type Interpolants = ();

    fn shade(&self, x: i32, y: i32, _: ZDepth, (): ()) -> Rgb565 {
        let ray = ray(f64::from(x) + 0.5, f64::from(y) + 0.5).map(|part| part as f32);
        let weights = self.to_weights * Vector3::from(ray);
        let weights = weights / weights.sum();
        let (point, normal) = (self.points * weights, self.normals * weights);
        // glue
        let normal = Fx16::normalize(Fx16::normal(normal.into()));
        let surface = SurfacePoint::matte(Fx16::point(point.into()), normal);
        let color = self.lights.white.color(&surface, &self.lights.lights, self.lights.ambient);
        display::Rgb565::from_linear_dithered(color, x as u32, y as u32).into()
        // end of glue
    }
}

/// A display in memory.
struct Panel(Vec<Rgb565>);

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
            self.0[at.y as usize * WIDTH + at.x as usize] = color;
        }
        Ok(())
    }
}

fn draw() -> Result<Picture, luminaire::Error> {
    let lights = Lights { white: white()?, lights: lights()?, ambient: ambient::<Fx16>()? };
    let mut panel = Panel(vec![Rgb565::BLACK; WIDTH * HEIGHT]);
    let mut depth = vec![ZDepth::MAX; WIDTH * HEIGHT];
    let to_clip = Matrix4::from_fn(|row, column| to_clip()[row][column]);
    for mesh in [floor(8), ball(64)] {
        for triangle in &mesh.triangles {
            let screen = triangle.map(|vertex| {
                let clip = to_clip * Vector3::from(mesh.points[vertex]).push(1.0);
                let [x, y, z] = [clip.x / clip.w, clip.y / clip.w, clip.z / clip.w];
                let x = (x + 1.0) * WIDTH as f32 / 2.0;
                let y = (1.0 - y) * HEIGHT as f32 / 2.0;
                (Point::new(x.floor() as i32, y.floor() as i32), z)
            });
            let points = Matrix3::from_columns(&triangle.map(|vertex| mesh.points[vertex].into()));
            let normals = Matrix3::from_columns(&triangle.map(|vertex| mesh.normals[vertex].into()));
            let seen =
                Matrix3::from_columns(&triangle.map(|v| Vector3::from(mesh.points[v]) - Vector3::from(EYE)));
            let Some(to_weights) = seen.try_inverse() else { continue };
            let lit = Lit { lights, points, normals, to_weights };
            let (places, depths) = (screen.map(|(place, _)| place), screen.map(|(_, depth)| depth));
            draw_triangle_zbuffered(places, depths, &lit, &mut panel, &mut depth);
        }
    }
    let codes = panel.0.into_iter().map(Rgb888::from).map(|color| [color.r(), color.g(), color.b()]);
    Ok(Picture(codes.collect()))
}

fn main() -> Result<(), luminaire::Error> {
    draw()?.write("picture.png");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn picture_is_what_the_kernel_computes() {
        let picture = draw().expect("valid lights");
        let found = picture.agreement::<Fx16>();
        // A step of five bits is 8.2 codes, and dither shows the one above or the one below.
        let bounds = [9.0, 10.5];
        let (source, folder) = (include_str!("main.rs"), env!("CARGO_MANIFEST_DIR"));
        scene::check("embedded-3dgfx 0.7.2", source, folder, &picture, found, bounds);
    }
}
