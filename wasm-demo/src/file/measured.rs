//! What the page shows of a light that is not round: two of its planes, a room in its light, and its directions.

use crate::{false_colour::rgba, refusal::Refusal};
use luminaire::attenuation::AnyAttenuation;
use luminaire::display::{clip, encode_srgb, encode_srgb_dithered};
use luminaire::light::Distribution;
use luminaire::{Fx16, MeasuredLight, Rgb, Vec3};
use luminaire_render::Camera;
use std::f64::consts::{PI, TAU};

/// A light of a table over all directions.
pub(super) type Measured = MeasuredLight<'static, AnyAttenuation>;

/// The height of the light over the floor of the room, and the distance of the wall behind it, in metres.
const HEIGHT: f32 = 4.0;
const BEHIND: f32 = 3.0;

/// The width of the pictures, and the heights of the two, in pixels.
const WIDTH: usize = 440;
const ROOM: usize = 240;
const SPHERE: usize = 220;

/// Returns the shares of the largest intensity at angles off the axis in degrees from -180 to 180, in the plane of the
/// light's side and in that of its front.
pub(super) fn planes(light: &Measured) -> [Vec<[f64; 2]>; 2] {
    let table = light.distribution();
    let share = |plane: usize, degrees: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        table.exact(if plane == 0 { [sine, 0.0, cosine] } else { [0.0, sine, cosine] })
    };
    let angles = || (-90..=90).map(|i| 2.0 * f64::from(i));
    [0, 1].map(|plane| angles().map(|degrees| [degrees, share(plane, degrees)]).collect())
}

/// Returns the luminous flux in lumens of an intensity in candela: that of the table, by the middles of 64 x 128 parts
/// of equal size.
pub(super) fn lumens(table: Distribution<'_>, candela: f64) -> f64 {
    let middle = |i: i32, count: i32| (f64::from(i) + 0.5) / f64::from(count);
    let parts = (0..64).flat_map(|row| (0..128).map(move |column| (row, column)));
    let sum: f64 = parts
        .map(|(row, column)| table.exact(way(2.0 * middle(row, 64) - 1.0, TAU * middle(column, 128))))
        .sum();
    4.0 * PI * candela * sum / (64.0 * 128.0)
}

/// Returns the direction with this cosine off the axis, at an angle about it from the side, in radians.
fn way(cosine: f64, about: f64) -> [f64; 3] {
    let (front, side) = about.sin_cos();
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    [sine * side, sine * front, cosine]
}

/// Returns the pixels of a room, RGBA: a floor and the wall behind, white, under the light, by the 16-bit kernel. The
/// brightest pixel is full scale. The light's front is toward the viewer, whatever its place in the file.
pub(super) fn room(light: &Measured) -> Result<Vec<u8>, Refusal> {
    let hung = |intensity| {
        MeasuredLight::new([0.0, HEIGHT, 0.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], light.distribution())?
            .with_color(light.color())?
            .with_intensity(intensity)
    };
    let camera = camera();
    let pixels = (0..ROOM).flat_map(|y| (0..WIDTH).map(move |x| [x, y]));
    let points: Vec<_> = pixels.map(|pixel| seen(&camera, pixel)).collect();
    let one = hung(1.0)?.compile::<f32>()?;
    let lit = |&(point, normal): &(Vec3<f32>, Vec3<f32>)| one.irradiance(point, normal);
    let brightest = points.iter().flatten().map(lit).fold(0.0, f32::max);
    let light = hung(if brightest > 0.0 { 1.0 / brightest } else { 1.0 })?.compile::<Fx16>()?;
    let codes = points.iter().enumerate().map(|(i, place)| {
        let Some((point, normal)) = place else { return [0; 3] };
        let irradiance = light.irradiance(point.map(Fx16::length), normal.map(Fx16::from_f32));
        let lit = Rgb::lit(irradiance, light.color());
        let [x, y] = [i % WIDTH, i / WIDTH].map(|place| place as u32);
        <[Fx16; 3]>::from(clip(lit)).map(|channel| encode_srgb_dithered(channel, x, y))
    });
    Ok(rgba(codes))
}

/// The camera of the room.
fn camera() -> Camera {
    Camera::new(Vec3::new(0.0, 1.6, -1.0), 13.0, 0.25, 0.2, 0.6)
}

/// Returns the point of the room that a pixel shows, and its normal.
fn seen(camera: &Camera, [x, y]: [usize; 2]) -> Option<(Vec3<f32>, Vec3<f32>)> {
    let place = |at: usize, count: usize| (at as f32 + 0.5) / count as f32;
    let way = camera.toward([place(x, WIDTH), place(y, ROOM)], WIDTH as f32 / ROOM as f32);
    let eye = camera.eye();
    let at = |along: f32| eye.zip(way, |from, way| from + along * way);
    let (to_wall, to_floor) = ((-BEHIND - eye.z) / way.z, -eye.y / way.y);
    let wall = (to_wall > 0.0).then(|| (at(to_wall), Vec3::new(0.0, 0.0, 1.0)));
    let is_floor = to_floor > 0.0 && !(to_wall > 0.0 && to_wall < to_floor);
    if is_floor { Some((at(to_floor), Vec3::new(0.0, 1.0, 0.0))) } else { wall }
}

/// Returns the pixels of two discs, RGBA: the intensities of the directions below the light and above it, by the
/// azimuthal map of equal areas, with the side of the light to the right and its front down, as seen from above.
pub(super) fn sphere(light: &Measured) -> Vec<u8> {
    let (table, radius) = (light.distribution(), 0.49 * SPHERE as f64);
    let codes = (0..SPHERE).flat_map(|y| (0..WIDTH).map(move |x| [x, y])).map(|[x, y]| {
        let (is_above, x) = (2 * x >= WIDTH, x % (WIDTH / 2));
        let place = |at: usize, count: usize| (at as f64 + 0.5 - count as f64 / 2.0) / radius;
        let [across, down] = [place(x, WIDTH / 2), place(y, SPHERE)];
        // The versine is the square of the distance from the middle: of two hemispheres each ends at 1.
        let versine = across * across + down * down;
        if versine > 1.0 {
            return [0; 3];
        }
        let cosine = if is_above { versine - 1.0 } else { 1.0 - versine };
        [encode_srgb(table.exact(way(cosine, down.atan2(across))) as f32); 3]
    });
    rgba(codes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use luminaire::{attenuation::InverseSquare, light::Symmetry};

    /// A light that is brighter toward its side, and dark from the horizon on.
    const HALF: [u16; 15] = [0, 20_000, 40_000, 65_535, 0, 0, 0, 40_000, 0, 0, 0, 0, 0, 0, 0];

    fn light(samples: &'static [u16], size: u32, symmetry: Symmetry) -> Measured {
        let table = Distribution::new(samples, size, symmetry).expect("a sound table");
        let light = MeasuredLight::new([0.0; 3], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], table);
        light.expect("a sound light").with_attenuation(AnyAttenuation::from(InverseSquare))
    }

    #[test]
    fn flux_is_that_of_the_intensities() {
        let full = light(&[65_535; 9], 3, Symmetry::None);
        let flux = lumens(full.distribution(), 10.0);
        assert!((flux / (40.0 * PI) - 1.0).abs() < 1e-9, "{flux}");
        // A table that is bright on the axis alone: the sum over much finer parts.
        let spot = light(&[65_535, 0, 0, 0], 3, Symmetry::Quadrant);
        let middle = |i: i32, count: i32| (f64::from(i) + 0.5) / f64::from(count);
        let parts = (0..1_000).flat_map(|i| (0..1_000).map(move |j| [middle(i, 1_000), middle(j, 1_000)]));
        let mean: f64 = parts.map(|[c, a]| spot.distribution().exact(way(2.0 * c - 1.0, TAU * a))).sum();
        let flux = lumens(spot.distribution(), 1.0);
        assert!((flux / (4.0 * PI * mean / 1e6) - 1.0).abs() < 2e-3, "{flux} {mean}");
    }

    /// Returns the sum of the red bytes of these columns of a picture.
    fn columns(pixels: &[u8], from: usize, to: usize) -> u64 {
        let rows = pixels.chunks(4 * WIDTH);
        rows.flat_map(|row| row[4 * from..4 * to].iter().step_by(4)).map(|code| u64::from(*code)).sum()
    }

    #[test]
    fn pictures_are_brighter_where_the_light_is() {
        let light = light(&HALF, 5, Symmetry::Bilateral);
        let [left, right, above] =
            [[0, 110], [110, 220], [220, 440]].map(|[from, to]| columns(&sphere(&light), from, to));
        assert!(5 * right > 6 * left && left > 0, "{left} {right}");
        // Between the samples at the horizon and those before it, light reaches a little behind.
        assert!(3 * above < right, "{above} of {right}");
        let room = room(&light).expect("a room");
        let [left, right] = [[0, 220], [220, 440]].map(|[from, to]| columns(&room, from, to));
        assert!(right > left && left > 0, "{left} {right}");
        assert_eq!(room.chunks(4).map(|pixel| pixel[0]).max(), Some(255));
    }

    /// The first plane is that of the side, the second that of the front.
    #[test]
    fn planes_are_those_of_side_and_front() {
        let light = light(&HALF, 5, Symmetry::Bilateral);
        let table = light.distribution();
        let [side, front] = planes(&light);
        let at = |plane: &[[f64; 2]], degrees: f64| {
            plane.iter().find(|[own, _]| *own == degrees).expect("an angle")[1]
        };
        let (sine, cosine) = 30.0_f64.to_radians().sin_cos();
        assert_eq!(at(&side, 30.0), table.exact([sine, 0.0, cosine]));
        assert_eq!(at(&side, -30.0), table.exact([-sine, 0.0, cosine]));
        assert_eq!(at(&front, 30.0), table.exact([0.0, sine, cosine]));
        assert!(at(&side, 30.0) > 2.0 * at(&side, -30.0), "{side:?}");
        assert_eq!((side[0][0], side[180][0], front.len()), (-180.0, 180.0, 181));
    }
}
