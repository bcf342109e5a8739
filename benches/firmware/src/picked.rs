//! The lights that `luminaire pick` answered with, at random points.

use luminaire::{Scalar, Vec3};
use luminaire_kernels::scene::{Random, Site, on_grid, scaled, sum, unit};
use luminaire_kernels::{Format, Value};

use crate::board::println;

/// Number of points of each light.
const POINTS: usize = 10_000;

/// Where the light of an answer is seen.
#[derive(Clone, Copy, Debug)]
pub struct Domain {
    /// The position of the light.
    pub position: [f32; 3],
    /// Its axis, of any length.
    pub axis: [f32; 3],
    /// The tangent of its outer half angle.
    pub tangent: f32,
    /// The nearest surface.
    pub near: f32,
    /// The farthest surface.
    pub far: f32,
}

/// Runs every light, and prints a checksum of its results.
pub fn picked() {
    each(&mut |number, _, _, bits| {
        if let Some(bits) = bits {
            println!("answer {number} {POINTS} {bits:08x}");
        }
    });
}

/// What visits lights: the number of the light, then either a point with its light or, at the end,
/// the checksum.
type Visit<'a> = &'a mut dyn FnMut(usize, &Site, f64, Option<u32>);

#[allow(unreachable_pub, reason = "an answer's constant is public")]
fn each(visit: Visit<'_>) {
    macro_rules! run {
        ($number:expr, $format:ty, $light:expr, $domain:expr) => {
            run::<$format>($number, $domain, |point, normal| $light.irradiance(point, normal), visit)
        };
    }
    include!(concat!(env!("OUT_DIR"), "/picked.rs"));
}

fn run<S: Format>(
    number: usize,
    domain: Domain,
    light: impl Fn(Vec3<S::Length>, Vec3<S>) -> S::Irradiance,
    visit: Visit<'_>,
) {
    let mut random = Random::new();
    let mut checksum: u32 = 0;
    let mut first = None;
    for _ in 0..POINTS {
        let site = domain.site(&mut random);
        let found = light(site.point.map(<S as Scalar>::length), site.normal.map(<S as Scalar>::from_f32));
        checksum = checksum.wrapping_mul(3) ^ found.bits();
        visit(number, &site, found.exact(), None);
        first = first.or(Some(site));
    }
    if let Some(site) = first {
        visit(number, &site, 0.0, Some(checksum));
    }
}

impl Domain {
    /// A random surface point in the cone or just outside, whose normal faces the light.
    fn site(&self, random: &mut Random) -> Site {
        let vector = |[x, y, z]: [f32; 3]| Vec3::new(x, y, z);
        let axis = unit(vector(self.axis));
        let across = |random: &mut Random| {
            let any = Vec3::new(random.number(), random.number(), random.number());
            let along = any.dot(axis);
            sum(any, scaled(axis, -along))
        };
        let side = scaled(unit(across(random)), 1.02 * self.tangent * random.number());
        let way = unit(sum(axis, side));
        let depth = (random.number() + 1.0) / 2.0;
        let distance = self.near + (self.far - self.near) * depth;
        let point = sum(vector(self.position).map(on_grid), scaled(way, distance)).map(on_grid);
        let tilt = Vec3::new(random.number(), random.number(), random.number());
        Site { point, normal: unit(sum(scaled(way, -1.0), scaled(tilt, 0.9))) }
    }
}

#[cfg(test)]
#[path = "../answers.rs"]
mod answers;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn error_of_every_answer_is_within_its_bound() {
        let answers = answers::all().expect("answers");
        let wide = |v: Vec3<f32>| luminaire_oracle::DVec3::new(v.x.into(), v.y.into(), v.z.into());
        let mut most = [0.0_f64; answers::COUNT];
        each(&mut |number, site, found, checksum| {
            if checksum.is_none() {
                let truth = luminaire_pick::measure::truth(&answers[number]).expect("a light");
                let exact = truth.irradiance(wide(site.point), wide(site.normal));
                most[number] =
                    most[number].max(luminaire_pick::measure::error(&answers[number], found, exact));
            }
        });
        for (answer, most) in answers.iter().zip(most) {
            assert!(most > 0.0 && most <= answer.bound.value, "{most}: {answer:?}");
        }
    }
}
