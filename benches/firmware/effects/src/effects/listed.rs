//! The effects of the models in the library's lists.

use luminaire::light::{CompiledMaterial, CompiledSpotLight};
#[allow(clippy::wildcard_imports, reason = "the types of the lists")]
use luminaire::{attenuation::*, falloff::*, specular::*};

use crate::constants::DIRECTIONAL;
use crate::{Format, Irradiance, Light, Surface};

/// A model of a list, and the effect that shows its cost.
pub trait Listed {
    /// The name of the program.
    const NAME: &'static str;
    /// The compiled light or material that has the model.
    type Constant;
    /// The value of the constant, which the build script has written.
    const CONSTANT: Self::Constant;
    /// The result of the effect.
    type Output;

    /// The effect at a surface point.
    fn effect(surface: Surface) -> Self::Output;
}

/// Implements [`Listed`] for a model. Its effect is the irradiance of a constant spotlight that has
/// the model.
macro_rules! spotlight {
    ($type:ty = $name:expr, $constant:ty) => {
        impl Listed for $type {
            const NAME: &'static str = $name;
            type Constant = $constant;
            const CONSTANT: Self::Constant = include!(concat!(env!("OUT_DIR"), "/", $name, ".rs"));
            type Output = Irradiance;

            #[inline(always)]
            fn effect(Surface { point, normal, .. }: Surface) -> Irradiance {
                Self::CONSTANT.irradiance(point, normal)
            }
        }
    };
}

macro_rules! falloffs {
    ($($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr;)*) => {
        $(spotlight!($type = concat!("spot-", $name, "-lambert"), CompiledSpotLight<Format, $type, NoAttenuation>);)*

        fn falloffs(visit: &mut impl super::Visit) {
            $(visit.surface(<$type>::NAME, <$type>::effect);)*
        }
    };
}
luminaire::constant_falloffs!(falloffs);

macro_rules! attenuations {
    ($($(#[$doc:meta])* $variant:ident($run_time:ty) = any $any:expr
       $(, $(#[$its_doc:meta])* $type:ty = $name:literal, $value:expr)*;)*) => {
        $($(spotlight!($type = concat!("spot-soft-lambert-", $name), CompiledSpotLight<Format, Soft, $type>);)*)*

        fn attenuations(visit: &mut impl super::Visit) {
            $($(visit.surface(<$type>::NAME, <$type>::effect);)*)*
        }
    };
}
luminaire::attenuations!(attenuations);

macro_rules! lobes {
    ($($(#[$doc:meta])* $type:ty = $name:literal, $value:expr;)*) => {
        $(impl Listed for $type {
            const NAME: &'static str = $name;
            type Constant = CompiledMaterial<Format, $type>;
            const CONSTANT: Self::Constant = include!(concat!(env!("OUT_DIR"), "/", $name, ".rs"));
            type Output = Light;

            #[inline(always)]
            fn effect(surface: Surface) -> Light {
                Self::CONSTANT.reflect(&surface, &DIRECTIONAL)
            }
        })*

        fn lobes(visit: &mut impl super::Visit) {
            $(visit.surface(<$type>::NAME, <$type>::effect);)*
        }
    };
}
luminaire::lobes!(lobes);

pub(super) fn each(visit: &mut impl super::Visit) {
    falloffs(visit);
    attenuations(visit);
    lobes(visit);
}
