//! Luminaires: lamps with what is mounted in front of them.

use crate::{
    effect::{Effect, Effects},
    error::{Accepted, Error, Parameter},
    lamp::Lamp,
};

/// A lamp as a scene has it: with the shadows that are asked for, or without.
///
/// ```
/// use luminaire::{Angle, Cone, Luminaire, Soft, Spot, Vec3};
/// let cone = Cone::from_field(Soft, Angle::degrees(15.0))?;
/// let spot = Spot::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?;
/// let key = Luminaire::from(spot).with_shadow(512)?;
/// assert_eq!(key.effects().to_string(), "diffuse, spot, soft, inverse-square, shadow");
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Luminaire {
    lamp: Lamp,
    shadow: Option<u16>,
}

/// The sides that a shadow map may have, in texels.
const SHADOW_SIDES: (u32, u32) = (16, 2048);

impl Luminaire {
    /// The same luminaire with shadows, by a map of so many texels a side. Only the light of spotlights has any.
    ///
    /// # Errors
    /// A side that is not from 16 to 2048.
    pub fn with_shadow(self, side: u16) -> Result<Self, Error> {
        let (least, most) = SHADOW_SIDES;
        if (least..=most).contains(&u32::from(side)) {
            Ok(Self { shadow: Some(side), ..self })
        } else {
            let accepted = Accepted::WholeBetween(least, most);
            Err(Error { parameter: Parameter::ShadowSide, value: side.into(), accepted })
        }
    }

    /// The same luminaire with another lamp, as one that has turned or is dimmed: all else that is asked for stays.
    pub fn with_lamp(self, lamp: impl Into<Lamp>) -> Self {
        Self { lamp: lamp.into(), ..self }
    }

    /// The lamp.
    pub fn lamp(&self) -> &Lamp {
        &self.lamp
    }

    /// The side of the shadow map, in texels; nothing where there are no shadows.
    pub fn shadow(&self) -> Option<u16> {
        self.shadow
    }

    /// What the luminaire calls for; nothing where its lamp is dark.
    pub fn effects(&self) -> Effects {
        let effects = self.lamp.effects();
        let casts_shadow = self.shadow.is_some() && effects.has(Effect::Spot);
        if casts_shadow { effects.with(Effect::Shadow) } else { effects }
    }
}

impl<L: Into<Lamp>> From<L> for Luminaire {
    fn from(lamp: L) -> Self {
        Self { lamp: lamp.into(), shadow: None }
    }
}
