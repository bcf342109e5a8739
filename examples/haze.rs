//! Draws the beams of spotlights in haze across an empty view, as PNG. Seen from the side are a
//! soft edge, a hard edge and a hotspot. One more beam points past the eye, and one away from it.
//!
//! `cargo run --release --example haze > docs/haze.png`.

use std::io::{self, BufWriter};

use luminaire::{
    Angle, Cone, Rgb, SpotLight, Vec3,
    display::{clip, encode_srgb},
    falloff::{Falloff, Hard, Soft},
    haze::{Haze, ViewRay},
};

const WIDTH: usize = 960;
const HEIGHT: usize = 400;
const EYE: Vec3<f32> = Vec3::new(0.0, 1.7, 8.0);

/// A beam in haze, as a function of a view ray.
type Beam = Box<dyn Fn(&ViewRay) -> Rgb<f32>>;

/// The beam of a spotlight at `from` that is aimed at `to`.
fn beam<P: Falloff + 'static>(from: [f32; 3], to: [f32; 3], cone: Cone<P>, color: Rgb<f32>) -> Beam {
    let [from, to] = [from, to].map(|[x, y, z]| Vec3::new(x, y, z));
    let spot = SpotLight::new(from, to.zip(from, |t, f| t - f), cone)
        .and_then(|spot| spot.with_intensity(120.0))
        .and_then(|spot| spot.with_color(color)?.compile::<f32>())
        .expect("a sound light");
    let beam = spot.in_haze(&Haze::new(0.03).expect("a sound density"));
    Box::new(move |view| {
        let light = beam.in_scattering(view);
        spot.color().map(|channel| channel * light)
    })
}

fn cone<P: Falloff>(falloff: P, field: f32) -> Cone<P> {
    Cone::from_field(falloff, Angle::degrees(field)).expect("a sound angle")
}

fn main() -> io::Result<()> {
    let hotspot = cone(Soft, 24.0).with_inner(Angle::degrees(14.0)).expect("a sound hotspot");
    let beams = [
        beam([-5.0, 4.5, 0.0], [-4.0, 0.0, 0.0], cone(Soft, 24.0), Rgb::new(1.0, 0.8, 0.5)),
        beam([-2.0, 4.5, 0.0], [-2.0, 0.0, 1.0], cone(Hard, 24.0), Rgb::new(0.5, 0.7, 1.0)),
        beam([1.0, 4.5, 0.0], [1.2, 0.0, 0.5], hotspot, Rgb::new(1.0, 0.5, 0.6)),
        beam([3.5, 4.0, -3.0], [2.0, 1.2, 6.0], cone(Soft, 10.0), Rgb::new(0.6, 1.0, 0.7)),
        beam([6.0, 0.3, 7.0], [4.5, 2.5, -8.0], cone(Hard, 8.0), Rgb::new(0.9, 0.6, 1.0)),
    ];
    let pixels: Vec<u8> = (0..WIDTH * HEIGHT)
        .flat_map(|i| {
            let (x, y) = ((i % WIDTH) as f32 + 0.5, (i / WIDTH) as f32 + 0.5);
            let scale = 12.0 / WIDTH as f32;
            let (half_width, half_height) = (WIDTH as f32 / 2.0, HEIGHT as f32 / 2.0);
            let target = Vec3::new((x - half_width) * scale, 2.3 - (y - half_height) * scale, 0.0);
            let view = ViewRay { length: f32::INFINITY, ..ViewRay::between(EYE, target) };
            let light = beams.iter().map(|beam| beam(&view)).fold(Rgb::default(), Rgb::plus::<f32>);
            let color = clip::<f32>(light).map(encode_srgb);
            [color.red, color.green, color.blue]
        })
        .collect();
    let mut encoder = png::Encoder::new(BufWriter::new(io::stdout().lock()), WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&pixels)?;
    Ok(())
}
