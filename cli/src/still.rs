//! `luminaire still`: a wall that a light shines on.

use luminaire::display::encode_srgb_dithered;
use luminaire::dynamic::AnyLight;
use luminaire::light::LightModel;
use luminaire::{Rgb, Vec3};
use luminaire_exchange::Refusal;

use crate::arguments::Still;
use crate::model;
use crate::source::save;

/// The side of the picture in pixels.
const SIDE: usize = 512;

/// Writes the picture of a light. Returns whether none was refused.
pub(crate) fn still(options: &Still) -> Result<bool, Refusal> {
    let found = match options.source.load(&options.spot, true)? {
        Some(found) => found,
        None => options.source.own(model::light(&options.spot, None, options.source.kelvin)?)?,
    };
    match &found.lamps[..] {
        [] => {}
        [(lamp, usage)] => {
            let pixels = wall(&lamp.named(*usage)?.light, usage.throw)?;
            save("output", &options.output, png(&pixels)?)?;
        }
        lamps => {
            let count = lamps.len();
            return Err(Refusal::new(
                "lights",
                count,
                format_args!("--light with a number from 1 to {count}"),
            ));
        }
    }
    Ok(found.is_whole)
}

/// Returns the pixels, in sRGB with three bytes each, of a white wall across the axis of a light at the
/// throw. The picture shows a quarter more than the pool of light, and at most 90 degrees.
fn wall(light: &AnyLight, throw: f64) -> Result<Vec<u8>, Refusal> {
    let (position, axis) = match light {
        AnyLight::Spot(spot) => (spot.position(), spot.axis()),
        AnyLight::Point(point) => (point.position(), Vec3::new(0.0, -1.0, 0.0)),
        AnyLight::Directional(_) => {
            let expected = "a spotlight or a point light: a wall in the sun is one colour";
            return Err(Refusal::new("light", "directional", expected));
        }
    };
    let half = match light {
        AnyLight::Spot(spot) => (0.5 * spot.cone().outer().to_degrees() * 1.25).min(45.0),
        _ => 45.0,
    };
    let lit = light.compile::<f32>()?;
    let [x, y, z] = <[f32; 3]>::from(axis);
    // Any two directions across the axis.
    let across = if y.abs() < 0.9 { [z, 0.0, -x] } else { [0.0, -z, y] };
    let length = across.iter().map(|c| c * c).sum::<f32>().sqrt();
    let across = across.map(|c| c / length);
    let up = [y * across[2] - z * across[1], z * across[0] - x * across[2], x * across[1] - y * across[0]];
    let (throw, reach) = (throw as f32, throw as f32 * half.to_radians().tan());
    let origin = <[f32; 3]>::from(position);
    let place = |pixel: usize| (2.0 * (pixel as f32 + 0.5) / SIDE as f32 - 1.0) * reach;
    let normals = Vec3::new(-x, -y, -z).map(|c| [c; SIDE]);
    let color: Rgb<f32> = light.color();
    let mut pixels = Vec::new();
    for row in 0..SIDE {
        let coordinates = |i: usize| -> [f32; SIDE] {
            let middle = origin[i] + throw * [x, y, z][i];
            std::array::from_fn(|column| middle + place(column) * across[i] - place(row) * up[i])
        };
        let points = Vec3::new(coordinates(0), coordinates(1), coordinates(2));
        let mut arrived = [0.0; SIDE];
        lit.irradiance_each(columns(&points), columns(&normals), &mut arrived);
        for (column, irradiance) in (0..).zip(arrived) {
            // Without dither the edge of the pool is a staircase of codes.
            let code = |channel| encode_srgb_dithered(irradiance * channel, column, row as u32);
            pixels.extend(<[f32; 3]>::from(color).map(code));
        }
    }
    Ok(pixels)
}

fn columns(of: &Vec3<[f32; SIDE]>) -> Vec3<&[f32]> {
    Vec3::new(&of.x, &of.y, &of.z)
}

/// Returns the pixels as a PNG.
fn png(pixels: &[u8]) -> Result<Vec<u8>, Refusal> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, SIDE as u32, SIDE as u32);
    encoder.set_color(png::ColorType::Rgb);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(pixels));
    written.map_err(|error| Refusal::new("picture", "wall", error))?;
    Ok(bytes)
}
