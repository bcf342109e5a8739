//! The channels by which a console controls a light, as source.

use std::fmt::Write;

use luminaire::dmx::Patch;

use crate::error::ExportError;
use crate::head::guarded;
use crate::language::Language;
use crate::name::{check_identifier, global};

/// The channels of a fixture, in words of the standard.
const NAMES: [&str; 8] = ["pan", "tilt", "zoom", "dimmer", "red", "green", "blue", "white"];

/// Returns the channels of a fixture as source beside its lights: in C with a function that makes the light of a universe, from
/// those of the narrowest and of the widest zoom, which have these names; in Rust as a constant.
///
/// # Errors
/// A name that is not its own [`identifier`](crate::identifier) in the language, or a language without channels:
/// [`Language::has_channels`].
pub fn export_patch(ends: [&str; 2], patch: &Patch, language: Language) -> Result<String, ExportError> {
    if !language.has_channels() {
        return Err(ExportError::new(
            "language",
            language.name(),
            "c-fx16, rust-f32, rust-fx32 or rust-fx16",
        ));
    }
    ends.into_iter().try_for_each(|name| check_identifier(name, language))?;
    let about = format!("The channels of the fixture {}: {}", ends[0], told(patch));
    Ok(if language == Language::CFixed { in_c(ends, patch, &about) } else { in_rust(ends[0], patch, &about) })
}

/// Returns which slots have which channel.
fn told(patch: &Patch) -> String {
    let channels = patch.channels();
    let slots = NAMES.iter().zip(channels).filter_map(|(name, channel)| match channel.slots() {
        [0, _] => None,
        [coarse, 0] => Some(format!("{name} {coarse}")),
        [coarse, fine] => Some(format!("{name} {coarse} and {fine}")),
    });
    slots.collect::<Vec<_>>().join(", ")
}

fn in_c([narrow, wide]: [&str; 2], patch: &Patch, about: &str) -> String {
    let each = patch.channels().map(|channel| {
        let ([coarse, fine], [from, to]) = (channel.slots(), channel.ends());
        format!("{{ {coarse}, {fine}, INT32_C({from}), INT32_C({to}) }}")
    });
    let [pan, tilt, zoom, dimmer, red, green, blue, white] = &each;
    let rows = patch.mount().map(|row| format!("{{ {} }}", row.map(|c| format!("INT32_C({c})")).join(", ")));
    let (constant, function) = (global(narrow, "patch"), format!("{narrow}_patched"));
    let [from, to] = [narrow, wide].map(|name| global(name, "light"));
    let irradiance = format!("{narrow}_patched_irradiance");
    let inner = format!("luminaire_{narrow}_Irradiance");
    let mut body = String::from("#include \"luminaire_dmx.h\"\n\n");
    let _ = write!(
        body,
        "/* The channels. */\nstatic const luminaire_patch {constant} = {{\n    {pan},\n    {tilt},\n    {zoom},\n    {dimmer},\n    \
         {{ {red},\n      {green},\n      {blue} }},\n    {white},\n    {{ {} }}\n}};\n\n\
         /* Makes the light of the fixture by the slots of a universe, of which the first is slot 1. */\n\
         static inline void {function}(luminaire_spot *spot, const uint8_t *universe, uint32_t count) {{\n    \
         luminaire_spot_patch(spot, &{from}, &{to}, &{constant}, universe, count);\n}}\n\n\
         /* Returns the irradiance of that light at a point with a unit normal, before its colour, in steps of 2^-14. */\n\
         static inline uint32_t {irradiance}(const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]) {{\n    \
         return spot && point && normal ? {inner}(spot, point, normal) : 0;\n}}\n",
        rows.join(", ")
    );
    guarded(narrow, "fixture", about, &body)
}

fn in_rust(name: &str, patch: &Patch, about: &str) -> String {
    let each = patch.channels().map(|channel| {
        format!(
            "luminaire::dmx::Channel::from_parts({:?}, {:?}),\n            ",
            channel.slots(),
            channel.ends()
        )
    });
    format!(
        "/// {about}.\npub mod {name}_patch {{\n    /// The channels.\n    pub const PATCH: luminaire::dmx::Patch = \
         luminaire::dmx::Patch::from_parts(\n        [\n            {}\n        ],\n        {:?},\n    );\n}}\n",
        each.concat().trim_end(),
        patch.mount()
    )
}
