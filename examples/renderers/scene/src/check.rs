//! Pictures: written, compared with the one in the folder, and compared with the kernel.

use std::fs::File;
use std::io::{BufReader, BufWriter};
use std::path::Path;
use std::{env, fmt};

use luminaire::{Rgb, Scalar, Vec3, light::SurfacePoint};

use crate::{HEIGHT, Object, Site, WIDTH, ambient, glue, lights, seen, white};

/// The variable of the environment that makes a test write its picture.
const BLESS: &str = "LUMINAIRE_BLESS";

/// A picture in sRGB codes, row by row.
#[derive(Clone, PartialEq, Eq)]
pub struct Picture(pub Vec<[u8; 3]>);

/// The largest differences of a picture from the kernel, in sRGB codes.
#[derive(Clone, Copy, Debug)]
pub struct Agreement {
    /// The number of pixels that were compared: all but those beside an outline.
    pub pixels: usize,
    /// The largest difference on the floor.
    pub floor: f64,
    /// The largest difference on the ball.
    pub ball: f64,
}

/// Prints a row of the table of renderers, with the lines of glue and the largest differences, and
/// asserts that the picture is the file in the package's folder, that there are at most five lines of
/// glue, and that the differences are within `bounds`, on the floor and on the ball.
///
/// # Panics
/// If the picture differs or exceeds a bound.
pub fn check(name: &str, source: &str, folder: &str, picture: &Picture, found: Agreement, bounds: [f64; 2]) {
    let (lines, Agreement { pixels, floor, ball }) = (glue(source), found);
    println!("| {name} | {lines} | {pixels} | {floor:.2} | {ball:.2} |");
    picture.assert_is_in(folder);
    assert!((1..=5).contains(&lines), "{lines} lines of glue");
    assert!(pixels > 60_000 && floor < bounds[0] && ball < bounds[1], "{found:?} exceeds {bounds:?}");
}

impl Picture {
    /// Writes the picture as PNG.
    ///
    /// # Panics
    /// If the file cannot be written.
    pub fn write(&self, file: impl AsRef<Path>) {
        let file = BufWriter::new(File::create(file).expect("a file to write"));
        let mut encoder = png::Encoder::new(file, WIDTH as u32, HEIGHT as u32);
        encoder.set_color(png::ColorType::Rgb);
        let mut writer = encoder.write_header().expect("a picture");
        writer.write_image_data(self.0.as_flattened()).expect("a whole picture");
    }

    /// Asserts that the picture is the file `picture.png` of a package's folder. With `LUMINAIRE_BLESS`
    /// set, writes the file.
    ///
    /// # Panics
    /// If the picture differs.
    pub fn assert_is_in(&self, folder: &str) {
        let file = Path::new(folder).join("picture.png");
        if env::var_os(BLESS).is_some() {
            self.write(&file);
        }
        let reader = BufReader::new(File::open(&file).expect("the picture to compare with"));
        let mut reader = png::Decoder::new(reader).read_info().expect("a PNG");
        let mut found = vec![0; reader.output_buffer_size().expect("a small picture")];
        reader.next_frame(&mut found).expect("a whole picture");
        let differing = found.chunks(3).zip(&self.0).filter(|(there, here)| there != here).count();
        assert!(
            differing == 0 && found.len() == 3 * self.0.len(),
            "{differing} pixels differ from {}: look at them and run the test with {BLESS}=1",
            file.display()
        );
    }

    /// Compares each pixel with the kernel's colour, in a format, at the point that the middle of the
    /// pixel sees, which is found without triangles. Left out are pixels beside an outline.
    pub fn agreement<S: Scalar>(&self) -> Agreement {
        let mut agreement = Agreement { pixels: 0, floor: 0.0, ball: 0.0 };
        for y in 0..HEIGHT {
            for x in 0..WIDTH {
                let (column, row) = (x as f64 + 0.5, y as f64 + 0.5);
                let site = seen(column, row);
                let around = [(-2.0, 0.0), (2.0, 0.0), (0.0, -2.0), (0.0, 2.0)];
                let is_inside =
                    around.iter().all(|(right, down)| seen(column + right, row + down).object == site.object);
                if !is_inside {
                    continue;
                }
                let pairs = exact::<S>(&site).into_iter().zip(self.0[y * WIDTH + x]);
                let found = pairs.map(|(exact, code)| (exact - f64::from(code)).abs()).fold(0.0, f64::max);
                let largest = match site.object {
                    Object::Floor => &mut agreement.floor,
                    Object::Ball => &mut agreement.ball,
                };
                *largest = largest.max(found);
                agreement.pixels += 1;
            }
        }
        agreement
    }
}

impl fmt::Debug for Picture {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "Picture of {} pixels", self.0.len())
    }
}

/// The kernel's colour at a point in sRGB codes, not rounded.
fn exact<S: Scalar>(site: &Site) -> [f64; 3] {
    let (lights, ambient) = (lights::<S>().expect("valid lights"), ambient::<S>().expect("a valid light"));
    let white = white::<S>().expect("a valid material");
    let [point, normal] = [site.point, site.normal].map(|v| Vec3::from(v.map(|c| c as f32)));
    let surface = SurfacePoint::matte(S::point(point), normal.map(S::from_f32));
    let color: Rgb<S> = white.color(&surface, &lights, ambient);
    <[S; 3]>::from(color).map(|channel| {
        let linear = f64::from(channel.to_f32());
        let encoded =
            if linear <= 0.0031308 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
        255.0 * encoded
    })
}
