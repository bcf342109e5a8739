//! A spotlight, and surface points about it of every kind that a renderer meets.

use luminaire::Vec3;

/// Position of the light, on the grid of 2^-16, which is exact in every format.
pub const POSITION: Vec3<f32> = Vec3::new(1.5, 4.0, -0.75);
/// Axis of the light, of unit length within the precision of f32.
pub const AXIS: Vec3<f32> = Vec3::new(0.36, -0.8, 0.48);
/// Intensity of the light with an inverse square: full scale at a distance of 4.
pub(crate) const INTENSITY: f32 = 16.0;
/// Position of the eye, near enough to the light to see highlights.
pub const EYE: Vec3<f32> = Vec3::new(-0.5, 3.5, 1.0);
/// Two directions across the axis and across one another, of length 0.88.
const ACROSS: [Vec3<f32>; 2] = [Vec3::new(0.8, 0.36, 0.0), Vec3::new(-0.1728, 0.384, 0.7696)];

/// A surface point in f32, the same on every machine. Its position is on the grid of 2^-16, which
/// is exact in every format.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Site {
    /// Its position.
    pub point: Vec3<f32>,
    /// The normal of the surface, of unit length as f32 has it.
    pub normal: Vec3<f32>,
}

/// How a surface point lies to the light.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Population {
    /// It is in the cone and faces the light.
    Lit,
    /// It is in the cone and faces away.
    Away,
    /// It faces the light from outside the cone.
    Outside,
    /// It is on the floor `y = 0`, in the cone or near it.
    Floor,
}

/// The surface points about a cone, one after the other: an infinite sequence.
#[derive(Clone, Debug)]
pub struct Sites {
    random: Random,
    population: Population,
    /// The tangent of the outer half angle.
    tangent: f32,
}

impl Sites {
    /// The sites of a population about the cone that ends at this versine.
    pub fn new(population: Population, outer: f32) -> Self {
        let tangent = libm::sqrtf(outer * (2.0 - outer)) / (1.0 - outer);
        Self { random: Random(0x9e37_79b9), population, tangent }
    }
}

impl Iterator for Sites {
    type Item = Site;

    fn next(&mut self) -> Option<Site> {
        let random = &mut self.random;
        let mut across = [self.tangent * 0.6 * random.number(), self.tangent * 0.6 * random.number()];
        if self.population == Population::Outside {
            // Far enough out along one of the two directions that the edge is passed whatever the
            // other is.
            across[0] = (self.tangent * (2.5 + random.number())).copysign(across[0]);
        }
        let way = sum(AXIS, sum(scaled(ACROSS[0], across[0]), scaled(ACROSS[1], across[1])));
        if self.population == Population::Floor {
            let point = sum(POSITION, scaled(way, -POSITION.y / way.y)).map(on_grid);
            return Some(Site { point, normal: Vec3::new(0.0, 1.0, 0.0) });
        }
        let distance = 4.0 + 3.0 * random.number();
        // Half a cube about the direction back to the light: no corner of it faces away.
        let tilt = Vec3::new(random.number(), random.number(), random.number());
        let normal = sum(scaled(way, -1.0), scaled(tilt, 0.5));
        let side = if self.population == Population::Away { -1.0 } else { 1.0 };
        let normal = scaled(normal, side / libm::sqrtf(normal.dot(normal)));
        Some(Site { point: sum(POSITION, scaled(way, distance)).map(on_grid), normal })
    }
}

/// The nearest multiple of 2^-16.
pub fn on_grid(value: f32) -> f32 {
    libm::roundf(value * 65_536.0) / 65_536.0
}

/// Marsaglia's xorshift generator of 32 bits.
#[derive(Clone, Debug)]
struct Random(u32);

impl Random {
    /// A number from -1 to 1.
    fn number(&mut self) -> f32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        (self.0 >> 8) as f32 / 8_388_608.0 - 1.0
    }
}

/// The sum of two vectors.
fn sum(a: Vec3<f32>, b: Vec3<f32>) -> Vec3<f32> {
    a.zip(b, |a, b| a + b)
}

/// The vector times a factor.
fn scaled(v: Vec3<f32>, factor: f32) -> Vec3<f32> {
    v.map(|c| c * factor)
}
