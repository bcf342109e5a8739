//! The scene of the comparison: a wall perpendicular to one beam.

use crate::refusal::Refusal;
use luminaire::{Cone, HalfAngle, SpotLight, Vec3, attenuation::NoAttenuation, falloff::Soft};
use luminaire_kernels::{
    scene::{AXIS, Site},
    truth::widened,
};
use luminaire_oracle::DVec3;

/// Narrowest outer half angle in degrees: the wall is then 29 km away, just within the range of
/// fixed point.
pub(crate) const NARROWEST: f32 = 0.002;
/// The widest outer half angle in degrees.
pub(crate) const WIDEST: f32 = 60.0;

/// Distance from the centre of the picture to its edge, in radii of the spot of light.
const REACH: f64 = 1.2;

/// Two unit vectors in the wall, orthogonal to each other and to the axis: the picture's right and
/// top.
const ACROSS: [DVec3; 2] = [DVec3::new(-0.8, 0.0, 0.6), DVec3::new(0.48, 0.6, 0.64)];

/// The wall and a soft beam. The distance is chosen so that the spot of light has a radius of one
/// metre for every angle of the beam: a narrower beam comes from farther away and gives the same
/// picture.
#[derive(Clone, Debug)]
pub(crate) struct Wall {
    /// The site of each pixel, row by row from the top.
    sites: Vec<Site>,
    spot: SpotLight<Soft, NoAttenuation>,
    half_angle: f32,
    distance: f64,
}

impl Wall {
    /// A wall as a square picture of `pixels` x `pixels` pixels, lit by a beam with this outer half
    /// angle in degrees.
    pub(crate) fn new(pixels: u32, half_angle: f32) -> Result<Self, Refusal> {
        let place = |i: u32| REACH * ((2.0 * f64::from(i) + 1.0) / f64::from(pixels) - 1.0);
        let normal = AXIS.map(|c| -c);
        let sites = (0..pixels)
            .flat_map(|row| (0..pixels).map(move |column| [place(column), -place(row)]))
            .map(|[right, up]| Site { point: on_grid(right * ACROSS[0] + up * ACROSS[1]), normal })
            .collect();
        let (spot, distance) = light(half_angle)?;
        Ok(Self { sites, spot, half_angle, distance })
    }

    /// Sets the outer half angle in degrees, and the distance at which the spot of light keeps its
    /// size.
    pub(crate) fn set_half_angle(&mut self, degrees: f32) -> Result<(), Refusal> {
        (self.spot, self.distance) = light(degrees)?;
        self.half_angle = degrees;
        Ok(())
    }

    /// The site of each pixel, row by row from the top.
    pub(crate) fn sites(&self) -> &[Site] {
        &self.sites
    }

    /// The light.
    pub(crate) fn spot(&self) -> &SpotLight<Soft, NoAttenuation> {
        &self.spot
    }

    /// The axis of the light before any format rounds it: it points at the centre of the wall.
    pub(crate) fn axis(&self) -> DVec3 {
        -widened(self.spot.position())
    }

    /// The outer half angle in degrees.
    pub(crate) fn half_angle(&self) -> f32 {
        self.half_angle
    }

    /// Distance from the light to the wall, in metres.
    pub(crate) fn distance(&self) -> f64 {
        self.distance
    }

    /// Returns the angle off axis of a pixel, in degrees.
    pub(crate) fn off_axis(&self, pixel: usize) -> f64 {
        let radius = self.sites.get(pixel).map_or(0.0, |site| widened(site.point).length());
        (radius / self.distance).atan().to_degrees()
    }
}

/// Returns the light with this outer half angle in degrees, and the distance of the light from the
/// centre of the wall.
fn light(half_angle: f32) -> Result<(SpotLight<Soft, NoAttenuation>, f64), Refusal> {
    if !(NARROWEST..=WIDEST).contains(&half_angle) {
        return Err(Refusal::outside("half angle", half_angle, [NARROWEST, WIDEST], "degrees"));
    }
    let distance = 1.0 / f64::from(half_angle).to_radians().tan();
    let position = on_grid(-distance * widened(AXIS).normalize());
    let cone = Cone::from_outer(Soft, HalfAngle::degrees(half_angle))?;
    let spot = SpotLight::new(position, position.map(|c| -c), cone)?;
    Ok((spot.with_attenuation(NoAttenuation), distance))
}

/// Rounds to the nearest position that every number format represents: a multiple of 2^-16 in f32.
fn on_grid(v: DVec3) -> Vec3<f32> {
    let [x, y, z] = luminaire_oracle::on_grid(v).as_vec3().to_array();
    Vec3::new(x, y, z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use luminaire_oracle::{half_degrees, versine_between};

    #[test]
    fn the_spot_is_one_metre_in_radius_whatever_the_angle() {
        for half_angle in [NARROWEST, 0.01, 0.5, 7.5, 30.0, WIDEST] {
            let wall = Wall::new(64, half_angle).unwrap();
            let light = widened(wall.spot().position());
            for (pixel, site) in wall.sites().iter().enumerate() {
                let point = widened(site.point);
                let versine = versine_between(point - light, wall.axis());
                let (radius, outer) = (point.length(), f64::from(wall.spot().cone().outer_versine()));
                // The axis and the position of the light are rounded to f32, which moves the spot
                // by an amount proportional to the distance.
                if (radius - 1.0).abs() > 0.005 {
                    assert_eq!(versine < outer, radius < 1.0, "{half_angle}: radius {radius}");
                }
                let off_axis = half_degrees(versine);
                let tolerance = 0.005 * f64::from(half_angle);
                assert!((wall.off_axis(pixel) - off_axis).abs() < tolerance, "{half_angle}: {off_axis}");
            }
        }
    }

    #[test]
    fn the_picture_is_upright_and_square_to_the_beam() {
        let wall = Wall::new(8, 10.0).unwrap();
        let [first, .., last] = wall.sites() else { panic!("no pixels") };
        let along = |site: &Site, direction| widened(site.point).dot(direction);
        assert!(along(first, ACROSS[0]) < 0.0 && along(first, ACROSS[1]) > 0.0);
        assert!(along(last, ACROSS[0]) > 0.0 && along(last, ACROSS[1]) < 0.0);
        for [a, b] in [[ACROSS[0], ACROSS[1]], [ACROSS[0], widened(AXIS)], [ACROSS[1], widened(AXIS)]] {
            assert!(a.dot(b).abs() < 1e-7 && (a.length_squared() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn an_angle_without_a_wall_is_refused_and_leaves_the_light() {
        let mut wall = Wall::new(8, 10.0).unwrap();
        let spot = *wall.spot();
        for degrees in [0.0, -1.0, 0.001, 61.0, f32::NAN, f32::INFINITY] {
            let message = wall.set_half_angle(degrees).unwrap_err().to_string();
            assert!(
                message.contains("half angle") && message.contains("expected 0.002 to 60 degrees"),
                "{message}"
            );
        }
        assert_eq!((*wall.spot(), wall.half_angle()), (spot, 10.0));
    }
}
