//! Cones with a given beam and field angle.

use super::Cone;
use crate::{
    angle::{Angle, IntoAngle},
    error::{Error, Expected, Parameter},
    falloff::{
        Cubic, Falloff, FittedFalloff, Hard, Quadratic, Smooth, SoftEdged,
        fit::{self, DEFAULT_SLOPE, HARD_RATIO, LEAST_RATIO, MOST_RATIO, MOST_SOFT_RATIO, SOFT_RATIO},
    },
};

const _: () = assert!(LEAST_RATIO == 1.1604 && MOST_RATIO == 5.437, "as is documented");

impl Cone<FittedFalloff> {
    /// Creates the cone with this beam angle (50 %) and this field angle (10 %).
    ///
    /// The falloff depends on `r`, the versine of half the field angle divided by the versine of
    /// half the beam angle:
    ///
    /// | r | falloff |
    /// |---|---|
    /// | 1 to 1.3416 | the hard falloff with a hotspot; at `r = 1` a step |
    /// | 1.3416 to 2.3345 | the [`Quadratic`] between hard and soft with this ratio |
    /// | 2.3345 to 5.437 | the [`Cubic`] of edge slope 1.34 with this ratio |
    ///
    /// The two quadratics of Hast 2004, hard and soft, are the ends of the middle row. In wide
    /// cones the quadratic may need an outer angle over 180 degrees where the cubic does not. The
    /// falloff is then the cubic.
    ///
    /// ```
    /// use luminaire::{Angle, Cone};
    /// // The Fresnel of Hast 2004, for which neither soft nor hard has both angles.
    /// let cone = Cone::from_beam_and_field(Angle::degrees(7.0), Angle::degrees(15.0))?;
    /// assert!((cone.beam().to_degrees() - 7.0).abs() < 1e-4);
    /// assert!((cone.field().to_degrees() - 15.0).abs() < 1e-4);
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    ///
    /// # Errors
    /// A beam angle outside (0, 180] degrees. A field angle that is smaller than the beam angle,
    /// gives a ratio `r` over 5.437, or needs an outer angle over 180 degrees. The error names the
    /// range of field angles for this beam angle.
    pub fn from_beam_and_field(beam: impl IntoAngle, field: impl IntoAngle) -> Result<Self, Error> {
        design(beam.into_angle(), field.into_angle(), MOST_RATIO, fitted)
    }
}

impl Cone<SoftEdged> {
    /// Creates the cone with this beam angle (50 %) and this field angle (10 %), whose light fades out without a visible
    /// edge, as that of a Fresnel lens does.
    ///
    /// Compared with [`Cone::from_beam_and_field`] the outer angle is wider. The falloff depends on `r`, the versine of
    /// half the field angle divided by the versine of half the beam angle:
    ///
    /// | r | falloff |
    /// |---|---|
    /// | 1 to 1.608 | smoothstep with a hotspot; at `r = 1` a step |
    /// | 1.608 to 2.3345 | the [`Cubic`] of edge slope 0 with this ratio, from smoothstep to the soft quadratic |
    /// | from 2.3345 on | the [`SoftPair`](crate::falloff::SoftPair) with the least slope on the axis |
    ///
    /// In wide cones that pair may need an outer angle over 180 degrees where another does not. The falloff is then the
    /// pair with an outer angle of 180 degrees.
    ///
    /// ```
    /// use luminaire::{Angle, Cone};
    /// // The Fresnel of Hast 2004.
    /// let cone = Cone::soft_from_beam_and_field(Angle::degrees(7.0), Angle::degrees(15.0))?;
    /// assert!((cone.beam().to_degrees() - 7.0).abs() < 1e-4);
    /// assert!((cone.field().to_degrees() - 15.0).abs() < 1e-4);
    /// assert!((cone.outer().to_degrees() - 19.75).abs() < 0.01);
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    ///
    /// # Errors
    /// A beam angle outside (0, 180] degrees. A field angle that is smaller than the beam angle, needs an outer angle
    /// over 180 degrees, or needs a pair whose ratio is over 1024, as one of 29 times a narrow beam angle does. The error names the
    /// range of field angles for this beam angle.
    pub fn soft_from_beam_and_field(beam: impl IntoAngle, field: impl IntoAngle) -> Result<Self, Error> {
        design(beam.into_angle(), field.into_angle(), MOST_SOFT_RATIO, soft_edged)
    }
}

impl Cone<Cubic> {
    /// Creates the cone with this beam and field angle as a [`Cubic`] with a given edge slope.
    ///
    /// In contrast to [`Cone::from_beam_and_field`], the falloff is always a cubic. The edge slope
    /// is the derivative with respect to `t` at the edge. At the same two angles, a smaller edge
    /// slope gives a softer edge.
    ///
    /// # Errors
    /// The errors of [`Cone::from_beam_and_field`], with ratios from 1.1604 to 5.437 accepted. Also
    /// an edge slope outside the range of [`Cone::edge_slopes`].
    pub fn from_beam_field_and_slope(
        beam: impl IntoAngle,
        field: impl IntoAngle,
        edge_slope: f32,
    ) -> Result<Self, Error> {
        let (beam, field) = (beam.into_angle(), field.into_angle());
        let (least, most) = Self::edge_slopes(beam, field)?;
        if !(least..=most).contains(&edge_slope) {
            let accepted = Expected::Between(least, most);
            return Err(Error { parameter: Parameter::EdgeSlope, value: edge_slope, accepted });
        }
        design(beam, field, MOST_RATIO, |beam, field| cubic(beam, field, edge_slope))
    }

    /// Returns the smallest and the largest edge slope of the monotone cubics with these two
    /// angles.
    ///
    /// # Errors
    /// A beam angle outside (0, 180] degrees, or a field angle for which the ratio of the versines
    /// is outside 1.1604 to 5.437.
    pub fn edge_slopes(beam: impl IntoAngle, field: impl IntoAngle) -> Result<(f32, f32), Error> {
        let reachable = |beam: f32, field: f32| {
            let ratio = field / beam;
            (LEAST_RATIO..=MOST_RATIO).contains(&ratio).then(|| fit::edge_slopes(ratio))
        };
        design(beam.into_angle(), field.into_angle(), MOST_RATIO, reachable)
    }
}

/// Applies `design` to the versines of half the beam angle and half the field angle. If `design`
/// fails, the error names the range of field angles for this beam angle. No ratio over `most_ratio` is possible.
fn design<T>(
    beam: Angle,
    field: Angle,
    most_ratio: f32,
    design: impl Fn(f32, f32) -> Option<T>,
) -> Result<T, Error> {
    let (near, far) = (beam.versine(), field.versine());
    // The versine of a tiny positive angle may underflow.
    if !(beam > Angle::degrees(0.0) && beam <= Angle::degrees(180.0) && near >= f32::MIN_POSITIVE) {
        let value = beam.to_degrees();
        let accepted = Expected::angle_up_to(180.0, value);
        return Err(Error { parameter: Parameter::BeamAngle, value, accepted });
    }
    let designed = if field >= beam && field <= Angle::degrees(180.0) { design(near, far) } else { None };
    designed.ok_or_else(|| {
        let (least, most) = reach(near, most_ratio, |field| design(near, field).is_some());
        // Inside by the roundings between angle and versine, so that the named angles are accepted.
        let most = (most * (1.0 - 1e-6)).max(least);
        let accepted = Expected::AngleBetween(
            if least > near {
                Angle::from_versine(least * (1.0 + 1e-6)).to_degrees()
            } else {
                beam.to_degrees()
            },
            Angle::from_versine(most).to_degrees(),
        );
        Error { parameter: Parameter::FieldAngle, value: field.to_degrees(), accepted }
    })
}

/// Returns the smallest and the largest field versine for which `can` holds, for this beam versine.
fn reach(beam: f32, most_ratio: f32, can: impl Fn(f32) -> bool) -> (f32, f32) {
    // Start at a field versine for which `can` holds: the beam versine, or the smallest field
    // versine of the cubics.
    let start = if can(beam) { beam } else { beam * (LEAST_RATIO + 1e-4) };
    let mut ends = [beam.min(start), (beam * most_ratio * 1.01).min(1.0)].map(|end| (start, end));
    for (held, beyond) in &mut ends {
        for _ in 0..24 {
            let middle = (*held + *beyond) / 2.0;
            if can(middle) { *held = middle } else { *beyond = middle }
        }
    }
    let [(least, _), (most, _)] = ends;
    (least, most)
}

/// Returns the cone whose falloff has these versines of half the beam angle and half the field
/// angle.
fn fitted(beam: f32, field: f32) -> Option<Cone<FittedFalloff>> {
    let ratio = field / beam;
    let quadratic = if ratio <= HARD_RATIO {
        Some(hotspot(Hard, beam, field).with_falloff(FittedFalloff::Quadratic(Quadratic::HARD)))
    } else if ratio <= SOFT_RATIO {
        let quadratic = fit::quadratic(ratio);
        Some(Cone::open(FittedFalloff::Quadratic(quadratic), 0.0, field / quadratic.field_versine()))
    } else {
        None
    };
    let within = |cone: &Cone<FittedFalloff>| cone.outer <= 1.0;
    quadratic.filter(within).or_else(|| {
        let cubic = cubic(beam, field, DEFAULT_SLOPE)?;
        Some(cubic.with_falloff(FittedFalloff::Cubic(cubic.falloff())))
    })
}

/// Returns the cone with the soft edge that has these versines of half the beam angle and half the field angle.
fn soft_edged(beam: f32, field: f32) -> Option<Cone<SoftEdged>> {
    let cone = if field * Smooth.beam_versine() <= beam * Smooth.field_versine() {
        hotspot(Smooth, beam, field).with_falloff(SoftEdged::Cubic(Cubic::SMOOTH))
    } else if field <= beam * SOFT_RATIO {
        let cubic = cubic(beam, field, 0.0)?;
        cubic.with_falloff(SoftEdged::Cubic(cubic.falloff()))
    } else {
        let pair = fit::soft_pair(beam, field)?;
        // At the limit, by the roundings of the pair.
        let outer = field / pair.field_versine();
        Cone::open(SoftEdged::SoftPair(pair), 0.0, if outer <= 1.0 + 1e-6 { outer.min(1.0) } else { outer })
    };
    (cone.outer <= 1.0).then_some(cone)
}

/// Returns a cone with a falloff and a hotspot. Such a cone reaches any ratio below that of the falloff.
fn hotspot<P: Falloff>(falloff: P, beam: f32, field: f32) -> Cone<P> {
    let (of_beam, of_field) = (falloff.beam_versine(), falloff.field_versine());
    let span = (field - beam) / (of_field - of_beam);
    let inner = (beam - span * of_beam).max(0.0);
    Cone::open(falloff, inner, field + span * (1.0 - of_field))
}

/// Returns the cone with the cubic of this edge slope, if the outer angle is at most 180 degrees.
fn cubic(beam: f32, field: f32, edge_slope: f32) -> Option<Cone<Cubic>> {
    let cubic = fit::cubic(edge_slope, field / beam)?;
    let cone = Cone::open(cubic, 0.0, field / cubic.field_versine());
    (cone.outer <= 1.0).then_some(cone)
}
