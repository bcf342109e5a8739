//! A ball on a floor in [euc](https://docs.rs/euc): its fragment shader asks luminaire for the colour
//! of a point.

use euc::{Pipeline, buffer::Buffer2d, rasterizer::Triangles};
use luminaire::light::{CompiledSpotLight, SurfacePoint};
use luminaire::{Error, Rgb, Scalar, display::encode_srgb, falloff::Soft, light::CompiledMaterial};
use scene::{HEIGHT, Mesh, Picture, WIDTH, ambient, ball, floor, lights, to_clip, white};
use vek::{Mat4, Vec3, Vec4};

struct Lit {
    mesh: Mesh,
    to_clip: Mat4<f32>,
    white: CompiledMaterial<f32>,
    lights: [CompiledSpotLight<f32, Soft>; 2],
    ambient: Rgb<f32>,
}

impl Pipeline for Lit {
    type Vertex = usize;
    type VsOut = (Vec3<f32>, Vec3<f32>); // point and normal
    type Pixel = [u8; 3];

    fn vert(&self, vertex: &usize) -> ([f32; 4], Self::VsOut) {
        let [point, normal] = [self.mesh.points[*vertex], self.mesh.normals[*vertex]].map(Vec3::from);
        ((self.to_clip * Vec4::from_point(point)).into_array(), (point, normal))
    }

    fn frag(&self, (point, normal): &Self::VsOut) -> [u8; 3] {
        // glue
        let (point, normal) = (point.into_array().into(), normal.into_array().into());
        let surface = SurfacePoint::matte(point, f32::normalize(normal));
        self.white.color(&surface, &self.lights, self.ambient).map(encode_srgb).into()
        // end of glue
    }
}

fn draw() -> Result<Picture, Error> {
    let mut color = Buffer2d::new([WIDTH, HEIGHT], [0; 3]);
    let mut depth = Buffer2d::new([WIDTH, HEIGHT], f32::INFINITY);
    for mesh in [floor(8), ball(64)] {
        let vertices = mesh.triangles.concat();
        let to_clip = Mat4::from_row_arrays(to_clip());
        let lit = Lit { mesh, to_clip, white: white()?, lights: lights()?, ambient: ambient::<f32>()? };
        lit.draw::<Triangles<_>, _>(&vertices, &mut color, Some(&mut depth));
    }
    Ok(Picture(color.as_ref().to_vec()))
}

fn main() -> Result<(), Error> {
    draw()?.write("picture.png");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn picture_is_what_the_kernel_computes() {
        let picture = draw().expect("valid lights");
        let found = picture.agreement::<f32>(|_, _| false);
        // Half a code by rounding; on the ball also the chords of its 64 segments.
        let bounds = [0.6, 5.0];
        let (source, folder) = (include_str!("main.rs"), env!("CARGO_MANIFEST_DIR"));
        scene::check("euc 0.5", source, folder, &picture, found, bounds);
    }
}
