//! LEDs at their places.

use luminaire::{Fx16, Scalar};

use super::LedMap;
use crate::refusal::Refusal;

/// The side from which an LED takes light.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Facing {
    /// The side that the map says, or without that [`Out`](Self::Out).
    Map,
    /// The side away from the upright axis through the middle of the LEDs.
    Out,
    /// All sides: a light counts in full whatever its direction.
    All,
}

/// The axis of a map that points up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Up {
    /// As in the coordinates of the lights.
    Y,
    /// As in most maps of trees.
    Z,
}

/// LEDs in the lights' coordinates, whose y axis points up.
#[derive(Clone, PartialEq, Debug)]
pub struct PlacedLeds {
    /// The places in units of the lights, in steps of 2^-16 as programs hold them.
    pub places: Vec<[f64; 3]>,
    /// The side from which they take light: [`Facing::Map`] only if the map says so.
    pub side: Facing,
    /// The unit vectors of the ways that they face, in steps of 2^-14; none for LEDs that take light from all sides.
    pub facing: Option<Vec<[f64; 3]>>,
    /// The middle from above: x and z.
    pub middle: [f64; 2],
}

impl PlacedLeds {
    /// Places the LEDs of a map. A `height` scales the map, and moves its lowest LED to 0 and its middle above the origin.
    ///
    /// # Errors
    /// A height that is not positive, or of LEDs that are all equally high; a place beyond the coordinates of `Fx16`.
    pub fn new(map: LedMap, up: Up, facing: Facing, height: Option<f64>) -> Result<Self, Refusal> {
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
        let rounded =
            |own: [f64; 3], bits: i32| own.map(|c| (c * 2_f64.powi(bits)).round() / 2_f64.powi(bits));
        let facing = facing.map(|facing| facing.into_iter().map(|way| rounded(unit(way), 14)).collect());
        let places = places.into_iter().map(|place| rounded(place, 16)).collect();
        Ok(Self { places, side, facing, middle })
    }
}
