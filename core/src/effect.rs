//! Effects that a scene may require, and sets of effects.

use core::fmt;

use crate::models::{attenuations, falloffs};

/// Declares the effects with their names: first those in brackets and the falloffs, then those in
/// further brackets, the attenuations, and the rest. The names are the keys of the cost list.
macro_rules! effects {
    (@falloffs [$($before:tt)*] $after:tt $rest:tt
     $(#[doc = $doc:literal] $falloff:ident($type:ty) = $name:literal, $truth:expr
       $(, constant $constant:ty = $its_name:literal, $value:expr, $its_truth:expr)?;)*) => {
        attenuations! { effects; @attenuations [$($before)* $(#[doc = $doc] $falloff = $name,)*] $after $rest }
    };
    (@attenuations [$($before:tt)*] [$($after:tt)*] [$($rest:tt)*]
     $(#[doc = $doc:literal] $variant:ident($type:ty) $(from $law:ty)? = $law_name:literal
       $(, effect #[doc = $effect_doc:literal] $effect:ident = $name:literal)?
       $(, #[doc = $its_doc:literal] $constant:ty = $its_name:literal)*;)*) => {
        effects! { $($before)* $($after)* $($(#[doc = $effect_doc] $effect = $name,)?)* $($rest)* }
    };
    ($($(#[$meta:meta])* $effect:ident = $name:literal,)*) => {
        /// An effect that a scene may require. An effect costs nothing in scenes that do not
        /// require this effect.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        #[non_exhaustive]
        pub enum Effect {
            $($(#[$meta])* $effect,)*
        }

        impl Effect {
            /// All effects.
            pub const ALL: &[Self] = &[$(Self::$effect,)*];

            /// Returns the name of the effect, as in the cost list.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$effect => $name,)*
                }
            }
        }
    };
}

falloffs! { effects; @falloffs [
    /// Ambient light.
    Ambient = "ambient",
    /// Lambert's cosine.
    Diffuse = "diffuse",
    /// Specular lobes.
    Specular = "specular",
    /// A directional light.
    Directional = "directional",
    /// A point light.
    Point = "point",
    /// A spotlight.
    Spot = "spot",
    /// A measured light, which is not round.
    Measured = "measured",
] [
    /// Full intensity up to an inner angle.
    Hotspot = "hotspot",
    /// A cutoff: a cone that ends before its falloff does.
    Cutoff = "cutoff",
] [
    /// A window that ends the light at a range.
    Window = "window",
    /// A range at which a light ends.
    Range = "range",
    /// A gobo: a pattern that a spotlight projects.
    Gobo = "gobo",
    /// A shadow map of a spotlight.
    Shadow = "shadow",
    /// The visible beam of a spotlight in haze.
    Haze = "haze",
    /// Dithering against banding.
    Dither = "dither",
]}

/// A set of effects.
///
/// ```
/// use luminaire::dynamic::{Effect, Effects};
/// let effects = Effects::NONE.with(Effect::Soft).with(Effect::Spot);
/// assert!(effects.has(Effect::Soft) && !effects.has(Effect::Gobo));
/// assert_eq!(effects.to_string(), "spot, soft");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Effects(u64);

impl Effects {
    /// No effect.
    pub const NONE: Self = Self(0);
    /// Every effect.
    pub const ALL: Self = {
        let (mut all, mut rest) = (Self::NONE, Effect::ALL);
        while let [effect, others @ ..] = rest {
            (all, rest) = (all.with(*effect), others);
        }
        all
    };

    /// Returns the set with one more effect.
    #[must_use]
    pub const fn with(self, effect: Effect) -> Self {
        Self(self.0 | 1 << effect as u32)
    }

    /// Returns the union of both sets.
    #[must_use]
    pub(crate) const fn union(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Returns whether the effect is in the set.
    pub const fn has(self, effect: Effect) -> bool {
        self.0 >> effect as u32 & 1 == 1
    }

    /// Returns the effects in the order of [`Effect::ALL`].
    pub fn iter(self) -> impl Iterator<Item = Effect> {
        Effect::ALL.iter().copied().filter(move |effect| self.has(*effect))
    }
}

/// Writes the names of the effects, separated by commas.
impl fmt::Display for Effects {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, effect) in self.iter().enumerate() {
            let comma = if number > 0 { ", " } else { "" };
            write!(out, "{comma}{}", effect.name())?;
        }
        Ok(())
    }
}

impl fmt::Debug for Effects {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_set().entries(self.iter()).finish()
    }
}
