//! A light as a node of a scene, and its IES profile.

use glam::{DQuat, DVec3};
use luminaire::dynamic::AnyLight;

use super::ies::ies;
use crate::curve::Curve;
use crate::fit::share;
use crate::lamp::{Lamp, Use};
use crate::parameters::Parameters;

/// A light of a scene.
#[derive(Clone, Debug)]
pub struct Entry<'a> {
    /// The light.
    pub lamp: &'a Lamp,
    /// Its parameters in the tool.
    pub found: Parameters,
    /// Its use, for which the parameters were found.
    pub usage: Use,
    /// What to tell of it, a line each.
    pub lines: Vec<String>,
}

/// A light as a node of a scene.
pub(super) struct Node<'a> {
    pub(super) entry: &'a Entry<'a>,
    /// The name as an identifier that no other node has.
    pub(super) name: String,
    pub(super) position: DVec3,
    /// The rotation that turns -z to the axis.
    pub(super) rotation: DQuat,
    pub(super) profile: Option<Profile>,
    pub(super) lines: Vec<String>,
}

/// An IES profile.
pub(super) struct Profile {
    /// The name of the file, which lies beside the scene.
    pub(super) file: String,
    pub(super) text: String,
    /// The intensity of the light's strongest channel, over that of the file.
    pub(super) factor: f64,
    /// The half angle in degrees at which the file's light has ended.
    pub(super) end: f64,
}

/// Returns the node of a light, with a profile if its parameters are not [exact](Parameters::is_exact).
pub(super) fn node<'a>(entry: &'a Entry, name: String, stem: &str) -> Node<'a> {
    let lamp = entry.lamp;
    let (position, axis) = match &lamp.light {
        AnyLight::Spot(spot) => (spot.position().into(), spot.given_axis().into()),
        AnyLight::Measured(light) => (light.position().into(), light.given_axis().into()),
        AnyLight::Point(point) => (point.position().into(), [0.0, 0.0, -1.0]),
        AnyLight::Directional(sun) => ([0.0; 3], sun.given_direction().into()),
    };
    let [position, axis] = [position, axis].map(|own: [f32; 3]| DVec3::from(own.map(f64::from)));
    let rotation = DQuat::from_rotation_arc(DVec3::NEG_Z, axis.normalize_or(DVec3::NEG_Z));
    let (mut lines, mut profile) = (entry.lines.clone(), None);
    if !entry.found.is_exact() {
        match (ies(lamp), lamp.curve()) {
            (Ok(text), Some(curve)) => {
                let file = format!("{stem}-{name}.ies");
                profile = Some(self::profile(entry, file, (text, &curve), &mut lines));
            }
            (Ok(_), None) => {}
            (Err(refusal), _) => lines.push(format!("no IES profile: {refusal}")),
        }
    }
    Node { entry, name, position, rotation, profile, lines }
}

/// Returns the profile of a light, and says how far it is from the light.
fn profile(
    Entry { lamp, found, usage, .. }: &Entry,
    file: String,
    (text, curve): (String, &Curve),
    lines: &mut Vec<String>,
) -> Profile {
    let (peak, _) = curve.peak();
    let by = found.values.iter().map(|(key, value)| format!("{key}={value}")).collect::<Vec<_>>().join(" ");
    lines.push(format!("without {file}, with the differences above: {by}"));
    lines.push(match &lamp.light {
        AnyLight::Spot(spot) if lamp.measured.is_none() => {
            let middles = curve.points().windows(2).map(|pair| (pair[0].0 + pair[1].0) / 2.0);
            let off = |at: f64| 255.0 * (share(&spot.cone(), at) - curve.at(at) / peak).abs();
            let most = middles.map(off).fold(0.0, f64::max);
            format!("{file}: within {most:.3} of 255 codes over the angle, found between its angles")
        }
        _ => format!("{file}: the intensities over the angle that were measured"),
    });
    if let Some(range) = lamp.attenuation().and_then(|attenuation| attenuation.range()) {
        lines.push(format!("{file}: the inverse square alone, without the range {range}"));
    }
    let factor = lamp.at(usage.throw) * usage.throw.powi(2) / peak;
    // A light that does not fall to 0 does so within the last step of the file, 0.0001 degrees.
    Profile { file, text, factor, end: (curve.end() + 2e-4).min(90.0) }
}
