//! The lights of a source together: one function that lights a point by all of them.

use std::ops::Add;

use luminaire::{AmbientLight, Rgb, Scalar};

use crate::error::ExportError;
use crate::item::Item;
use crate::language::Language;
use crate::name::{check_identifier, names};

/// What the lights of a source are together.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The name, which is an [`identifier`](crate::identifier). If a light has the same name, a number is added.
    pub name: &'a str,
    /// The ambient light, of which the source has the sum.
    pub ambient: &'a [AmbientLight],
}

/// A scene with its lights, and names that none of these has.
pub(crate) struct Together<'a> {
    pub(crate) name: String,
    /// The name of the ambient light beside those of the lights.
    pub(crate) ambient_name: String,
    pub(crate) ambient: &'a [AmbientLight],
    pub(crate) items: &'a [Item<'a>],
}

impl Together<'_> {
    /// Returns the sum of the ambient light in a format.
    pub(crate) fn ambient<S: Scalar>(&self) -> Rgb<S::Irradiance>
    where
        S::Irradiance: Add<Output = S::Irradiance>,
    {
        self.ambient.iter().map(AmbientLight::compile::<S>).fold(Rgb::default(), |sum, light| sum + light)
    }
}

impl<'a> Together<'a> {
    /// Returns a scene with its lights.
    ///
    /// # Errors
    /// A name that is not an identifier, or a language that evaluates each light alone.
    pub(crate) fn new(
        Scene { name, ambient }: &Scene<'a>,
        items: &'a [Item<'a>],
        language: Language,
    ) -> Result<Self, ExportError> {
        check_identifier(name, language)?;
        if !language.has_scenes() {
            let expected = format!("none in {language}, which has each light alone");
            return Err(ExportError::new("scene", name, expected));
        }
        let of_lights = || items.iter().map(|item| item.name);
        let free = |name| names(of_lights().chain([name]), language).pop().unwrap_or_default();
        Ok(Self { name: free(name), ambient_name: free("ambient"), ambient, items })
    }
}
