//! A spotlight, and surface points about it of every kind that a renderer meets.

use core::array;

use luminaire::{Angle, Cone, Error, Falloff, Profile, Scalar, Soft, Spot, Vec3};

/// How many inputs each kernel is run over.
pub const COUNT: usize = 256;

/// A field angle of 36 degrees: wide enough that no format comes near its limits.
const FIELD: Angle = Angle::degrees(36.0);
/// The tangent of half the outer angle, which for a soft edge is 43.65 degrees.
const TANGENT: f32 = 0.4;
const POSITION: Vec3<f32> = Vec3::new(1.5, 4.0, -0.75);
/// Of unit length, to the bit that f32 has.
const AXIS: Vec3<f32> = Vec3::new(0.36, -0.8, 0.48);
/// Two directions across the axis and across one another, of length 0.88.
const ACROSS: [Vec3<f32>; 2] = [Vec3::new(0.8, 0.36, 0.0), Vec3::new(-0.1728, 0.384, 0.7696)];

/// A surface point.
#[derive(Clone, Copy, Debug)]
pub struct Sample<S: Scalar> {
    /// Where it is.
    pub point: Vec3<S::Length>,
    /// The unit normal of the surface.
    pub normal: Vec3<S>,
}

/// What a surface point gets of the light.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Population {
    /// It is in the cone and faces the light.
    Lit,
    /// It is in the cone and faces away.
    Away,
    /// It faces the light from outside the cone.
    Outside,
}

/// The cone of the light.
///
/// # Errors
/// None for the profiles there are.
pub fn cone<P: Profile>(profile: P) -> Result<Cone<P>, Error> {
    Cone::from_field(profile, FIELD)
}

/// The light, with a soft edge.
///
/// # Errors
/// None: its figures are constants.
pub fn spot() -> Result<Spot<Soft>, Error> {
    Spot::new(POSITION, AXIS, cone(Soft)?)?.with_intensity(16.0)
}

/// Versines of angles from the axis to the edge of a cone, none of them on either.
pub fn versines<S: Scalar, P: Profile>(cone: &Cone<P>, falloff: &Falloff<S, P>) -> [S::Versine; COUNT] {
    array::from_fn(|index| falloff.versine(cone.outer_versine() * ((index as f32 + 0.5) / COUNT as f32)))
}

/// The points of a population, the same on every machine.
pub fn samples<S: Scalar>(population: Population) -> [Sample<S>; COUNT] {
    let mut random = Random(0x9e37_79b9);
    array::from_fn(|_| random.sample(population))
}

/// Marsaglia's xorshift generator of 32 bits.
struct Random(u32);

impl Random {
    /// A number from -1 to 1.
    fn number(&mut self) -> f32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        (self.0 >> 8) as f32 / 8_388_608.0 - 1.0
    }

    fn sample<S: Scalar>(&mut self, population: Population) -> Sample<S> {
        let mut across = [TANGENT * 0.6 * self.number(), TANGENT * 0.6 * self.number()];
        if population == Population::Outside {
            // Far enough out along one of the two directions that the edge is passed whatever the other is.
            across[0] = (TANGENT * (2.5 + self.number())).copysign(across[0]);
        }
        let way = sum(AXIS, sum(scaled(ACROSS[0], across[0]), scaled(ACROSS[1], across[1])));
        let distance = 4.0 + 3.0 * self.number();
        // Half a cube about the way back: no corner of it faces away.
        let tilt = Vec3::new(self.number(), self.number(), self.number());
        let normal = sum(scaled(way, -1.0), scaled(tilt, 0.5));
        let side = if population == Population::Away { -1.0 } else { 1.0 };
        let normal = scaled(normal, side / libm::sqrtf(normal.dot(normal)));
        Sample { point: sum(POSITION, scaled(way, distance)).map(S::length), normal: normal.map(S::from_f32) }
    }
}

fn sum(a: Vec3<f32>, b: Vec3<f32>) -> Vec3<f32> {
    a.zip(b, |a, b| a + b)
}

fn scaled(v: Vec3<f32>, factor: f32) -> Vec3<f32> {
    v.map(|c| c * factor)
}

#[cfg(test)]
mod tests {
    use luminaire::{Fx16, Fx32};

    use super::*;

    fn lit<S: Scalar>(population: Population) -> usize {
        let light = spot().unwrap().compile::<S>().unwrap();
        let is_lit = |s: &Sample<S>| S::light_to_f32(light.irradiance(s.point, s.normal)) > 0.0;
        samples(population).iter().filter(|sample| is_lit(sample)).count()
    }

    #[test]
    fn the_populations_are_what_they_are_called() {
        for lit in [lit::<f32>, lit::<Fx32>, lit::<Fx16>] {
            assert_eq!(lit(Population::Lit), COUNT);
            assert_eq!(lit(Population::Away), 0);
            assert_eq!(lit(Population::Outside), 0);
        }
    }
}
