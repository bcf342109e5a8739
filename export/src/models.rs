//! The list of models, for what the kernel itself does not tell.

use luminaire::attenuation::{
    AnyAttenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
    Windowed,
};
use luminaire::falloff::AnyFalloff;

use crate::fixed::FixedAttenuation;
use crate::json::DescribedAttenuation;
use crate::shader::FloatAttenuation;

macro_rules! falloff_name {
    ([$any:expr] $($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr
       $(, any $draw:expr)? $(, constant $constant:ty = $its_name:literal, $value:expr, $its_truth:expr)?;)*) => {
        match $any {
            $(AnyFalloff::$variant(_) => $name,)*
            _ => unreachable!("the list has every falloff"),
        }
    };
}

/// Returns the name of a falloff in the list.
pub(crate) fn falloff_name(falloff: AnyFalloff) -> &'static str {
    luminaire::falloffs! { falloff_name; [falloff] }
}

/// An attenuation that can be exported: an attenuation of the list without an implementation of one
/// of these traits does not compile here.
pub(crate) trait Exported: FloatAttenuation + FixedAttenuation + DescribedAttenuation {}

impl<A: FloatAttenuation + FixedAttenuation + DescribedAttenuation> Exported for A {}

macro_rules! attenuation {
    ([$any:expr] $($(#[$doc:meta])* $variant:ident($type:ty) = any $draw:expr
       $(, $(#[$its_doc:meta])* $constant:ty = $its_name:literal, $value:expr)*;)*) => {
        match $any {
            $(AnyAttenuation::$variant(attenuation) => attenuation as &$type,)*
            _ => unreachable!("the list has every attenuation"),
        }
    };
}

/// Returns an attenuation as what can be exported.
pub(crate) fn attenuation(attenuation: &AnyAttenuation) -> &dyn Exported {
    luminaire::attenuations! { attenuation; [attenuation] }
}
