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

/// Returns a header of C whose text counts once. Another text by the same name is an error of the
/// compiler: with an empty guard, the second of two lights of one name would be left out in
/// silence. `kind` is light, scene or fixture.
pub(crate) fn guarded(name: &str, kind: &str, head: &str, body: &str) -> String {
    // FNV-1a of 32 bits.
    let mixed = |sum: u32, byte: u8| (sum ^ u32::from(byte)).wrapping_mul(0x0100_0193);
    let sum = head.bytes().chain(body.bytes()).fold(0x811c_9dc5, mixed);
    let guard = format!("{name}_{kind}_H").to_ascii_uppercase();
    format!(
        "/* {head} */\n#ifndef {guard}\n#define {guard} {sum:#010x} /* a checksum of this text */\n\n{body}\n\
         #elif {guard} != {sum:#010x}\n#error \"two {kind}s have the name {name}: export one of them by another name\"\n\
         #endif\n"
    )
}
