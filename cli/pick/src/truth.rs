//! The exact light of any kind, in f64.

use luminaire::Vec3;
use luminaire::attenuation::Attenuation;
use luminaire::bound::ErrorBound;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{Falloff, Formula};
use luminaire_oracle::{DVec3, half_degrees, versine_between};

/// The exact light: the formulas that define its falloff and its attenuation, in f64.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Truth {
    light: AnyLight,
    /// The position; of a directional light the origin.
    pub(crate) position: DVec3,
    /// The unit axis; of a point light any.
    pub(crate) axis: DVec3,
}

/// Returns the angle of a versine, in radians.
fn angle(versine: f64) -> f64 {
    half_degrees(versine).to_radians()
}

fn exact(v: Vec3<f32>) -> DVec3 {
    DVec3::from_array(<[f32; 3]>::from(v).map(f64::from))
}

impl Truth {
    pub(crate) fn of(light: AnyLight) -> Self {
        let (position, axis) = match &light {
            AnyLight::Spot(spot) => (exact(spot.position()), exact(spot.given_axis()).normalize()),
            AnyLight::Point(point) => (exact(point.position()), DVec3::NEG_Y),
            AnyLight::Measured(light) => (exact(light.position()), exact(light.given_axis()).normalize()),
            AnyLight::Directional(sun) => (DVec3::ZERO, exact(sun.given_direction()).normalize()),
        };
        Self { light, position, axis }
    }

    /// Returns whether the light has a position.
    pub(crate) fn is_placed(&self) -> bool {
        match self.light {
            AnyLight::Spot(_) | AnyLight::Point(_) | AnyLight::Measured(_) => true,
            AnyLight::Directional(_) => false,
        }
    }

    /// Returns the angle in radians off the axis at which the light ends.
    pub(crate) fn half_angle(&self) -> f64 {
        match &self.light {
            AnyLight::Spot(spot) => angle(spot.cone().versines()[2].into()),
            AnyLight::Point(_) | AnyLight::Measured(_) => std::f64::consts::PI,
            AnyLight::Directional(_) => 0.0,
        }
    }

    /// Returns the direction from a point towards the light, of unit length, and the distance, which is 0 for a
    /// directional light.
    fn way(&self, point: DVec3) -> (DVec3, f64) {
        if !self.is_placed() {
            return (-self.axis, 0.0);
        }
        let way = self.position - point;
        let distance = way.length();
        (way / distance, distance)
    }

    /// Returns the angle in degrees off the axis at which a point lies; 0 for a light without a cone.
    pub(crate) fn degrees_off_axis(&self, point: DVec3) -> f64 {
        match self.light {
            AnyLight::Spot(_) => half_degrees(versine_between(point - self.position, self.axis)),
            AnyLight::Point(_) | AnyLight::Measured(_) | AnyLight::Directional(_) => 0.0,
        }
    }

    /// Returns the distance of a point, and the cosine of the angle of incidence on a surface there.
    pub(crate) fn incidence(&self, point: DVec3, normal: DVec3) -> (f64, f64) {
        let (way, distance) = self.way(point);
        // The cosine of a stored normal, which may be too long by its rounding, is capped at 1.
        (distance, way.dot(normal).clamp(0.0, 1.0))
    }

    /// Returns the light that arrives at a surface that faces the light.
    pub(crate) fn arriving(&self, point: DVec3) -> f64 {
        let distance = self.way(point).1;
        match &self.light {
            AnyLight::Spot(spot) => {
                let [inner, outer, limit] = spot.cone().versines().map(f64::from);
                let (falloff, versine) =
                    (spot.cone().falloff(), versine_between(point - self.position, self.axis));
                let share = if versine >= limit {
                    0.0
                } else if versine <= inner {
                    falloff.formula().exact(1.0)
                } else {
                    falloff.formula().exact((outer - versine) / (outer - inner))
                };
                f64::from(spot.intensity()) * share * spot.attenuation().exact(distance)
            }
            AnyLight::Point(light) => f64::from(light.intensity()) * light.attenuation().exact(distance),
            AnyLight::Measured(light) => {
                let DVec3 { x, y, z } = point - self.position;
                light.exact_intensity(Vec3::new(x, y, z)) * light.attenuation().exact(distance)
            }
            AnyLight::Directional(light) => light.intensity().into(),
        }
    }

    /// Returns the light on the axis that arrives at a surface that faces the light at a distance; of a measured light,
    /// that of full intensity.
    pub(crate) fn most(&self, distance: f64) -> f64 {
        if let AnyLight::Measured(light) = &self.light {
            return f64::from(light.intensity()) * light.attenuation().exact(distance);
        }
        self.arriving(self.position + distance * self.axis)
    }

    /// Returns the light that arrives at a surface point, by Lambert's cosine.
    pub(crate) fn irradiance(&self, point: DVec3, normal: DVec3) -> f64 {
        self.arriving(point) * self.incidence(point, normal).1
    }

    /// Returns whether the light jumps so near to a point that a bound does not hold there.
    pub(crate) fn jumps_near(&self, point: DVec3, bound: &ErrorBound) -> bool {
        let at_range = |range: Option<f32>| {
            let distance = self.way(point).1;
            range.is_some_and(|range| (distance - f64::from(range)).abs() < f64::from(bound.range))
        };
        match &self.light {
            AnyLight::Spot(spot) => {
                let [inner, _, limit] = spot.cone().versines().map(|versine| angle(versine.into()));
                let off = angle(versine_between(point - self.position, self.axis));
                let is_near = |edge: f64| (off - edge).abs() < f64::from(bound.edge);
                // An inverted power below 1 has an infinite derivative at the hotspot.
                let falloff = spot.cone().falloff();
                let is_steep = matches!(falloff.formula(), Formula::InvertedPower(p, _) if p < 1.0);
                at_range(spot.attenuation().range()) || is_near(limit) || (is_steep && is_near(inner))
            }
            AnyLight::Point(point) => at_range(point.attenuation().range()),
            AnyLight::Measured(light) => at_range(light.attenuation().range()),
            AnyLight::Directional(_) => false,
        }
    }
}
