//! Prints the errors of both spotlights against f64, a row of a table for each cone.

use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor as _};
use luminaire::{Fx16, Vec3};
use luminaire_kernels::scene::{AXIS, POSITION, on_grid};
use luminaire_oracle::{Cone, DVec3, SplitMix64, soft, versine, versine_between};
use luminaire_spotlights::{cone16, cone32, ours, theirs};
use nalgebra::Point3;

/// The outer half angles, in degrees.
const CONES: [f32; 5] = [5.0, 10.0, 15.0, 20.0, 30.0];
/// Points along the axis, at distances from 1 to 4.
const ALONG: u32 = 2_774;
/// Random points in and about the cone.
const ABOUT: u32 = 200_000;

fn main() -> Result<(), luminaire::Error> {
    for half in CONES {
        println!("{}", row(half)?);
    }
    Ok(())
}

fn row(half: f32) -> Result<String, luminaire::Error> {
    let (before, light32, light16) = (theirs(half), ours::<f32>(half)?, ours::<Fx16>(half)?);
    let before = |p: Vec3<f32>| before.contribution_at(Point3::new(p.x, p.y, p.z));
    let after = |p: Vec3<f32>| [cone32(&light32, p), cone16(&light16, Fx16::point(p.into()))];

    let along = |i: u32| point(AXIS, 1.0 + 3.0 * i as f32 / (ALONG - 1) as f32);
    let green = |pixel: Rgb565| u32::from(pixel.g());
    let on_axis = |of: &dyn Fn(Vec3<f32>) -> Rgb565| {
        let greens = (0..ALONG).map(|i| green(of(along(i))));
        let (dark, least) =
            greens.fold((0, 63), |(dark, least), green| (dark + u32::from(green == 0), green.min(least)));
        (100.0 * f64::from(dark) / f64::from(ALONG), least)
    };
    let (dark, least) = on_axis(&before);
    let (dark_after, least_after) = on_axis(&|p| after(p)[1]);
    assert_eq!((dark_after, least_after), (0.0, 63), "the axis is at full strength");

    let exact = Cone::new(soft, versine(f64::from(half)));
    let mut random = SplitMix64(1);
    let mut worst = [0.0_f64; 3];
    let tangent = half.to_radians().tan();
    for i in 0..ALONG + ABOUT {
        let place = if i < ALONG { along(i) } else { about(&mut random, tangent) };
        let [p, origin, axis] =
            [place, POSITION, AXIS].map(|v| DVec3::new(v.x.into(), v.y.into(), v.z.into()));
        let exact = exact.falloff(versine_between(axis, p - origin));
        let [in_f32, in_16_bits] = after(place);
        for (worst, pixel) in worst.iter_mut().zip([before(place), in_f32, in_16_bits]) {
            *worst = worst.max(255.0 * (f64::from(pixel.g()) / 63.0 - exact).abs());
        }
    }
    let [before, in_f32, in_16_bits] = worst;
    Ok(format!("| {half}° | {dark:.0} % | {least} of 63 | {before:.1} | {in_f32:.2} | {in_16_bits:.2} |"))
}

/// The point at a distance along a direction from the light, on the grid of fixed point.
fn point(direction: Vec3<f32>, distance: f32) -> Vec3<f32> {
    POSITION.zip(direction, |origin, part| on_grid(origin + distance * part))
}

/// A random point within 1.2 times the tangent of the cone, at a distance from 1 to 4.
fn about(random: &mut SplitMix64, tangent: f32) -> Vec3<f32> {
    // Across the axis, and across one another.
    let across = [Vec3::new(0.8, 0.36, 0.0), Vec3::new(-0.1728, 0.384, 0.7696)];
    let [u, v] = [(); 2].map(|()| 1.36 * tangent * random.between(-1.0, 1.0) as f32);
    let direction = AXIS.zip(across[0], |a, b| a + u * b).zip(across[1], |a, b| a + v * b);
    point(direction, random.between(1.0, 4.0) as f32)
}
