//! The ends of a light's dials, found by the checks that take the values between them.

use crate::{
    fixture,
    light::{DialEnds, lumens_of},
    model::{Chosen, is_logarithmic},
    photometry::full_scale,
    refusal::Refusal,
    setting::Setting,
    stage::Stage,
};
use luminaire::{
    Angle, Cone,
    dynamic::AnyLight,
    models::{Accepts, Number},
};
use wasm_bindgen::prelude::*;

/// The ends of the dial of the intensity, as multiples of the light's own intensity.
const INTENSITIES: [f32; 2] = [0.01, 10.0];

/// The same for a fixture whose flux is published, which is its most.
const DIMMED: [f32; 2] = [0.001, 1.0];

/// The usual colour temperatures in kelvin, from a candle to a blue sky. Every light takes them.
const KELVINS: [f32; 2] = [1_800.0, 12_000.0];

/// Number of halvings between a value that is taken and one that is refused.
const HALVINGS: usize = 20;

#[wasm_bindgen]
impl Stage {
    /// Returns the ends of the dials of a light. They stay the same during a gesture.
    #[wasm_bindgen(js_name = dialEnds)]
    pub fn dial_ends(&self, light: usize) -> Result<DialEnds, Refusal> {
        let setting = Setting { is_on: true, ..*self.held(light)? };
        let original = &self.rig().original(&setting)?;
        let full_scale = full_scale(self.state().scene);
        let is_taken: &dyn Fn(&str, f32) -> bool = &|name, value| {
            let mut next = setting;
            next.set_number(name, value, original, full_scale)
                .and_then(|()| self.rig().accept(self.state(), light, &next))
                .is_ok()
        };
        let ends = |name: &str, value: f32, ends: [f32; 2]| {
            ends.map(|end| farthest(value, end, geometric, &|value| is_taken(name, value))).into()
        };
        // Of each number of a model: its usual values, as far as the light takes them.
        let all_ends = |kind: &str, list: &[Number], values: Vec<f32>| -> Vec<f32> {
            let each = (0..).zip(list).zip(values).flat_map(|((place, number), value): ((usize, _), _)| {
                let (name, [least, most]) = (format!("{kind}-{place}"), number.limits);
                let ends = number.usual.map(|end| end.max(least).min(most));
                ends.map(|end| farthest(value, end, middle_of(number), &|value| is_taken(&name, value)))
            });
            each.collect()
        };
        let on = *setting.applied(original, 1.0)?.light();
        let published = setting.fixture.and_then(|fixture| fixture.lumens);
        let own = original.light().intensity();
        let flux = published.or_else(|| lumens_of(original.light(), full_scale * own));
        let own = match (on, flux) {
            (AnyLight::Spot(spot), Some(flux)) => spot.cone().candela(flux),
            _ => full_scale * own,
        };
        // A light that is dark in its scene has the dial of one at full scale.
        let own = if own > 0.0 { own } else { full_scale };
        let shares = if published.is_some() { DIMMED } else { INTENSITIES };
        let mut dials = DialEnds {
            intensity: ends("intensity", own, shares.map(|share| share * own)),
            kelvin: KELVINS.into(),
            law: setting.law.map_or(Vec::new(), |law| all_ends("law", law.list(), law.values())),
            ..DialEnds::default()
        };
        if let AnyLight::Spot(spot) = on {
            let (cone, edge) = (spot.cone(), spot.cone().falloff());
            let outer = [self.state().format.narrowest(edge), Angle::degrees(180.0)]
                .map(|outer| Cone::from_outer(edge, outer).unwrap_or(cone));
            let angle = |name, of: fn(&Cone<_>) -> Angle| {
                ends(name, of(&cone).to_degrees(), outer.each_ref().map(|cone| of(cone).to_degrees()))
            };
            dials.beam = angle("beam", |cone| cone.beam());
            dials.field = angle("field", |cone| cone.field());
            if let Some(edge) = setting.chosen_edge() {
                dials.edge = all_ends("edge", edge.list(), edge.values());
            }
            if let (Some(fixture), Some((_, zoom))) = (setting.fixture, setting.design.one()) {
                dials.zoom = ends("zoom", zoom, fixture::zooms(fixture));
            }
        }
        Ok(dials)
    }
}

/// The value in the middle of the way between two others.
type Middle = fn(f32, f32) -> f32;

fn geometric(a: f32, b: f32) -> f32 {
    (a * b).sqrt()
}

/// Returns how the middle of two values is found on the slider of a number.
fn middle_of(number: &Number) -> Middle {
    match number.accepts {
        Accepts::Whole => |a, b| geometric(a, b).round(),
        _ if is_logarithmic(number) => geometric,
        _ => |a, b| 0.5 * (a + b),
    }
}

/// Returns the end, or the value nearest to it that is taken, between the end and the light's own value.
fn farthest(value: f32, end: f32, middle: Middle, is_taken: &dyn Fn(f32) -> bool) -> f32 {
    if is_taken(end) {
        return end;
    }
    // A light at an end of its dial may be a rounding error beyond it.
    let inside = [1.0, 1.0 + 1e-6, 1.0 - 1e-6, 1.0 + 1e-5, 1.0 - 1e-5].map(|share| share * value);
    let Some(mut taken) = inside.into_iter().find(|&value| is_taken(value)) else { return value };
    let mut refused = end;
    for _ in 0..HALVINGS {
        let middle = middle(taken, refused);
        if is_taken(middle) { taken = middle } else { refused = middle }
    }
    taken
}
