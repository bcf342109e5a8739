//! A ball on a floor in [retrofire](https://docs.rs/retrofire-core): its fragment shader asks luminaire
//! for the colour of a point.

use luminaire::{Error, Rgb, Scalar, display::encode_srgb, light::SurfacePoint};
use retrofire_core::math::Matrix;
use retrofire_core::prelude::{Buf2, Color3, Context, Dims, Frag, Normal3, Point3, ProjMat3, Vertex3};
use retrofire_core::prelude::{pt3, rgb, tri, vec3, vertex, viewport};
use retrofire_core::render::{World, render, shader};
use scene::{HEIGHT, Picture, WIDTH, ambient, ball, floor, lights, to_clip, white};

fn draw() -> Result<Picture, Error> {
    let (white, lights, ambient) = (white::<f32>()?, lights()?, ambient::<f32>()?);
    let shader = shader::new(
        |v: Vertex3<Normal3, World>, to_clip: &ProjMat3<World>| {
            vertex(to_clip.apply(&v.pos), (v.pos, v.attrib))
        },
        |frag: Frag<(Point3<World>, Normal3)>, _: &ProjMat3<World>| {
            let (point, normal) = frag.var;
            // glue
            let surface = SurfacePoint::matte(point.0.into(), f32::normalize(normal.0.into()));
            let Rgb { red, green, blue } = white.color(&surface, &lights, ambient).map(encode_srgb);
            rgb(red, green, blue).to_rgba()
            // end of glue
        },
    );
    let dims = Dims(WIDTH as u32, HEIGHT as u32);
    let mut buffer = Buf2::<Color3>::new(dims);
    let [x, y, z, w] = to_clip();
    let to_clip = Matrix::new([x, y.map(|part| -part), z, w]); // down, so that triangles turn round
    // The ball is behind nothing, so that it needs no depth buffer if it is drawn last.
    for mesh in [floor(8), ball(64)] {
        let vertices = mesh.points.iter().zip(&mesh.normals);
        let vertices: Vec<_> =
            vertices.map(|([x, y, z], [u, v, w])| vertex(pt3(*x, *y, *z), vec3(*u, *v, *w))).collect();
        let triangles: Vec<_> = mesh.triangles.iter().map(|[a, b, c]| tri(*a, *c, *b)).collect();
        render(
            triangles,
            vertices,
            &shader,
            &to_clip,
            viewport(dims.into()),
            &mut buffer,
            &Context::default(),
        );
    }
    Ok(Picture(buffer.data().iter().map(|color| color.0).collect()))
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
        let found = picture.agreement::<f32>();
        // Half a code by rounding; on the ball also the chords of its 64 segments.
        let bounds = [0.6, 5.0];
        let (source, folder) = (include_str!("main.rs"), env!("CARGO_MANIFEST_DIR"));
        scene::check("retrofire 0.4", source, folder, &picture, found, bounds);
    }
}
