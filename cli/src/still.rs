//! `luminaire still`: a wall that lights shine on.

use luminaire::display::encode_srgb_dithered;
use luminaire::dynamic::AnyLight;
use luminaire::light::LightModel;
use luminaire::{AmbientLight, Rgb, Vec3};
use luminaire_exchange::Refusal;

use crate::arguments::Still;
use crate::model;
use crate::source::save;

/// The side of the picture in pixels.
const SIDE: usize = 512;

/// Writes the picture of the lights. Returns whether none was refused.
pub(crate) fn still(options: &Still) -> Result<bool, Refusal> {
    let found = match options.source.load(&options.spot, true)? {
        Some(found) => found,
        None => options.source.own(model::light(&options.spot, None, options.source.kelvin)?)?,
    };
    let lights: Result<Vec<_>, _> =
        found.lamps.iter().map(|(lamp, usage)| Ok::<_, Refusal>(lamp.named(*usage)?.light)).collect();
    let ambient: Vec<_> = found.ambient.iter().map(|ambient| ambient.light).collect();
    if let Some((_, usage)) = found.lamps.first() {
        save("output", &options.output, png(&wall(&lights?, &ambient, usage.throw)?)?)?;
    } else if !ambient.is_empty() {
        return Err(one_color("ambient"));
    }
    Ok(found.is_whole)
}

/// A flat white wall of the picture.
struct Wall {
    /// The middle of the picture.
    middle: [f32; 3],
    /// The unit vectors along the lights, to the right and up.
    axis: [f32; 3],
    across: [f32; 3],
    up: [f32; 3],
    /// Half of the side.
    reach: f32,
}

impl Wall {
    /// Returns a wall at the throw, across the mean axis of the lights and behind the one that is farthest along it. It
    /// shows a quarter more than each pool of light, and of each at most 90 degrees.
    fn new(lights: &[AnyLight], throw: f32) -> Result<Self, Refusal> {
        let mut sum = [0.0; 3];
        for light in lights {
            let axis = match light {
                AnyLight::Spot(spot) => spot.axis(),
                AnyLight::Measured(light) => light.frame()[2],
                AnyLight::Directional(sun) => sun.direction(),
                AnyLight::Point(_) => continue,
            };
            sum = add(sum, axis.into());
        }
        let length = dot(sum, sum).sqrt();
        // Lights that shine against one another have no axis, and point lights none either.
        let axis = if length > 1e-3 { sum.map(|c| c / length) } else { [0.0, -1.0, 0.0] };
        let [x, y, z] = axis;
        // To the right and up for a viewer at the lights: of lights that point down, along x and -z.
        let across = if y.abs() < 0.9 { [-z, 0.0, x] } else { [-y, x, 0.0] };
        let across = across.map(|c| c / dot(across, across).sqrt());
        let up =
            [across[1] * z - across[2] * y, across[2] * x - across[0] * z, across[0] * y - across[1] * x];
        // Position, axis and half angle in degrees of the pools.
        let pools: Vec<([f32; 3], [f32; 3], f32)> = lights
            .iter()
            .filter_map(|light| match light {
                AnyLight::Spot(spot) => {
                    let half = (0.5 * spot.cone().outer().to_degrees() * 1.25).min(45.0);
                    Some((spot.position().into(), spot.axis().into(), half))
                }
                AnyLight::Measured(light) => Some((light.position().into(), light.frame()[2].into(), 45.0)),
                AnyLight::Point(point) => Some((point.position().into(), axis, 45.0)),
                AnyLight::Directional(_) => None,
            })
            .collect();
        let farthest = pools.iter().map(|(position, ..)| dot(*position, axis)).reduce(f32::max);
        let far = farthest.ok_or_else(|| one_color("directional"))? + throw;
        let mut ends = [[f32::INFINITY, f32::NEG_INFINITY]; 2];
        for (position, own, half) in pools {
            let (away, along) = (far - dot(position, axis), dot(own, axis));
            // A light along the wall, or away from it, has its pool in front of it.
            let way = if along > 0.3 { away / along } else { 0.0 };
            let (pool, radius) =
                (add(position, own.map(|c| way * c)), away.max(way) * half.to_radians().tan());
            for (ends, side) in ends.iter_mut().zip([across, up]) {
                *ends = [ends[0].min(dot(pool, side) - radius), ends[1].max(dot(pool, side) + radius)];
            }
        }
        let [right, upward] = ends.map(|[least, most]| f32::midpoint(least, most));
        let reach = ends.iter().map(|[least, most]| 0.5 * (most - least)).fold(0.0, f32::max);
        let middle = [0, 1, 2].map(|i| far * axis[i] + right * across[i] + upward * up[i]);
        Ok(Self { middle, axis, across, up, reach })
    }
}

/// Returns the pixels, in sRGB with three bytes each, of a white wall that lights and ambient light shine on.
fn wall(lights: &[AnyLight], ambient: &[AmbientLight], throw: f64) -> Result<Vec<u8>, Refusal> {
    let Wall { middle, axis, across, up, reach } = Wall::new(lights, throw as f32)?;
    let lit: Result<Vec<_>, _> = lights.iter().map(AnyLight::compile::<f32>).collect();
    let lit = lit?;
    let everywhere = ambient.iter().fold(Rgb::default(), |sum, light| sum + light.compile::<f32>());
    let place = |pixel: usize| (2.0 * (pixel as f32 + 0.5) / SIDE as f32 - 1.0) * reach;
    let normals = Vec3::from(axis).map(|c| [-c; SIDE]);
    let mut pixels = Vec::new();
    for row in 0..SIDE {
        let coordinates = |i: usize| -> [f32; SIDE] {
            std::array::from_fn(|column| middle[i] + place(column) * across[i] - place(row) * up[i])
        };
        let points = Vec3::new(coordinates(0), coordinates(1), coordinates(2));
        let mut sums = [everywhere; SIDE];
        for light in &lit {
            let mut arrived = [0.0; SIDE];
            light.irradiance_each(columns(&points), columns(&normals), &mut arrived);
            for (sum, irradiance) in sums.iter_mut().zip(arrived) {
                *sum += Rgb::lit(irradiance, light.color());
            }
        }
        for (column, sum) in (0..).zip(sums) {
            // Without dither the edge of the pool is a staircase of codes.
            pixels.extend(
                <[f32; 3]>::from(sum).map(|channel| encode_srgb_dithered(channel, column, row as u32)),
            );
        }
    }
    Ok(pixels)
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn add(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Refuses lights that light a wall evenly.
fn one_color(kind: &str) -> Refusal {
    Refusal::new("light", kind, "a spotlight or a point light: a wall in the sun is one colour")
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
