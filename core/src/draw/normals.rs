//! Normals from the bytes of normal maps.

/// Returns the normals of a map in OpenGL's convention, `Y+`: a bright green faces up. glTF has it.
///
/// The map has red, green and blue of each pixel, as an image. A normal has signed bytes in units
/// of 1/127, to the right, **down** and to the viewer, as a [`Sprite`](super::Sprite) takes them:
/// each is a byte minus 128, and green is negated. So the flat blue (128, 128, 255) is exactly the
/// normal towards the viewer. Directions of a map that stores `n` as `127.5 (n + 1)`, rounded to
/// nearest, err by at most 0.78 degrees, and of one that stores `127 n + 128` by at most 0.4
/// degrees (derived). Black and the grey of 128 give a zero normal, which is transparent.
///
/// As a constant it costs nothing where it runs:
///
/// ```
/// use luminaire::draw::{normals_from_directx, normals_from_opengl};
/// // Facing up, down and the viewer, and a transparent pixel.
/// const MAP: [[u8; 3]; 4] = [[128, 218, 218], [128, 38, 218], [128, 128, 255], [0, 0, 0]];
/// const NORMALS: [[i8; 3]; 4] = normals_from_opengl(&MAP);
/// assert_eq!(NORMALS, [[0, -90, 90], [0, 90, 90], [0, 0, 127], [0; 3]]);
/// assert_eq!(normals_from_directx(&MAP), [[0, 90, 90], [0, -90, 90], [0, 0, 127], [0; 3]]);
/// ```
pub const fn normals_from_opengl<const N: usize>(map: &[[u8; 3]; N]) -> [[i8; 3]; N] {
    let mut normals = normals_from_directx(map);
    let mut i = 0;
    while i < N {
        normals[i][1] = 0_i8.saturating_sub(normals[i][1]);
        i += 1;
    }
    normals
}

/// Returns the normals of a map in DirectX's convention, `Y-`: a bright green faces down. All else
/// is as in [`normals_from_opengl`].
pub const fn normals_from_directx<const N: usize>(map: &[[u8; 3]; N]) -> [[i8; 3]; N] {
    let mut normals = [[0; 3]; N];
    let mut i = 0;
    while i < N {
        let [red, green, blue] = map[i];
        if red | green | blue != 0 {
            normals[i] =
                [red.wrapping_sub(128) as i8, green.wrapping_sub(128) as i8, blue.wrapping_sub(128) as i8];
        }
        i += 1;
    }
    normals
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        display::{Ramp, Rgb565},
        draw::Sprite,
        light::PointLight,
    };

    extern crate std;

    /// Returns the largest angle in degrees between a direction and its stored normal.
    fn largest_error(store: impl Fn(f64) -> f64) -> f64 {
        let mut rng = fastrand::Rng::with_seed(43);
        let mut largest = 0.0_f64;
        for _ in 0..200_000 {
            // Uniform in z, and so over the half sphere that a map has.
            let (z, turn) = (rng.f64(), core::f64::consts::TAU * rng.f64());
            let flat = (1.0 - z * z).sqrt();
            let [x, y] = [flat * turn.cos(), flat * turn.sin()];
            let map = [[x, y, z].map(|c| store(c) as u8)];
            for (normals, y) in [(normals_from_opengl(&map), -y), (normals_from_directx(&map), y)] {
                let [a, b, c] = normals[0].map(f64::from);
                let cosine = (a * x + b * y + c * z) / (a * a + b * b + c * c).sqrt();
                largest = largest.max(cosine.min(1.0).acos().to_degrees());
            }
        }
        largest
    }

    /// A byte minus 128 is within 1 or 1/2 of 127.5 or 127 times the component.
    #[test]
    fn a_map_keeps_its_directions() {
        let errors =
            [largest_error(|n| (127.5 * (n + 1.0)).round()), largest_error(|n| (127.0 * n).round() + 128.0)];
        std::println!("{errors:.3?} degrees");
        assert!((0.74..0.78).contains(&errors[0]) && (0.37..0.4).contains(&errors[1]), "{errors:?}");
    }

    #[test]
    fn every_pixel_but_black_is_its_bytes_less_128() {
        for (red, green) in (0..=u8::MAX).flat_map(|red| (0..=u8::MAX).map(move |green| (red, green))) {
            let map: [_; 256] = core::array::from_fn(|blue| [red, green, blue as u8]);
            for (pixel, normal) in map.into_iter().zip(normals_from_directx(&map)) {
                let expected =
                    if pixel == [0; 3] { [0; 3] } else { pixel.map(|c| c.wrapping_sub(128) as i8) };
                assert_eq!(normal, expected, "{pixel:?}");
            }
        }
    }

    /// The light is above the picture, so only the pixel that faces up is lit.
    #[test]
    fn green_says_what_faces_up() {
        let [up, down] = [[128, 218, 218], [128, 38, 218]];
        let ramps: [Ramp<Rgb565>; 1] = [Ramp::new([0.0; 3].into(), [0.8; 3].into()).unwrap()];
        let light =
            PointLight::new([0.0, -4.0, 2.0]).unwrap().with_intensity(9.0).unwrap().compile::<f32>().unwrap();
        let codes = |normals: &[[i8; 3]]| {
            let mut row = [Rgb565(0); 2];
            Sprite::new(2, normals, &ramps, 1.0 / 32.0).unwrap().row(&[light], 0, 0, &mut row);
            row.map(|pixel| pixel.to_codes().green)
        };
        let [above, below] = codes(&normals_from_opengl(&[up, down]));
        assert!(above > 100 && below == 0, "{above} {below}");
        assert_eq!(codes(&normals_from_directx(&[down, up])), [above, below]);
    }
}
