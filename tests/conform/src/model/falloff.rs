//! Cones, and the falloff from a versine to an intensity.

use luminaire::{
    Angle, Cone, Error, HalfAngle, Vec3,
    falloff::{Falloff, FittedFalloff, Power},
};

use crate::case::{Case, Outcome};
use crate::word::Format;

/// The samples of the table, from the axis to the edge.
pub(super) static SAMPLES: [u16; 6] = [65_535, 62_000, 41_000, 39_999, 1_000, 7];

pub(super) fn components(v: Vec3<f32>) -> [f32; 3] {
    [v.x, v.y, v.z]
}

/// The description of a cone, in full angles and degrees. `design` says which angle `angle` is: 0
/// outer, 1 beam, 2 field. An inner angle or cutoff of zero is not set.
pub(super) struct Description<P> {
    falloff: Result<P, Error>,
    design: u32,
    angle: f32,
    inner: f32,
    cutoff: f32,
}

impl<P: Falloff> Description<P> {
    pub(super) fn of(case: &mut Case<'_>, falloff: impl Fn(&mut Case<'_>) -> Result<P, Error>) -> Self {
        Self {
            falloff: falloff(case),
            design: case.whole("design"),
            angle: case.number("angle"),
            inner: case.number("inner"),
            cutoff: case.number("cutoff"),
        }
    }

    pub(super) fn cone(self) -> Result<Cone<P>, Error> {
        let (falloff, angle) = (self.falloff?, Angle::degrees(self.angle));
        let mut cone = match self.design {
            0 => Cone::from_outer(falloff, angle),
            1 => Cone::from_beam(falloff, angle),
            _ => Cone::from_field(falloff, angle),
        }?;
        if self.inner != 0.0 {
            cone = cone.with_inner(Angle::degrees(self.inner))?;
        }
        if self.cutoff != 0.0 {
            cone = cone.with_cutoff(Angle::degrees(self.cutoff))?;
        }
        Ok(cone)
    }
}

/// Outputs the outer versine, then beam, field and outer angle in degrees, then the luminous flux
/// in lumens at an intensity of one candela.
fn give<P: Falloff>(case: &mut Case<'_>, cone: &Cone<P>) {
    case.give(cone.outer_versine());
    for angle in [cone.beam(), cone.field(), cone.outer()] {
        case.give(angle.to_degrees());
    }
    case.give(cone.lumens(1.0));
}

pub(super) fn cone<P: Falloff>(
    case: &mut Case<'_>,
    falloff: impl Fn(&mut Case<'_>) -> Result<P, Error>,
) -> Outcome {
    let cone = Description::of(case, falloff).cone()?;
    give(case, &cone);
    Ok(())
}

/// The outputs of a cone and the inner angle; then the slopes of a cubic at the edge and in the
/// middle, or the edge slope of a quadratic.
pub(super) fn two_angles(case: &mut Case<'_>) -> Outcome {
    let (beam, field) = (case.number("beam"), case.number("field"));
    let cone = Cone::from_beam_and_field(Angle::degrees(beam), Angle::degrees(field))?;
    give(case, &cone);
    case.give(cone.inner().to_degrees());
    match cone.falloff() {
        FittedFalloff::Quadratic(quadratic) => case.give(quadratic.edge_slope()),
        FittedFalloff::Cubic(cubic) => {
            case.give(cubic.edge_slope());
            case.give(cubic.middle_slope());
        }
    }
    Ok(())
}

/// The outputs of a cone; then the slope in the middle.
pub(super) fn two_angles_and_slope(case: &mut Case<'_>) -> Outcome {
    let (beam, field, slope) = (case.number("beam"), case.number("field"), case.number("edge slope"));
    let cone = Cone::from_beam_field_and_slope(Angle::degrees(beam), Angle::degrees(field), slope)?;
    give(case, &cone);
    case.give(cone.falloff().middle_slope());
    Ok(())
}

/// The outputs of a cone that is given by OpenGL's cutoff, a half angle in degrees.
pub(super) fn opengl(case: &mut Case<'_>) -> Outcome {
    let cone = Cone::<Power<15>>::opengl(HalfAngle::degrees(case.number("spot cutoff")))?;
    give(case, &cone);
    Ok(())
}

/// Three outputs: the representable versine nearest to a number, in the scale of the cone; the
/// intensity at that versine; and the intensity at a versine of any bits.
pub(super) fn falloff<S: Format, P: Falloff>(
    case: &mut Case<'_>,
    falloff: impl Fn(&mut Case<'_>) -> Result<P, Error>,
) -> Outcome {
    let description = Description::of(case, falloff);
    let (number, bits) = (case.number("versine"), case.versine::<S>("versine of the format"));
    let falloff = description.cone()?.compile::<S>()?;
    let versine = falloff.versine(number);
    case.give(versine);
    case.give(falloff.at(versine));
    case.give(falloff.at(bits));
    Ok(())
}
