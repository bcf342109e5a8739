//! The list of models, for what the kernel itself does not tell.

use luminaire::attenuation::AnyAttenuation;

use crate::fixed::attenuation::FixedAttenuation;
use crate::json::attenuation::DescribedAttenuation;
use crate::shader::attenuation::FloatAttenuation;

/// An attenuation that can be exported.
pub(crate) trait Exported: FloatAttenuation + FixedAttenuation + DescribedAttenuation {}

impl<A: FloatAttenuation + FixedAttenuation + DescribedAttenuation> Exported for A {}

/// Returns an attenuation as what can be exported.
pub(crate) fn attenuation(attenuation: &AnyAttenuation) -> &dyn Exported {
    match attenuation {
        AnyAttenuation::Constant(attenuation) => attenuation,
        AnyAttenuation::InverseSquare(attenuation) => attenuation,
        AnyAttenuation::Polynomial(attenuation) => attenuation,
        AnyAttenuation::GltfRange(attenuation) => attenuation,
        AnyAttenuation::WindowedConstant(attenuation) => attenuation,
        AnyAttenuation::FilamentRange(attenuation) => attenuation,
        AnyAttenuation::WindowedPolynomial(attenuation) => attenuation,
        AnyAttenuation::SmoothRange(attenuation) => attenuation,
        _ => unreachable!("the list has every attenuation"),
    }
}
