//! A dim pool of light on a display of 16 bits: with bands, with dither, and the error of both.

use super::picture::Picture;
use luminaire::{
    Angle, Cone, Error, Rgb, Scalar, SpotLight, Vec3,
    display::{Rgb565, decode_srgb, encode_srgb},
};

/// Width and height of a picture in pixels. Half of the height is a multiple of a cell of the dither.
const SIZE: (usize, usize) = (320, 208);
/// Side of a cell of the dither in pixels.
const CELL: usize = 8;
/// What a code of error adds to the grey of the map: half a step of five bits, four codes, is the
/// largest error.
const CONTRAST: i32 = 28;

/// The pool in RGB565, the same with dither, and the map: the error of the mean light of each cell, in
/// sRGB codes of each channel, above without dither and below with it. Grey is no error.
pub(crate) fn pictures() -> Result<[Picture; 3], Error> {
    let light = SpotLight::new([0.0, 0.0, 3.0], [0.0, 0.0, -1.0], Cone::soft(Angle::degrees(50.0))?)?;
    let light = light.with_intensity(1.8)?.compile::<f32>()?;
    let color = |x: usize, y: usize| {
        let [x, y] = [(x, SIZE.0), (y, SIZE.1)].map(|(at, side)| 0.008 * (at as f32 - 0.5 * side as f32));
        let lit = light.irradiance(f32::point([x, y, 0.0]), Vec3::new(0.0, 0.0, 1.0));
        Rgb::new(1.0, 0.72, 0.42).map(|channel: f32| channel * lit)
    };
    let nearest = |x, y| Rgb565::from_linear(color(x, y)).to_codes();
    let dithered = |x, y| Rgb565::from_linear_dithered(color(x, y), x as u32, y as u32).to_codes();
    let mean = |of: &dyn Fn(usize, usize) -> Rgb<f32>, x: usize, y: usize| {
        let pixels = (0..CELL * CELL).map(|i| of(x / CELL * CELL + i % CELL, y / CELL * CELL + i / CELL));
        let sum = pixels.fold(Rgb::default(), |sum: Rgb<f32>, pixel| sum.zip(pixel, |a, b| a + b));
        sum.map(|sum| i32::from(encode_srgb(sum / (CELL * CELL) as f32)))
    };
    let error = |x, y| {
        let shown = |x, y| if 2 * y < SIZE.1 { nearest(x, y) } else { dithered(x, y) }.map(decode_srgb);
        let error = mean(&shown, x, y).zip(mean(&color, x, y), |shown, exact| shown - exact);
        error.map(|error| (128 + CONTRAST * error).clamp(0, 255) as u8)
    };
    Ok([picture(nearest), picture(dithered), picture(error)])
}

fn picture(codes: impl Fn(usize, usize) -> Rgb<u8>) -> Picture {
    let (width, height) = SIZE;
    let pixels = (0..width * height).map(|i| codes(i % width, i / width));
    Picture { width, height, codes: pixels.flat_map(|pixel| [pixel.red, pixel.green, pixel.blue]).collect() }
}

/// The rings of the error above are what the eye sees; below only small errors are left, without rings.
#[test]
fn dither_leaves_a_third_of_the_error() -> Result<(), Error> {
    let [.., map] = pictures()?;
    let codes: Vec<_> = map.codes.iter().map(|&code| (i32::from(code) - 128).abs() / CONTRAST).collect();
    let (above, below) = codes.split_at(codes.len() / 2);
    let most = [above, below].map(|half| half.iter().copied().max());
    let [above, below] = [above, below].map(|half| half.iter().sum::<i32>() as f32 / half.len() as f32);
    assert!(most == [Some(3), Some(1)] && below < above / 3.0, "{most:?}, means of {above} and {below}");
    Ok(())
}
