//! One picture on six screens, each drawn in its own pixels and in 16-bit integers, row by row as a
//! microcontroller draws it: a stage with a window, a wall, a floor and a ball.

use luminaire::{
    Angle, Cone, Error, Fx16, Length, Rgb, SpotLight,
    display::{Gray1, Gray2, Gray4, Palette, Pixel, Ramp, Rgb332, Rgb565, Rgb888, decode_srgb},
    draw::{Gradient, Pool, Sprite, normals_from_opengl},
    light::{QuickSpotLight, Row},
    number::Light16,
};

use super::picture::Picture;

/// Width and height of a screen in pixels.
const SIZE: (usize, usize) = (240, 160);
/// White pixels between two screens.
const GAP: usize = 8;
/// The first row of the floor.
const FLOOR: usize = 118;
/// Pixels to the metre, a power of two: a length has 16 fraction bits.
const METRE: i32 = 32;
/// The length of a pixel.
const PIXEL: Length = Length::from_bits((1 << 16) / METRE);
/// Left, right, top and bottom of the window in pixels.
const WINDOW: [i32; 4] = [24, 84, 18, 76];
/// The centre of the moon in pixels, and its radius.
const MOON: ([i32; 2], i32) = ([68, 32], 7);
/// Side of the ball's picture in pixels, and its upper left corner.
const BALL: usize = 64;
const PLACE: [i32; 2] = [132, 66];
/// The colours of electronic paper with seven inks, as its maker states them.
const INKS: [Rgb<u8>; 7] = [
    Rgb::new(0, 0, 0),
    Rgb::new(255, 255, 255),
    Rgb::new(0, 255, 0),
    Rgb::new(0, 0, 255),
    Rgb::new(255, 0, 0),
    Rgb::new(255, 255, 0),
    Rgb::new(255, 128, 0),
];

/// Six screens, three in a row: RGB of 16 and of 8 bits, paper of seven inks; grey of 4, 2 and 1 bits.
pub(crate) fn picture() -> Result<Picture, Box<dyn std::error::Error>> {
    let ball = Ball::new();
    let paper = paper(&screen::<Rgb888>(&ball)?)?;
    let above = [shown(&screen::<Rgb565>(&ball)?), shown(&screen::<Rgb332>(&ball)?), paper];
    let below =
        [shown(&screen::<Gray4>(&ball)?), shown(&screen::<Gray2>(&ball)?), shown(&screen::<Gray1>(&ball)?)];
    let [above, below] = [above, below].map(|[a, b, c]| Picture::beside(&[&a, &b, &c], GAP));
    let gap = vec![u8::MAX; 3 * GAP * above.width];
    let codes = [above.codes, gap, below.codes].concat();
    Ok(Picture { width: above.width, height: 2 * SIZE.1 + GAP, codes })
}

/// The ball as a picture of normals, and which of its pixels are painted.
struct Ball {
    normals: [[i8; 3]; BALL * BALL],
    paint: [u8; BALL * BALL],
}

impl Ball {
    /// A normal map, as an editor of images would export it, and a stripe.
    fn new() -> Self {
        let (mut map, mut paint) = ([[0; 3]; BALL * BALL], [0; BALL * BALL]);
        for (i, (map, paint)) in map.iter_mut().zip(&mut paint).enumerate() {
            let [x, y] = [i % BALL, i / BALL].map(|at| (at as f32 + 0.5) / (BALL / 2) as f32 - 1.0);
            let square = x * x + y * y;
            if square < 1.0 {
                // Green points up, and 128 is 0.
                let z = (1.0 - square).sqrt();
                *map = [x, -y, z].map(|component| (127.0 * component).round() as i32 as u8 ^ 0x80);
                *paint = u8::from((y + 0.4 * x).abs() < 0.22);
            }
        }
        Self { normals: normals_from_opengl(&map), paint }
    }
}

/// Draws the scene on a screen of these pixels, row by row.
fn screen<P: Pixel + Copy + Default>(ball: &Ball) -> Result<Vec<P>, Error> {
    // A warm light above the stage, two metres in front of the wall and towards its foot. y points down.
    let cone = Cone::soft(Angle::degrees(56.0))?;
    let light = SpotLight::new([3.4, -0.9, 2.2], [0.7, 4.1, -2.0], cone)?.with_intensity(24.0)?;
    let light: QuickSpotLight<Fx16, _> = light.compile_quick()?;

    let plaster: Ramp<P> = Ramp::new(Rgb::new(0.012, 0.016, 0.05), Rgb::new(0.75, 0.5, 0.3))?;
    let boards: Ramp<P> = Ramp::new(Rgb::new(0.016, 0.012, 0.02), Rgb::new(0.5, 0.27, 0.13))?;
    let [rubber, stripe] = [[0.65, 0.06, 0.04], [0.9, 0.85, 0.75]].map(|[red, green, blue]| {
        Ramp::new(Rgb::new(red, green, blue).map(|channel: f32| 0.03 * channel), Rgb::new(red, green, blue))
    });
    let ramps: [Ramp<P>; 2] = [rubber?, stripe?];

    let [left, right, top, bottom] = WINDOW;
    let [night, dusk, moon] = [Rgb::new(8, 14, 52), Rgb::new(206, 112, 104), Rgb::new(255, 246, 214)];
    let ends = [top, bottom].map(|y| [0.0, y as f32]);
    let sky: Gradient<P> = Gradient::linear(&[night, dusk], ends[0], ends[1])?;
    let glow = Rgb::new(60, 62, 98);
    let (center, radius) = MOON;
    let disk: Gradient<P, 64> =
        Gradient::radial(&[moon, moon, moon, glow], center.map(|at| at as f32), radius as f32)?;

    let wall = Pool::new(&plaster, PIXEL);
    let [x, y] = PLACE;
    let ball = Sprite::new(BALL, &ball.normals, &ramps, PIXEL)?.with_materials(&ball.paint)?.at(x, y);
    let mut pixels = vec![P::default(); SIZE.0 * SIZE.1];
    for (y, row) in (0..).zip(pixels.chunks_exact_mut(SIZE.0)) {
        if (y as usize) < FLOOR {
            wall.row(&light, y, 0, row);
        } else {
            floor(&light, &boards, y, row);
        }
        if (top..bottom).contains(&y) {
            sky.row(y, left, &mut row[left as usize..right as usize]);
            let [x, middle] = center;
            if (middle - radius..middle + radius).contains(&y) {
                // Half of the row's chord of the disk.
                let square = (radius * radius) as f32 - ((y - middle) as f32 + 0.5).powi(2);
                let half = square.max(0.0).sqrt() as i32;
                disk.row(y, x - half, &mut row[(x - half) as usize..(x + half) as usize]);
            }
        }
        ball.row(&[light], y, 0, row);
    }
    Ok(pixels)
}

/// A row of the floor, which comes 1/20 of a metre nearer with each: every fourth point is evaluated, and
/// the light is linear between them.
fn floor<P: Pixel>(
    light: &QuickSpotLight<Fx16, impl luminaire::falloff::Falloff>,
    ramp: &Ramp<P>,
    y: i32,
    row: &mut [P],
) {
    let height = Length::from_bits(FLOOR as i32 * PIXEL.to_bits());
    let nearer = Length::from_bits((y - FLOOR as i32) * (1 << 16) / 20);
    let up = Fx16::normal([0.0, -1.0, 0.0]);
    let points = Row::along_x(up, [height, nearer], |x| Length::from_bits(x as i32 * PIXEL.to_bits()));
    let mut arrived = [Light16::ZERO; SIZE.0];
    let lit = points.reach(light, arrived.len());
    points.fill_interpolated::<_, 4>(light, lit.start, &mut arrived[lit]);
    for ((x, pixel), arrived) in (0..).zip(row).zip(arrived) {
        *pixel = ramp.pixel::<Fx16>(arrived, x, y as u32);
    }
}

/// The codes that a screen shows.
fn shown<P: Pixel + Copy>(pixels: &[P]) -> Picture {
    let codes = pixels.iter().flat_map(|pixel| {
        let Rgb { red, green, blue } = pixel.to_codes();
        [red, green, blue]
    });
    Picture { width: SIZE.0, height: SIZE.1, codes: codes.collect() }
}

/// The inks of the paper, from the picture of 24 bits.
fn paper(pixels: &[Rgb888]) -> Result<Picture, Error> {
    let palette = Palette::new(&INKS)?;
    let inks = pixels.iter().enumerate().flat_map(|(i, pixel)| {
        let linear: Rgb<f32> = pixel.to_codes().map(decode_srgb);
        let Rgb { red, green, blue } =
            palette.color(palette.dithered(linear, (i % SIZE.0) as u32, (i / SIZE.0) as u32));
        [red, green, blue]
    });
    Ok(Picture { width: SIZE.0, height: SIZE.1, codes: inks.collect() })
}
