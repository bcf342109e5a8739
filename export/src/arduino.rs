//! The library for Arduino's IDE.

use luminaire::{Angle, Cone, SpotLight};

use crate::{ExportError, Language, c_header, export};

/// Returns the files of a library for Arduino's IDE, by their paths in its folder: the file that all
/// lights in [`Language::CFixed`] include, and the example *Wall*.
///
/// Its `url` is the `repository` of this crate's manifest; without one there is no `url`.
///
/// # Errors
/// None is known: the light of the example can be exported.
pub fn arduino() -> Result<Vec<(&'static str, String)>, ExportError> {
    let mut properties = include_str!("../arduino/library.properties").to_owned();
    properties += concat!("version=", env!("CARGO_PKG_VERSION"), "\n");
    if !env!("CARGO_PKG_REPOSITORY").is_empty() {
        properties += concat!("url=", env!("CARGO_PKG_REPOSITORY"), "\n");
    }
    // What the sketch says of its light.
    let key = SpotLight::new([2.5, 1.0, 3.0], [0.0, 0.0, -1.0], Cone::soft(Angle::degrees(40.0))?)?;
    let key = export(key.with_intensity(9.0)?, "key", Language::CFixed)?;
    Ok(vec![
        ("library.properties", properties),
        ("README.md", include_str!("../arduino/README.md").to_owned()),
        ("LICENSE", include_str!("../LICENSE-MIT").to_owned()),
        ("LICENSE-APACHE", include_str!("../LICENSE-APACHE").to_owned()),
        ("src/luminaire.h", c_header()),
        ("examples/Wall/Wall.ino", include_str!("../arduino/examples/Wall/Wall.ino").to_owned()),
        ("examples/Wall/key.h", key),
    ])
}
