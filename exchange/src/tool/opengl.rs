//! OpenGL 1 and 2 (specification of 2.1, section 2.14.1; reference page of `glLight`): a half angle in degrees.

use luminaire::falloff::AnyFalloff;
use luminaire::{Angle, Cone};

use super::{Fall, Law, Rows, Spot, Tool, Writer, Written, no_cone, polynomial, row};
use crate::difference::Difference;
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::limits::within;
use crate::record::{Kind, Record};
use crate::refusal::Refusal;
use crate::versine::full;

pub(crate) struct OpenGl;

/// `GL_CONSTANT_ATTENUATION` and its siblings.
const COEFFICIENTS: [&str; 3] = ["constant_attenuation", "linear_attenuation", "quadratic_attenuation"];

impl Tool for OpenGl {
    /// `cos^e` up to the cutoff, divided by `k0 + k1 d + k2 d^2`. As in OpenGL the quotient is not capped, except at
    /// distances below 0.001 if `k0` is 0.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let cutoff = record.near("spot_cutoff", 180.0, 0.0, 90.0)?;
        let is_point = within(cutoff, 180.0, 180.0).is_some();
        if is_point {
            record.kind = Kind::Point;
        } else if !(cutoff > 0.0 && cutoff <= 90.0) {
            let expected = "over 0 and at most 90 degrees (half angle), or 180 for a point light";
            return Err(Refusal::new("spot_cutoff", cutoff, expected));
        }
        let exponent = record.within("spot_exponent", 0.0, 0.0, 1_024.0)?;
        let (attenuation, factor) = polynomial(record, COEFFICIENTS, [1.0, 0.0, 0.0], None)?;
        let intensity = record.get("intensity", 1.0)? * factor;
        let (cone, difference) = if is_point {
            (no_cone()?, Difference::default())
        } else {
            cut_off(exponent, cutoff.to_radians())?
        };
        Ok(Spot { difference, ..Spot::new(record, cone, intensity, attenuation)? })
    }

    fn writer(&self) -> Option<&'static dyn Writer> {
        Some(&Self)
    }
}

/// Returns the cone of a power of the cosine that is cut off at a half angle in radians.
pub(super) fn cut_off(exponent: f64, cutoff: f64) -> Result<(Cone<AnyFalloff>, Difference), Refusal> {
    let cutoff = full(cutoff);
    let cone = match AnyFalloff::power(exponent as f32)? {
        step @ AnyFalloff::Step(_) => Cone::from_outer(step, cutoff)?,
        falloff => Cone::from_outer(falloff, Angle::degrees(180.0))?.with_cutoff(cutoff)?,
    };
    // For an exponent below 1, the derivative of `cos^e` with respect to the angle is infinite at 90 degrees. Only a
    // cutoff of 90 degrees includes that angle.
    let is_boundless = !cone.has_cutoff() && exponent > 0.0 && exponent < 1.0;
    Ok((cone, if is_boundless { Difference::AT_THE_EDGE } else { Difference::default() }))
}

impl Writer for OpenGl {
    fn family(&self) -> Family {
        Family::Cosine
    }

    fn fall(&self, law: &Law) -> Fall {
        Fall::Polynomial { coefficients: law.polynomial(), range: None }
    }

    fn cone(&self, [outer, _, exponent]: Free) -> Rows {
        vec![row("spot_cutoff", outer.to_degrees()), row("spot_exponent", exponent)]
    }

    fn rest(&self, light: &Written) -> Rows {
        let coefficients = COEFFICIENTS.into_iter().zip(light.fall.coefficients());
        coefficients.chain([("intensity", light.shown())]).map(|(name, value)| row(name, value)).collect()
    }

    fn notes(&self, _: Use) -> Vec<&'static str> {
        vec!["the intensity is a factor of GL_DIFFUSE, which may be over 1"]
    }
}
