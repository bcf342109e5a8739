//! LEDs at their places, and the light that reaches them.

use luminaire::dynamic::AnyLight;
use luminaire::{Fx16, Scalar, Vec3};
use luminaire_exchange::Refusal;

use super::map::Map;
use super::options::{Facing, Up};

/// LEDs in the lights' coordinates, whose y axis points up.
pub(super) struct Placed {
    pub(super) places: Vec<[f64; 3]>,
    /// The side from which they take light: `map` only if the map says so.
    pub(super) side: Facing,
    /// Unit vectors; none for LEDs that take light from all sides.
    pub(super) facing: Option<Vec<[f64; 3]>>,
    /// The middle from above: x and z.
    pub(super) middle: [f64; 2],
}

impl Placed {
    pub(super) fn new(map: Map, up: Up, facing: Facing, height: Option<f64>) -> Result<Self, Refusal> {
        let upright = |[x, y, z]: [f64; 3]| match up {
            Up::Y => [x, y, z],
            Up::Z => [x, z, 0.0 - y],
        };
        let mut places: Vec<_> = map.places.into_iter().map(upright).collect();
        let ends = |axis: usize, places: &[[f64; 3]]| {
            let all = places.iter().map(|place| place[axis]);
            all.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], own| [least.min(own), most.max(own)])
        };
        let middle = |places: &[[f64; 3]]| [0, 2].map(|axis| ends(axis, places).iter().sum::<f64>() / 2.0);
        if let Some(height) = height {
            let ([low, high], [x, z]) = (ends(1, &places), middle(&places));
            let scale = height / (high - low);
            if !(scale.is_finite() && scale > 0.0) {
                let expected = "a height over 0, and LEDs at more than one: --up chooses the axis";
                return Err(Refusal::new("height", height, expected));
            }
            for place in &mut places {
                *place = [(place[0] - x) * scale, (place[1] - low) * scale, (place[2] - z) * scale];
            }
        }
        let farthest = f64::from(Fx16::FARTHEST);
        if let Some((led, place)) =
            (0..).zip(&places).find(|(_, place)| place.iter().any(|c| c.abs() > farthest))
        {
            let expected = format_args!("coordinates up to {farthest}: scale the map by --height");
            return Err(
                Refusal::new("place", format_args!("{place:?}"), expected).at(format_args!("LED {led}"))
            );
        }
        let middle = middle(&places);
        let outward = |[x, _, z]: &[f64; 3]| [x - middle[0], 0.0, z - middle[1]];
        let (side, facing): (_, Option<Vec<_>>) = match (facing, map.facing) {
            (Facing::All, _) => (Facing::All, None),
            (Facing::Map, Some(facing)) => (Facing::Map, Some(facing.into_iter().map(upright).collect())),
            (Facing::Map | Facing::Out, _) => (Facing::Out, Some(places.iter().map(outward).collect())),
        };
        // An LED on the axis itself faces up.
        let unit = |way: [f64; 3]| {
            let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
            if length > 1e-9 && length.is_finite() { way.map(|c| c / length) } else { [0.0, 1.0, 0.0] }
        };
        let facing = facing.map(|facing| facing.into_iter().map(unit).collect());
        Ok(Self { places, side, facing, middle })
    }

    /// Returns how many LEDs have light other than the ambient one.
    pub(super) fn lit<'a>(&self, lights: impl Iterator<Item = &'a AnyLight>) -> Result<usize, Refusal> {
        let lights = lights.map(AnyLight::compile::<f32>).collect::<Result<Vec<_>, _>>()?;
        let vector = |own: [f64; 3]| Vec3::from(own.map(|c| c as f32));
        let is_lit = |led: &usize| {
            let place = vector(self.places[*led]);
            let facing = self.facing.as_ref().map(|facing| vector(facing[*led]));
            lights.iter().any(|light| {
                let facing = facing.map(|facing| light.irradiance(place, facing));
                facing.unwrap_or_else(|| light.irradiance_facing(place)) > 0.0
            })
        };
        Ok((0..self.places.len()).filter(is_lit).count())
    }

    /// Refuses a light whose position would leave the coordinates of the format as it turns about the LEDs.
    pub(super) fn check_turn(&self, light: &AnyLight) -> Result<(), Refusal> {
        let position = match light {
            AnyLight::Spot(light) => light.position(),
            AnyLight::Point(light) => light.position(),
            AnyLight::Measured(light) => light.position(),
            AnyLight::Directional(_) => return Ok(()),
        };
        let [x, z] = self.middle;
        let distance = (f64::from(position.x) - x).hypot(f64::from(position.z) - z);
        let most = f64::from(Fx16::FARTHEST) - x.abs().max(z.abs());
        if distance <= most {
            return Ok(());
        }
        let expected = format_args!(
            "at most {most} for a light that turns about them: --turn 0 lets it stand still, or place it nearer"
        );
        Err(Refusal::new("distance from the middle of the LEDs", distance, expected))
    }
}
