//! The angles that a cone is designed from.

use crate::refusal::{Refusal, choose};
use luminaire::{
    Angle, Cone, Error,
    error::{Expected, Parameter},
    falloff::{AnyFalloff, Falloff},
};

/// The angle that a cone is designed from. The kernel computes the others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Mark {
    /// Full angle at which the intensity is half of that on the axis.
    Beam,
    /// Full angle at which the intensity is a tenth of that on the axis.
    Field,
}

/// Share by which the ends of a range are drawn in, so that an end in degrees is accepted.
const MARGIN: f32 = 1e-5;

/// The edge of a cone that has a beam and a field angle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Both {
    /// The falloff with the narrowest outer angle that both determine.
    Fitted,
    /// A soft edge, farther out.
    Soft,
}

/// Full angles in degrees. One of them gives the other by the falloff; both give the falloff. The
/// kernel computes what is not given.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub(crate) struct Design {
    pub(crate) beam: Option<f32>,
    pub(crate) field: Option<f32>,
}

impl Mark {
    /// The kind of angle with this name.
    pub(crate) fn named(name: &str) -> Result<Self, Refusal> {
        choose("reading of the published angle", name, &[Self::Beam, Self::Field], Self::name)
    }

    /// The name that [`Self::named`] accepts.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Beam => "beam",
            Self::Field => "field",
        }
    }
}

impl Both {
    pub(crate) const ALL: [Self; 2] = [Self::Fitted, Self::Soft];

    /// Returns the edge of two angles for the falloff that is chosen.
    pub(crate) fn of(chosen: Option<AnyFalloff>) -> Self {
        if matches!(chosen, Some(AnyFalloff::Soft(_))) { Self::Soft } else { Self::Fitted }
    }

    /// The name in the list of edges.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Fitted => "fitted",
            Self::Soft => "fitted-soft",
        }
    }

    /// Returns the cone with both angles, in degrees.
    fn cone(self, beam: f32, field: f32) -> Result<Cone<AnyFalloff>, Error> {
        let (beam, field) = (Angle::degrees(beam), Angle::degrees(field));
        match self {
            Self::Fitted => Cone::from_beam_and_field(beam, field).map(any),
            Self::Soft => Cone::soft_from_beam_and_field(beam, field).map(any),
        }
    }

    /// Returns the least and the largest field angle of the cones with this beam angle, in degrees;
    /// `None` if there is no such cone.
    pub(crate) fn fields(self, beam: f32) -> Option<[f32; 2]> {
        // No field angle is 0: the error has the range.
        match self.cone(beam, 0.0).err()? {
            Error {
                parameter: Parameter::FieldAngle, accepted: Expected::AngleBetween(least, most), ..
            } => Some([least, most * (1.0 - MARGIN)]),
            _ => None,
        }
    }

    /// Returns the least and the largest beam angle of the cones with this field angle, in degrees;
    /// `None` if there is no such cone.
    pub(crate) fn beams(self, field: f32) -> Option<[f32; 2]> {
        self.cone(field, field).ok()?;
        let (mut most_refused, mut least) = (0.0, field);
        for _ in 0..24 {
            let middle = f32::midpoint(most_refused, least);
            if self.cone(middle, field).is_ok() { least = middle } else { most_refused = middle }
        }
        Some([least * (1.0 + MARGIN), field])
    }
}

fn any(cone: Cone<impl Falloff + Into<AnyFalloff>>) -> Cone<AnyFalloff> {
    cone.with_falloff(cone.falloff().into())
}

impl Design {
    /// One angle.
    pub(crate) fn of(mark: Mark, degrees: f32) -> Self {
        match mark {
            Mark::Beam => Self { beam: Some(degrees), field: None },
            Mark::Field => Self { beam: None, field: Some(degrees) },
        }
    }

    /// These two angles, or else those of a cone. The field angle is the nearest that a cone with this beam
    /// angle and such an edge can have.
    pub(crate) fn or_both_of(self, cone: &Cone<AnyFalloff>, edge: Both) -> Self {
        let of_cone = || (cone.beam().to_degrees(), cone.field().to_degrees());
        let (beam, field) = self.both().unwrap_or_else(of_cone);
        Self { beam: None, field: Some(field) }.with(Mark::Beam, beam, edge)
    }

    /// Both angles, if both are given.
    pub(crate) fn both(&self) -> Option<(f32, f32)> {
        self.beam.zip(self.field)
    }

    /// The angle, if one is given.
    pub(crate) fn one(&self) -> Option<(Mark, f32)> {
        match (self.beam, self.field) {
            (Some(beam), None) => Some((Mark::Beam, beam)),
            (None, Some(field)) => Some((Mark::Field, field)),
            _ => None,
        }
    }

    /// The design of two angles with one of them changed. The other one follows as far as it must,
    /// so that there is a cone with both and such an edge.
    pub(crate) fn with(self, mark: Mark, degrees: f32, edge: Both) -> Self {
        let nearest = |other: Option<f32>, reach: Option<[f32; 2]>| {
            other.zip(reach).map(|(other, [least, most])| other.max(least).min(most)).or(other)
        };
        match mark {
            Mark::Beam => Self { beam: Some(degrees), field: nearest(self.field, edge.fields(degrees)) },
            Mark::Field => Self { field: Some(degrees), beam: nearest(self.beam, edge.beams(degrees)) },
        }
    }

    /// All angles multiplied by a factor.
    pub(crate) fn times(self, factor: f32) -> Self {
        Self { beam: self.beam.map(|angle| factor * angle), field: self.field.map(|angle| factor * angle) }
    }

    /// Returns the cone with these angles: by the falloff `edge`, or by that of `original`.
    pub(crate) fn cone(
        &self,
        edge: Option<AnyFalloff>,
        original: Cone<AnyFalloff>,
    ) -> Result<Cone<AnyFalloff>, Error> {
        let profile = edge.unwrap_or(original.falloff());
        match (self.beam, self.field) {
            (Some(beam), Some(field)) => Both::of(edge).cone(beam, field),
            (Some(beam), None) => Cone::from_beam(profile, Angle::degrees(beam)),
            (None, Some(field)) => Cone::from_field(profile, Angle::degrees(field)),
            (None, None) if edge.is_some() => Cone::from_field(profile, original.field()),
            (None, None) => Ok(original),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_what_is_reached_are_cones_and_beyond_them_is_none() {
        let angles = [0.1, 1.0, 9.8, 30.0, 89.0, 140.0, 170.0];
        for (edge, angle) in Both::ALL.into_iter().flat_map(|edge| angles.map(|angle| (edge, angle))) {
            let is_cone = |beam, field| edge.cone(beam, field).is_ok();
            let [least, most] = edge.fields(angle).unwrap();
            assert!(is_cone(angle, least) && is_cone(angle, most), "{angle}: {least} to {most}");
            assert!(!is_cone(angle, most * 1.001) && !is_cone(angle, least * 0.999), "{angle}");
            let [least, most] = edge.beams(angle).unwrap();
            assert!(is_cone(least, angle) && is_cone(most, angle), "{angle}: {least} to {most}");
            assert!(!is_cone(least * 0.999, angle) && !is_cone(most * 1.001, angle), "{angle}");
        }
        for angle in [0.0, -1.0, 181.0, f32::NAN, f32::INFINITY] {
            assert_eq!((Both::Soft.fields(angle), Both::Fitted.beams(angle)), (None, None));
        }
    }

    #[test]
    fn the_other_angle_follows_no_farther_than_it_must() {
        let design = Design { beam: Some(10.0), field: Some(15.0) };
        let with = |mark, degrees| design.with(mark, degrees, Both::Fitted);
        assert_eq!(with(Mark::Field, 20.0), Design { beam: Some(10.0), field: Some(20.0) });
        assert_eq!(with(Mark::Field, 5.0), Design { beam: Some(5.0), field: Some(5.0) });
        assert_eq!(with(Mark::Beam, 18.0), Design { beam: Some(18.0), field: Some(18.0) });
        let wide = with(Mark::Field, 60.0);
        assert!(wide.beam.unwrap() > 20.0 && wide.cone(None, Both::Fitted.cone(10.0, 15.0).unwrap()).is_ok());
        // A soft edge has both.
        let wide = Design { beam: Some(10.0), field: Some(60.0) };
        assert_eq!(design.with(Mark::Field, 60.0, Both::Soft), wide);
    }
}
