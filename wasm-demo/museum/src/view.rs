//! The points of a picture.

use luminaire::{
    Cone, Error, SpotLight, Vec3,
    attenuation::NoAttenuation,
    dynamic::AnyLight,
    falloff::{AnyFalloff, Falloff},
};
use luminaire_oracle::{DVec3, on_grid};

/// Where the light shines in a view that is not aligned to the coordinates: no component of a
/// direction is then exact.
const AXIS: DVec3 = DVec3::new(0.36, -0.8, 0.48);
/// Two unit vectors, orthogonal to each other and to the axis: a picture's right and top.
const ACROSS: [DVec3; 2] = [DVec3::new(-0.8, 0.0, 0.6), DVec3::new(0.48, 0.6, 0.64)];

/// Where the points of a square picture are.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum View {
    /// A wall that the light meets head on. The wall is as far away as a cone of this half angle, in
    /// degrees, has a radius of one metre. The second number is the distance from the centre of the
    /// picture to its edge, in metres.
    Wall(f64, f64),
    /// A plane through the axis, which runs from the left edge to the right one. The edges are at
    /// these distances from the light, in metres. Every surface faces the light.
    Side(f64, f64),
}

/// A surface point, on the grid of 2^-16 that fixed point has.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Place {
    /// Its position.
    pub point: DVec3,
    /// The normal of the surface, of unit length within the rounding of f32.
    pub normal: DVec3,
}

impl View {
    /// A wall with a cone of this half angle in degrees, and a dark margin about its spot.
    pub fn spot_on_wall(half_angle: f64) -> Self {
        Self::Wall(half_angle, 1.2)
    }

    /// The position of the light.
    pub fn position(self) -> DVec3 {
        match self {
            Self::Wall(half_angle, _) => on_grid(-AXIS / libm::tan(half_angle.to_radians())),
            Self::Side(..) => DVec3::new(1.5, 4.0, -0.75),
        }
    }

    /// The direction in which the light shines, of any length and exact.
    pub fn axis(self) -> DVec3 {
        match self {
            Self::Wall(..) => -self.position(),
            Self::Side(..) => AXIS,
        }
    }

    /// The position of the light, and the direction in which it shines, as the crate takes them.
    pub fn light(self) -> [Vec3<f32>; 2] {
        [self.position(), self.axis()].map(narrowed)
    }

    /// The point at a pixel of a square picture of `pixels` x `pixels`, from the upper left.
    pub fn place(self, column: u32, row: u32, pixels: u32) -> Place {
        let middle = |i: u32| (2.0 * f64::from(i) + 1.0) / f64::from(pixels) - 1.0;
        let [right, up] = [middle(column), -middle(row)];
        let facing = |point: DVec3| {
            let point = on_grid(point);
            Place { point, normal: rounded((self.position() - point).normalize()) }
        };
        match self {
            Self::Wall(_, reach) => {
                let point = on_grid(reach * (right * ACROSS[0] + up * ACROSS[1]));
                Place { point, normal: rounded(self.position().normalize()) }
            }
            Self::Side(from, to) => {
                let half = 0.5 * (to - from);
                let along = from + half * (right + 1.0);
                facing(self.position() + along * AXIS + half * up * ACROSS[1])
            }
        }
    }

    /// The spotlight of a cone, whose light does not decrease with the distance.
    ///
    /// # Errors
    /// Those of [`SpotLight::new`].
    pub fn spot<P: Falloff + Into<AnyFalloff>>(self, cone: Cone<P>) -> Result<AnyLight, Error> {
        let [position, axis] = self.light();
        Ok(SpotLight::new(position, axis, cone)?.with_attenuation(NoAttenuation).into())
    }
}

/// The nearest vector in f32.
pub(crate) fn narrowed(v: DVec3) -> Vec3<f32> {
    let [x, y, z] = v.as_vec3().to_array();
    Vec3::new(x, y, z)
}

/// The vector with its components rounded to f32.
fn rounded(v: DVec3) -> DVec3 {
    v.as_vec3().as_dvec3()
}
