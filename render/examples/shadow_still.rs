//! temp
use luminaire::{CompiledSpot, Fx16, Projection, Rgb, Scalar, encode_srgb};
use luminaire_render::{Renderer, ShadowMap, stage};
use std::{error::Error, fs::File, io::BufWriter, time::Instant};

fn main() -> Result<(), Box<dyn Error>> {
    type S = f32;
    let mut renderer = Renderer::<S>::new(1280, 720)?;
    let scene = stage::scene();
    let mut camera = stage::camera();
    let yaw: f32 = std::env::args().nth(2).map_or(0.0, |a| a.parse().unwrap());
    camera.orbit(yaw, 0.05);
    camera.zoom(std::env::args().nth(3).map_or(1.0, |a| a.parse().unwrap()));
    renderer.draw_geometry(&scene, &camera);
    let side: usize = std::env::args().nth(1).unwrap().parse()?;
    let spots = stage::lights()?;
    let only: Option<usize> = std::env::args().nth(4).map(|a| a.parse().unwrap());
    let mut maps = vec![];
    for spot in &spots {
        let mut map = ShadowMap::<S>::new(side)?;
        let projection = Projection::of(spot)?;
        let turned = projection.turned(luminaire::Angle::degrees(1.0))?;
        let mut best = f64::MAX;
        for i in 0..40 {
            let start = Instant::now();
            map.draw(&scene, if i % 2 == 0 { &turned } else { &projection })?;
            best = best.min(start.elapsed().as_secs_f64());
        }
        map.draw(&scene, &projection)?;
        println!("{side}: {:.3} ms", best * 1e3);
        maps.push((spot.compile::<S>()?, map));
    }
    let (width, height) = renderer.size();
    let mut pixels = vec![];
    let start = Instant::now();
    for y in 0..height {
        for x in 0..width {
            let mut sum = Rgb::new(0.014, 0.016, 0.022);
            if let Some((point, normal, material)) = renderer.surface(x, y) {
                for (i, (spot, map)) in maps.iter().enumerate() {
                    if only.is_some_and(|o| o != i) {
                        continue;
                    }
                    let light = S::light_to_f32(spot.irradiance(point, normal))
                        * map.shadow().unwrap().visibility(point).to_f32();
                    sum = sum.zip(spot.color(), |s, c| s + light * c.to_f32());
                }
                let out = sum.zip(material.albedo, |s, a| encode_srgb(s * a));
                pixels.extend([out.red, out.green, out.blue, 255]);
            } else {
                pixels.extend([0, 0, 0, 255]);
            }
        }
    }
    println!("{:?}", start.elapsed());
    let mut encoder =
        png::Encoder::new(BufWriter::new(File::create("/tmp/shadow.png")?), width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&pixels)?;
    Ok(())
}
