//! The comment that begins a file.

use luminaire::dynamic::AnyLight;

/// Returns the lines of the comment that begins a file.
pub(crate) fn head(light: &AnyLight, name: &str) -> Vec<String> {
    let version = env!("CARGO_PKG_VERSION");
    let mut lines = vec![format!("The light {name}, written by luminaire-export {version}: do not edit.")];
    if let AnyLight::Spot(spot) = light {
        let cone = spot.cone();
        let [beam, field, outer] = [cone.beam(), cone.field(), cone.outer()].map(|angle| angle.to_degrees());
        let falloff = cone.falloff().effect().name();
        lines.push(format!(
            "A spotlight: falloff {falloff}, full angles in degrees: beam {beam:.2}, field {field:.2}, outer {outer:.2}."
        ));
    }
    lines.push("Lengths have the unit of the scene; light is linear, and 1 is full scale.".to_owned());
    lines
}
